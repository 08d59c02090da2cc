// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/edit_stack.h"

#include <QAction>
#include <QDropEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <algorithm>

#include "widgets/inputs/icons.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"

namespace gonio::widgets {

EditRow::EditRow(QWidget* parent)
    : QWidget(parent),
      m_eye(new QToolButton),
      m_name(new QLabel),
      m_nameField(new QLineEdit),
      m_slider(new ParameterSlider),
      m_field(new NumberField),
      m_delete(new QToolButton),
      m_effect(new QLabel) {
  constexpr double percentScale = 100;
  const int em = fontMetrics().height();
  for (QToolButton* button : {m_eye, m_delete}) {
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
  }
  m_eye->setCheckable(true);
  m_delete->setIcon(themedIcon(QStringLiteral("close")));
  m_delete->setToolTip(tr("Deletes this edit"));
  m_name->setTextFormat(Qt::PlainText);
  m_name->setMinimumWidth(1);  // a long name must not widen the whole inspector
  m_nameField->setVisible(false);
  m_nameField->setAccessibleName(tr("Name of the edit"));
  m_nameField->installEventFilter(this);
  m_slider->setRange(0, 1, models::ParameterScale::linear);
  m_slider->setReference(1);
  m_slider->setToolTip(tr("Strength: percentage of the change that is applied"));
  m_field->setRange(0, 1);
  m_field->setUnit(QStringLiteral("%"), percentScale);
  m_field->setStep(0.01);
  m_field->setFixedWidth(em * 5);
  auto* names = new QHBoxLayout;
  names->setSpacing(0);
  names->addWidget(m_name, 1);
  names->addWidget(m_nameField, 1);
  auto* strength = new QHBoxLayout;
  strength->setSpacing(em / 3);
  strength->addWidget(m_slider, 1);
  strength->addWidget(m_field);
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(em / 4, em / 6, em / 4, em / 4);
  layout->setHorizontalSpacing(em / 3);
  layout->setVerticalSpacing(em / 8);
  layout->setColumnStretch(1, 1);
  layout->addWidget(m_eye, 0, 0);
  layout->addLayout(names, 0, 1);
  layout->addWidget(m_delete, 0, 2);
  layout->addLayout(strength, 1, 1, 1, 2);
  layout->addWidget(m_effect, 2, 1, 1, 2);
  m_effect->setMinimumWidth(1);
  m_effect->setForegroundRole(QPalette::PlaceholderText);
  connect(m_eye, &QToolButton::clicked, this, &EditRow::enabledChosen);
  connect(m_delete, &QToolButton::clicked, this, &EditRow::deleteRequested);
  connect(m_slider, &ParameterSlider::editingStarted, this, &EditRow::editingStarted);
  connect(m_slider, &ParameterSlider::numberEdited, this, &EditRow::strengthEdited);
  connect(m_slider, &ParameterSlider::editingFinished, this, &EditRow::editingFinished);
  connect(m_slider, &ParameterSlider::resetRequested, this, [this] { Q_EMIT strengthEdited(1); });
  connect(m_field, &NumberField::valueEdited, this, &EditRow::strengthEdited);
  connect(m_nameField, &QLineEdit::editingFinished, this, [this] {
    if (m_nameField->isHidden()) return;  // hiding takes the focus and finishes once more
    const QString name = m_nameField->text();
    endRename();
    if (name.trimmed() != m_described->ownName) Q_EMIT renamed(name.trimmed());
  });
}

void EditRow::show(const EditEntry& entry) {
  m_eye->setChecked(entry.enabled);
  m_slider->setNumber(entry.strength);
  m_slider->setModified(entry.strength != 1);
  m_field->setValue(entry.strength);
  if (m_described && m_described->hasSameTexts(entry)) return;
  m_described = entry;
  elideName();
  m_name->setToolTip(entry.toolTip);
  m_name->setEnabled(entry.enabled);
  m_eye->setIcon(themedIcon(entry.enabled ? QStringLiteral("shown") : QStringLiteral("hidden")));
  m_eye->setToolTip(entry.enabled ? tr("Excludes this edit from the image, the checks and exports")
                                  : tr("Includes this edit again"));
  m_eye->setAccessibleName(tr("%1 enabled").arg(entry.name));
  m_slider->setAccessibleName(tr("Strength of %1").arg(entry.name));
  m_field->setAccessibleName(tr("Strength of %1").arg(entry.name));
  m_effect->setText(entry.effect);
  m_effect->setVisible(!entry.effect.isEmpty());
  m_delete->setAccessibleName(tr("Delete %1").arg(entry.name));
  for (QWidget* control : std::initializer_list<QWidget*>{m_slider, m_field}) control->setEnabled(entry.enabled);
}

void EditRow::beginRename() {
  m_nameField->setText(m_described->ownName);
  m_nameField->setPlaceholderText(m_described->name);
  m_name->setVisible(false);
  m_nameField->setVisible(true);
  m_nameField->selectAll();
  m_nameField->setFocus();
}

void EditRow::endRename() {
  m_nameField->setVisible(false);
  m_name->setVisible(true);
}

void EditRow::elideName() {
  if (!m_described) return;
  m_name->setText(m_name->fontMetrics().elidedText(m_described->name, Qt::ElideMiddle, std::max(1, m_name->width())));
}

bool EditRow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_nameField && (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();
    if (event->type() == QEvent::KeyPress) {
      endRename();
      parentWidget()->setFocus();
    }
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void EditRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  elideName();
}

namespace {

/// The selected row is tinted, with a bar at its side: text and controls on it stay as legible as on the others.
class RowDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex&) const override {
    if (!(option.state & QStyle::State_Selected)) return;
    constexpr int barWidth = 3;
    QColor tint = option.palette.color(QPalette::Highlight);
    painter->fillRect(QRect(option.rect.topLeft(), QSize(barWidth, option.rect.height())), tint);
    tint.setAlphaF(option.state & QStyle::State_HasFocus ? 0.3f : 0.15f);
    painter->fillRect(option.rect, tint);
  }
};

}  // namespace

/// As high as its rows. A drop asks for a move instead of making it.
class EditStack::List : public QListWidget {
 public:
  explicit List(EditStack& stack) : m_stack(stack) {
    setDragDropMode(QAbstractItemView::InternalMove);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    // Rows follow the width of the list: with this mode alone they would follow its height.
    setWordWrap(true);
    setItemDelegate(new RowDelegate(this));
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    setAccessibleName(EditStack::tr("Edits"));
  }

  QSize sizeHint() const override {
    int height = 2 * frameWidth();
    for (int row = 0; row < count(); ++row) height += sizeHintForRow(row);
    return {10 * fontMetrics().height(), height};
  }
  QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }

 protected:
  void dropEvent(QDropEvent* event) override {
    stopAutoScroll();
    setState(NoState);
    viewport()->update();
    // The view would take the row away after a move: the owner does.
    event->setDropAction(Qt::IgnoreAction);
    event->accept();
    const QPoint place = event->position().toPoint();
    const QModelIndex below = indexAt(place);
    int to = below.isValid() ? below.row() : count();
    if (below.isValid() && place.y() > visualRect(below).center().y()) ++to;
    const int from = currentRow();
    if (to > from) --to;
    if (from < 0 || to == from) return;
    // When the drag is over: the rows are built anew.
    QMetaObject::invokeMethod(
        &m_stack, [this, from, to] { Q_EMIT m_stack.moveRequested(from, to); }, Qt::QueuedConnection);
  }

 private:
  EditStack& m_stack;
};

EditStack::EditStack(QWidget* parent)
    : QWidget(parent),
      m_list(new List(*this)),
      m_empty(new QLabel),
      m_addMenu(new QMenu(this)),
      m_add(new QToolButton) {
  m_empty->setWordWrap(true);
  m_empty->setForegroundRole(QPalette::PlaceholderText);
  m_empty->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  // As high as the first edit, which appears while a slider is dragged: nothing moves under the hand.
  EditRow first;
  first.show({.name = QStringLiteral("-"), .effect = QStringLiteral("-")});
  m_empty->setMinimumHeight(first.sizeHint().height() + 2 * m_list->frameWidth());
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_list);
  layout->addWidget(m_empty);
  buildActions();
  buildButtons();
  connect(m_list, &QListWidget::currentRowChanged, this, [this](int row) {
    updateActions();
    if (row >= 0) Q_EMIT selectionChosen(row);
  });
  connect(m_list, &QListWidget::itemDoubleClicked, this, [this] { beginRename(selected()); });
  setEntries({}, -1, {});
}

EditStack::~EditStack() = default;

void EditStack::buildActions() {
  const auto add = [this](const QString& text, const QString& toolTip, const QKeySequence& keys, auto&& act) {
    auto* action = new QAction(text, this);
    action->setToolTip(toolTip);
    action->setShortcut(keys);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(action, &QAction::triggered, this, act);
    addAction(action);
    return action;
  };
  m_rename = add(tr("Rename"), tr("Renames the selected edit (F2)"), Qt::Key_F2, [this] { beginRename(selected()); });
  m_duplicate = add(tr("Duplicate"), tr("Adds a copy of the selected edit after it"), {},
                    [this] { Q_EMIT duplicateRequested(selected()); });
  m_up = add(tr("Move up"), tr("Applies the selected edit earlier (Alt+Up)"), QKeySequence(Qt::ALT | Qt::Key_Up),
             [this] { Q_EMIT moveRequested(selected(), selected() - 1); });
  m_down = add(tr("Move down"), tr("Applies the selected edit later (Alt+Down)"), QKeySequence(Qt::ALT | Qt::Key_Down),
               [this] { Q_EMIT moveRequested(selected(), selected() + 1); });
  m_delete = add(tr("Delete"), tr("Deletes the selected edit (Delete)"), Qt::Key_Delete,
                 [this] { Q_EMIT deleteRequested(selected()); });
  setContextMenuPolicy(Qt::ActionsContextMenu);
}

void EditStack::buildButtons() {
  m_add->setText(tr("Add edit"));
  m_add->setToolTip(tr("Adds another edit after the selected one"));
  m_add->setMenu(m_addMenu);
  m_add->setPopupMode(QToolButton::InstantPopup);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_add);
  for (QAction* action : {m_duplicate, m_rename}) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    buttons->addWidget(button);
  }
  buttons->addStretch();
  for (auto* button : findChildren<QToolButton*>()) button->setFocusPolicy(Qt::StrongFocus);
  static_cast<QVBoxLayout*>(layout())->addLayout(buttons);
}

int EditStack::selected() const { return m_list->currentRow(); }

void EditStack::setEntries(const std::vector<EditEntry>& entries, int selected, const QString& emptyText) {
  const bool sameRows = std::equal(entries.begin(), entries.end(), m_entries.begin(), m_entries.end(),
                                   [](const EditEntry& a, const EditEntry& b) { return a.name == b.name; });
  m_entries = entries;
  const QSignalBlocker blocker(m_list);
  // A slider that is dragged must not be taken out of the hand.
  if (!sameRows) rebuild();
  for (std::size_t i = 0; i < m_rows.size(); ++i) m_rows[i]->show(m_entries[i]);
  m_list->setCurrentRow(selected);
  m_list->setVisible(!m_entries.empty());
  m_empty->setText(emptyText);
  m_empty->setVisible(m_entries.empty());
  m_add->setEnabled(std::ranges::any_of(m_addMenu->actions(), &QAction::isEnabled));
  updateActions();
}

void EditStack::rebuild() {
  const QWidget* focus = focusWidget();
  const bool focused = focus && focus->hasFocus() && m_list->isAncestorOf(focus);
  m_list->clear();  // a row may be the sender: it goes when its event is done
  m_rows.clear();
  for (int i = 0; i < int(m_entries.size()); ++i) {
    auto* row = new EditRow;
    m_rows.push_back(row);
    connectRow(row, i);
    row->show(m_entries[std::size_t(i)]);
    auto* item = new QListWidgetItem(m_list);
    item->setData(Qt::AccessibleTextRole, m_entries[std::size_t(i)].name);
    item->setSizeHint({1, row->sizeHint().height()});
    m_list->setItemWidget(item, row);
  }
  m_list->updateGeometry();
  if (focused) m_list->setFocus();
}

void EditStack::connectRow(EditRow* row, int entry) {
  connect(row, &EditRow::enabledChosen, this, [=, this](bool enabled) { Q_EMIT enabledChosen(entry, enabled); });
  connect(row, &EditRow::editingStarted, this, &EditStack::editingStarted);
  connect(row, &EditRow::strengthEdited, this, [=, this](double to) { Q_EMIT strengthEdited(entry, to); });
  connect(row, &EditRow::editingFinished, this, &EditStack::editingFinished);
  connect(row, &EditRow::renamed, this, [=, this](const QString& name) { Q_EMIT renamed(entry, name); });
  connect(row, &EditRow::deleteRequested, this, [=, this] { Q_EMIT deleteRequested(entry); });
}

void EditStack::updateActions() {
  const int row = selected();
  for (QAction* action : {m_rename, m_duplicate, m_delete}) action->setEnabled(row >= 0);
  m_up->setEnabled(row > 0);
  m_down->setEnabled(row >= 0 && row + 1 < int(m_rows.size()));
}

void EditStack::beginRename(int entry) {
  if (entry >= 0 && entry < int(m_rows.size())) m_rows[std::size_t(entry)]->beginRename();
}

}  // namespace gonio::widgets

#include "moc_edit_stack.cpp"
