// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/sampling_method.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/baselines/baselines.h"
#include "core/brdf/density_mixture.h"
#include "core/factorization/pdv_brdf.h"
#include "core/factorization/pdv_factors.h"
#include "core/fitting/fit.h"
#include "core/models/registry.h"
#include "core/support/error.h"

namespace gonio::rendering {

namespace {

constexpr std::array<SamplingMethod, 7> methods{{
    {"auto", "Automatic", "The density with the least noise at equal time."},
    {"pdv", "PDV factors", "The first term of the PDV factors, with exact normalisation and a cosine-weighted part."},
    {"published", "PDV factors (published)",
     "The first term of the published PDV factors by eq. 4.27 to 4.32 of Tongbuasirilai 2023; samples off the disk are "
     "lost."},
    {"lawrence", "Lawrence et al. 2004",
     "Half vectors from the factors of Lawrence, Rusinkiewicz and Ramamoorthi 2004."},
    {"bilgili", "Bilgili et al. 2011", "Half vectors from the factors of Bilgili, Öztürk and Kurt 2011."},
    {"ggx", "GGX fit", "The density of a fitted GGX model."},
    {"cosine", "Cosine-weighted", "Proportional to the cosine of the angle to the normal."},
}};

/// A BRDF whose values are not used.
template <typename Sampler>
class SamplerBrdf final : public Brdf {
 public:
  explicit SamplerBrdf(Sampler sampler) : sampler_(std::move(sampler)) {}

  void evaluate(std::span<const DirectionPair>, std::span<Rgb> values) const override {
    std::ranges::fill(values, Rgb(0));
  }
  bool hasImportanceSampling() const override { return true; }
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override { return sampler_.sample(wo, u); }
  double pdf(const Direction& wi, const Direction& wo) const override { return sampler_.pdf(wi, wo); }

 private:
  Sampler sampler_;
};

template <typename Sampler>
std::shared_ptr<const Brdf> brdfOf(Sampler sampler) {
  return std::make_shared<const SamplerBrdf<Sampler>>(std::move(sampler));
}

template <typename Sampler>
std::shared_ptr<const Brdf> pdvSampler(const TabulatedBrdf& table, const factorization::PdvOptions& options,
                                       const TaskControl& control) {
  const factorization::PdvFactors factors = factorization::factorizePdv(table, options, control).factors;
  return brdfOf(Sampler(*factorization::makePdvBrdf(factors), factors.thetaNodes, factors.deviationNodes));
}

std::shared_ptr<const TabulatedBrdf> tableOf(const std::shared_ptr<const Brdf>& brdf, const TaskControl& control) {
  if (auto table = std::dynamic_pointer_cast<const TabulatedBrdf>(brdf)) return table;
  constexpr int azimuths = 16;
  const HalfDifferenceGrid grid;
  return bakeTable(*brdf, brdf->isReciprocal() ? grid : grid.wholeCircle(), control, azimuths);
}

std::shared_ptr<const Brdf> samplerOf(std::string_view method, const TabulatedBrdf& table, const TaskControl& control) {
  using namespace factorization;
  if (method == "pdv") return pdvSampler<PdvSampler>(table, {.terms = 1}, control);
  if (method == "published")
    return pdvSampler<PublishedPdvSampler>(table, publishedPdvOptions(PdvForm::threeFactors, 1), control);
  if (method == "ggx") return models::ggx().instantiate(fitting::fit(table, models::ggx(), {}, control).parameters);
  constexpr std::size_t bytes[] = {44'680};
  return baselines::findBaseline(method).build(table, std::span(bytes), control).front().brdf;
}

}  // namespace

std::span<const SamplingMethod> samplingMethods() { return methods; }

std::shared_ptr<const RenderMaterial> sampledBy(std::string_view method, std::shared_ptr<const Brdf> brdf,
                                                const TaskControl& control) {
  if (std::ranges::find(methods, method, &SamplingMethod::id) == methods.end()) {
    std::string known;
    for (const SamplingMethod& each : methods) known += (known.empty() ? "" : ", ") + std::string(each.id);
    throw Error("sampling: found '" + std::string(method) + "', expected one of " + known);
  }
  if (method == methods.front().id) return std::make_shared<const RenderMaterial>(std::move(brdf));
  if (method == "cosine") return RenderMaterial::withSampler(std::move(brdf), brdfOf(cosineSampler()));
  const auto table = meanOfOrders(tableOf(brdf, control.between(0, 0.2)));
  return RenderMaterial::withSampler(std::move(brdf), samplerOf(method, *table, control.between(0.2, 1)));
}

}  // namespace gonio::rendering
