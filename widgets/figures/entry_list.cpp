// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/figures/entry_list.h"

#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPalette>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

namespace gonio::widgets {

namespace {
enum Column { nameColumn, budgetColumn };
}

EntryListModel::EntryListModel(const QString& nameTitle, bool hasBudgets, QObject* parent)
    : QAbstractTableModel(parent), m_nameTitle(nameTitle), m_hasBudgets(hasBudgets) {}

void EntryListModel::setEntries(std::vector<ListEntry> entries) {
  // Remaining rows keep the selection and an open editor.
  const int before = rowCount(), after = int(entries.size());
  if (after > before) beginInsertRows({}, before, after - 1);
  if (after < before) beginRemoveRows({}, after, before - 1);
  m_entries = std::move(entries);
  if (after > before) endInsertRows();
  if (after < before) endRemoveRows();
  if (after > 0) Q_EMIT dataChanged(index(0, 0), index(after - 1, labelColumn()));
}

int EntryListModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_entries.size()); }
int EntryListModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : labelColumn() + 1; }

QVariant EntryListModel::data(const QModelIndex& index, int role) const {
  const ListEntry& entry = m_entries[std::size_t(index.row())];
  const bool isLabel = index.column() == labelColumn(), isBudget = m_hasBudgets && index.column() == budgetColumn;
  if (role == Qt::EditRole) {
    if (isLabel) return entry.label;
    if (isBudget && entry.budget) return *entry.budget;
  }
  if (role == Qt::DisplayRole) {
    if (isLabel) return entry.label.isEmpty() ? entry.usualLabel : entry.label;
    if (isBudget) return entry.budget ? QVariant(*entry.budget) : QVariant();
    return entry.name;
  }
  if (role == Qt::ToolTipRole && index.column() == nameColumn) return entry.toolTip;
  if (role == Qt::ToolTipRole && isLabel) return tr("Label in the figure; double-click or press F2 to edit it");
  if (role == Qt::ToolTipRole && isBudget && entry.budget)
    return tr("Budget, 1 to %1; double-click to edit").arg(entry.maxBudget);
  if (role == Qt::ForegroundRole && isLabel && entry.label.isEmpty())
    return QGuiApplication::palette().color(QPalette::PlaceholderText);
  if (role == Qt::TextAlignmentRole && isBudget) return int(Qt::AlignRight | Qt::AlignVCenter);
  return {};
}

QVariant EntryListModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  if (section == labelColumn()) return tr("Label");
  return section == nameColumn ? m_nameTitle : tr("Budget");
}

Qt::ItemFlags EntryListModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  if (!index.isValid()) return flags;
  const bool hasBudget = m_hasBudgets && index.column() == budgetColumn && m_entries[std::size_t(index.row())].budget;
  if (hasBudget || index.column() == labelColumn()) flags |= Qt::ItemIsEditable;
  return flags;
}

bool EntryListModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable)) return false;
  const ListEntry& entry = m_entries[std::size_t(index.row())];
  if (index.column() == labelColumn()) {
    if (const QString label = value.toString().trimmed(); label != entry.label) Q_EMIT labelEdited(index.row(), label);
    return true;
  }
  const int budget = value.toInt();
  if (budget < 1 || budget > entry.maxBudget) return false;
  if (budget != entry.budget) Q_EMIT budgetEdited(index.row(), budget);
  return true;
}

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
