// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/factor_quality.h"

#include "core/metrics/brdf_metrics.h"
#include "core/rendering/render_picture.h"
#include "core/study/evaluation_time.h"

namespace gonio::tool {

BrdfQuality brdfQuality(const Brdf& measurement, const Brdf& test) {
  return {metrics::brdfErrors(measurement, test), metrics::brdfSignalToNoiseRatio(measurement, test)};
}

std::string addTableQuality(Json& json, const Brdf& measurement, const TabulatedBrdf& table) {
  if (formOf<TabulatedBrdf>(measurement) == &table) return {};
  const BrdfQuality quality = brdfQuality(measurement, table);
  json["table"] = {{"errors", errorsJson(quality.errors)}, {"brdfSnr", decibelsJson(quality.brdfSnr)}};
  return "the table that the method works on: BRDF SNR " + number(quality.brdfSnr) + " dB against the material\n";
}

FactorQuality factorQuality(const materials::Material& material, const Brdf& factors, int samples, const Tool& tool) {
  FactorQuality quality{brdfQuality(*material.brdf, factors)};
  quality.evaluationNs = study::measureEvaluation(factors).median;
  RenderOptions picture = smallComparisonPicture();
  picture.samples = samples;
  const RenderedComparison comparison(*material.brdf, picture, tool.control("rendering the material"));
  quality.renderedSnr =
      comparison.signalToNoiseRatio(comparison.render(factors, tool.control("rendering the factors")));
  return quality;
}

void addQuality(Json& json, const FactorQuality& quality) {
  json["errors"] = errorsJson(quality.errors);
  json["brdfSnr"] = decibelsJson(quality.brdfSnr);
  json["renderedSnr"] = decibelsJson(quality.renderedSnr);
  json["evaluationNs"] = quality.evaluationNs;
}

std::string qualityText(const FactorQuality& quality, double seconds) {
  return "BRDF SNR " + number(quality.brdfSnr) + " dB, rendered SNR " + number(quality.renderedSnr) + " dB, " +
         number(seconds) + " s, " + number(quality.evaluationNs) + " ns per evaluation\n" + errorsText(quality.errors);
}

}  // namespace gonio::tool
