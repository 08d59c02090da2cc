// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// Measurement of two curves: figures 2.6, 5.3, 5.4.
#include <algorithm>
#include <cmath>

#include "core/acquisition/factor_prediction.h"
#include "core/reproduction/picture_rows.h"
#include "core/support/text.h"

namespace gonio::reproduction {

namespace {

using acquisition::FactorAxes;
using acquisition::FactorBound;

ComparedBrdf measured(const char* label, const Brdf& material, FactorAxes axes, FactorBound bound) {
  return {label, acquisition::predictFromFactors(acquisition::measureFactors(material, {.axes = axes}), bound)};
}

/// The best product of two curves of all cells, which no measurement of two curves exceeds by much.
ComparedBrdf rankOneFit(const TabulatedBrdf& table, const TaskControl& control) {
  const factorization::PdvOptions options{.form = factorization::PdvForm::twoFactors, .terms = 1};
  return {"PDV, rank-one fit",
          factorization::makePdvBrdf(factorization::factorizePdv(table, options, {control.stop, {}}).factors)};
}

MadeFigure makeSparseMeasurement(const FigureRecord& record, Inputs& inputs, const TaskControl& control) {
  const InputMaterial subject = inputs.find(record.subjects[0]);
  const auto table = inputs.table(subject, control);
  PictureRows rows(inputs.picture());
  const std::array compared{measured("Sparse measurement", *table, FactorAxes::projectedDeviation, FactorBound::none)};
  const auto ratios = rows.add(shownName(subject), *table, compared, control);
  return {rows.draw(std::string(record.title)), rows.table(), {{"rendered SNR", "dB", ratios[0]}}, {}};
}

MadeFigure makeFactorMeasurement(const FigureRecord& record, Inputs& inputs, const TaskControl& control) {
  const InputMaterial subject = inputs.find(record.subjects[0]);
  const auto table = inputs.table(subject, control);
  const std::array compared{
      measured("PDV", *table, FactorAxes::projectedDeviation, FactorBound::none),
      measured("Half-difference", *table, FactorAxes::halfDifference, FactorBound::none),
      measured("Half-out", *table, FactorAxes::halfOut, FactorBound::none),
      measured("Symmetric PDV, bounded", *table, FactorAxes::symmetricDeviation, FactorBound::readings),
      measured("All readings", *table, FactorAxes::adaptive, FactorBound::readings),
      rankOneFit(*table, control)};
  PictureRows rows(inputs.picture());
  const auto ratios = rows.add(shownName(subject), *table, compared, control);
  MadeFigure made{rows.draw(std::string(record.title)), rows.table(), {}, {}};
  for (std::size_t i = 0; i < compared.size(); ++i)
    made.values.push_back({compared[i].label + ", rendered SNR", "dB", ratios[i]});
  // The print does not state the fixed angle: how much it decides.
  const rendering::RenderedComparison comparison(*table, inputs.picture(), {control.stop, {}});
  for (const double angle : {15., 30., 45., 75.}) {
    const auto measurement = acquisition::measureFactors(*table, {.fixedAngle = radians(angle)});
    const auto brdf = acquisition::predictFromFactors(measurement, FactorBound::none);
    made.values.push_back({"PDV, fixed angle " + shortText(angle) + " degrees, rendered SNR", "dB",
                           comparison.signalToNoiseRatio(comparison.render(*brdf, {control.stop, {}}))});
  }
  return made;
}

MadeFigure makeFactorCurves(const FigureRecord& record, Inputs& inputs, const TaskControl& control) {
  const InputMaterial subject = inputs.find(record.subjects[0]);
  const auto measurement = acquisition::measureFactors(*inputs.table(subject, control));
  Chart along{.title = "(a) F1: along the mirror direction",
              .xTitle = "theta_R [degrees]",
              .yTitle = "ln(1 + rho)",
              .series = {}};
  Chart across{.title = "(b) F2: across, at theta_R = " + shortText(degrees(measurement.fixedAngle)) + " degrees",
               .xTitle = "|Dp|",
               .yTitle = "ln(1 + rho)",
               .series = {}};
  constexpr std::array names{"red", "green", "blue"};
  constexpr std::array colours{"#d55e00", "#009e73", "#0072b2"};
  MadeFigure made;
  const std::size_t rows = std::max(measurement.angles.size(), measurement.distances.size());
  const auto column = [&](const std::string& title, std::vector<double> values, double scale = 1) {
    for (double& value : values) value *= scale;
    values.resize(rows, std::nan(""));
    made.table.columns.push_back({title, std::move(values)});
  };
  column("theta_R [degrees]", measurement.angles, degrees(1));
  for (std::size_t c = 0; c < 3; ++c) column(std::string("F1 ") + names[c], measurement.along[c]);
  column("|Dp|", measurement.distances);
  for (std::size_t c = 0; c < 3; ++c) column(std::string("F2 ") + names[c], measurement.acrossRead[c]);
  for (std::size_t c = 0; c < 3; ++c) {
    ChartSeries f1{.name = names[c], .points = {}, .colour = colours[c]}, f2 = f1;
    for (std::size_t i = 0; i < measurement.angles.size(); ++i)
      f1.points.emplace_back(degrees(measurement.angles[i]), measurement.along[c][i]);
    for (std::size_t i = 0; i < measurement.distances.size(); ++i)
      f2.points.emplace_back(measurement.distances[i], measurement.acrossRead[c][i]);
    along.series.push_back(std::move(f1));
    across.series.push_back(std::move(f2));
  }
  made.drawing = drawCharts(std::string(record.title) + ", " + shownName(subject), std::array{along, across}, 2);
  const std::vector<double>& green = measurement.along[1];
  made.values = {{"F1 at the last angle over F1 at the first, green", "", green.back() / green.front()},
                 {"readings", "", double(measurement.angles.size() + measurement.distances.size())}};
  return made;
}

}  // namespace

std::vector<FigureRecord> measurementFigures() {
  const Subject redPaint{MaterialSet::merl, "red-metallic-paint", {"blue-metallic-paint2", "gold-metallic-paint3"}};
  return {
      {.id = "2.6",
       .title = "A material from a sparse measurement",
       .shows = "gold-metallic-paint3 predicted from the two curves of a factor measurement (eq. 5.6).",
       .source = "figure 2.6: no numbers printed",
       .subjects = {{MaterialSet::merl, "gold-metallic-paint3", {"gold-metallic-paint2", "gold-metallic-paint"}}},
       .fullMinutes = 0.05,
       .quickMinutes = 0.05,
       .make = makeSparseMeasurement},
      {.id = "5.3",
       .title = "Factor measurement in three coordinates",
       .shows = "red-metallic-paint predicted from two measured curves (eq. 5.6) in PDV, half-difference and half-out "
                "coordinates, with Gonio's bounds, by a fit to all readings (Gonio's default, with as many readings), "
                "and as "
                "the best product of two curves of all cells; for other fixed angles in the table of values.",
       .source = "figure 5.3, captions",
       .printed = {{"PDV, rendered SNR", 31.84},
                   {"Half-difference, rendered SNR", 22.06},
                   {"Half-out, rendered SNR", 25.59}},
       .differences =
           "The print does not state the fixed angle (here 60 degrees) nor the number of readings (here 90 and "
           "90 to 89 degrees, arms at least 2 degrees apart), and renders another scene. The best product of two "
           "curves "
           "of all cells bounds what two curves can reach; of the bundled copies it comes close to the printed value.",
       .subjects = {redPaint},
       .fullMinutes = 0.2,
       .quickMinutes = 0.1,
       .make = makeFactorMeasurement},
      {.id = "5.4",
       .title = "The two curves of a factor measurement",
       .shows = "chrome: ln(1 + rho) in the mirror direction, and across the highlight at the fixed angle.",
       .source = "figure 5.4: no numbers printed; F1 is high and steep near grazing angles",
       .subjects = {{MaterialSet::merl, "chrome", {"chrome-steel"}}},
       .fullMinutes = 0.02,
       .quickMinutes = 0.02,
       .make = makeFactorCurves},
  };
}

}  // namespace gonio::reproduction
