// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/comparison_bar.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QStandardItemModel>
#include <QToolButton>

#include "widgets/inputs/icons.h"
#include "widgets/inputs/number_field.h"
#include "widgets/library/material_drag.h"

namespace gonio::widgets {

namespace {

constexpr double minScale = 1e-6, maxScale = 1e6;
/// The last entry of the lists: chooses a file.
constexpr int otherMaterialEntry = 4;

QHBoxLayout* rowLayout(QWidget* row) {
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(6, 2, 6, 2);
  return layout;
}

}  // namespace

ComparisonBar::ComparisonBar(QWidget* parent) : QWidget(parent) {
  setAcceptDrops(true);
  setAccessibleName(tr("Comparison"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 2, 0, 2);
  layout->setSpacing(0);
  layout->addWidget(buildModes());
  layout->addWidget(m_sideRow = buildSides());
  layout->addWidget(m_differenceRow = buildDifference());
  refresh();
}

QWidget* ComparisonBar::buildModes() {
  auto* row = new QWidget(this);
  auto* layout = rowLayout(row);
  layout->setSpacing(2);
  layout->addWidget(new QLabel(tr("Compare"), row));
  m_modes = new QButtonGroup(row);
  const std::tuple<CompareMode, const char*, QString, QString> modes[] = {
      {CompareMode::off, "one", tr("Off"), tr("Shows one image")},
      {CompareMode::split, "split", tr("Split"),
       tr("Shows the first side left and the second side right of a bar; drag the bar to move the split")},
      {CompareMode::flicker, "flicker", tr("Flicker"),
       tr("Shows the first side, and the second side while \\ or the button is held")},
      {CompareMode::difference, "difference", tr("Difference"), tr("Shows the luminance difference in false colour")},
      {CompareMode::twoUp, "side-by-side", tr("Side by side"),
       tr("Shows both sides next to each other, with the same camera")}};
  for (const auto& [mode, icon, text, toolTip] : modes) {
    auto* button = new QToolButton(row);
    button->setText(text);
    button->setIcon(themedIcon(QString::fromLatin1(icon)));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setToolTip(mode == CompareMode::off ? toolTip : tr("%1 (C switches it on and off)").arg(toolTip));
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    m_modes->addButton(button, int(mode));
    layout->addWidget(button);
  }
  layout->addStretch();
  connect(m_modes, &QButtonGroup::idClicked, this, [this](int id) {
    m_comparison.mode = CompareMode(id);
    emitComparison();
  });
  return row;
}

QWidget* ComparisonBar::buildSides() {
  auto* row = new QWidget(this);
  auto* layout = rowLayout(row);
  for (int side = 0; side < 2; ++side) {
    auto* list = m_sides[std::size_t(side)] = new QComboBox(row);
    list->setAccessibleName(side == 0 ? tr("First side") : tr("Second side"));
    list->setToolTip(side == 0 ? tr("First side: shown left, or while no key is held")
                               : tr("Second side, the reference: shown right, or while \\ is held"));
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    list->setMinimumContentsLength(8);
    for (int i = 0; i <= otherMaterialEntry; ++i) list->addItem({});
    list->setItemText(otherMaterialEntry, tr("Another material..."));
    connect(list, &QComboBox::activated, this, [this, side] { emitSides(side); });
    layout->addWidget(list, 1);
    if (side == 0) layout->addWidget(new QLabel(tr("against"), row));
  }
  auto* swap = new QToolButton(row);
  swap->setIcon(themedIcon(QStringLiteral("exchange")));
  swap->setToolTip(tr("Exchanges the sides"));
  swap->setAccessibleName(tr("Exchange the sides"));
  swap->setAutoRaise(true);
  swap->setFocusPolicy(Qt::StrongFocus);
  connect(swap, &QToolButton::clicked, this, [this] { Q_EMIT sidesEdited(m_chosen[1], m_chosen[0]); });
  layout->addWidget(swap);
  m_hold = new QPushButton(tr("Hold: \\"), row);
  m_hold->setToolTip(tr("Shows the second side while it is held, as the key \\ does"));
  connect(m_hold, &QPushButton::pressed, this, [this] { Q_EMIT flickerHeld(true); });
  connect(m_hold, &QPushButton::released, this, [this] { Q_EMIT flickerHeld(false); });
  layout->addWidget(m_hold);
  return row;
}

QWidget* ComparisonBar::buildDifference() {
  auto* row = new QWidget(this);
  auto* layout = rowLayout(row);
  m_kind = new QComboBox(row);
  m_kind->setAccessibleName(tr("Kind of difference"));
  m_kind->addItems({tr("Absolute"), tr("Signed"), tr("Relative")});
  for (int i = 0; i < m_kind->count(); ++i) m_kind->setItemData(i, differenceTitle(DifferenceKind(i)), Qt::ToolTipRole);
  m_kind->setToolTip(
      tr("Luminance difference that is shown\nAbsolute: |first − second|\nSigned: first − second\n"
         "Relative: |first − second| / second"));
  connect(m_kind, &QComboBox::activated, this, [this](int kind) {
    m_comparison.difference = DifferenceKind(kind);
    m_comparison.range = 0;
    emitComparison();
  });
  m_automatic = new QCheckBox(tr("Automatic maximum"), row);
  m_automatic->setToolTip(tr("Sets the maximum of the scale to the 99.5th percentile of the differences, rounded up"));
  connect(m_automatic, &QCheckBox::clicked, this, [this](bool automatic) {
    m_comparison.range = automatic ? 0 : m_range->value();
    emitComparison();
  });
  m_range = new NumberField(row);
  m_range->setAccessibleName(tr("Scale maximum"));
  m_range->setToolTip(tr("Luminance difference at the maximum of the colour scale; lower it to see small differences"));
  m_range->setRange(minScale, maxScale);
  connect(m_range, &NumberField::valueEdited, this, [this](double range) {
    m_comparison.range = range;
    emitComparison();
  });
  layout->addWidget(m_kind, 1);
  layout->addWidget(m_automatic);
  layout->addWidget(m_range);
  return row;
}

void ComparisonBar::setSubjects(const std::array<QString, 4>& names) {
  if (m_names == names) return;
  m_names = names;
  for (QComboBox* list : m_sides) {
    auto* items = qobject_cast<QStandardItemModel*>(list->model());
    const QString fallback[] = {tr("Measured"), tr("Fit"), tr("Edited"), tr("Other material (none)")};
    for (int i = 0; i < otherMaterialEntry; ++i) {
      const QString& name = names[std::size_t(i)];
      list->setItemText(i, name.isEmpty() ? fallback[i] : name);
      items->item(i)->setEnabled(!name.isEmpty());
    }
  }
}

void ComparisonBar::setSides(ComparedSubject first, ComparedSubject second) {
  m_chosen = {first, second};
  m_sides[0]->setCurrentIndex(int(first));
  m_sides[1]->setCurrentIndex(int(second));
}

void ComparisonBar::setComparison(const PreviewComparison& comparison) {
  m_comparison = comparison;
  refresh();
}

void ComparisonBar::setFoundRange(double range) {
  if (m_comparison.range == 0) m_range->setValue(range);
}

void ComparisonBar::emitSides(int changed) {
  const int entry = m_sides[std::size_t(changed)]->currentIndex();
  const auto before = m_chosen;
  setSides(before[0], before[1]);  // until it is set otherwise
  if (entry == otherMaterialEntry) return referenceRequested();
  auto after = before;
  after[std::size_t(changed)] = ComparedSubject(entry);
  // Choosing the other side's subject exchanges the two.
  if (after[0] == after[1]) after[std::size_t(1 - changed)] = before[std::size_t(changed)];
  Q_EMIT sidesEdited(after[0], after[1]);
}

void ComparisonBar::emitComparison() {
  refresh();
  Q_EMIT comparisonEdited(m_comparison);
}

void ComparisonBar::refresh() {
  m_modes->button(int(m_comparison.mode))->setChecked(true);
  m_sideRow->setVisible(m_comparison.mode != CompareMode::off);
  m_differenceRow->setVisible(m_comparison.mode == CompareMode::difference);
  m_hold->setVisible(m_comparison.mode == CompareMode::flicker);
  m_kind->setCurrentIndex(int(m_comparison.difference));
  m_automatic->setChecked(m_comparison.range == 0);
  const bool relative = m_comparison.difference == DifferenceKind::relative;
  m_range->setUnit(relative ? QStringLiteral("%") : QString(), relative ? 100 : 1);
  if (m_comparison.range > 0) m_range->setValue(m_comparison.range);
}

void ComparisonBar::dragEnterEvent(QDragEnterEvent* event) {
  if (!draggedMaterial(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void ComparisonBar::dropEvent(QDropEvent* event) {
  const QString file = draggedMaterial(event->mimeData());
  if (file.isEmpty()) return;
  event->acceptProposedAction();
  Q_EMIT referenceDropped(file);
}

}  // namespace gonio::widgets

#include "moc_comparison_bar.cpp"
