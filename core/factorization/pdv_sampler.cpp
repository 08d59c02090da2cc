// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_sampler.h"

#include <algorithm>
#include <cmath>

#include "core/brdf/density_mixture.h"
#include "core/coordinates/projected_deviation.h"
#include "core/math/monotone_cubic.h"

namespace gonio::factorization {

namespace {

constexpr double leastCosineShare = 0.1;
constexpr double smallestSampledCosine = 1e-9;

/// The viewer, with the azimuth that projected deviations refer to.
struct Viewer {
  explicit Viewer(const Direction& wo)
      : sine(std::hypot(wo.x, wo.y)),
        theta(std::atan2(sine, wo.z)),
        azimuth(sine > 0 ? glm::dvec2(wo.x, wo.y) / sine : glm::dvec2(1, 0)) {}

  double sine, theta;
  glm::dvec2 azimuth;

  /// The point of the disk.
  glm::dvec2 pointAt(double deviation, double phi) const {
    const glm::dvec2 local(deviation * std::cos(phi) - sine, deviation * std::sin(phi));
    return {azimuth.x * local.x - azimuth.y * local.y, azimuth.y * local.x + azimuth.x * local.y};
  }
};

/// The direction above a point of the disk; one on its rim is lifted by less than any cosine resolves.
Direction directionAbove(glm::dvec2 point) {
  const double radius = glm::length(point);
  if (radius > 1) point /= radius;
  const double cosine = radius < 1 ? std::sqrt((1 - radius) * (1 + radius)) : 0;
  return {point.x, point.y, std::max(cosine, smallestSampledCosine)};
}

/// No more rows than improve the sampling: of many nodes (files may hold thousands) some, the ends among them.
std::vector<double> thinned(const std::vector<double>& nodes) {
  constexpr std::size_t most = 181;
  if (nodes.size() <= most) return nodes;
  std::vector<double> result;
  for (std::size_t i = 0; i < most; ++i) result.push_back(nodes[i * (nodes.size() - 1) / (most - 1)]);
  return result;
}

double deviationOf(const Direction& wi, const Direction& wo) { return std::hypot(wi.x + wo.x, wi.y + wo.y); }

/// Evenly in area.
double deviationIn(double low, double high, double u) { return std::sqrt(low * low + u * (high - low) * (high + low)); }

}  // namespace

DeviationRows::DeviationRows(const Brdf& brdf, const std::vector<double>& thetaNodes, const std::vector<double>& edges,
                             Ring ring)
    : thetaNodes_(thinned(thetaNodes)), edges_(thinned(edges)), cumulative_(thetaNodes_.size() * edges_.size(), 0.0) {
  for (std::size_t i = 0; i < thetaNodes_.size(); ++i) fillRow(brdf, i, ring);
}

void DeviationRows::fillRow(const Brdf& brdf, std::size_t index, Ring ring) {
  constexpr int steps = 2, azimuths = 8;
  const double theta = thetaNodes_[index], sine = std::sin(theta);
  std::vector<DirectionPair> pairs;
  std::vector<double> weights;
  std::vector<std::size_t> bins;
  // A bin that the row before does not reach has no fraction: between them it may not be on the disk.
  const double reach = 1 + std::sin(thetaNodes_[index > 0 ? index - 1 : 0]);
  std::size_t bin = 0;
  for (; bin < this->bins() && low(bin) < reach; ++bin)
    for (int step = 0; step < steps; ++step) {
      const double end = high(bin, sine), area = (end - low(bin)) * (end + low(bin)) / steps;
      const double deviation = deviationIn(low(bin), end, (step + 0.5) / steps), limit = azimuthLimit(deviation, sine);
      for (int k = 0; k < azimuths; ++k) {
        const auto at = fromProjectedDeviation({theta, deviation, limit * (k + 0.5) / azimuths});
        pairs.push_back(at.pair);
        weights.push_back(area * (ring == Ring::whole ? pi : limit));
        bins.push_back(bin);
      }
    }
  std::vector<Rgb> values(pairs.size());
  brdf.evaluate(pairs, values);
  double* fractions = cumulative_.data() + index * edges_.size();
  for (std::size_t n = 0; n < pairs.size(); ++n)
    fractions[bins[n] + 1] += weights[n] * (values[n].x + values[n].y + values[n].z);
  for (std::size_t j = 0; j < this->bins(); ++j) fractions[j + 1] += fractions[j];
  const double total = fractions[this->bins()];
  const bool black = !(total > 0) || !std::isfinite(total);
  for (std::size_t j = 0; j <= this->bins(); ++j) fractions[j] = black ? 0 : fractions[j] / total;
}

double DeviationRows::high(std::size_t bin, double sinThetaR) const { return std::min(edges_[bin + 1], 1 + sinThetaR); }

std::size_t DeviationRows::binOf(double deviation) const {
  const auto above = std::upper_bound(edges_.begin(), edges_.end(), deviation);
  return std::size_t(above - edges_.begin()) - 1;
}

std::size_t DeviationRows::sampleBin(double thetaR, double u) const {
  const NodeInterval at = findInterval(thetaNodes_, thetaR);
  const double *before = row(at.index), *after = row(at.index + 1), last = double(bins());
  // A black row has nothing to give: only the other one is sampled.
  const double fraction = after[bins()] == 0 ? 0 : before[bins()] == 0 ? 1 : at.fraction;
  const bool second = u < fraction;
  const double within = second ? u / fraction : (u - fraction) / (1 - fraction);
  const double* chosen = second ? after : before;
  const auto above = std::upper_bound(chosen + 1, chosen + bins() + 1, within);
  std::size_t bin = std::size_t(std::min(double(above - chosen) - 1, last - 1));
  // Rounding may reach behind the last bin that has a fraction.
  while (bin > 0 && chosen[bin + 1] <= chosen[bin]) --bin;
  return bin;
}

double DeviationRows::probability(double thetaR, std::size_t bin) const {
  const NodeInterval at = findInterval(thetaNodes_, thetaR);
  const double *before = row(at.index), *after = row(at.index + 1);
  const double fraction = after[bins()] == 0 ? 0 : before[bins()] == 0 ? 1 : at.fraction;
  return (1 - fraction) * (before[bin + 1] - before[bin]) + fraction * (after[bin + 1] - after[bin]);
}

double DeviationRows::blackFraction(double thetaR) const {
  const NodeInterval at = findInterval(thetaNodes_, thetaR);
  return (1 - at.fraction) * (1 - row(at.index)[bins()]) + at.fraction * (1 - row(at.index + 1)[bins()]);
}

PdvSampler::PdvSampler(const Brdf& brdf, const std::vector<double>& thetaNodes,
                       const std::vector<double>& deviationNodes)
    : rows_(brdf, thetaNodes, deviationNodes, DeviationRows::Ring::onDisk) {}

double PdvSampler::cosineFraction(double thetaR) const {
  return leastCosineShare + (1 - leastCosineShare) * rows_.blackFraction(thetaR);
}

DirectionSample PdvSampler::sample(const Direction& wo, const glm::dvec3& u) const {
  const Viewer viewer(wo);
  const double cosine = cosineFraction(viewer.theta);
  Direction wi;
  if (u.x < cosine) {
    wi = CosineDensity().sample(wo, {u.y, u.z});
    wi.z = std::max(wi.z, smallestSampledCosine);
  } else {
    const std::size_t bin = rows_.sampleBin(viewer.theta, (u.x - cosine) / (1 - cosine));
    const double deviation = deviationIn(rows_.low(bin), rows_.high(bin, viewer.sine), u.y);
    wi = directionAbove(viewer.pointAt(deviation, azimuthLimit(deviation, viewer.sine) * (2 * u.z - 1)));
  }
  return {wi, pdf(wi, wo)};
}

double PdvSampler::pdf(const Direction& wi, const Direction& wo) const {
  if (!(wi.z > 0) || !(wo.z >= 0)) return 0;
  const Viewer viewer(wo);
  const double cosine = cosineFraction(viewer.theta), matte = cosine * wi.z / pi;
  const double deviation = deviationOf(wi, wo), limit = azimuthLimit(deviation, viewer.sine);
  const std::size_t bin = rows_.binOf(deviation);
  if (bin >= rows_.bins() || !(limit > 0)) return matte;
  const double low = rows_.low(bin), high = rows_.high(bin, viewer.sine);
  if (!(high > low)) return matte;
  return matte + (1 - cosine) * rows_.probability(viewer.theta, bin) * wi.z / ((high - low) * (high + low) * limit);
}

}  // namespace gonio::factorization
