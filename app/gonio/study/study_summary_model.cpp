// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/study_summary_model.h"

#include <QPalette>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/gonio/comparison/comparison_numbers.h"
#include "core/study/study_plot.h"
#include "core/study/study_record.h"

namespace gonio::app {

void StudySummaryModel::plan(const std::vector<study::Representation>& representations) {
  beginResetModel();
  m_rows = representations;
  for (std::vector<study::StudyRecord>& records : m_records)
    std::erase_if(records,
                  [&](const study::StudyRecord& record) { return !std::ranges::count(m_rows, record.representation); });
  m_summaries = study::summarise(m_records);
  endResetModel();
}

void StudySummaryModel::add(std::size_t material, const study::StudyRecord& record) {
  const auto row = std::ranges::find(m_rows, record.representation);
  if (row == m_rows.end()) return;
  m_records[material].push_back(record);
  m_summaries = study::summarise(m_records);
  const int place = int(row - m_rows.begin());
  Q_EMIT dataChanged(index(place, 0), index(place, ColumnCount - 1));
}

std::vector<study::Representation> StudySummaryModel::missing(std::size_t material) const {
  std::vector<study::Representation> result = m_rows;
  for (const study::StudyRecord& record : m_records[material]) std::erase(result, record.representation);
  return result;
}

QString StudySummaryModel::csv(const study::MachineFacts& machine, const std::string& pictures) const {
  std::string title = "medians over " + std::to_string(m_materials.size()) + " materials:";
  for (const std::string& name : m_materials) title += " " + name;
  return QString::fromStdString(io::toCsv(summaryCsv(title, m_summaries, m_materials, machine, pictures)));
}

const study::StudySummary* StudySummaryModel::summaryOf(int row) const {
  const auto found = std::ranges::find(m_summaries, m_rows[std::size_t(row)],
                                       [](const study::StudySummary& one) { return one.median.representation; });
  return found == m_summaries.end() ? nullptr : &*found;
}

int StudySummaryModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_rows.size()); }

int StudySummaryModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QString StudySummaryModel::text(const study::StudySummary& summary, int column) const {
  const auto number = [](double value) { return QString::fromStdString(study::shortNumber(value)); };
  const study::StudyRecord& median = summary.median;
  switch (column) {
    case MaterialsColumn:
      return QString::number(summary.materials);
    case MedianSnrColumn:
      return comparisonValue(median.renderedSnr);
    case WorstSnrColumn:
      return comparisonValue(summary.minSnr);
    case WorstMaterialColumn:
      return QString::fromStdString(m_materials[summary.worst]);
    case BytesColumn:
      return number(double(median.bytes));
    case EvaluationColumn:
      return number(median.evaluation.median);
    case FrameColumn:
      return number(median.frameMilliseconds);
    case EncodingColumn:
      return median.encodeSeconds > 0 ? number(median.encodeSeconds) : tr("none");
  }
  return {};
}

QVariant StudySummaryModel::sortKey(int row, int column) const {
  const study::Representation& representation = m_rows[std::size_t(row)];
  // Budgets by their size, not by their first digit.
  if (column == NameColumn)
    return QStringLiteral("%1 %2")
        .arg(QString::fromStdString(representation.label()))
        .arg(representation.budget, 9, 'f', 0);
  const study::StudySummary* summary = summaryOf(row);
  if (column == WorstMaterialColumn) return summary ? text(*summary, column) : QString(QChar(0xffff));
  constexpr double last = std::numeric_limits<double>::infinity();
  if (!summary) return last;
  const study::StudyRecord& median = summary->median;
  const double keys[] = {0,
                         -double(summary->materials),
                         -median.renderedSnr,
                         -summary->minSnr,
                         0,
                         double(median.bytes),
                         median.evaluation.median,
                         median.frameMilliseconds,
                         median.encodeSeconds};
  return std::isnan(keys[column]) ? last : keys[column];
}

QVariant StudySummaryModel::data(const QModelIndex& index, int role) const {
  const int row = index.row(), column = index.column();
  if (role == Qt::DisplayRole && column == NameColumn)
    return QString::fromStdString(m_rows[std::size_t(row)].fullLabel());
  if (role == Qt::UserRole) return sortKey(row, column);
  if (role == Qt::TextAlignmentRole && column != NameColumn && column != WorstMaterialColumn)
    return int(Qt::AlignRight | Qt::AlignVCenter);
  const study::StudySummary* summary = summaryOf(row);
  if (role == Qt::DisplayRole) return summary ? text(*summary, column) : QStringLiteral("-");
  if (role == Qt::ForegroundRole && !summary) return QPalette().brush(QPalette::PlaceholderText);
  return {};
}

QVariant StudySummaryModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::DisplayRole) {
    const QString titles[] = {tr("Representation"),          tr("Materials"),      tr("Median rendered SNR [dB]"),
                              tr("Worst rendered SNR [dB]"), tr("Worst material"), tr("Size [B]"),
                              tr("Evaluation [ns]"),         tr("Frame [ms]"),     tr("Encoding [s]")};
    return titles[section];
  }
  if (role == Qt::ToolTipRole) {
    const QString tips[] = {
        tr("Representation of the materials at one budget"),
        tr("Number of materials measured with this representation"),
        tr("Median of the rendered SNR over the materials. Larger is better."),
        tr("Smallest rendered SNR of all materials. Larger is better."),
        tr("The material with the smallest rendered SNR"),
        tr("Median size over the materials: size of the file; of a table: its size in memory; of a fit: the size of "
           "its parameters. Dictionaries are not counted."),
        tr("Median over the materials: processor time of one evaluation on one thread, in batches"),
        tr("Median over the materials: time of one frame in the reference renderer on the CPU"),
        tr("Median over the materials: time to compute the representation from the table, seconds")};
    return tips[section];
  }
  return {};
}

}  // namespace gonio::app

#include "moc_study_summary_model.cpp"
