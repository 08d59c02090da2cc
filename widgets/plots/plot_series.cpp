// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/plots/plot_series.h"

#include <QCoreApplication>
#include <cmath>

#include "widgets/inputs/number_field.h"

namespace gonio::widgets {

namespace {
struct PlotsText {
  Q_DECLARE_TR_FUNCTIONS(Plots)
};
}  // namespace

QString channelName(plots::Channel channel) {
  switch (channel) {
    case plots::Channel::red:
      return PlotsText::tr("Red");
    case plots::Channel::green:
      return PlotsText::tr("Green");
    case plots::Channel::blue:
      return PlotsText::tr("Blue");
    case plots::Channel::luminance:
      break;
  }
  return PlotsText::tr("Luminance");
}

QString cosineName(plots::CosineFactor cosine) {
  return cosine == plots::CosineFactor::none       ? PlotsText::tr("ρ")
         : cosine == plots::CosineFactor::incident ? PlotsText::tr("ρ cos θi")
                                                   : PlotsText::tr("ρ cos θo");
}

QString valueTitle(const PlotSettings& settings) {
  return PlotsText::tr("%1, %2 [1/sr]").arg(cosineName(settings.cosine), channelName(settings.channel).toLower());
}

QString axisName(plots::SectionAxis axis) {
  return axis == plots::SectionAxis::thetaH   ? PlotsText::tr("θh")
         : axis == plots::SectionAxis::thetaD ? PlotsText::tr("θd")
                                              : PlotsText::tr("θo");
}

QString stateText(plots::PointState state) {
  return state == plots::PointState::belowHorizon ? PlotsText::tr("below the horizon") : PlotsText::tr("not measured");
}

QString valueText(double value, plots::PointState state) {
  if (state != plots::PointState::known) return stateText(state);
  return value == value ? PlotsText::tr("%1 1/sr").arg(formatNumber(value)) : PlotsText::tr("no value");
}

std::string channelForCsv(plots::Channel channel) {
  static constexpr const char* names[] = {"luminance", "red", "green", "blue"};
  return names[int(channel)];
}

std::string valueForCsv(const PlotSettings& settings) {
  static constexpr const char* values[] = {"rho (without a cosine)", "rho cos theta_i", "rho cos theta_o"};
  return std::string(values[int(settings.cosine)]) + ", " + channelForCsv(settings.channel) + " [1/sr]";
}

std::string conventionForCsv() {
  return "convention: unit directions, both away from the surface, z = normal; theta_i of the direction to the light, "
         "theta_o to the viewer, theta_h of their half vector, theta_d between half vector and light; rho is the BRDF, "
         "linear RGB (sRGB primaries); luminance by ITU-R BT.709";
}

std::string angleForCsv(const std::string& name, double radians) {
  return name + " = " + formatNumber(degrees(radians)).toStdString() + " degrees";
}

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
