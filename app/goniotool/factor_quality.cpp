// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/factor_quality.h"

#include "core/metrics/brdf_metrics.h"
#include "core/rendering/rendered_comparison.h"
#include "core/study/evaluation_time.h"

namespace gonio::tool {

FactorQuality factorQuality(const materials::Material& material, const TabulatedBrdf& table, const Brdf& factors,
                            int samples, const Tool& tool) {
  FactorQuality quality{.errors = metrics::brdfErrors(table, factors),
                        .brdfSnr = metrics::brdfSignalToNoiseRatio(table, factors),
                        .evaluationNs = study::measureEvaluation(factors).median};
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
