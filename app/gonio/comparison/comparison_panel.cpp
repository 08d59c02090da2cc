// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/comparison/comparison_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include "app/gonio/comparison/comparison_controller.h"
#include "widgets/inputs/plain_text_style.h"
#include "widgets/parameters/formula_text.h"

namespace gonio::app {

namespace {
const QString comparisonKey = QStringLiteral("comparison");
/// After the last change: while the hand moves nothing is measured.
constexpr int comparisonDelayMilliseconds = 250;
constexpr int columnCount = 4, valueColumn = 1, unitColumn = 2, meaningColumn = 3;

struct Measured {
  ComparisonReferencePtr reference;
  ComparisonNumbers numbers;
};
}  // namespace

ComparisonPanel::ComparisonPanel(ComparisonController& comparison, BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent),
      m_comparison(comparison),
      m_tasks(tasks),
      m_title(new QLabel(this)),
      m_table(new QTableWidget(0, columnCount, this)),
      m_copy(new QPushButton(tr("Copy as &CSV"), this)) {
  m_title->setWordWrap(true);
  m_title->setTextFormat(Qt::PlainText);
  m_table->setHorizontalHeaderLabels({tr("Quantity"), tr("Value"), tr("Unit"), tr("Meaning")});
  m_table->verticalHeader()->hide();
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_table->horizontalHeader()->setStretchLastSection(true);
  m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->setShowGrid(false);
  m_table->setTabKeyNavigation(false);
  m_table->setAccessibleName(tr("Comparison results"));
  m_copy->setToolTip(tr("Copies every number with its unit, as comma-separated text"));
  auto* top = new QHBoxLayout;
  top->addWidget(m_title, 1);
  top->addWidget(m_copy, 0, Qt::AlignTop);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addLayout(top);
  layout->addWidget(m_table, 1);
  m_delay.setSingleShot(true);
  m_delay.setInterval(comparisonDelayMilliseconds);
  connect(&m_delay, &QTimer::timeout, this, &ComparisonPanel::measure);
  connect(m_copy, &QPushButton::clicked, this, &ComparisonPanel::copy);
  connect(&comparison, &ComparisonController::subjectsChanged, this, &ComparisonPanel::subjectsChanged);
  subjectsChanged();
}

bool ComparisonPanel::hasBoth() const {
  const auto sides = m_comparison.sides();
  return !m_comparison.subject(sides[0]).isEmpty() && !m_comparison.subject(sides[1]).isEmpty();
}

bool ComparisonPanel::isSettled() const { return m_current || !isVisible() || !hasBoth(); }

void ComparisonPanel::subjectsChanged() {
  const auto sides = m_comparison.sides();
  m_current = false;
  m_tasks.drop(comparisonKey);
  if (!hasBoth()) m_numbers.reset();
  m_title->setText(
      hasBoth() ? tr("%1 against %2, comparison scene").arg(m_comparison.name(sides[0]), m_comparison.name(sides[1]))
                : tr("Open and fit a material to compare it with its fit."));
  showNumbers();
  if (isVisible()) m_delay.start();
}

void ComparisonPanel::showEvent(QShowEvent*) {
  if (!m_current) m_delay.start();
}

void ComparisonPanel::measure() {
  if (!hasBoth() || m_current) return;
  const auto sides = m_comparison.sides();
  const widgets::PreviewSubject test = m_comparison.subject(sides[0]), against = m_comparison.subject(sides[1]);
  const bool known = m_reference && sameSubject(m_reference->subject, against);
  m_tasks.run<Measured>(
      {tr("Comparing"), comparisonKey, false, true},
      [test, against, reference = known ? m_reference : nullptr](const TaskControl& control) {
        Measured measured;
        measured.reference = reference ? reference : comparisonReference(against, control);
        measured.numbers = compareSubjects(test, *measured.reference, control);
        return measured;
      },
      [this](const Measured& measured) {
        m_reference = measured.reference;
        m_numbers = measured.numbers;
        m_current = true;
        m_shown.reset();  // other values
        showNumbers();
      },
      [this](const QString& error) {
        m_current = true;
        m_title->setText(error);
      });
}

/// Fills the table if something else is to be shown: a slider that moves leaves outdated numbers as they are.
void ComparisonPanel::showNumbers() {
  const Shown shown{hasBoth(), m_numbers.has_value(), m_current, isVisible()};
  if (shown == m_shown) return;
  m_shown = shown;
  fillTable(shown);
}

void ComparisonPanel::fillTable(const Shown& shown) {
  const auto lines = comparisonLines(m_numbers ? &*m_numbers : nullptr);
  m_table->setRowCount(shown.rows ? int(lines.size()) : 0);
  for (int row = 0; row < m_table->rowCount(); ++row) {
    const ComparisonLine& line = lines[std::size_t(row)];
    const QString value = shown.numbers     ? comparisonValue(line.value)
                          : shown.measuring ? tr("measuring...")
                                            : QString();
    const QString cells[] = {line.name, value, line.unit, line.meaning};
    for (int column = 0; column < columnCount; ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      if (line.formulaHtml.isEmpty())
        item->setToolTip(line.meaning);
      else
        item->setData(widgets::richToolTipRole, line.formulaHtml);
      if (column == valueColumn) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      // Grey: these are not the numbers of what is shown now.
      if (column == valueColumn && !shown.current)
        item->setForeground(palette().brush(QPalette::Disabled, QPalette::Text));
      m_table->setItem(row, column, item);
    }
    showFormula(row, line);
  }
  m_copy->setEnabled(shown.numbers && shown.current);
}

/// The formula of a metric and its unit are typeset by labels over their cells.
void ComparisonPanel::showFormula(int row, const ComparisonLine& line) {
  for (const auto& [column, text] : {std::pair(unitColumn, line.unit), {meaningColumn, line.meaning}}) {
    if (line.formulaHtml.isEmpty()) {
      m_table->removeCellWidget(row, column);
      continue;
    }
    m_table->item(row, column)->setText({});
    m_table->item(row, column)->setData(Qt::AccessibleTextRole, text);
    auto* label = qobject_cast<QLabel*>(m_table->cellWidget(row, column));
    if (!label) m_table->setCellWidget(row, column, label = new QLabel);
    label->setTextFormat(Qt::RichText);
    label->setContentsMargins(3, 0, 3, 0);
    label->setText(widgets::formulaHtml(text.toStdString()));
    widgets::setRichToolTip(*label, line.formulaHtml);
  }
}

void ComparisonPanel::copy() {
  const auto sides = m_comparison.sides();
  if (m_numbers)
    QApplication::clipboard()->setText(
        comparisonCsv(*m_numbers, m_comparison.name(sides[0]), m_comparison.name(sides[1])));
}

}  // namespace gonio::app

#include "moc_comparison_panel.cpp"
