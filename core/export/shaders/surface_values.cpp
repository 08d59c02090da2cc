// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/shaders/surface_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/export/shaders/reciprocal_lobes.h"
#include "core/fitting/bounded_least_squares.h"

namespace gonio::exports {

namespace {

constexpr int trialIterations = 10, finalIterations = 40;
constexpr std::size_t finalists = 2;

/// The numbers of a field: three of a colour, else one.
template <typename Values>
auto numbersOf(Values& v, SurfaceField field) {
  using Number = std::conditional_t<std::is_const_v<Values>, const double, double>;
  const auto colour = [](auto& c) { return std::span<Number>(&c.x, 3); };
  const auto number = [](auto& n) { return std::span<Number>(&n, 1); };
  switch (field) {
    case SurfaceField::baseColour:
      return colour(v.baseColour);
    case SurfaceField::metalness:
      return number(v.metalness);
    case SurfaceField::roughness:
      return number(v.roughness);
    case SurfaceField::anisotropy:
      return number(v.anisotropy);
    case SurfaceField::rotation:
      return number(v.rotation);
    case SurfaceField::specularColour:
      return colour(v.specularColour);
    case SurfaceField::specular:
      return number(v.specular);
    case SurfaceField::specularTint:
      return number(v.specularTint);
    case SurfaceField::ior:
      return number(v.ior);
    case SurfaceField::coat:
      return number(v.coat);
    case SurfaceField::coatRoughness:
      return number(v.coatRoughness);
    case SurfaceField::sheenColour:
      return colour(v.sheenColour);
    default:
      return number(v.sheenRoughness);
  }
}

/// A search over the values that a shader takes.
class SurfaceSearch {
 public:
  SurfaceSearch(const SurfaceShader& shader, const Brdf& material, const PictureCells& cells)
      : shader_(shader), cells_(cells), target_(cells.residualsOfMaterial(material)) {
    for (const SurfaceLimit& limit : shader.limits)
      if (!cells.isIsotropic() || (limit.field != SurfaceField::anisotropy && limit.field != SurfaceField::rotation))
        limits_.push_back(limit);
  }

  SurfaceValues refined(const SurfaceValues& start, int iterations, const TaskControl& control) const {
    fitting::BoundedVariables variables;
    for (const SurfaceLimit& limit : limits_)
      for (const double number : numbersOf(start, limit.field)) {
        variables.start.push_back(number);
        variables.minimum.push_back(limit.minimum);
        variables.maximum.push_back(limit.maximum);
      }
    const auto function = [&](std::span<const double> x, std::span<double> residuals) {
      differences(at(x), residuals);
    };
    const auto x = fitting::boundedLeastSquares(function, target_.size(), variables, iterations, control.stop);
    control.throwIfStopped();
    return at(x);
  }

  double cost(const SurfaceValues& values) const {
    std::vector<double> residuals(target_.size());
    differences(values, residuals);
    double sum = 0;
    for (const double residual : residuals) sum += residual * residual;
    return sum;
  }

 private:
  SurfaceValues at(std::span<const double> x) const {
    SurfaceValues values = shader_.defaults;
    std::size_t next = 0;
    for (const SurfaceLimit& limit : limits_)
      for (double& number : numbersOf(values, limit.field))
        number = std::clamp(x[next++], limit.minimum, limit.maximum);
    return values;
  }
  void differences(const SurfaceValues& values, std::span<double> residuals) const {
    const std::vector<double> found = cells_.residualsOf(*shader_.brdf(values));
    std::ranges::transform(found, target_, residuals.begin(), std::minus{});
  }

  const SurfaceShader& shader_;
  const PictureCells& cells_;
  std::vector<double> target_;
  std::vector<SurfaceLimit> limits_;
};

double albedoOf(const ReciprocalLobes::Lobe& lobe) { return maxChannel(0.9 * lobe.normal + 0.1 * lobe.edge); }

/// Metals and dielectrics with the widths and colours of the lobes, with the strongest lobe or the widest as the base
/// and the sharpest as a coat.
std::vector<SurfaceValues> surfaceStarts(const SurfaceShader& shader, const ReciprocalLobes& lobes) {
  SurfaceValues plain = shader.defaults;
  if (lobes.lobes.empty()) {
    plain.baseColour = lobes.diffuse;
    plain.roughness = 1;
    return {plain};
  }
  const auto& strongest = *std::ranges::max_element(lobes.lobes, {}, albedoOf);
  const auto root = [](const ReciprocalLobes::Lobe& lobe) { return std::sqrt(lobe.alpha.mean()); };
  // The shaders' x axis is that of the wider slopes.
  plain.rotation = lobes.rotation + (strongest.alpha.x < strongest.alpha.y ? halfPi : 0);
  plain.anisotropy = lobes.isIsotropic() ? 0 : 0.5;
  plain.roughness = root(strongest);
  SurfaceValues metal = plain, dielectric = plain;
  metal.metalness = 0.9;
  metal.baseColour = glm::clamp(strongest.normal + 0.5 * lobes.diffuse, 0.01, 0.99);
  dielectric.metalness = 0.1;
  dielectric.baseColour = glm::clamp(lobes.diffuse, 0.01, 0.99);
  std::vector<SurfaceValues> starts{metal, dielectric};
  if (!shader.isFitted(SurfaceField::coat)) return starts;
  for (SurfaceValues values : {metal, dielectric}) {
    values.roughness = root(lobes.lobes.front());
    values.coat = 0.5;
    values.coatRoughness = root(lobes.lobes.back());
    starts.push_back(values);
  }
  return starts;
}

}  // namespace

bool SurfaceShader::isFitted(SurfaceField field) const {
  return std::ranges::find(limits, field, &SurfaceLimit::field) != limits.end();
}

SurfaceValues fitSurface(const SurfaceShader& shader, const Brdf& material, const TaskControl& control) {
  const PictureCells cells(material.isIsotropic() || !shader.isFitted(SurfaceField::anisotropy));
  const auto starts = surfaceStarts(shader, fitReciprocalLobes(material, cells, 2, control.between(0, 0.2)));
  const SurfaceSearch search(shader, material, cells);
  std::vector<std::pair<double, SurfaceValues>> found;
  for (const SurfaceValues& start : starts) {
    const SurfaceValues values = search.refined(start, trialIterations, control);
    found.emplace_back(search.cost(values), values);
    control.report(0.2 + 0.4 * double(found.size()) / double(starts.size()));
  }
  const auto byCost = [](const auto& one) { return one.first; };
  std::ranges::stable_sort(found, {}, byCost);
  found.resize(std::min(found.size(), finalists));
  for (auto& [cost, values] : found) {
    values = search.refined(values, finalIterations, control);
    cost = search.cost(values);
  }
  control.report(1);
  return std::ranges::min_element(found, {}, byCost)->second;
}

}  // namespace gonio::exports
