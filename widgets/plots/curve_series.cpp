// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/plots/curve_series.h"

#include <cmath>

#include "widgets/inputs/number_field.h"

namespace gonio::widgets {

std::vector<io::CsvColumn> curveColumns(const PlotSeriesList<plots::Curve>& series, const std::string& angle,
                                        plots::Channel channel, const std::string& unit) {
  std::vector<io::CsvColumn> columns;
  if (series.empty()) return columns;
  io::CsvColumn& angles = columns.emplace_back(io::CsvColumn{angle + " [degrees]", {}});
  for (const double value : series.front().data.angles) angles.values.push_back(degrees(value));
  for (const auto& [role, name, curve] : series) {
    io::CsvColumn column{name.toStdString() + " [" + unit + "]", {}};
    for (std::size_t i = 0; i < curve.angles.size(); ++i) column.values.push_back(curve.points.at(i, channel));
    columns.push_back(std::move(column));
  }
  return columns;
}

std::vector<double> shownValues(const PlotSeriesList<plots::Curve>& series, plots::Channel channel) {
  std::vector<double> values;
  for (const auto& each : series)
    for (std::size_t i = 0; i < each.data.angles.size(); ++i) values.push_back(each.data.points.at(i, channel));
  return values;
}

QString curveReadout(const PlotSeriesList<plots::Curve>& series, double angle, plots::Channel channel,
                     const QString& unit) {
  QStringList lines;
  for (const auto& each : series) {
    const double value = plots::valueAt(each.data, angle, channel);
    lines << QStringLiteral("%1: %2").arg(
        each.name, std::isnan(value) ? QObject::tr("no value") : formatNumber(value) + ' ' + unit);
  }
  return lines.join('\n');
}

}  // namespace gonio::widgets
