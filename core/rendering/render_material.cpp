// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/render_material.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/sampling.h"
#include "core/sampling/fitted_densities.h"
#include "core/support/error.h"

namespace gonio::rendering {

namespace {

constexpr std::uint32_t samples = 512;

/// A sampled direction stands for a piece of the hemisphere: how large that is, and what it reflects.
struct Piece {
  double value;       ///< of the BRDF, 1/sr
  double fraction;    ///< of the cosine-weighted hemisphere
  double reflection;  ///< of a light of radiance 1 from there
};

std::vector<Piece> drawnPieces(const Brdf& brdf, const ReflectionBound::Sampler& sampler, const Direction& wo) {
  std::vector<DirectionPair> pairs;
  std::vector<double> densities;
  for (std::uint32_t i = 0; i < samples; ++i) {
    const glm::dvec2 u = scrambledSobol(i, 1);
    const DirectionSample drawn = sampler(wo, {scrambledVanDerCorput(i, 2), u.x, u.y});
    if (!(drawn.pdf > 0)) continue;
    pairs.push_back({drawn.wi, wo});
    densities.push_back(drawn.pdf);
  }
  std::vector<Rgb> values(pairs.size());
  brdf.evaluate(pairs, values);
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double value = std::max(0.0, maxChannel(values[i])), cosine = pairs[i].wi.z;
    pieces.push_back({value, cosine / (pi * densities[i] * samples), value * cosine / (densities[i] * samples)});
  }
  std::ranges::sort(pieces, std::greater(), &Piece::value);
  return pieces;
}

}  // namespace

ReflectionBound::ReflectionBound(const Brdf& brdf, const Sampler& sampler) {
  for (const double theta : {0, 15, 30, 45, 60, 70, 75, 80, 85, 89})
    for (const double phi : {0, 45, 90, 135})
      if (phi == 0 || !brdf.isIsotropic()) include(brdf, sampler, fromSpherical(radians(theta), radians(phi)));
  for (std::size_t step = 1; step <= steps; ++step) bound_[step] = std::max(bound_[step], bound_[step - 1]);
}

ReflectionBound ReflectionBound::ofDiffuse(double albedo) {
  ReflectionBound bound;
  bound.peak_ = albedo / pi;
  bound.bound_.fill(albedo);  // at() then keeps to the peak's line
  return bound;
}

void ReflectionBound::include(const Brdf& brdf, const Sampler& sampler, const Direction& wo) {
  double fraction = 0, reflection = 0;
  std::size_t step = 1;
  for (const Piece& piece : drawnPieces(brdf, sampler, wo)) {
    peak_ = std::max(peak_, piece.value);
    // A step that ends within the piece has it whole: the bound errs upward.
    reflection += piece.reflection;
    fraction += piece.fraction;
    for (; step < steps && std::pow(double(step) / steps, 2) <= fraction; ++step)
      bound_[step] = std::max(bound_[step], reflection);
  }
  for (; step <= steps; ++step) bound_[step] = std::max(bound_[step], reflection);
}

double ReflectionBound::at(double fraction) const {
  const double place = std::sqrt(std::clamp(fraction, 0.0, 1.0)) * steps;
  const auto step = std::min(steps - 1, std::size_t(place));
  // Within the first step mirrors rise faster than any line.
  const double bound =
      step == 0 ? bound_[1] : bound_[step] + (place - double(step)) * (bound_[step + 1] - bound_[step]);
  return std::min(bound, pi * peak_ * std::clamp(fraction, 0.0, 1.0));
}

namespace {

class DiffuseBrdf final : public Brdf {
 public:
  explicit DiffuseBrdf(const Rgb& reflectance) : value_(reflectance / pi) {}

  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i)
      values[i] = isBelowHorizon(pairs[i].wi) || isBelowHorizon(pairs[i].wo) ? Rgb(0) : value_;
  }
  bool hasImportanceSampling() const override { return true; }

 private:
  Rgb value_;
};

}  // namespace

/// The one with the least noise at equal time: variance goes with the second moment of the estimator, samples with
/// time.
/// @param tabulated null: made where it is needed.
RenderMaterial::Density RenderMaterial::chosenDensity(const Brdf& brdf,
                                                      std::shared_ptr<const TabulatedDensity> tabulated) {
  constexpr double nearTheLeast = 1.1;  // costs are known to a tenth, and no moment is below 1
  const bool hasOwn = brdf.hasImportanceSampling();
  const std::vector<MomentProbe> probes = hasOwn ? momentProbes(brdf) : std::vector<MomentProbe>();
  const double own = samplerMoment(probes, brdf) * brdf.samplingCost();
  if (hasOwn && own < nearTheLeast) return {};
  if (!tabulated) tabulated = std::make_shared<const TabulatedDensity>(brdf);
  const std::optional<SamplingDensity>& symmetric = tabulated->symmetricDensity();
  if (hasOwn && own < (symmetric ? samplerMoment(probes, *symmetric)
                                 : samplerMoment(probes, tabulatedMixture(*tabulated)) * TabulatedDensity::cost))
    return {};
  if (symmetric) return {.closedForm = symmetric};
  return {.tabulated = std::move(tabulated)};
}

RenderMaterial::RenderMaterial(std::shared_ptr<const Brdf> brdf, Density density)
    : brdf_(std::move(brdf)),
      density_(std::move(density)),
      bound_(*brdf_, [this](const Direction& wo, const glm::dvec3& u) { return sample(wo, u); }) {}

RenderMaterial::RenderMaterial(std::shared_ptr<const Brdf> brdf, std::optional<SamplingDensity> density, DensityUse use)
    : RenderMaterial(brdf, density && (use == DensityUse::always || !brdf->hasImportanceSampling())
                               ? Density{.closedForm = density}
                               : chosenDensity(*brdf, nullptr)) {}

RenderMaterial::RenderMaterial(std::shared_ptr<const Brdf> brdf, std::shared_ptr<const TabulatedDensity> tabulated)
    : RenderMaterial(brdf, chosenDensity(*brdf, std::move(tabulated))) {}

std::shared_ptr<const RenderMaterial> diffuseMaterial(const Rgb& reflectance) {
  return std::shared_ptr<const RenderMaterial>(new RenderMaterial(std::make_shared<const DiffuseBrdf>(reflectance),
                                                                  ReflectionBound::ofDiffuse(maxChannel(reflectance))));
}

RenderMaterials materialsInSlots(const Scene& scene, const std::shared_ptr<const RenderMaterial>& first,
                                 const RenderMaterials& others) {
  RenderMaterials materials(std::size_t(materialSlotCount(scene)), first);
  for (std::size_t i = 1; i < materials.size() && i <= others.size(); ++i)
    if (others[i - 1]) materials[i] = others[i - 1];
  return materials;
}

std::vector<std::shared_ptr<const RenderMaterial>> bindMaterials(
    const Scene& scene, std::span<const std::shared_ptr<const RenderMaterial>> slotMaterials) {
  if (std::size_t(materialSlotCount(scene)) > slotMaterials.size())
    throw Error("the scene '" + scene.name + "' shows " + std::to_string(materialSlotCount(scene)) +
                " materials, found " + std::to_string(slotMaterials.size()));
  std::vector<std::shared_ptr<const RenderMaterial>> materials;
  for (const SceneObject& object : scene.objects) {
    if (object.emits())
      materials.push_back(nullptr);
    else if (const auto* diffuse = std::get_if<Diffuse>(&object.material))
      materials.push_back(diffuseMaterial(diffuse->reflectance));
    else
      materials.push_back(slotMaterials[std::size_t(std::get<MaterialSlot>(object.material).number)]);
  }
  return materials;
}

}  // namespace gonio::rendering
