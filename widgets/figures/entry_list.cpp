// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/figures/entry_list.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

namespace gonio::widgets {

namespace {
constexpr int shownRows = 4;
}

EntryList::EntryList(const QString& nameTitle, bool hasBudgets, QWidget* parent)
    : QWidget(parent),
      m_model(nameTitle, hasBudgets),
      m_view(new QTreeView),
      m_empty(new QLabel(m_view->viewport())),
      m_menu(new QMenu(this)) {
  m_view->setModel(&m_model);
  m_view->setRootIsDecorated(false);
  m_view->setUniformRowHeights(true);
  m_view->setAlternatingRowColors(true);
  m_view->setAccessibleName(nameTitle);
  m_view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  m_view->setMinimumHeight((shownRows + 2) * fontMetrics().lineSpacing());
  m_view->header()->setStretchLastSection(true);
  m_view->header()->setSectionsMovable(false);
  m_view->header()->resizeSection(0, fontMetrics().averageCharWidth() * 27);
  if (hasBudgets) m_view->header()->resizeSection(1, fontMetrics().averageCharWidth() * 9);
  m_view->installEventFilter(this);
  m_empty->setAlignment(Qt::AlignCenter);
  m_empty->setWordWrap(true);
  m_empty->setForegroundRole(QPalette::PlaceholderText);
  m_empty->setAttribute(Qt::WA_TransparentForMouseEvents);

  auto* over = new QVBoxLayout(m_view->viewport());
  over->addWidget(m_empty);
  auto* buttons = new QHBoxLayout;
  m_add = button(tr("Add"), tr("Adds an entry at the end"));
  m_add->setMenu(m_menu);
  m_add->setPopupMode(QToolButton::InstantPopup);
  m_remove = button(tr("Remove"), tr("Removes the selected entry (Delete)"));
  m_up = button(tr("Move up"), tr("Moves the selected entry up (Alt+Up)"));
  m_down = button(tr("Move down"), tr("Moves the selected entry down (Alt+Down)"));
  for (QToolButton* one : {m_add, m_remove, m_up, m_down}) buttons->addWidget(one);
  buttons->addStretch();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_view, 1);
  layout->addLayout(buttons);
  connect(m_remove, &QToolButton::clicked, this, [this] { Q_EMIT removeRequested(current()); });
  connect(m_up, &QToolButton::clicked, this, [this] { move(-1); });
  connect(m_down, &QToolButton::clicked, this, [this] { move(1); });
  connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, &EntryList::refresh);
  refresh();
}

QToolButton* EntryList::button(const QString& text, const QString& toolTip) {
  auto* button = new QToolButton;
  button->setText(text);
  button->setToolTip(toolTip);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

void EntryList::setEmptyText(const QString& text) { m_empty->setText(text); }

void EntryList::setEntries(std::vector<ListEntry> entries, bool full) {
  m_model.setEntries(std::move(entries));
  m_add->setEnabled(!full);
  refresh();
}

int EntryList::current() const {
  const QModelIndex index = m_view->currentIndex();
  return index.isValid() ? index.row() : -1;
}

void EntryList::select(int row) { m_view->setCurrentIndex(m_model.index(row, m_model.labelColumn())); }

void EntryList::move(int by) {
  const int from = current(), to = from + by;
  if (from < 0 || to < 0 || to >= m_model.rowCount()) return;
  Q_EMIT moveRequested(from, to);
  select(to);
}

void EntryList::refresh() {
  const int row = current(), count = m_model.rowCount();
  m_empty->setVisible(count == 0);
  m_remove->setEnabled(row >= 0);
  m_up->setEnabled(row > 0);
  m_down->setEnabled(row >= 0 && row + 1 < count);
}

bool EntryList::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  const bool alt = key->modifiers() == Qt::AltModifier;
  if (key->key() == Qt::Key_Delete && current() >= 0)
    Q_EMIT removeRequested(current());
  else if (alt && (key->key() == Qt::Key_Up || key->key() == Qt::Key_Down))
    move(key->key() == Qt::Key_Up ? -1 : 1);
  else
    return QWidget::eventFilter(watched, event);
  return true;
}

}  // namespace gonio::widgets

#include "moc_entry_list.cpp"
