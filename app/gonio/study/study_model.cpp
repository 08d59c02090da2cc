// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/study_model.h"

#include <QBuffer>
#include <QFont>
#include <QLocale>
#include <QPalette>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/gonio/comparison/comparison_numbers.h"
#include "app/gonio/library/thumbnail.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/inputs/plain_text_style.h"
#include "widgets/panels/model_panel.h"
#include "widgets/parameters/formula_text.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {

constexpr int iconSide = 64;
constexpr double sortedLast = std::numeric_limits<double>::infinity();

/// "1.2k", as in the plot.
QString shortText(double value) { return QString::fromStdString(study::shortNumber(value)); }

QString asHtmlImage(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  image.save(&buffer, "PNG");
  return QStringLiteral("<img src=\"data:image/png;base64,%1\"/>").arg(QString::fromLatin1(bytes.toBase64()));
}

QIcon iconOf(const QImage& picture) {
  const QPixmap pixmap =
      QPixmap::fromImage(picture.scaled(iconSide, iconSide, Qt::KeepAspectRatio, Qt::SmoothTransformation));
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);  // a tinted one would be another material
  return icon;
}

/// As large as the icon of a row that is measured, so that all names are aligned.
const QIcon& blankIcon() {
  static const QIcon icon = [] {
    QPixmap pixmap(iconSide, iconSide);
    pixmap.fill(Qt::transparent);
    return QIcon(pixmap);
  }();
  return icon;
}

QString warningsOf(const fitting::FitResult& fit) {
  QStringList lines;
  for (const std::string& warning : fit.warnings) lines << QString::fromStdString(warning);
  return lines.join('\n');
}

}  // namespace

void StudyModel::setMaterials(std::vector<std::string> names, const std::vector<int>& before) {
  beginResetModel();
  const auto rows = std::exchange(m_rows, {});
  const auto records = std::exchange(m_records, {});
  m_materials = std::move(names);
  for (const Row& row : rows) m_rows.push_back({row.representation});
  dropResults();
  for (std::size_t i = 0; i < m_materials.size(); ++i) {
    if (before[i] < 0) continue;
    const auto was = std::size_t(before[i]);
    m_records[i] = records[was];
    for (std::size_t row = 0; row < rows.size(); ++row)
      if (was < rows[row].studied.size()) keep(m_rows[row], i, rows[row].studied[was]);
    // Of many materials only numbers were kept; a few have pictures, too.
    if (m_materials.size() <= maxKeptMaterials)
      std::erase_if(m_records[i], [&](const study::StudyRecord& record) {
        const auto row = std::ranges::find(m_rows, record.representation, &Row::representation);
        return row == m_rows.end() || i >= row->studied.size() || !row->studied[i];
      });
  }
  for (Row& row : m_rows) showPicture(row);
  summariseAgain();
  endResetModel();
  Q_EMIT plottedChanged();
}

StudyModel::Studied StudyModel::studied(int row, std::size_t material) const {
  const std::vector<Studied>& kept = m_rows[std::size_t(row)].studied;
  return material < kept.size() ? kept[material] : nullptr;
}

void StudyModel::keep(Row& row, std::size_t material, const Studied& studied) {
  if (material >= maxKeptMaterials) return;
  row.studied.resize(std::max(row.studied.size(), material + 1));
  row.studied[material] = studied;
}

void StudyModel::showPicture(Row& row) const {
  const Studied first = isSummary() || row.studied.empty() ? nullptr : row.studied[0];
  if (!first || first->picture.width == 0) return;
  row.picture = displayedImage(first->picture);
  row.icon = iconOf(row.picture);
}

bool StudyModel::isShown(int column) const {
  switch (column) {
    case MaterialsColumn:
    case WorstSnrColumn:
    case WorstMaterialColumn:
      return isSummary();
    case PlotColumn:
    case ErrorColumn:
    case WarningsColumn:
      return !isSummary();
    default:
      return true;
  }
}

void StudyModel::dropResults() {
  for (Row& row : m_rows) row = {row.representation};
  m_records.assign(m_materials.size(), {});
  m_again.assign(m_materials.size(), {});
  m_outdated = false;
  m_shown = m_best = -1;
  summariseAgain();
}

void StudyModel::summariseAgain() { m_summaries = study::summarise(m_records); }

void StudyModel::plan(const std::vector<study::Representation>& representations) {
  const bool hadPlots = !plotted().empty();
  beginResetModel();
  std::vector<Row> rows;
  for (const study::Representation& representation : representations) {
    const auto known = std::ranges::find(m_rows, representation, &Row::representation);
    rows.push_back(known == m_rows.end() ? Row{representation} : *known);
  }
  m_rows = std::move(rows);
  for (auto& records : m_records)
    std::erase_if(records, [&](const study::StudyRecord& record) {
      return !std::ranges::count(m_rows, record.representation, &Row::representation);
    });
  m_shown = m_best = -1;
  summariseAgain();
  endResetModel();
  if (hadPlots) Q_EMIT plottedChanged();
}

void StudyModel::outdate() {
  const bool hadPlots = !plotted().empty();
  for (Row& row : m_rows) row.plotted = false;
  m_outdated = !isEmpty();
  m_shown = m_best = -1;
  refreshRows();
  if (hadPlots) Q_EMIT plottedChanged();
}

void StudyModel::requestAgain(const std::vector<study::Representation>& representations) {
  m_again.assign(m_materials.size(), representations);
}

std::vector<study::Representation> StudyModel::missing(std::size_t material, bool timed) const {
  std::vector<study::Representation> result;
  for (const Row& row : m_rows) {
    const auto& records = m_records[material];
    const auto known = std::ranges::find(records, row.representation, &study::StudyRecord::representation);
    if (m_outdated || known == records.end() || (timed && std::isnan(known->frameMilliseconds)) ||
        std::ranges::count(m_again[material], row.representation))
      result.push_back(row.representation);
  }
  return result;
}

void StudyModel::add(std::size_t material, const Studied& studied) {
  const study::Representation& representation = studied->record.representation;
  const auto row = std::ranges::find(m_rows, representation, &Row::representation);
  if (row == m_rows.end()) return;
  if (m_outdated) {
    dropResults();
    refreshRows();
  }
  auto& records = m_records[material];
  std::erase(m_again[material], representation);
  std::erase_if(records, [&](const study::StudyRecord& one) { return one.representation == representation; });
  records.push_back(studied->record);
  if (m_materials.size() <= maxKeptMaterials) keep(*row, material, studied);
  showPicture(*row);
  summariseAgain();
  const int place = int(row - m_rows.begin());
  Q_EMIT dataChanged(index(place, 0), index(place, ColumnCount - 1));
  if (row->plotted) Q_EMIT plottedChanged();
}

const study::StudySummary* StudyModel::summaryOf(int row) const {
  const auto found = std::ranges::find(m_summaries, representation(row),
                                       [](const study::StudySummary& one) { return one.median.representation; });
  return found == m_summaries.end() ? nullptr : &*found;
}

const fitting::FitResult* StudyModel::fitOf(int row) const {
  const Studied one = isSummary() ? nullptr : studied(row);
  return one && one->fit ? &*one->fit : nullptr;
}

std::vector<study::StudyRecord> StudyModel::records(const std::vector<int>& rows) const {
  std::vector<study::StudyRecord> result;
  for (const int row : rows)
    if (isMeasured(row)) result.push_back(record(row));
  return result;
}

QString StudyModel::csv(const std::vector<int>& rows, const std::string& title, const study::MachineFacts& machine,
                        const std::string& pictures) const {
  if (!isSummary())
    return QString::fromStdString(io::toCsv(study::studyCsv("material: " + title, records(rows), machine, pictures)));
  std::string names = "medians over " + std::to_string(m_materials.size()) + " materials:";
  for (const std::string& name : m_materials) names += " " + name;
  std::vector<study::StudySummary> summaries;
  for (const int row : rows)
    if (const study::StudySummary* summary = summaryOf(row)) summaries.push_back(*summary);
  return QString::fromStdString(io::toCsv(study::summaryCsv(names, summaries, m_materials, machine, pictures)));
}

void StudyModel::refreshRows() {
  if (!m_rows.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

void StudyModel::setMetric(metrics::BrdfMetric metric) {
  m_metric = metric;
  Q_EMIT headerDataChanged(Qt::Horizontal, ErrorColumn, ErrorColumn);
  if (!m_rows.empty()) Q_EMIT dataChanged(index(0, ErrorColumn), index(rowCount() - 1, ErrorColumn));
}

void StudyModel::setMarks(int shown, int best) {
  if (shown == m_shown && best == m_best) return;
  m_shown = shown;
  m_best = best;
  refreshRows();
}

void StudyModel::setModelInUse(const models::Model* model) {
  if (std::exchange(m_inUse, model) != model) refreshRows();
}

std::vector<const fitting::FitResult*> StudyModel::plotted() const {
  std::vector<const fitting::FitResult*> fits;
  for (int row = 0; row < rowCount(); ++row)
    if (m_rows[std::size_t(row)].plotted && fitOf(row)) fits.push_back(fitOf(row));
  return fits;
}

QString StudyModel::nameOf(int row) const {
  const study::Representation& one = representation(row);
  QStringList marks;
  if (one.kind->model && one.kind->model == m_inUse) marks << tr("in use");
  if (row == m_shown) marks << tr("shown");
  if (row == m_best) marks << tr("best");
  const QString name = QString::fromStdString(one.shortLabel());
  return marks.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, marks.join(QStringLiteral(", ")));
}

QString StudyModel::toolTip(int row) const {
  if (!isMeasured(row)) return tr("Not measured yet");
  const study::StudyRecord& one = record(row);
  const auto nanoseconds = [](double value) { return widgets::secondsText(1e-9 * value); };
  QStringList lines{tr("<b>%1</b>").arg(QString::fromStdString(one.representation.fullLabel()).toHtmlEscaped()),
                    tr("rendered SNR %1 dB").arg(comparisonValue(one.renderedSnr))};
  if (!std::isnan(one.frameMilliseconds))
    lines << tr("%1 per evaluation (%2 to %3)")
                 .arg(nanoseconds(one.evaluation.median), nanoseconds(one.evaluation.lowerQuartile),
                      nanoseconds(one.evaluation.upperQuartile))
          << tr("%1 per frame").arg(widgets::secondsText(1e-3 * one.frameMilliseconds));
  lines << QLocale().formattedDataSize(qint64(one.bytes), 1, QLocale::DataSizeSIFormat)
        << tr("encoded in %1").arg(widgets::secondsText(one.encodeSeconds));
  const Row& shown = m_rows[std::size_t(row)];
  const QString picture = shown.picture.isNull() ? QString() : tr("<p>%1</p>").arg(asHtmlImage(shown.picture));
  const models::Model* model = one.representation.kind->model;
  return picture + tr("<p>%1</p>").arg(lines.join(QStringLiteral("<br>"))) +
         (model ? widgets::modelToolTip(model->spec()) : QString());
}

int StudyModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_rows.size()); }

int StudyModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QString StudyModel::text(int row, int column) const {
  if (column == NameColumn) return nameOf(row);
  const study::StudySummary* summary = summaryOf(row);
  if (column == PlotColumn) return {};
  if (!summary) return QStringLiteral("-");
  const study::StudyRecord& one = summary->median;
  switch (column) {
    case MaterialsColumn:
      return QString::number(summary->materials);
    case SnrColumn:
      return comparisonValue(one.renderedSnr);
    case WorstSnrColumn:
      return comparisonValue(summary->minSnr);
    case WorstMaterialColumn:
      return widgets::spacedName(QString::fromStdString(m_materials[summary->worst]));
    case ErrorColumn:
      return QString::number(study::qualityOf(one, m_metric), 'g', 3);
    case EvaluationColumn:
      return std::isnan(one.evaluation.median)
                 ? QStringLiteral("-")
                 : tr("%1 (%2–%3)")
                       .arg(shortText(one.evaluation.median), shortText(one.evaluation.lowerQuartile),
                            shortText(one.evaluation.upperQuartile));
    case FrameColumn:
      return shortText(one.frameMilliseconds);
    case BytesColumn:
      return shortText(double(one.bytes));
    case EncodingColumn:
      return one.encodeSeconds > 0 ? shortText(one.encodeSeconds) : tr("none");
    case ParametersColumn:
      return one.representation.kind->model ? QString::number(one.bytes / sizeof(float)) : QString();
    case WarningsColumn:
      if (const auto* fit = fitOf(row); fit && !fit->warnings.empty())
        return tr("⚠ %1").arg(warningsOf(*fit).replace('\n', ' '));
  }
  return {};
}

QVariant StudyModel::sortKey(int row, int column) const {
  const study::Representation& one = representation(row);
  if (column == NameColumn)  // budgets by their size, not by their first digit
    return QStringLiteral("%1 %2").arg(QString::fromStdString(one.label())).arg(one.budget, 9, 'f', 0);
  if (column == PlotColumn) return !m_rows[std::size_t(row)].plotted;
  const study::StudySummary* summary = summaryOf(row);
  if (column == WorstMaterialColumn) return summary ? text(row, column) : QString(QChar(0xffff));
  if (!summary) return sortedLast;
  const study::StudyRecord& record = summary->median;
  const auto key = [&]() -> double {
    switch (column) {
      case MaterialsColumn:
        return -double(summary->materials);
      case SnrColumn:
        return -record.renderedSnr;
      case WorstSnrColumn:
        return -summary->minSnr;
      case ErrorColumn:
        return study::qualityOf(record, m_metric);
      case EvaluationColumn:
        return record.evaluation.median;
      case FrameColumn:
        return record.frameMilliseconds;
      case BytesColumn:
        return double(record.bytes);
      case ParametersColumn:
        return one.kind->model ? double(record.bytes / sizeof(float)) : sortedLast;
      case WarningsColumn:
        return fitOf(row) ? double(fitOf(row)->warnings.size()) : 0;
      default:
        return record.encodeSeconds;
    }
  }();
  return std::isnan(key) ? sortedLast : key;
}

QVariant StudyModel::data(const QModelIndex& index, int role) const {
  const int row = index.row(), column = index.column();
  const Row& one = m_rows[std::size_t(row)];
  switch (role) {
    case Qt::DisplayRole:
      return text(row, column);
    case Qt::UserRole:
      return sortKey(row, column);
    case Qt::CheckStateRole:
      if (column == PlotColumn && fitOf(row) && !m_outdated) return one.plotted ? Qt::Checked : Qt::Unchecked;
      return {};
    case Qt::DecorationRole:
      if (column != NameColumn || isSummary()) return {};
      return one.icon.isNull() ? blankIcon() : one.icon;
    case Qt::ToolTipRole:
      return column == WarningsColumn && fitOf(row) ? warningsOf(*fitOf(row)) : QVariant();
    case widgets::richToolTipRole:
      return column == WarningsColumn ? QVariant() : toolTip(row);
    case Qt::ForegroundRole:
      return m_outdated || !isMeasured(row) ? QPalette().brush(QPalette::PlaceholderText) : QVariant();
    case Qt::FontRole:
      if (QFont bold; row == m_shown || (one.representation.kind->model && one.representation.kind->model == m_inUse)) {
        bold.setBold(true);
        return bold;
      }
      return {};
    case Qt::TextAlignmentRole:
      if (column == NameColumn || column == PlotColumn || column == WorstMaterialColumn || column == WarningsColumn)
        return {};
      return int(Qt::AlignRight | Qt::AlignVCenter);
    default:
      return {};
  }
}

bool StudyModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::CheckStateRole || index.column() != PlotColumn || !fitOf(index.row())) return false;
  m_rows[std::size_t(index.row())].plotted = value.toInt() == Qt::Checked;
  Q_EMIT dataChanged(index, index);
  Q_EMIT plottedChanged();
  return true;
}

Qt::ItemFlags StudyModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  const bool canPlot = index.column() == PlotColumn && fitOf(index.row()) && !m_outdated;
  return canPlot ? flags | Qt::ItemIsUserCheckable : flags;
}

QVariant StudyModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const metrics::MetricRecord& metric = metrics::metricRecord(m_metric);
  const QString unit = widgets::toQString(metric.unit);
  struct Header {
    QString title, toolTip;
  };
  const bool many = isSummary();
  const QString over = many ? tr("Median over the materials. ") : QString();
  const Header headers[ColumnCount] = {
      {tr("Representation"), many ? tr("Representation of the materials at one budget")
                                  : tr("Representation at one budget, with its rendered image")},
      {tr("Plot"), tr("Ticked fits are shown in the plots in addition to the one in use")},
      {tr("Materials"), tr("Number of materials measured with this representation")},
      {many ? tr("Median SNR [dB]") : tr("Rendered SNR [dB]"),
       over + tr("Rendered SNR of the image in the comparison scene (bundled scene \"sphere\"). Larger is better.")},
      {tr("Worst SNR [dB]"), tr("Smallest rendered SNR of all materials. Larger is better.")},
      {tr("Worst material"), tr("The material with the smallest rendered SNR")},
      {unit.isEmpty() ? tr("Error") : tr("Error [%1]").arg(unit), QString()},  // rich
      {tr("Evaluation [ns]"),
       over + tr("Processor time of one evaluation on one thread, in batches: median and quartiles")},
      {tr("Frame [ms]"), over + tr("Time of one frame in the reference renderer on the CPU, not in the preview")},
      {tr("Size [B]"), over + tr("Size of the file; of a table: its size in memory; of a fit: the size of its "
                                 "parameters. Dictionaries are not counted.")},
      {tr("Encoding [s]"),
       over + tr("Time to compute the representation from the table, seconds; of a fit: of the fit")},
      {tr("Parameters"), tr("Number of values that a fit determines")},
      {tr("Warnings"), tr("Warnings of the fit about the measurement")}};
  if (role == Qt::DisplayRole) return headers[section].title;
  if (role == widgets::richToolTipRole && section == ErrorColumn)
    return tr("<p>%1: %2. Smaller is better.</p>")
        .arg(widgets::toQString(metric.name), widgets::formulaHtml(metric.formula));
  if (role == Qt::ToolTipRole) return headers[section].toolTip;
  return {};
}

}  // namespace gonio::app

#include "moc_study_model.cpp"
