// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/half_vector_sampler.h"

#include <algorithm>
#include <cmath>

#include "core/brdf/density_mixture.h"
#include "core/coordinates/half_out.h"
#include "core/math/monotone_cubic.h"
#include "core/math/sampling.h"

namespace gonio::baselines {

namespace {

std::vector<double> powerNodes(int count, double last, double exponent) {
  std::vector<double> nodes;
  for (int i = 0; i < count; ++i) nodes.push_back(last * std::pow(double(i) / (count - 1), exponent));
  return nodes;
}

}  // namespace

HalfOutAxes makeHalfOutAxes(int thetaHCount, int phiHCount, int thetaOCount) {
  return {.thetaH = powerNodes(thetaHCount, factorization::maxPolarAngle, 2),
          .phiH = powerNodes(phiHCount, pi, 1),
          .thetaO = powerNodes(thetaOCount, factorization::maxPolarAngle, 1)};
}

HalfOutSamples sampleHalfOut(const TabulatedBrdf& table, const HalfOutAxes& axes, const TaskControl& control) {
  const auto readingsOf = [&](std::size_t h, std::size_t p, std::size_t o) {
    const auto [pair, valid] = fromHalfOut({.thetaO = axes.thetaO[o], .thetaH = axes.thetaH[h], .phiH = axes.phiH[p]});
    const Direction mirrored(pair.wi.x, -pair.wi.y, pair.wi.z);
    return factorization::NodeReadings<2>{
        .pair = pair, .at = {toHalfDifference(pair.wi, pair.wo), toHalfDifference(mirrored, pair.wo)}, .valid = valid};
  };
  return factorization::sampleNodes(table, axes, axes.phiH.size(), axes.thetaO.size(), readingsOf, control);
}

double projectedMeasure(const HalfOutSamples& samples, std::size_t h, std::size_t p, std::size_t o) {
  const HalfOutAxes& axes = samples.axes;
  const std::size_t i = axes.index(h, p, o);
  if (!samples.valid[i]) return 0;
  const double thetaO = axes.thetaO[o], thetaH = axes.thetaH[h];
  const double cosD = glm::dot(fromSpherical(thetaO, 0), fromSpherical(thetaH, axes.phiH[p]));
  return samples.cosI[i] * std::cos(thetaO) * std::sin(thetaO) * std::sin(thetaH) * halfOutJacobian(cosD) *
         factorization::nodeSpacing(axes.thetaH, h) * factorization::nodeSpacing(axes.phiH, p) *
         factorization::nodeSpacing(axes.thetaO, o);
}

namespace {

constexpr double cosineFraction = 0.1;

/// 1 - cos, exact about 0.
double versine(double theta) { return 2 * std::pow(std::sin(theta / 2), 2); }

/// A viewer along the normal has no azimuth: half vectors are sampled evenly about it.
bool isVertical(const Direction& wo) { return wo.x == 0 && wo.y == 0; }

double polarAngle(const Direction& w) { return std::atan2(std::hypot(w.x, w.y), w.z); }

}  // namespace

LinearDensity::LinearDensity(const std::vector<double>& nodes, std::vector<double> values)
    : values_(std::move(values)), cumulative_{0} {
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    cumulative_.push_back(cumulative_.back() + (values_[i] + values_[i + 1]) / 2 * (nodes[i + 1] - nodes[i]));
}

double LinearDensity::sample(const std::vector<double>& nodes, double u) const {
  const double wanted = u * integral();
  const auto after = std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, wanted);
  const auto i = std::size_t(after - cumulative_.begin()) - 1;
  const double width = nodes[i + 1] - nodes[i], area = std::max(0.0, wanted - cumulative_[i]) / width;
  return nodes[i] + inverseOfRamp(values_[i], values_[i + 1], area) * width;
}

double LinearDensity::at(const std::vector<double>& nodes, double x) const {
  if (x < nodes.front() || x > nodes.back()) return 0;
  const NodeInterval place = findInterval(nodes, x);
  return (1 - place.fraction) * values_[place.index] + place.fraction * values_[place.index + 1];
}

HalfVectorSampler::HalfVectorSampler(const HalfOutAxes& axes, const std::vector<Product>& products)
    : phiH_(axes.phiH), thetaO_(axes.thetaO) {
  for (const double theta : axes.thetaH) versines_.push_back(versine(theta));
  for (const Product& product : products)
    curves_.push_back({LinearDensity(versines_, product.polar), LinearDensity(phiH_, product.azimuth), product.viewer});
}

/// Integral of the product over all half vectors, both signs of phi_h.
double HalfVectorSampler::strength(const Curves& curves, double thetaO) const {
  const NodeInterval place = findInterval(thetaO_, thetaO);
  const double viewer =
      (1 - place.fraction) * curves.viewer[place.index] + place.fraction * curves.viewer[place.index + 1];
  return 2 * viewer * curves.polar.integral() * curves.azimuth.integral();
}

double HalfVectorSampler::total(double thetaO) const {
  double sum = 0;
  for (const Curves& curves : curves_) sum += strength(curves, thetaO);
  return sum;
}

DirectionSample HalfVectorSampler::sample(const Direction& wo, const glm::dvec3& u) const {
  const double thetaO = polarAngle(wo), all = total(thetaO), cosinePart = all > 0 ? cosineFraction : 1;
  if (u.x < cosinePart) {
    const Direction wi = CosineDensity().sample(wo, {u.y, u.z});
    return {wi, pdf(wi, wo)};
  }
  double wanted = (u.x - cosinePart) / (1 - cosinePart) * all;
  const Curves* chosen = nullptr;
  double mass = 0;
  for (const Curves& curves : curves_) {
    if (const double one = strength(curves, thetaO); one > 0) {
      chosen = &curves;
      mass = one;
      if (wanted < one) break;
      wanted -= one;
    }
  }
  // What is left of the number that chose the product chooses the side.
  const double side = 2 * std::clamp(wanted / mass, 0.0, 1.0) < 1 ? 1 : -1;
  const double height = chosen->polar.sample(versines_, u.y), sine = std::sqrt(height * (2 - height));
  const double azimuth = isVertical(wo) ? pi * u.z : chosen->azimuth.sample(phiH_, u.z);
  const double phi = std::atan2(wo.y, wo.x) + side * azimuth;
  const Direction h(sine * std::cos(phi), sine * std::sin(phi), 1 - height);
  const double cosD = glm::dot(wo, h);
  const Direction wi = glm::normalize(2 * cosD * h - wo);
  if (!(cosD > 0) || !(wi.z > 0)) return {wi, 0};
  return {wi, pdf(wi, wo)};
}

double HalfVectorSampler::pdf(const Direction& wi, const Direction& wo) const {
  if (isBelowHorizon(wi) || isBelowHorizon(wo)) return 0;
  const HalfOut at = toHalfOut(wi, wo);
  const double cosine = std::max(0.0, wi.z) / pi, all = total(at.thetaO);
  if (!(all > 0) || !at.valid) return all > 0 ? cosineFraction * cosine : cosine;
  const NodeInterval place = findInterval(thetaO_, at.thetaO);
  const double height = versine(at.thetaH), phi = std::abs(at.phiH);
  double sum = 0;
  for (const Curves& curves : curves_) {
    const double viewer =
        (1 - place.fraction) * curves.viewer[place.index] + place.fraction * curves.viewer[place.index + 1];
    if (!(viewer > 0)) continue;
    const double azimuth = isVertical(wo) ? curves.azimuth.integral() / pi : curves.azimuth.at(phiH_, phi);
    sum += viewer * curves.polar.at(versines_, height) * azimuth;
  }
  const double cosD = std::cos(std::atan2(glm::length(wi - wo), glm::length(wi + wo)));
  return cosineFraction * cosine + (1 - cosineFraction) * sum / (all * halfOutJacobian(std::max(cosD, 1e-12)));
}

namespace {

constexpr double tensorCosineFraction = 0.1;

/// 1 - cos, exact about 0.
double versineOf(double theta) { return 2 * std::pow(std::sin(theta / 2), 2); }

bool isAlongNormal(const Direction& wo) { return wo.x == 0 && wo.y == 0; }

/// A uniform number reused: chooses the first of two alternatives with probability `first`, and is scaled back to [0,
/// 1). Returns whether the first was chosen.
bool choose(double& u, double first) {
  const bool isFirst = u < first;
  u = isFirst ? u / first : (u - first) / (1 - first);
  u = std::clamp(u, 0.0, 1 - 1e-12);
  return isFirst;
}

}  // namespace

TensorHalfVectorSampler::TensorHalfVectorSampler(const HalfOutAxes& axes, const std::vector<double>& density)
    : phiH_(axes.phiH), thetaO_(axes.thetaO) {
  for (const double theta : axes.thetaH) versines_.push_back(versineOf(theta));
  for (std::size_t o = 0; o < thetaO_.size(); ++o) {
    std::vector<LinearDensity> azimuths;
    std::vector<double> totals;
    for (std::size_t h = 0; h < versines_.size(); ++h) {
      std::vector<double> row;
      for (std::size_t p = 0; p < phiH_.size(); ++p) row.push_back(density[axes.index(h, p, o)]);
      totals.push_back(azimuths.emplace_back(phiH_, std::move(row)).integral());
    }
    slices_.push_back({LinearDensity(versines_, std::move(totals)), std::move(azimuths)});
  }
}

TensorHalfVectorSampler::Choice TensorHalfVectorSampler::choiceOf(double thetaO) const {
  const NodeInterval place = findInterval(thetaO_, thetaO);
  Choice choice;
  double sum = 0;
  for (const auto& [slice, weight] :
       {std::pair(place.index, 1 - place.fraction), std::pair(place.index + 1, place.fraction)}) {
    if (!(weight > 0) || !(slices_[slice].polar.integral() > 0)) continue;
    choice.slices[choice.count] = slice;
    choice.weights[choice.count++] = weight;
    sum += weight;
  }
  for (double& weight : choice.weights) weight /= sum > 0 ? sum : 1;
  return choice;
}

DirectionSample TensorHalfVectorSampler::sample(const Direction& wo, const glm::dvec3& u) const {
  const Choice choice = choiceOf(std::atan2(std::hypot(wo.x, wo.y), wo.z));
  double pick = u.x;
  if (choice.count == 0 || choose(pick, tensorCosineFraction)) {
    const Direction wi = CosineDensity().sample(wo, {u.y, u.z});
    return {wi, pdf(wi, wo)};
  }
  const bool isFirst = choice.count == 1 || choose(pick, choice.weights[0]);
  const Slice& slice = slices_[choice.slices[isFirst ? 0 : 1]];
  const double height = slice.polar.sample(versines_, u.y);
  // At this height the density over phi_h is a mixture of those of the two nodes about it.
  const NodeInterval place = findInterval(versines_, height);
  const double low = (1 - place.fraction) * slice.azimuths[place.index].integral(),
               high = place.fraction * slice.azimuths[place.index + 1].integral();
  const std::size_t row = low + high > 0 && choose(pick, low / (low + high)) ? place.index : place.index + 1;
  const double azimuth = isAlongNormal(wo) ? pi * u.z : slice.azimuths[row].sample(phiH_, u.z);
  const double side = choose(pick, 0.5) ? 1 : -1;
  const double sine = std::sqrt(height * (2 - height)), phi = std::atan2(wo.y, wo.x) + side * azimuth;
  const Direction h(sine * std::cos(phi), sine * std::sin(phi), 1 - height);
  const double cosD = glm::dot(wo, h);
  const Direction wi = glm::normalize(2 * cosD * h - wo);
  if (!(cosD > 0) || !(wi.z > 0)) return {wi, 0};
  return {wi, pdf(wi, wo)};
}

/// Per solid angle of the half vector, both signs of phi_h.
double TensorHalfVectorSampler::density(const Slice& slice, double versine, double phi, bool vertical) const {
  if (versine > versines_.back()) return 0;
  const NodeInterval place = findInterval(versines_, versine);
  const auto row = [&](std::size_t h) {
    const LinearDensity& azimuths = slice.azimuths[h];
    return vertical ? azimuths.integral() / pi : azimuths.at(phiH_, phi);
  };
  return ((1 - place.fraction) * row(place.index) + place.fraction * row(place.index + 1)) /
         (2 * slice.polar.integral());
}

double TensorHalfVectorSampler::pdf(const Direction& wi, const Direction& wo) const {
  if (isBelowHorizon(wi) || isBelowHorizon(wo)) return 0;
  const HalfOut at = toHalfOut(wi, wo);
  const double cosine = std::max(0.0, wi.z) / pi;
  const Choice choice = choiceOf(at.thetaO);
  if (choice.count == 0) return cosine;
  if (!at.valid) return tensorCosineFraction * cosine;
  double sum = 0;
  for (std::size_t i = 0; i < choice.count; ++i)
    sum += choice.weights[i] *
           density(slices_[choice.slices[i]], versineOf(at.thetaH), std::abs(at.phiH), isAlongNormal(wo));
  const double cosD = std::cos(std::atan2(glm::length(wi - wo), glm::length(wi + wo)));
  return tensorCosineFraction * cosine + (1 - tensorCosineFraction) * sum / halfOutJacobian(std::max(cosD, 1e-12));
}

}  // namespace gonio::baselines
