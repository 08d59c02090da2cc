// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/fit_ranking_model.h"

#include <QFont>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/gonio/comparison/comparison_numbers.h"
#include "app/gonio/library/thumbnail.h"
#include "core/io/csv_text.h"
#include "widgets/inputs/plain_text_style.h"
#include "widgets/panels/model_panel.h"
#include "widgets/parameters/formula_text.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {

constexpr int thumbnailSide = 96;

QIcon thumbnailOf(const Image& picture) {
  if (picture.width == 0) return {};
  const QPixmap pixmap = QPixmap::fromImage(
      displayedImage(picture).scaled(thumbnailSide, thumbnailSide, Qt::KeepAspectRatio, Qt::SmoothTransformation));
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);  // a tinted one would be another material
  return icon;
}

/// Last where it is not a number.
double orLast(double value) { return std::isnan(value) ? std::numeric_limits<double>::infinity() : value; }

QString warningsText(const fitting::FitResult& fit) {
  QStringList lines;
  for (const std::string& warning : fit.warnings) lines << QString::fromStdString(warning);
  return lines.join('\n');
}

}  // namespace

void FitRankingModel::clear() {
  beginResetModel();
  m_rows.clear();
  endResetModel();
  Q_EMIT plottedChanged();
}

void FitRankingModel::add(const study::RankedFit& ranked) {
  Row row{ranked, thumbnailOf(ranked.picture)};
  row.ranked.picture = {};
  const auto known = std::find_if(m_rows.begin(), m_rows.end(),
                                  [&](const Row& other) { return other.ranked.fit.model == ranked.fit.model; });
  const int place = int(known - m_rows.begin());
  if (known != m_rows.end()) {
    row.plotted = known->plotted;
    *known = std::move(row);
    Q_EMIT dataChanged(index(place, 0), index(place, ColumnCount - 1));
    if (known->plotted) Q_EMIT plottedChanged();
    return;
  }
  beginInsertRows({}, place, place);
  m_rows.push_back(std::move(row));
  endInsertRows();
}

std::vector<const fitting::FitResult*> FitRankingModel::plotted() const {
  std::vector<const fitting::FitResult*> fits;
  for (const Row& row : m_rows)
    if (row.plotted) fits.push_back(&row.ranked.fit);
  return fits;
}

bool FitRankingModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::CheckStateRole || index.column() != PlotColumn) return false;
  m_rows[std::size_t(index.row())].plotted = value.toInt() == Qt::Checked;
  Q_EMIT dataChanged(index, index);
  Q_EMIT plottedChanged();
  return true;
}

Qt::ItemFlags FitRankingModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  return index.column() == PlotColumn ? flags | Qt::ItemIsUserCheckable : flags;
}

void FitRankingModel::setMetric(metrics::BrdfMetric metric) {
  m_metric = metric;
  Q_EMIT headerDataChanged(Qt::Horizontal, ErrorColumn, ErrorColumn);
  if (!m_rows.empty()) Q_EMIT dataChanged(index(0, ErrorColumn), index(rowCount() - 1, ErrorColumn));
}

void FitRankingModel::setCurrent(const models::Model* model) {
  if (model == m_current) return;
  m_current = model;
  if (!m_rows.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

QString FitRankingModel::csv() const {
  io::CsvTable table;
  const auto texts = [&](const std::string& title, auto text) {
    io::CsvColumn& column = table.columns.emplace_back(io::CsvColumn{title, {}});
    for (const Row& row : m_rows) column.texts.emplace_back(text(row.ranked));
  };
  const auto numbers = [&](const std::string& title, auto number) {
    io::CsvColumn& column = table.columns.emplace_back(io::CsvColumn{title, {}});
    for (const Row& row : m_rows) column.values.push_back(double(number(row.ranked)));
  };
  using R = const study::RankedFit&;
  texts("model", [](R ranked) { return ranked.fit.model->spec().id; });
  numbers("rendered SNR [dB]", [](R ranked) { return ranked.renderedSnr; });
  numbers("parameters", [](R ranked) { return ranked.parameterCount; });
  numbers("time [s]", [](R ranked) { return ranked.fit.seconds; });
  const auto records = metrics::metricRecords();
  for (std::size_t i = 0; i < records.size(); ++i) {
    const std::string unit = records[i].unit.empty() ? "" : " [" + std::string(records[i].unit) + "]";
    numbers(std::string(records[i].id) + unit, [i](R ranked) { return ranked.fit.errors[i]; });
  }
  return QString::fromStdString(io::toCsv(table));
}

int FitRankingModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_rows.size()); }

int FitRankingModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

double FitRankingModel::error(const Row& row) const {
  const auto metrics = metrics::allBrdfMetrics();
  const auto at = std::size_t(std::find(metrics.begin(), metrics.end(), m_metric) - metrics.begin());
  return at < row.ranked.fit.errors.size() ? row.ranked.fit.errors[at] : std::numeric_limits<double>::quiet_NaN();
}

QVariant FitRankingModel::text(const Row& row, int column) const {
  const fitting::FitResult& fit = row.ranked.fit;
  switch (column) {
    case NameColumn: {
      const QString name = widgets::toQString(fit.model->spec().name);
      return fit.model == m_current ? tr("%1 (in use)").arg(name) : name;
    }
    case ErrorColumn:
      return comparisonValue(error(row));
    case SnrColumn:
      return comparisonValue(row.ranked.renderedSnr);
    case ParametersColumn:
      return qulonglong(row.ranked.parameterCount);
    case SecondsColumn:
      return QString::number(fit.seconds, 'f', 2);
    case WarningsColumn:
      return fit.warnings.empty() ? QString() : tr("⚠ %1").arg(warningsText(fit).replace('\n', ' '));
  }
  return {};
}

QVariant FitRankingModel::sortKey(const Row& row, int column) const {
  switch (column) {
    case PlotColumn:
      return !row.plotted;
    case ErrorColumn:
      return orLast(error(row));
    case SnrColumn:
      return orLast(-row.ranked.renderedSnr);
    case ParametersColumn:
      return qulonglong(row.ranked.parameterCount);
    case SecondsColumn:
      return row.ranked.fit.seconds;
    case WarningsColumn:
      return qulonglong(row.ranked.fit.warnings.size());
  }
  return widgets::toQString(row.ranked.fit.model->spec().name);
}

QVariant FitRankingModel::data(const QModelIndex& index, int role) const {
  const Row& row = m_rows[std::size_t(index.row())];
  const int column = index.column();
  if (role == Qt::DisplayRole) return text(row, column);
  if (role == Qt::UserRole) return sortKey(row, column);
  if (role == Qt::CheckStateRole && column == PlotColumn) return row.plotted ? Qt::Checked : Qt::Unchecked;
  if (role == Qt::DecorationRole && column == NameColumn) return row.thumbnail;
  if (role == Qt::ToolTipRole && column == WarningsColumn) return warningsText(row.ranked.fit);
  if (role == widgets::richToolTipRole && column != WarningsColumn)
    return widgets::modelToolTip(row.ranked.fit.model->spec());
  if (role == Qt::FontRole && row.ranked.fit.model == m_current) {
    QFont bold;
    bold.setBold(true);
    return bold;
  }
  if (role == Qt::TextAlignmentRole && column != NameColumn && column != PlotColumn && column != WarningsColumn)
    return int(Qt::AlignRight | Qt::AlignVCenter);
  return {};
}

QVariant FitRankingModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const metrics::MetricRecord& record = metrics::metricRecord(m_metric);
  if (role == Qt::DisplayRole) {
    const QString unit = widgets::toQString(record.unit);
    const QString titles[] = {tr("Model"),
                              tr("Plot"),
                              unit.isEmpty() ? tr("Error") : tr("Error [%1]").arg(unit),
                              tr("Rendered SNR [dB]"),
                              tr("Parameters"),
                              tr("Time [s]"),
                              tr("Warnings")};
    return titles[section];
  }
  if (role == widgets::richToolTipRole && section == ErrorColumn)
    return tr("<p>%1: %2. Smaller is better.</p>")
        .arg(widgets::toQString(record.name), widgets::formulaHtml(record.formula));
  if (role == Qt::ToolTipRole) {
    const QString tips[] = {
        tr("The model, rendered with its fitted parameters"),
        tr("Ticked fits are shown in the plots in addition to the one in use"),
        QString(),  // rich
        tr("Rendered SNR of the image in the comparison scene (bundled scene \"sphere\"). Larger is better."),
        tr("Number of values that the fit determines"),
        tr("Time of the fit, seconds"),
        tr("Warnings of the fit about the measurement")};
    return tips[section];
  }
  return {};
}

}  // namespace gonio::app

#include "moc_fit_ranking_model.cpp"
