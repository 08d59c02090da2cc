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
#include "widgets/inputs/plain_text_style.h"
#include "widgets/parameters/formula_text.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {

constexpr int iconSide = 64;

/// "1.2k", as in the plot.
QString shortText(double value) { return QString::fromStdString(study::shortNumber(value)); }

/// "1.2 ms".
QString secondsText(double seconds) { return QString::fromStdString(study::shortQuantity(seconds, "s")); }
QString nanosecondsText(double nanoseconds) { return secondsText(1e-9 * nanoseconds); }

QString asHtmlImage(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  image.save(&buffer, "PNG");
  return QStringLiteral("<img src=\"data:image/png;base64,%1\"/>").arg(QString::fromLatin1(bytes.toBase64()));
}

}  // namespace

void StudyModel::plan(const std::vector<study::Representation>& representations) {
  m_rows.clear();
  replan(representations);
}

void StudyModel::replan(const std::vector<study::Representation>& representations) {
  beginResetModel();
  std::vector<Row> rows;
  for (const study::Representation& representation : representations) {
    const auto known = std::ranges::find(m_rows, representation, &Row::representation);
    rows.push_back(known == m_rows.end() ? Row{representation, {}, {}, {}} : *known);
  }
  m_rows = std::move(rows);
  m_shown = m_best = -1;
  endResetModel();
}

void StudyModel::add(const Studied& studied) {
  const auto row = std::ranges::find(m_rows, studied->record.representation, &Row::representation);
  if (row == m_rows.end()) return;
  row->studied = studied;
  row->picture = displayedImage(studied->picture);
  const QPixmap pixmap =
      QPixmap::fromImage(row->picture.scaled(iconSide, iconSide, Qt::KeepAspectRatio, Qt::SmoothTransformation));
  row->icon = QIcon(pixmap);
  row->icon.addPixmap(pixmap, QIcon::Selected);  // a tinted one would be another material
  const int place = int(row - m_rows.begin());
  Q_EMIT dataChanged(index(place, 0), index(place, ColumnCount - 1));
}

std::vector<study::Representation> StudyModel::missing() const {
  std::vector<study::Representation> result;
  for (const Row& row : m_rows)
    if (!row.studied) result.push_back(row.representation);
  return result;
}

std::vector<study::StudyRecord> StudyModel::records() const {
  std::vector<study::StudyRecord> result;
  for (const Row& row : m_rows)
    if (row.studied) result.push_back(row.studied->record);
  return result;
}

std::vector<int> StudyModel::measuredRows() const {
  std::vector<int> rows;
  for (int row = 0; row < rowCount(); ++row)
    if (studied(row)) rows.push_back(row);
  return rows;
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
  if (!m_rows.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

QString StudyModel::nameOf(int row) const {
  const QString name = QString::fromStdString(representation(row).fullLabel());
  if (row == m_shown && row == m_best) return tr("%1 (shown, best)").arg(name);
  if (row == m_shown) return tr("%1 (shown)").arg(name);
  return row == m_best ? tr("%1 (best)").arg(name) : name;
}

QString StudyModel::toolTip(int row) const {
  const Row& one = m_rows[std::size_t(row)];
  if (!one.studied) return tr("Not measured yet");
  const study::StudyRecord& record = one.studied->record;
  return tr("<p>%1</p><p><b>%2</b><br>rendered SNR %3 dB<br>%4 per evaluation (%5 to %6)<br>%7 per "
            "frame<br>%8<br>encoded in %9</p>")
      .arg(asHtmlImage(one.picture), QString::fromStdString(record.representation.fullLabel()).toHtmlEscaped(),
           comparisonValue(record.renderedSnr), nanosecondsText(record.evaluation.median),
           nanosecondsText(record.evaluation.lowerQuartile), nanosecondsText(record.evaluation.upperQuartile),
           secondsText(1e-3 * record.frameMilliseconds),
           QLocale().formattedDataSize(qint64(record.bytes), 1, QLocale::DataSizeSIFormat),
           secondsText(record.encodeSeconds));
}

int StudyModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_rows.size()); }

int StudyModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QString StudyModel::text(const study::StudyRecord& record, int column) const {
  switch (column) {
    case SnrColumn:
      return comparisonValue(record.renderedSnr);
    case ErrorColumn:
      return QString::number(study::qualityOf(record, m_metric), 'g', 3);
    case EvaluationColumn:
      return tr("%1 (%2–%3)")
          .arg(shortText(record.evaluation.median), shortText(record.evaluation.lowerQuartile),
               shortText(record.evaluation.upperQuartile));
    case FrameColumn:
      return shortText(record.frameMilliseconds);
    case BytesColumn:
      return shortText(double(record.bytes));
    case EncodingColumn:
      return record.encodeSeconds > 0 ? shortText(record.encodeSeconds) : tr("none");
  }
  return {};
}

QVariant StudyModel::sortKey(const Row& row, int column) const {
  constexpr double last = std::numeric_limits<double>::infinity();
  if (column == NameColumn) {
    // Budgets by their size, not by their first digit.
    return QStringLiteral("%1 %2")
        .arg(QString::fromStdString(row.representation.label()))
        .arg(row.representation.budget, 9, 'f', 0);
  }
  if (!row.studied) return last;
  const study::StudyRecord& record = row.studied->record;
  const double keys[] = {0,
                         -record.renderedSnr,
                         study::qualityOf(record, m_metric),
                         record.evaluation.median,
                         record.frameMilliseconds,
                         double(record.bytes),
                         record.encodeSeconds};
  return std::isnan(keys[column]) ? last : keys[column];
}

QVariant StudyModel::data(const QModelIndex& index, int role) const {
  const Row& row = m_rows[std::size_t(index.row())];
  const int column = index.column();
  if (role == Qt::DisplayRole && column == NameColumn) return nameOf(index.row());
  if (role == Qt::DisplayRole) return row.studied ? text(row.studied->record, column) : QStringLiteral("-");
  if (role == Qt::UserRole) return sortKey(row, column);
  if (role == Qt::DecorationRole && column == NameColumn) return row.icon;
  if (role == widgets::richToolTipRole) return toolTip(index.row());
  if (role == Qt::ForegroundRole && !row.studied) return QPalette().brush(QPalette::PlaceholderText);
  if (role == Qt::FontRole && index.row() == m_shown) {
    QFont bold;
    bold.setBold(true);
    return bold;
  }
  if (role == Qt::TextAlignmentRole && column != NameColumn) return int(Qt::AlignRight | Qt::AlignVCenter);
  return {};
}

QVariant StudyModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const metrics::MetricRecord& metric = metrics::metricRecord(m_metric);
  const QString unit = widgets::toQString(metric.unit);
  if (role == Qt::DisplayRole) {
    const QString titles[] = {
        tr("Representation"),  tr("Rendered SNR [dB]"), unit.isEmpty() ? tr("Error") : tr("Error [%1]").arg(unit),
        tr("Evaluation [ns]"), tr("Frame [ms]"),        tr("Size [B]"),
        tr("Encoding [s]")};
    return titles[section];
  }
  if (role == widgets::richToolTipRole && section == ErrorColumn)
    return tr("<p>%1: %2. Smaller is better.</p>")
        .arg(widgets::toQString(metric.name), widgets::formulaHtml(metric.formula));
  if (role == Qt::ToolTipRole) {
    const QString tips[] = {
        tr("Representation at one budget, with its rendered image"),
        tr("Rendered SNR of the image in the comparison scene (bundled scene \"sphere\"). Larger is better."),
        QString(),  // rich
        tr("Processor time of one evaluation on one thread, in batches: median and quartiles"),
        tr("Time of one frame in the reference renderer on the CPU, not in the preview"),
        tr("Size of the file; of a table: its size in memory; of a fit: the size of its parameters. Dictionaries are "
           "not counted."),
        tr("Time to compute the representation from the table, seconds")};
    return tips[section];
  }
  return {};
}

}  // namespace gonio::app

#include "moc_study_model.cpp"
