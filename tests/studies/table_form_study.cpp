// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// table_form_study: rendered SNR of half-difference tables of the bundled RGL files against the files themselves:
// folded as in MERL files (90 x 90 x 180) and over the whole circle (90 x 90 x 360), of the values, of the values times
// both cosines, and over the whole circle of the values times the cosine of the light, as RGL files store them.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "core/materials/measured_library.h"
#include "core/rendering/rendered_comparison.h"
#include "tests/studies/study_main.h"

namespace {

using namespace gonio;

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

int run() {
  const HalfDifferenceGrid folded, whole{.phiDCount = 360, .reciprocal = false};
  const std::pair<HalfDifferenceGrid, Cosine> forms[] = {{folded, Cosine::none},
                                                         {folded, Cosine::both},
                                                         {whole, Cosine::none},
                                                         {whole, Cosine::both},
                                                         {whole, Cosine::light}};
  const RenderOptions options{.width = 128, .height = 128, .samples = 64};
  std::vector<double> columns[std::size(forms)];
  std::printf("material, folded, folded both cosines, whole, whole both cosines, whole light cosine\n");
  for (const materials::MeasuredMaterial& one : materials::measuredMaterials()) {
    const auto brdf = materials::measuredMaterial(one).brdf;
    const RenderedComparison comparison(*brdf, options);
    std::printf("%s", one.name.c_str());
    for (std::size_t form = 0; form < std::size(forms); ++form) {
      const auto& [grid, cosine] = forms[form];
      const auto table = bakeTable(Scaled(brdf, cosine, false), grid);
      const double snr = comparison.signalToNoiseRatio(comparison.render(Scaled(table, cosine, true)));
      columns[form].push_back(snr);
      std::printf(", %.1f", snr);
      std::fflush(stdout);
    }
    std::printf("\n");
  }
  std::printf("median");
  for (std::vector<double>& column : columns) {
    std::ranges::nth_element(column, column.begin() + std::ptrdiff_t(column.size() / 2));
    std::printf(", %.1f", column[column.size() / 2]);
  }
  std::printf("\n");
  return 0;
}

}  // namespace

int main() { return gonio::study::studyMain(run); }
