// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// gonio_studies pdv MERL_FILE ...: three tables of docs/results/factors.md. Noise at equal samples: the standard
// deviation of the light that the material sends to a viewer under the studio environment, relative to its mean and
// averaged over viewers, for directions drawn by five densities. Factor measurement: SNR of pictures and of
// reflectances predicted from two curves, over four pairs of axes, each at the best of several fixed angles. And
// where in |Dp| and theta_h the highlight has fallen to half, in the plane of incidence toward the viewer.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <random>

#include "core/acquisition/factor_prediction.h"
#include "core/baselines/baselines.h"
#include "core/brdf/density_mixture.h"
#include "core/coordinates/half_difference.h"
#include "core/coordinates/projected_deviation.h"
#include "core/factorization/pdv_brdf.h"
#include "core/factorization/pdv_factors.h"
#include "core/fitting/fit.h"
#include "core/formats/pdv.h"
#include "core/materials/material.h"
#include "core/metrics/brdf_metrics.h"
#include "core/models/registry.h"
#include "core/rendering/environment.h"
#include "core/rendering/render_picture.h"
#include "tests/studies/study_program.h"

namespace gonio::study::pdv_study {
namespace {

using Draw = std::function<DirectionSample(const Direction& wo, const glm::dvec3& u)>;

/// Viewers every 10 degrees, turned about the normal: the environment's up is the normal.
double noise(const Brdf& brdf, const rendering::EnvironmentMap& environment, const Draw& draw) {
  constexpr int samples = 40000;
  double sum = 0;
  int viewers = 0;
  for (double degrees = 5; degrees < 90; degrees += 10, ++viewers) {
    const Direction wo = fromSpherical(radians(degrees), radians(37 * degrees));
    std::mt19937_64 random{std::uint64_t(degrees)};
    std::uniform_real_distribution<double> uniform(0, 1);
    double mean = 0, squares = 0;
    for (int n = 0; n < samples; ++n) {
      const double a = uniform(random), b = uniform(random), c = uniform(random);
      const DirectionSample s = draw(wo, {a, b, c});
      if (!(s.pdf > 0)) continue;
      const Rgb light = environment.radiance({s.wi.x, s.wi.z, -s.wi.y}) * brdf.evaluate(s.wi, wo) * s.wi.z / s.pdf;
      const double value = (light.x + light.y + light.z) / 3;
      mean += value / samples;
      squares += value * value / samples;
    }
    sum += std::sqrt(std::max(0.0, squares - mean * mean)) / mean;
  }
  return sum / viewers;
}

void printNoise(const std::string& name, const TabulatedBrdf& table) {
  const auto environment = rendering::studioEnvironment();
  const factorization::PdvFactors factors = factorization::factorizePdv(table, {.terms = 1}).factors;
  const auto first = factorization::makePdvBrdf(factors);
  const factorization::PdvSampler exact(*first, factors.thetaNodes, factors.deviationNodes);
  const factorization::PublishedPdvSampler printed(*first, factors.thetaNodes, factors.deviationNodes);
  const fitting::FitResult fit = fitting::fit(table, models::ggx(), {});
  const auto ggx = models::ggx().instantiate(fit.parameters);
  const std::size_t bytes[] = {formats::pdvFileBytes(factorization::PdvForm::threeFactors, 10)};
  const auto baseline = [&](const char* id) {
    return baselines::findBaseline(id).build(table, std::span<const std::size_t>(bytes), {}).front().brdf;
  };
  const auto lawrence = baseline("lawrence"), bilgili = baseline("bilgili");
  const auto cosine = cosineSampler();
  const Draw draws[] = {[&](const Direction& wo, const glm::dvec3& u) { return cosine.sample(wo, u); },
                        [&](const Direction& wo, const glm::dvec3& u) { return printed.sample(wo, u); },
                        [&](const Direction& wo, const glm::dvec3& u) { return exact.sample(wo, u); },
                        [&](const Direction& wo, const glm::dvec3& u) { return ggx->sample(wo, u); },
                        [&](const Direction& wo, const glm::dvec3& u) { return lawrence->sample(wo, u); },
                        [&](const Direction& wo, const glm::dvec3& u) { return bilgili->sample(wo, u); }};
  std::printf("| %s |", name.c_str());
  for (const Draw& draw : draws) std::printf(" %.3f |", noise(table, *environment, draw));
  std::printf("\n");
}

void printMeasurement(const std::string& name, const TabulatedBrdf& table) {
  using acquisition::FactorAxes;
  const rendering::RenderedComparison comparison(table, {.width = 128, .height = 128, .samples = 16});
  std::printf("| %s |", name.c_str());
  for (const auto axes : {FactorAxes::projectedDeviation, FactorAxes::symmetricDeviation, FactorAxes::halfDifference,
                          FactorAxes::halfOut}) {
    double rendered = -1e9, renderedAt = 0, reflectance = -1e9, reflectanceAt = 0;
    for (double degrees = 10; degrees < 80; degrees += 10) {
      const auto m = acquisition::measureFactors(table, {.axes = axes, .fixedAngle = radians(degrees)});
      const auto predicted = acquisition::predictFromFactors(m, acquisition::FactorBound::none);
      const double snr = metrics::brdfSignalToNoiseRatio(table, *predicted);
      const double picture = comparison.signalToNoiseRatio(comparison.render(*predicted));
      if (snr > reflectance) reflectance = snr, reflectanceAt = degrees;
      if (picture > rendered) rendered = picture, renderedAt = degrees;
    }
    std::printf(" %.2f (%.0f), %.2f (%.0f) |", rendered, renderedAt, reflectance, reflectanceAt);
  }
  std::printf("\n");
  std::fflush(stdout);
}

/// Where green has fallen to half of ln(1 + rho) of the mirror direction.
void printWidths(const std::string& name, const TabulatedBrdf& table) {
  std::printf("| %s |", name.c_str());
  for (const double degrees : {10.0, 45.0, 70.0, 80.0}) {
    const auto z = [&](const DirectionPair& pair) { return std::log1p(table.Brdf::evaluate(pair.wi, pair.wo).y); };
    const double peak = z(fromProjectedDeviation({radians(degrees), 0, 0}).pair);
    double deviation = 0;
    const auto pairAt = [&] { return fromProjectedDeviation({radians(degrees), deviation, 0}).pair; };
    while (deviation < 1 && z(pairAt()) > peak / 2) deviation += 1e-4;
    const DirectionPair half = pairAt();
    std::printf(" %.3f, %.1f |", deviation, gonio::degrees(toHalfDifference(half.wi, half.wo).thetaH));
  }
  std::printf("\n");
}

int study(int argc, char** argv) {
  std::vector<std::pair<std::string, std::shared_ptr<const TabulatedBrdf>>> materials;
  for (int i = 1; i < argc; ++i)
    materials.emplace_back(std::filesystem::path(argv[i]).stem().string(),
                           meanOfOrders(materials::readMaterial(argv[i]).tabulated()));
  std::printf(
      "| material | cosine | printed | exact | GGX fit | Lawrence | Bilgili |\n|---|---|---|---|---|---|---|\n");
  for (const auto& [name, table] : materials) printNoise(name, *table);
  std::printf("\n| material | deviation | symmetric | half-difference | half-out |\n|---|---|---|---|---|\n");
  for (const auto& [name, table] : materials) printMeasurement(name, *table);
  std::printf("\n| material | 10 | 45 | 70 | 80 degrees |\n|---|---|---|---|---|\n");
  for (const auto& [name, table] : materials) printWidths(name, *table);
  return 0;
}

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::pdv_study
