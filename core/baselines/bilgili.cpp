// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/bilgili.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/baselines/half_vector_sampler.h"
#include "core/coordinates/half_out.h"
#include "core/factorization/masked_rank_one.h"
#include "core/math/monotone_cubic.h"

namespace gonio::baselines {

namespace {

/// All cells count: a hole takes the value of the theta_h before. Left free, products grow without bounds there, and
/// pairs between a hole and a measured node would read them.
factorization::MaskedTensor logarithm(const HalfOutSamples& s, std::optional<int> channel) {
  const HalfOutAxes& axes = s.axes;
  const std::size_t slice = axes.phiH.size() * axes.thetaO.size();
  factorization::MaskedTensor tensor;
  tensor.sizes[0] = int(axes.thetaH.size());
  tensor.sizes[1] = int(axes.phiH.size());
  tensor.sizes[2] = int(axes.thetaO.size());
  tensor.weights.assign(s.values.size(), 1.0f);
  for (std::size_t i = 0; i < s.values.size(); ++i)
    tensor.values.push_back(s.valid[i]   ? float(std::log1p(channel ? s.values[i][*channel] : luminance(s.values[i])))
                            : i >= slice ? tensor.values[i - slice]
                                         : 0.0f);
  return tensor;
}

double between(const std::vector<double>& curve, const NodeInterval& at) {
  return (1 - at.fraction) * curve[at.index] + at.fraction * curve[at.index + 1];
}

double valueAt(const BilgiliFactors& f, const HalfOut& at) {
  const NodeInterval h = findInterval(f.axes.thetaH, at.thetaH), p = findInterval(f.axes.phiH, std::abs(at.phiH)),
                     o = findInterval(f.axes.thetaO, at.thetaO);
  double sum = 0;
  for (const BilgiliFactors::Term& term : f.terms) sum += between(term.a, h) * between(term.b, p) * between(term.c, o);
  return std::expm1(std::clamp(sum, 0.0, f.highest));
}

/// kd and ks of each channel: the line rho = kd + ks Y of least weighted squares. A constant Y keeps ks alone.
void fitColours(const HalfOutSamples& s, BilgiliFactors& f) {
  f.kd = f.ks = Rgb(0);
  double weights = 0, y = 0, yy = 0;
  Rgb rho(0), rhoY(0);
  const HalfOutAxes& axes = s.axes;
  for (std::size_t h = 0, at = 0; h < axes.thetaH.size(); ++h)
    for (std::size_t p = 0; p < axes.phiH.size(); ++p)
      for (std::size_t o = 0; o < axes.thetaO.size(); ++o, ++at) {
        const double weight = projectedMeasure(s, h, p, o);
        if (!(weight > 0)) continue;
        const double value = valueAt(f, {.thetaO = axes.thetaO[o], .thetaH = axes.thetaH[h], .phiH = axes.phiH[p]});
        weights += weight;
        y += weight * value;
        yy += weight * value * value;
        rho += weight * s.values[at];
        rhoY += weight * value * s.values[at];
      }
  const double determinant = weights * yy - y * y;
  if (determinant > 1e-12 * weights * yy) {
    f.ks = (weights * rhoY - y * rho) / determinant;
    f.kd = (yy * rho - y * rhoY) / determinant;
  } else if (yy > 0) {
    f.ks = rhoY / yy;
  }
}

std::size_t termBytes(const HalfOutAxes& axes) {
  return (axes.thetaH.size() + axes.phiH.size() + axes.thetaO.size()) * sizeof(float);
}

constexpr std::size_t colourBytes = 7 * sizeof(float);  // kd, ks, highest

/// @param parts the luminance, or three channels.
Rgb reflectanceAt(std::span<const BilgiliFactors> parts, const HalfOut& at) {
  if (parts.size() == 1) return glm::max(Rgb(0), parts[0].kd + parts[0].ks * valueAt(parts[0], at));
  return {valueAt(parts[0], at), valueAt(parts[1], at), valueAt(parts[2], at)};
}

/// The luminance times the cosine of the light at the nodes, per solid angle of the half vector.
TensorHalfVectorSampler bilgiliSampler(std::span<const BilgiliFactors> parts) {
  const HalfOutAxes& axes = parts[0].axes;
  std::vector<double> density(axes.size(), 0);
  for (std::size_t h = 0; h < axes.thetaH.size(); ++h)
    for (std::size_t p = 0; p < axes.phiH.size(); ++p)
      for (std::size_t o = 0; o < axes.thetaO.size(); ++o) {
        const HalfOut node{.thetaO = axes.thetaO[o], .thetaH = axes.thetaH[h], .phiH = axes.phiH[p]};
        const auto [pair, valid] = fromHalfOut(node);
        if (!valid) continue;
        const double cosD = glm::dot(fromSpherical(node.thetaO, 0), fromSpherical(node.thetaH, node.phiH));
        density[axes.index(h, p, o)] =
            luminance(reflectanceAt(parts, node)) * std::max(0.0, pair.wi.z) * halfOutJacobian(std::max(0.0, cosD));
      }
  return {axes, density};
}

class BilgiliBrdf final : public Brdf {
 public:
  explicit BilgiliBrdf(std::vector<BilgiliFactors> parts) : parts_(std::move(parts)) {}

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [wi, wo] = pairs[i];
      values[i] = Rgb(0);
      if (isBelowHorizon(wi) || isBelowHorizon(wo)) continue;
      if (const HalfOut at = toHalfOut(wi, wo); at.valid) values[i] = reflectanceAt(parts_, at);
    }
  }
  bool isReciprocal() const override { return false; }
  bool hasImportanceSampling() const override { return true; }
  double samplingCost() const override { return 2; }
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override { return sampler().sample(wo, u); }
  double pdf(const Direction& wi, const Direction& wo) const override { return sampler().pdf(wi, wo); }

 private:
  const TensorHalfVectorSampler& sampler() const {
    std::call_once(samplerOnce_, [this] { sampler_.emplace(bilgiliSampler(parts_)); });
    return *sampler_;
  }

  std::vector<BilgiliFactors> parts_;
  mutable std::once_flag samplerOnce_;
  mutable std::optional<TensorHalfVectorSampler> sampler_;
};

}  // namespace

std::size_t BilgiliFactors::bytes() const {
  return terms.size() * termBytes(axes) + (channel ? sizeof(float) : colourBytes);
}

HalfOutAxes bilgiliAxes() { return makeHalfOutAxes(90, 45, 45); }

int bilgiliTerms(const HalfOutAxes& axes, std::size_t byteBudget) {
  const std::size_t room = byteBudget > colourBytes ? byteBudget - colourBytes : 0;
  return int(std::max<std::size_t>(1, room / termBytes(axes)));
}

BilgiliFactors factorizeBilgili(const HalfOutSamples& samples, int terms, std::optional<int> channel,
                                const TaskControl& control) {
  BilgiliFactors result{.axes = samples.axes, .channel = channel};
  factorization::MaskedTensor left = logarithm(samples, channel);
  const double total = left.squaredNorm();
  if (!left.values.empty()) result.highest = *std::max_element(left.values.begin(), left.values.end());
  result.residuals.push_back(total > 0 ? 1 : 0);
  for (int l = 0; l < terms; ++l) {
    control.throwIfStopped();
    control.report(double(l) / terms);
    factorization::RankOne best = factorization::bestRankOne(left, {.maxSweeps = 60, .tolerance = 1e-6});
    factorization::subtract(left, best);
    result.terms.push_back({std::move(best.a), std::move(best.b), std::move(best.c)});
    result.residuals.push_back(total > 0 ? std::sqrt(left.squaredNorm() / total) : 0);
  }
  if (!channel) fitColours(samples, result);
  return result;
}

BilgiliFactors truncateBilgili(const BilgiliFactors& factors, int terms, const HalfOutSamples& samples) {
  BilgiliFactors result = factors;
  const std::size_t count = std::min(std::size_t(std::max(terms, 1)), factors.terms.size());
  result.terms.resize(count);
  result.residuals.resize(count + 1);
  if (!result.channel) fitColours(samples, result);
  return result;
}

std::shared_ptr<const Brdf> makeBilgiliBrdf(BilgiliFactors luminance) {
  return std::make_shared<const BilgiliBrdf>(std::vector{std::move(luminance)});
}

std::shared_ptr<const Brdf> makeBilgiliBrdf(std::array<BilgiliFactors, 3> channels) {
  return std::make_shared<const BilgiliBrdf>(std::vector<BilgiliFactors>(channels.begin(), channels.end()));
}

}  // namespace gonio::baselines
