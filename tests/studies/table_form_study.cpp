// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// gonio_studies table_form [MATERIAL ...]: rendered SNR of half-difference tables of the bundled RGL files against the
// files themselves: folded as in MERL files (90 x 90 x 180) and over the whole circle (90 x 90 x 360), of the values,
// of the values times both cosines, and over the whole circle of the values times the cosine of the light, as RGL files
// store them. The first column is the mean of both orders of the directions without a table. Behind each SNR, in
// brackets, that of the values times the light's cosine alone where one of the directions is 80 to 89.5 degrees from
// the normal. Without a name all of the files.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/materials/bundled_library.h"
#include "core/rendering/render_picture.h"
#include "core/study/study_record.h"
#include "tests/studies/study_program.h"

namespace gonio::study::table_form_study {
namespace {

enum class Cosine { none, light, both };

double factor(Cosine cosine, const DirectionPair& pair) {
  constexpr double least = 1e-3;
  const double light = std::max(pair.wi.z, least);
  return cosine == Cosine::none ? 1 : cosine == Cosine::light ? light : light * std::max(pair.wo.z, least);
}

/// A BRDF times a power of the cosine.
class Scaled final : public Brdf {
 public:
  Scaled(std::shared_ptr<const Brdf> brdf, Cosine cosine, bool divides)
      : brdf_(std::move(brdf)), cosine_(cosine), divides_(divides) {}

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    brdf_->evaluate(pairs, values);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double scale = factor(cosine_, pairs[i]);
      values[i] *= divides_ ? 1 / scale : scale;
    }
  }
  bool isReciprocal() const override { return cosine_ != Cosine::light && brdf_->isReciprocal(); }

 private:
  std::shared_ptr<const Brdf> brdf_;
  Cosine cosine_;
  bool divides_;
};

/// Pairs with the light, or the viewer, near the horizon, evenly over the azimuths.
std::vector<DirectionPair> grazingPairs() {
  constexpr int azimuths = 45;
  std::vector<DirectionPair> pairs;
  for (const double grazing : {80.0, 82.5, 85.0, 87.5, 89.5})
    for (double other = 2.5; other < 90; other += 5)
      for (int azimuth = 0; azimuth < azimuths; ++azimuth) {
        const Direction low = fromSpherical(radians(grazing), 0.3);
        const Direction high = fromSpherical(radians(other), 0.3 + 2 * pi * (azimuth + 0.5) / azimuths);
        pairs.push_back({low, high});
        pairs.push_back({high, low});
      }
  return pairs;
}

/// dB over grazingPairs(), values times the cosine of the light.
double grazingRatio(const Brdf& brdf, const Brdf& truth) {
  static const std::vector<DirectionPair> pairs = grazingPairs();
  std::vector<Rgb> values(pairs.size()), expected(pairs.size());
  brdf.evaluate(pairs, values);
  truth.evaluate(pairs, expected);
  double signal = 0, error = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Rgb whole = expected[i] * pairs[i].wi.z, difference = (values[i] - expected[i]) * pairs[i].wi.z;
    signal += glm::dot(whole, whole);
    error += glm::dot(difference, difference);
  }
  return 10 * std::log10(signal / error);
}

int run(const std::vector<std::string>& names) {
  const HalfDifferenceGrid folded, whole{.phiDCount = 360, .reciprocal = false};
  const std::pair<HalfDifferenceGrid, Cosine> forms[] = {{folded, Cosine::none},
                                                         {folded, Cosine::both},
                                                         {whole, Cosine::none},
                                                         {whole, Cosine::both},
                                                         {whole, Cosine::light}};
  const rendering::RenderOptions options{.width = 128, .height = 128, .samples = 64};
  std::vector<double> means, columns[std::size(forms)], grazing[std::size(forms)];
  std::printf(
      "material, mean of both orders, folded, folded both cosines, whole, whole both cosines, whole light cosine\n");
  for (const materials::MeasuredMaterial& one : materials::measuredMaterials()) {
    if (!names.empty() && std::ranges::find(names, one.name) == names.end()) continue;
    const auto brdf = materials::measuredMaterial(one).brdf;
    const rendering::RenderedComparison comparison(*brdf, options);
    const auto mean = withIncident(brdf, IncidentDirection::mean);
    means.push_back(comparison.signalToNoiseRatio(comparison.render(*mean)));
    const double meanLow = grazingRatio(*mean, *brdf);
    std::printf("%s, %.1f (%.1f)", one.name.c_str(), means.back(), meanLow);
    for (std::size_t form = 0; form < std::size(forms); ++form) {
      const auto& [grid, cosine] = forms[form];
      const auto table = bakeTable(Scaled(brdf, cosine, false), grid);
      const Scaled held(table, cosine, true);
      const double snr = comparison.signalToNoiseRatio(comparison.render(held)), low = grazingRatio(held, *brdf);
      columns[form].push_back(snr);
      grazing[form].push_back(low);
      std::printf(", %.1f (%.1f)", snr, low);
      std::fflush(stdout);
    }
    std::printf("\n");
  }
  const auto median = [](const std::vector<double>& column) { return quantile(column, 0.5); };
  std::printf("median, %.1f", median(means));
  for (std::size_t form = 0; form < std::size(forms); ++form)
    std::printf(", %.1f (%.1f)", median(columns[form]), median(grazing[form]));
  std::printf("\n");
  return 0;
}

int study(int count, char** values) { return run({values + 1, values + count}); }

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::table_form_study
