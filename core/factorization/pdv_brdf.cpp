// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_brdf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "core/brdf/density_mixture.h"
#include "core/brdf/value_bound.h"
#include "core/coordinates/projected_deviation.h"
#include "core/factorization/pdv_factors.h"
#include "core/factorization/pdv_operations.h"
#include "core/math/fast_functions.h"
#include "core/math/monotone_cubic.h"
#include "core/support/error.h"

namespace gonio::factorization {

namespace {

constexpr double leastCosineFraction = 0.1;
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
    fractions[bins[n] + 1] += weights[n] * std::max(0.0, values[n].x + values[n].y + values[n].z);
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
  return leastCosineFraction + (1 - leastCosineFraction) * rows_.blackFraction(thetaR);
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

PublishedPdvSampler::PublishedPdvSampler(const Brdf& brdf, const std::vector<double>& thetaNodes,
                                         const std::vector<double>& deviationNodes)
    : rows_(brdf, thetaNodes, deviationNodes, DeviationRows::Ring::whole) {}

DirectionSample PublishedPdvSampler::sample(const Direction& wo, const glm::dvec3& u) const {
  const double sine = std::hypot(wo.x, wo.y), thetaR = std::atan2(sine, wo.z);
  const std::size_t bin = rows_.sampleBin(thetaR, u.x);
  const double low = rows_.low(bin), high = rows_.high(bin, sine);
  const double deviation = std::sqrt(low * low + u.y * (high - low) * (high + low));
  const ProjectedDirections at = fromProjectedDeviation({thetaR, deviation, 2 * pi * u.z});
  if (!at.valid) return {};
  const Direction wi = AzimuthRotation(std::atan2(wo.y, wo.x))(at.pair.wi);
  return {wi, pdf(wi, wo)};
}

double PublishedPdvSampler::pdf(const Direction& wi, const Direction& wo) const {
  if (!(wi.z > 0) || !(wo.z >= 0)) return 0;
  const double sine = std::hypot(wo.x, wo.y);
  const std::size_t bin = rows_.binOf(std::hypot(wi.x + wo.x, wi.y + wo.y));
  if (bin >= rows_.bins()) return 0;
  const double low = rows_.low(bin), high = rows_.high(bin, sine);
  if (!(high > low)) return 0;
  return rows_.probability(std::atan2(sine, wo.z), bin) * wi.z / ((high - low) * (high + low) * pi);
}

namespace {

/// findInterval() of one set of nodes for many places: a table of even steps gives the node to begin at.
class NodeIndex {
 public:
  explicit NodeIndex(std::span<const double> nodes) {
    if (nodes.size() < 2) return;
    scale_ = steps / nodes.back();
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) inverseWidths_.push_back(1 / (nodes[i + 1] - nodes[i]));
    for (std::size_t step = 0; step < steps; ++step)
      starts_[step] = std::uint16_t(findInterval(nodes, double(step) / scale_).index);
  }

  NodeInterval place(std::span<const double> nodes, double x) const {
    if (!(x > 0)) return {0, 0};
    if (x >= nodes.back()) return {nodes.size() - 2, 1};
    // Rounding may put the first place of a step a node too far.
    std::size_t index = starts_[std::min(steps - 1, std::size_t(x * scale_))];
    while (x < nodes[index]) --index;
    while (x >= nodes[index + 1]) ++index;
    return {index, (x - nodes[index]) * inverseWidths_[index]};
  }

 private:
  static constexpr std::size_t steps = 1024;
  double scale_ = 0;
  std::array<std::uint16_t, steps> starts_{};
  std::vector<double> inverseWidths_;
};

/// Pairs are evaluated in blocks, so that loops over them are vectorised.
constexpr std::size_t blockSize = 64;
using Block = std::array<double, blockSize>;

struct Coordinates {
  Block thetaR, deviation, phi;  ///< phi in [0, pi]
  Block weight;                  ///< cosineWeight()
};

/// toProjectedDeviation() to about 1e-15, in a few ns: curves need no more.
void computeCoordinates(std::span<const DirectionPair> pairs, Coordinates& at) {
  Block inX, inY, inZ, outX, outY, outZ;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [wi, wo] = pairs[i];
    inX[i] = wi.x, inY[i] = wi.y, inZ[i] = wi.z;
    outX[i] = wo.x, outY[i] = wo.y, outZ[i] = wo.z;
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double sinR = std::sqrt(outX[i] * outX[i] + outY[i] * outY[i]), inverse = 1 / (sinR > 0 ? sinR : 1.0);
    const double cosine = sinR > 0 ? outX[i] * inverse : 1.0, sine = outY[i] * inverse;
    const double along = cosine * inX[i] + sine * inY[i] + sinR, across = cosine * inY[i] - sine * inX[i];
    at.thetaR[i] = fastAtan2(sinR, outZ[i]);
    at.deviation[i] = std::sqrt(along * along + across * across);
    at.phi[i] = fastAtan2(std::abs(across), along);
    at.weight[i] = cosineWeight(std::max(0.0, inZ[i]), std::max(0.0, outZ[i]));
  }
}

template <DataTransform transform>
void invertTransform(std::span<double> sums, const Range& limits, const Block& weights) {
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double y = std::max(limits.low, std::min(sums[i], limits.high));
    sums[i] = std::copysign(inverseTransformed(transform, std::abs(y), weights[i]), y);
  }
}

void invertTransform(DataTransform transform, std::span<double> sums, const Range& limits, const Block& weights) {
  const auto invert = [&]<std::size_t... i>(std::index_sequence<i...>) {
    (..., (transform == DataTransform(i) ? invertTransform<DataTransform(i)>(sums, limits, weights) : void()));
  };
  invert(std::make_index_sequence<dataTransformNames.size()>());
}

/// Edited curves may have any values. In single precision, products of three that are limited to maxCurveValue and 1
/// are finite, and so are the values between nodes with limited slopes; beyond them the bound of y decides
/// (PdvFactors::highest).
constexpr double mostSlope = 1e37;
std::vector<double> limitedCurve(std::span<const double> values) {
  std::vector<double> limited(values.begin(), values.end());
  for (double& value : limited) value = std::clamp(value, -maxCurveValue, maxCurveValue);
  return limited;
}

/// All curves of one axis side by side, so that one place between two nodes serves all of them in vector code.
class CurveBundle {
 public:
  CurveBundle(std::vector<double> nodes, std::size_t width)
      : nodes_(std::move(nodes)),
        index_(nodes_),
        width_(width),
        values_(nodes_.size() * width),
        slopes_(nodes_.size() * width) {}

  void set(std::size_t curve, std::span<const double> values) {
    const std::vector<double> limited = limitedCurve(values), slopes = monotoneSlopes(nodes_, limited);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      values_[i * width_ + curve] = float(limited[i]);
      slopes_[i * width_ + curve] = float(std::clamp(slopes[i], -mostSlope, mostSlope));
    }
  }

  /// Multiplies each entry of `products` by its curve at x.
  void multiply(double x, float* products) const {
    if (nodes_.size() < 2) {
      for (std::size_t c = 0; c < width_; ++c) products[c] *= values_[c];
      return;
    }
    const NodeInterval at = index_.place(nodes_, x);
    const HermiteWeights w(at.fraction, nodes_[at.index + 1] - nodes_[at.index]);
    const float before = float(w.before), after = float(w.after);
    const float slopeBefore = float(w.slopeBefore), slopeAfter = float(w.slopeAfter);
    const float *v = values_.data() + at.index * width_, *s = slopes_.data() + at.index * width_;
    for (std::size_t c = 0; c < width_; ++c)
      products[c] *= before * v[c] + after * v[c + width_] + slopeBefore * s[c] + slopeAfter * s[c + width_];
  }

 private:
  std::vector<double> nodes_;
  NodeIndex index_;
  std::size_t width_;
  std::vector<float> values_, slopes_;
};

/// The extrema of all curves of one axis: between two nodes a monotone cubic stays between their values.
class CurveExtrema {
 public:
  CurveExtrema(std::vector<double> nodes, std::size_t width)
      : nodes_(std::move(nodes)), width_(width), values_(nodes_.size() * width), slopes_(values_.size()) {}

  void set(std::size_t curve, std::span<const double> values) {
    const std::vector<double> limited = limitedCurve(values), slopes = monotoneSlopes(nodes_, limited);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      values_[i * width_ + curve] = float(limited[i]);
      slopes_[i * width_ + curve] = float(std::clamp(slopes[i], -mostSlope, mostSlope));
    }
  }

  /// Multiplies each entry of `products` by the range of its curve over a range of places.
  void multiply(const Range& x, std::span<Range> products) const {
    std::vector<float> low(width_), high(width_), end(width_);
    valuesAt(x.low, low);
    high = low;
    const auto include = [&](const float* values) {
      for (std::size_t c = 0; c < width_; ++c) {
        low[c] = std::min(low[c], values[c]);
        high[c] = std::max(high[c], values[c]);
      }
    };
    valuesAt(x.high, end);
    include(end.data());
    for (auto node = std::size_t(std::upper_bound(nodes_.begin(), nodes_.end(), x.low) - nodes_.begin());
         node < nodes_.size() && nodes_[node] < x.high; ++node)
      include(values_.data() + node * width_);
    constexpr double rounding = 1e-6;
    for (std::size_t c = 0; c < width_; ++c) {
      const double slack = rounding * std::max(std::abs(low[c]), std::abs(high[c]));
      products[c] *= Range(low[c] - slack, high[c] + slack);
    }
  }

 private:
  void valuesAt(double x, std::vector<float>& result) const {
    if (nodes_.size() < 2) {
      std::copy_n(values_.begin(), width_, result.begin());
      return;
    }
    const NodeInterval at = findInterval(nodes_, x);
    const HermiteWeights w(at.fraction, nodes_[at.index + 1] - nodes_[at.index]);
    const float *v = values_.data() + at.index * width_, *s = slopes_.data() + at.index * width_;
    for (std::size_t c = 0; c < width_; ++c)
      result[c] =
          float(w.before * v[c] + w.after * v[c + width_] + w.slopeBefore * s[c] + w.slopeAfter * s[c + width_]);
  }

  std::vector<double> nodes_;
  std::size_t width_;
  std::vector<float> values_, slopes_;
};

/// Sets the curves of all terms, channel by channel. @tparam Curves CurveBundle or CurveExtrema.
template <typename Curves>
void setCurves(const PdvFactors& f, Curves& f1, Curves& f2, Curves& f3) {
  std::size_t curve = 0;
  for (const auto& channel : f.channels)
    for (const PdvTerm& term : channel) {
      f1.set(curve, term.f1);
      f2.set(curve, term.f2);
      f3.set(curve, term.f3);
      ++curve;
    }
}

/// The coordinates of a box are those of the factors: theta_R is the viewer's polar angle, the deviation the length of
/// the projected wi + wo = 2 cos theta_d h, and phi its azimuth from the viewer's.
class PdvBound final : public ValueBound {
 public:
  explicit PdvBound(const PdvFactors& f)
      : transform_(f.transform),
        limits_(f.lowest, f.highest),
        terms_(std::size_t(f.terms())),
        f1_(f.thetaNodes, 3 * terms_),
        f2_(f.deviationNodes, 3 * terms_),
        f3_(f.phiNodes, 3 * terms_) {
    setCurves(f, f1_, f2_, f3_);
  }

  RgbRange over(const PairBox& box) const override {
    std::array<Range, 3 * maxEvaluatedTerms> products;
    const std::span<Range> used = std::span(products).first(3 * terms_);
    std::ranges::fill(used, Range(1));
    f1_.multiply(box.thetaO, used);
    f2_.multiply(Range(2) * box.cosD * box.sinH, used);
    f3_.multiply(abs(box.psi), used);
    const double weight = cosineWeight(box.cosI.low, box.cosO.low), most = cosineWeight(box.cosI.high, box.cosO.high);
    RgbRange result;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      Range sum = 0;
      for (std::size_t term = 0; term < terms_; ++term) sum += used[channel * terms_ + term];
      const auto c = int(channel);
      const double low = std::clamp(sum.low, limits_.low, limits_.high);
      const double high = std::clamp(sum.high, limits_.low, limits_.high);
      result.low[c] = inverseTransformedSigned(transform_, low, low < 0 ? weight : most);
      result.high[c] = inverseTransformedSigned(transform_, high, high < 0 ? most : weight);
    }
    return result;
  }

 private:
  DataTransform transform_;
  Range limits_;  ///< of y
  std::size_t terms_;
  CurveExtrema f1_, f2_, f3_;
};

class PdvBrdf final : public Brdf {
 public:
  explicit PdvBrdf(const PdvFactors& f)
      : factors_(std::make_shared<const PdvFactors>(f)),
        transform_(f.transform),
        limits_(f.lowest, f.highest),
        terms_(std::size_t(f.terms())),
        f1_(f.thetaNodes, 3 * terms_),
        f2_(f.deviationNodes, 3 * terms_),
        f3_(f.phiNodes, 3 * terms_) {
    if (f.terms() > maxEvaluatedTerms)
      throw Error("found factors of " + std::to_string(f.terms()) + " terms, expected at most " +
                  std::to_string(maxEvaluatedTerms));
    setCurves(f, f1_, f2_, f3_);
  }

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t begin = 0; begin < pairs.size(); begin += blockSize) {
      const std::size_t length = std::min(blockSize, pairs.size() - begin);
      evaluateBlock(pairs.subspan(begin, length), values.subspan(begin, length));
    }
  }
  bool hasImportanceSampling() const override { return true; }
  double samplingCost() const override { return 1.6; }
  bool isReciprocal() const override { return false; }
  std::shared_ptr<const ValueBound> valueBound() const override { return std::make_shared<const PdvBound>(*factors_); }
  const std::shared_ptr<const PdvFactors>& factors() const { return factors_; }
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override { return sampler().sample(wo, u); }
  double pdf(const Direction& wi, const Direction& wo) const override { return sampler().pdf(wi, wo); }

 private:
  void evaluateBlock(std::span<const DirectionPair> pairs, std::span<Rgb> values) const {
    Coordinates at;
    computeCoordinates(pairs, at);
    std::array<Block, 3> sums;
    for (std::size_t i = 0; i < pairs.size(); ++i) addTerms(at.thetaR[i], at.deviation[i], at.phi[i], sums, i);
    for (Block& sum : sums) invertTransform(transform_, {sum.data(), pairs.size()}, limits_, at.weight);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      values[i] =
          isBelowHorizon(pairs[i].wi) || isBelowHorizon(pairs[i].wo) ? Rgb(0) : Rgb(sums[0][i], sums[1][i], sums[2][i]);
  }

  /// Sets the entries `i` of `sums` to the sums over all terms, one per channel.
  void addTerms(double thetaR, double deviation, double phi, std::array<Block, 3>& sums, std::size_t i) const {
    float products[3 * maxEvaluatedTerms];
    std::fill_n(products, 3 * terms_, 1.0f);
    f1_.multiply(thetaR, products);
    f2_.multiply(deviation, products);
    f3_.multiply(phi, products);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      double sum = 0;
      for (std::size_t term = 0; term < terms_; ++term) sum += products[channel * terms_ + term];
      sums[channel][i] = sum;
    }
  }

  const PdvSampler& sampler() const {
    std::call_once(samplerOnce_, [this] {
      if (terms_ <= 1)
        sampler_.emplace(*this, factors_->thetaNodes, factors_->deviationNodes);
      else
        sampler_.emplace(PdvBrdf(factors_->truncated(1)), factors_->thetaNodes, factors_->deviationNodes);
    });
    return *sampler_;
  }

  std::shared_ptr<const PdvFactors> factors_;
  DataTransform transform_;
  Range limits_;  ///< of y
  std::size_t terms_;
  CurveBundle f1_, f2_, f3_;
  mutable std::once_flag samplerOnce_;
  mutable std::optional<PdvSampler> sampler_;
};

}  // namespace

std::shared_ptr<const Brdf> makePdvBrdf(const PdvFactors& factors) { return std::make_shared<const PdvBrdf>(factors); }

std::shared_ptr<const PdvFactors> pdvFactorsOf(const Brdf& brdf) {
  const auto* pdv = formOf<PdvBrdf>(brdf);
  return pdv ? pdv->factors() : nullptr;
}

}  // namespace gonio::factorization
