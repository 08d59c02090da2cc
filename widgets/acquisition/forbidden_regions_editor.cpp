// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/acquisition/forbidden_regions_editor.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/inputs/number_field.h"

namespace gonio::widgets {

namespace {

constexpr int rangeCount = 3, columnCount = 2 * rangeCount, visibleRows = 2;
/// A new row initially forbids light beyond this angle, for all viewers.
constexpr double newLowest = radians(80);

acquisition::AngleRange& rangeOf(acquisition::ForbiddenRegion& region, int column) {
  return column < 2 ? region.thetaI : column < 4 ? region.thetaO : region.azimuthDifference;
}

double largest(int column) { return column < 4 ? 90 : 180; }

}  // namespace

ForbiddenRegionsEditor::ForbiddenRegionsEditor(QWidget* parent)
    : QWidget(parent),
      m_table(new QTableWidget(0, columnCount)),
      m_add(new QPushButton(tr("Add"))),
      m_remove(new QPushButton(tr("Remove"))) {
  m_table->setHorizontalHeaderLabels({tr("θi ≥"), tr("θi ≤"), tr("θo ≥"), tr("θo ≤"), tr("Δφ ≥"), tr("Δφ ≤")});
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  m_table->horizontalHeader()->setMinimumSectionSize(0);
  m_table->verticalHeader()->hide();
  m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
  m_table->setSelectionMode(QAbstractItemView::SingleSelection);
  m_table->setAccessibleName(tr("Directions that the rig cannot reach, degrees"));
  m_table->setToolTip(tr(
      "Direction pairs with all three angles in the ranges of a row are not chosen.\nθi: polar angle of the light, "
      "θo: polar angle of the viewer, Δφ: angle between their azimuths (180°: side of the mirror direction); degrees"));
  m_table->setFixedHeight((visibleRows + 1) * fontMetrics().height() * 3 / 2 + 8);
  m_add->setToolTip(tr("Adds a row that excludes light beyond 80°; change its ranges as needed"));
  m_remove->setToolTip(tr("Removes the selected row"));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_add);
  buttons->addWidget(m_remove);
  buttons->addStretch();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_table);
  layout->addLayout(buttons);
  connect(m_table, &QTableWidget::cellChanged, this, &ForbiddenRegionsEditor::cellChanged);
  connect(m_add, &QPushButton::clicked, this, [this] {
    m_regions.emplace_back().thetaI.lowest = newLowest;
    fill();
    m_table->setCurrentCell(int(m_regions.size()) - 1, 0);
    Q_EMIT regionsEdited();
  });
  connect(m_remove, &QPushButton::clicked, this, [this] {
    const int row = std::max(0, m_table->currentRow());
    m_regions.erase(m_regions.begin() + row);
    fill();
    Q_EMIT regionsEdited();
  });
  fill();
}

void ForbiddenRegionsEditor::fill() {
  const QSignalBlocker blocker(m_table);
  m_table->setRowCount(int(m_regions.size()));
  for (int row = 0; row < m_table->rowCount(); ++row)
    for (int column = 0; column < columnCount; ++column) {
      const acquisition::AngleRange& range = rangeOf(m_regions[std::size_t(row)], column);
      auto* item = new QTableWidgetItem(formatNumber(degrees(column % 2 ? range.highest : range.lowest)));
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      m_table->setItem(row, column, item);
    }
  m_table->setVisible(!m_regions.empty());
  m_remove->setEnabled(!m_regions.empty());
}

void ForbiddenRegionsEditor::cellChanged(int row, int column) {
  bool isNumber = false;
  QString text = m_table->item(row, column)->text().remove(QStringLiteral("°")).trimmed();
  const double typed = text.replace(',', '.').toDouble(&isNumber);
  if (isNumber && typed >= 0 && typed <= largest(column)) {
    acquisition::AngleRange& range = rangeOf(m_regions[std::size_t(row)], column);
    (column % 2 ? range.highest : range.lowest) = radians(typed);
    if (range.lowest > range.highest) std::swap(range.lowest, range.highest);
    Q_EMIT regionsEdited();
  }
  fill();
}

}  // namespace gonio::widgets

#include "moc_forbidden_regions_editor.cpp"
