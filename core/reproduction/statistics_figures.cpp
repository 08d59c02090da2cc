// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// Quantities, error metrics of fits, coordinates and the energy over |Dp|: table 2.1 and figures 2.7, 4.1, 4.2.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/coordinates/half_difference.h"
#include "core/coordinates/half_out.h"
#include "core/coordinates/projected_deviation.h"
#include "core/factorization/deviation_grid.h"
#include "core/fitting/fit.h"
#include "core/models/registry.h"
#include "core/plots/plotted_values.h"
#include "core/reproduction/charts.h"
#include "core/reproduction/figure_record.h"
#include "core/study/study_record.h"
#include "core/support/text.h"

namespace gonio::reproduction {

namespace {

// Table 2.1.

MadeFigure makeQuantities(const FigureRecord& record, Inputs&, const TaskControl&) {
  const std::vector<std::string> columns{"Radiometric quantity", "Definition", "Unit"};
  const std::vector<std::vector<std::string>> rows{{"Radiant energy Q", "h c / lambda", "J"},
                                                   {"Radiant flux Phi", "dQ / dt", "J/s = W"},
                                                   {"Irradiance E", "dPhi / dA", "W/m^2"},
                                                   {"Intensity I", "dPhi / domega", "W/sr"},
                                                   {"Radiance L", "d^2 Phi / (domega dA cos theta)", "W/(m^2 sr)"}};
  MadeFigure made{drawTable(std::string(record.title), columns, rows), {}, {}, {}};
  for (std::size_t c = 0; c < columns.size(); ++c) {
    io::CsvColumn column{columns[c], {}};
    for (const auto& row : rows) column.texts.push_back(row[c]);
    made.table.columns.push_back(std::move(column));
  }
  return made;
}

// Figure 2.7.

/// Median over directions of |ln(model / measurement)| of the luminance, within or beyond an angle of the mirror
/// direction.
double logErrorAbout(const plots::Curve& measured, const plots::Curve& model, double mirror, double from, double to) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < measured.angles.size(); ++i) {
    const double distance = std::abs(measured.angles[i] - mirror);
    const double m = measured.points.at(i, plots::Channel::luminance),
                 f = model.points.at(i, plots::Channel::luminance);
    if (distance >= from && distance <= to && m > 0 && f > 0) errors.push_back(std::abs(std::log(f / m)));
  }
  return study::quantile(errors, 0.5);
}

void addColumn(io::CsvTable& table, const std::string& title, std::vector<double> values) {
  table.columns.push_back({title, std::move(values)});
}

MadeFigure makeMetricFits(const FigureRecord& record, Inputs& inputs, const TaskControl& control) {
  const auto table = inputs.table(inputs.find(record.subjects[0]), control);
  const models::Model& model = models::findModel("cook-torrance");
  MadeFigure made;
  std::vector<Chart> charts;
  std::vector<std::pair<std::string, metrics::BrdfMetric>> metricsOfFits{{"logarithmic", metrics::BrdfMetric::log},
                                                                         {"linear", metrics::BrdfMetric::cosineL2}};
  for (const auto& [name, metric] : metricsOfFits) {
    const auto fit = fitting::fit(*table, model, {.metric = metric}, {control.stop, {}});
    control.throwIfStopped();
    const auto brdf = model.instantiate(fit.parameters);
    for (const double degreesOfLight : {0., 67.}) {
      const plots::Section section{.axis = plots::SectionAxis::thetaO, .thetaI = radians(degreesOfLight)};
      const plots::Curve measured = plots::sectionCurve(*table, section, table.get());
      const plots::Curve fitted = plots::sectionCurve(*brdf, section);
      const std::string light = "theta_i = " + shortText(degreesOfLight) + " degrees";
      Chart chart{.title = name + " metric, " + light,
                  .xTitle = "theta_o [degrees]",
                  .yTitle = "BRDF luminance [1/sr]",
                  .series = {},
                  .logY = true,
                  .xRange = std::array{-90., 90.}};
      for (const auto& [curve, label] : {std::pair{&measured, "measured"}, std::pair{&fitted, "Cook-Torrance"}}) {
        ChartSeries series{.name = label, .points = {}};
        std::vector<double> values;
        for (std::size_t i = 0; i < curve->angles.size(); ++i) {
          values.push_back(curve->points.at(i, plots::Channel::luminance));
          series.points.emplace_back(degrees(curve->angles[i]), values.back());
        }
        if (curve == &measured && made.table.columns.size() % 5 == 0) {
          std::vector<double> angles;
          for (const double angle : curve->angles) angles.push_back(degrees(angle));
          addColumn(made.table, "theta_o [degrees], " + name + ", " + light, angles);
        }
        addColumn(made.table, std::string(label) + " [1/sr], " + name + ", " + light, values);
        chart.series.push_back(std::move(series));
      }
      charts.push_back(std::move(chart));
      made.values.push_back(
          {name + " metric, " + light + ", median |ln ratio| beyond 30 degrees of the mirror direction", "",
           logErrorAbout(measured, fitted, section.thetaI, radians(30), pi)});
    }
    made.values.push_back({name + " metric, cosine-weighted linear error of the fit", "1/sr",
                           fit.errors[std::size_t(metrics::BrdfMetric::cosineL2)]});
  }
  made.drawing = drawCharts(std::string(record.title), charts, 2);
  return made;
}

// Figure 4.1.

/// A curve of constant second coordinate; parts without light above the horizon are left out.
struct CoordinateCurve {
  double constant = 0;
  std::vector<Direction> lights;  ///< NaN where there is none
};

const Direction noDirection(std::nan(""));

/// The curves of one panel: `first` is theta_R, theta_h or theta_o, rad.
template <typename LightOf>
std::vector<CoordinateCurve> coordinateCurves(double step, double end, const LightOf& lightAt) {
  constexpr int points = 360;
  std::vector<CoordinateCurve> curves;
  for (double constant = step; constant < end; constant += step) {
    CoordinateCurve curve{constant, {}};
    for (int k = 0; k <= points; ++k) curve.lights.push_back(lightAt(constant, -pi + 2 * pi * k / points));
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<CoordinateCurve> deviationCurves(double thetaR) {
  constexpr double printedStep = 0.044;
  return coordinateCurves(printedStep, 1 + std::sin(thetaR), [&](double deviation, double phi) {
    const auto found = fromProjectedDeviation({thetaR, deviation, phi});
    return found.valid ? found.pair.wi : noDirection;
  });
}
std::vector<CoordinateCurve> differenceCurves(double thetaH) {
  return coordinateCurves(radians(2), halfPi, [&](double thetaD, double phi) {
    return isAboveHorizon(thetaH, thetaD, phi) ? fromHalfDifference(thetaH, thetaD, phi).wi : noDirection;
  });
}
std::vector<CoordinateCurve> halfOutCurves(double thetaO) {
  return coordinateCurves(radians(2), halfPi, [&](double thetaH, double phi) {
    const auto found = fromHalfOut({thetaO, thetaH, phi, true});
    return found.valid ? found.pair.wi : noDirection;
  });
}

/// From above, or of the hemisphere at an oblique angle.
glm::dvec2 projected(const Direction& w, bool fromAbove) {
  if (fromAbove) return {w.x, w.y};
  const double tilt = radians(25);
  return {w.x, w.y * std::sin(tilt) + w.z * std::cos(tilt)};
}

ChartSeries circle(bool fromAbove) {
  ChartSeries series{.points = {}, .colour = "#000000"};
  for (int k = 0; k <= 180; ++k) {
    const double phi = 2 * pi * k / 180;
    series.points.push_back(projected({std::cos(phi), std::sin(phi), 0}, fromAbove));
  }
  return series;
}

/// Contours of a material for one viewer: for each azimuth about the mirror direction, the |Dp| at which the luminance
/// has fallen to a fraction of its value there.
struct IsoContour {
  double fraction = 0;
  std::vector<double> deviations;  ///< for 72 azimuths of Dp; NaN where the disk ends first
  /// Standard deviation over mean: 0 for a circle about the mirror direction.
  double spread() const {
    double sum = 0, squares = 0, count = 0;
    for (const double d : deviations)
      if (std::isfinite(d)) sum += d, squares += d * d, ++count;
    return std::sqrt(std::max(0., squares / count - sum * sum / (count * count))) / (sum / count);
  }
};

constexpr int contourAzimuths = 72;
double contourAzimuth(int k) { return -pi + 2 * pi * k / contourAzimuths; }

IsoContour isoContour(const Brdf& brdf, double thetaR, double fraction) {
  const auto valueAt = [&](double deviation, double phi) {
    const auto found = fromProjectedDeviation({thetaR, deviation, phi});
    return found.valid ? luminance(brdf.evaluate(found.pair.wi, found.pair.wo)) : std::nan("");
  };
  IsoContour contour{fraction, {}};
  const double level = fraction * valueAt(0, 0);
  for (int k = 0; k < contourAzimuths; ++k) {
    constexpr double step = 0.002;
    double deviation = step;
    double value = valueAt(deviation, contourAzimuth(k));
    while (value > level) value = valueAt(deviation += step, contourAzimuth(k));
    contour.deviations.push_back(std::isnan(value) ? value : deviation);
  }
  return contour;
}

MadeFigure makeCoordinates(const FigureRecord& record, Inputs& inputs, const TaskControl& control) {
  MadeFigure made;
  std::vector<Chart> charts;
  std::vector<std::string> panels, curveNames;
  std::vector<double> constants, x, y, z;
  const std::array names{"PDV, theta_R", "half-difference, theta_h", "half-out, theta_o"};
  for (const double angle : {30., 70.})
    for (int system = 0; system < 3; ++system) {
      const double theta = radians(angle);
      const auto curves = system == 0   ? deviationCurves(theta)
                          : system == 1 ? differenceCurves(theta)
                                        : halfOutCurves(theta);
      const bool fromAbove = angle < 50;
      Chart chart{.title = std::string(names[std::size_t(system)]) + " = " + shortText(angle) + " degrees",
                  .series = {circle(fromAbove)},
                  .xRange = std::array{-1.05, 1.05},
                  .yRange = fromAbove ? std::array{-1.05, 1.05} : std::array{-0.5, 1.1},
                  .isDisk = true};
      for (const CoordinateCurve& curve : curves) {
        ChartSeries series{.points = {}, .colour = "#0072b2"};
        for (const Direction& light : curve.lights) {
          series.points.push_back(projected(light, fromAbove));
          if (std::isnan(light.x)) continue;
          panels.push_back(chart.title);
          constants.push_back(system == 0 ? curve.constant : degrees(curve.constant));
          x.push_back(light.x), y.push_back(light.y), z.push_back(light.z);
        }
        chart.series.push_back(std::move(series));
      }
      charts.push_back(std::move(chart));
    }
  const InputMaterial material = inputs.find(record.subjects[0]);
  const auto table = inputs.table(material, control);
  for (const double angle : {30., 50., 70.}) {
    Chart chart{.title = "iso-contours, theta_o = " + shortText(angle) + " degrees",
                .series = {circle(true)},
                .xRange = std::array{-1.05, 1.05},
                .yRange = std::array{-1.05, 1.05},
                .isDisk = true};
    double widest = 0;
    for (const double fraction : {0.1, 0.03, 0.01, 0.003, 0.001}) {
      control.throwIfStopped();
      const IsoContour contour = isoContour(*table, radians(angle), fraction);
      ChartSeries series{.points = {}, .colour = "#d55e00"};
      for (int k = 0; k <= contourAzimuths; ++k) {
        const double phi = contourAzimuth(k), d = contour.deviations[std::size_t(k % contourAzimuths)];
        const glm::dvec2 at(d * std::cos(phi) - std::sin(radians(angle)), d * std::sin(phi));
        series.points.push_back(at);
        if (std::isnan(d) || k == contourAzimuths) continue;
        panels.push_back(chart.title + ", " + material.name);
        constants.push_back(fraction);
        x.push_back(at.x), y.push_back(at.y);
        z.push_back(std::sqrt(std::max(0., 1 - at.x * at.x - at.y * at.y)));
      }
      chart.series.push_back(std::move(series));
      if (fraction == 0.01) widest = contour.spread();
    }
    charts.push_back(std::move(chart));
    made.values.push_back({"iso-contour at a hundredth of the mirror value, theta_o = " + shortText(angle) +
                               " degrees, standard deviation of |Dp| over mean",
                           "", widest});
  }
  made.drawing = drawCharts(std::string(record.title) + ", " + material.name, charts, 3);
  made.table.columns = {{"panel", {}, panels},
                        {"constant: |Dp|, angle [degrees], or fraction of the mirror value", constants},
                        {"x", x},
                        {"y", y},
                        {"z", z}};
  return made;
}

// Figure 4.2.

MadeFigure makeEnergy(const FigureRecord& record, Inputs& inputs, const TaskControl& control) {
  const auto materials = materialsOf(record, inputs);
  std::vector<double> energy;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    const auto own = factorization::publishedDeviationEnergy(*inputs.table(materials[m], control), {control.stop, {}});
    energy.resize(own.size());
    for (std::size_t j = 0; j < own.size(); ++j) energy[j] += own[j] / double(materials.size());
    control.report(double(m + 1) / double(materials.size()));
  }
  const double sum = std::accumulate(energy.begin(), energy.end(), 0.);
  const auto nodes = factorization::deviationNodes(energy, factorization::defaultDeviations);
  const double step = factorization::maxDeviation / double(energy.size());
  Chart curve{.title = "(a) normalised energy", .xTitle = "|Dp|", .yTitle = "energy", .series = {{.points = {}}}};
  Chart steps{
      .title = "(b) step of |Dp|", .xTitle = "number of the node", .yTitle = "step", .series = {{.points = {}}}};
  MadeFigure made;
  std::vector<double> deviations, energies, indices, places, widths;
  for (std::size_t j = 0; j < energy.size(); ++j) {
    deviations.push_back((double(j) + 0.5) * step);
    energies.push_back(sum > 0 ? energy[j] / sum : 0);
    curve.series[0].points.emplace_back(deviations.back(), energies.back());
  }
  // A table has columns of one length: nodes are followed by empty fields.
  for (std::size_t j = 0; j < energy.size(); ++j) {
    const bool isNode = j < nodes.size();
    indices.push_back(isNode ? double(j + 1) : std::nan(""));
    places.push_back(isNode ? nodes[j] : std::nan(""));
    widths.push_back(j + 1 < nodes.size() ? nodes[j + 1] - nodes[j] : std::nan(""));
    if (j + 1 < nodes.size()) steps.series[0].points.emplace_back(indices.back(), widths.back());
  }
  made.table.columns = {{"|Dp|", deviations},
                        {"normalised energy", energies},
                        {"node", indices},
                        {"|Dp| of the node", places},
                        {"step to the next node", widths}};
  made.drawing = drawCharts(std::string(record.title), std::vector<Chart>{curve, steps}, 2);
  made.values = {
      {"materials", "", double(materials.size())},
      {"|Dp| below which half of the energy is", "", nodes[nodes.size() / 2]},
      {"smallest step", "", *std::ranges::min_element(widths, {}, [](double w) { return std::isnan(w) ? 1e9 : w; })},
      {"largest step", "", *std::ranges::max_element(widths, {}, [](double w) { return std::isnan(w) ? -1 : w; })}};
  return made;
}

}  // namespace

std::vector<FigureRecord> statisticsFigures() {
  return {
      {.id = "2.1",
       .isTable = true,
       .title = "Radiometric quantities and their units",
       .shows = "Definitions, which depend on no material.",
       .source = "table 2.1: no numbers printed",
       .fullMinutes = 0.01,
       .quickMinutes = 0.01,
       .make = makeQuantities},
      {.id = "2.7",
       .title = "Fits by a logarithmic and a linear error metric",
       .shows = "Cook-Torrance fitted to alum-bronze; BRDF values in the plane of incidence at 0 and 67 degrees.",
       .source = "figure 2.7: no numbers printed; the linear fit follows the highlights and neglects wide angles",
       .differences =
           "The print shows curves of Loew et al. 2012; here the fit is Gonio's, against the cosine-weighted "
           "linear and the logarithmic metric.",
       .subjects = {{MaterialSet::merl, "alum-bronze", {"brass", "aluminium-bronze"}}},
       .fullMinutes = 0.05,
       .quickMinutes = 0.05,
       .make = makeMetricFits},
      {.id = "4.1",
       .title = "Coordinate curves and iso-contours on the disk",
       .shows = "Curves of constant |Dp| (0.044 apart), theta_d and theta_h (2 degrees apart) on the unit disk and the "
                "hemisphere; below, contours of a measured material about the mirror direction.",
       .source = "figure 4.1: no numbers printed; contours of measured materials are close to circles in PDV",
       .differences = "The print names no material for its contours.",
       .subjects = {{MaterialSet::merl, "gold-metallic-paint3", {"gold-metallic-paint", "gold-metallic-paint2"}}},
       .fullMinutes = 0.02,
       .quickMinutes = 0.02,
       .make = makeCoordinates},
      {.id = "4.2",
       .title = "Normalised energy over the deviation, and the steps of its nodes",
       .shows = "The energy of eq. 4.24 at 2,000 values of |Dp|, and the steps of 90 nodes at its quantiles.",
       .source = "figure 4.2: no numbers printed",
       .differences = "The energy is that of ln(1 + rho), as in Paper B; eq. 4.24 prints rho.",
       .wholeSets = {MaterialSet::merl},
       .fullMinutes = 0.5,
       .quickMinutes = 0.02,
       .make = makeEnergy},
  };
}

}  // namespace gonio::reproduction
