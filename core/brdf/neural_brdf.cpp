// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/neural_brdf.h"

#include <algorithm>
#include <cmath>

#include "core/brdf/value_bound.h"
#include "core/math/fast_functions.h"
#include "core/support/error.h"

namespace gonio {

namespace {

/// One layer without its activation; `weights` is moved behind it.
template <std::size_t inputs, std::size_t outputs>
std::array<float, outputs> layer(const float*& weights, const std::array<float, inputs>& from) {
  std::array<float, outputs> to;
  std::copy_n(weights + inputs * outputs, outputs, to.begin());
  for (std::size_t i = 0; i < inputs; ++i)
    for (std::size_t o = 0; o < outputs; ++o) to[o] += from[i] * weights[i * outputs + o];
  weights += inputs * outputs + outputs;
  return to;
}

template <std::size_t size>
std::array<float, size> rectified(std::array<float, size> values) {
  for (float& value : values) value = std::max(value, 0.0f);
  return values;
}

}  // namespace

std::array<float, NeuralBrdf::inputs> NeuralBrdf::inputsAt(const HalfDifference& at) {
  constexpr double perTurn = 1 / (2 * pi);
  const auto thetaH = fastSineAndCosine(at.thetaH * perTurn), thetaD = fastSineAndCosine(at.thetaD * perTurn),
             phi = fastSineAndCosine(foldPhiD(at.phiD) * perTurn);
  return {float(thetaH.sine),  0, float(thetaH.cosine), float(thetaD.sine * phi.cosine), float(thetaD.sine * phi.sine),
          float(thetaD.cosine)};
}

NeuralBrdf::NeuralBrdf(std::span<const float> weights) {
  if (weights.size() != weightCount)
    throw Error("found a neural BRDF with " + std::to_string(weights.size()) + " weights, expected " +
                std::to_string(weightCount));
  for (std::size_t i = 0; i < weightCount; ++i)
    if (!std::isfinite(weights[i]))
      throw Error("weight " + std::to_string(i) + " of a neural BRDF is " + std::to_string(weights[i]) +
                  ", expected a finite number");
  std::copy(weights.begin(), weights.end(), weights_.begin());
}

namespace {

constexpr std::size_t inputs = NeuralBrdf::inputs, hidden = NeuralBrdf::hidden, outputs = NeuralBrdf::outputs;
/// exp(80) is within the range of float.
constexpr float maxExponent = 80;

/// Numbers by their middles and half widths.
template <std::size_t size>
struct Ball {
  std::array<double, size> middle{}, radius{};
};

/// A layer's weights in double precision, [input][output], and its bias.
template <std::size_t from, std::size_t to>
struct Weights {
  std::array<std::array<double, to>, from> matrix;
  std::array<double, to> bias;

  explicit Weights(const float*& weights) {
    for (auto& row : matrix)
      for (double& weight : row) weight = double(*weights++);
    for (double& b : bias) b = double(*weights++);
  }

  /// Contains the layer's outputs with the rounding of evaluate() in single precision.
  Ball<to> over(const Ball<from>& x) const {
    constexpr double rounding = 32 * 6e-8;
    Ball<to> result;
    std::array<double, to> sizes;
    for (std::size_t o = 0; o < to; ++o) {
      result.middle[o] = bias[o];
      sizes[o] = std::abs(bias[o]);
    }
    for (std::size_t i = 0; i < from; ++i)
      for (std::size_t o = 0; o < to; ++o) {
        const double weight = matrix[i][o], size = std::abs(weight);
        result.middle[o] += weight * x.middle[i];
        result.radius[o] += size * x.radius[i];
        sizes[o] += size * (std::abs(x.middle[i]) + x.radius[i]);
      }
    for (std::size_t o = 0; o < to; ++o) result.radius[o] += rounding * sizes[o];
    return result;
  }

  /// The slopes of one output of the network with respect to the layer's inputs, from those to its outputs.
  Ball<from> slopes(const Ball<to>& ofOutputs) const {
    Ball<from> result;
    for (std::size_t i = 0; i < from; ++i)
      for (std::size_t o = 0; o < to; ++o) {
        result.middle[i] += matrix[i][o] * ofOutputs.middle[o];
        result.radius[i] += std::abs(matrix[i][o]) * ofOutputs.radius[o];
      }
    return result;
  }
};

Ball<hidden> rectified(const Ball<hidden>& x) {
  Ball<hidden> result;
  for (std::size_t i = 0; i < hidden; ++i) {
    const double low = std::max(0.0, x.middle[i] - x.radius[i]), high = std::max(0.0, x.middle[i] + x.radius[i]);
    result.middle[i] = (low + high) / 2;
    result.radius[i] = (high - low) / 2;
  }
  return result;
}
/// Slopes of an output with respect to the numbers, from those with respect to the rectified ones.
Ball<hidden> throughRectifier(Ball<hidden> slopes, const Ball<hidden>& x) {
  for (std::size_t i = 0; i < hidden; ++i) {
    const bool isOff = x.middle[i] + x.radius[i] <= 0, isOn = x.middle[i] - x.radius[i] >= 0;
    if (isOn) continue;
    // Between 0 and 1 where the unit switches.
    const double middle = slopes.middle[i], radius = slopes.radius[i];
    slopes.middle[i] = isOff ? 0 : middle / 2;
    slopes.radius[i] = isOff ? 0 : std::abs(middle) / 2 + radius;
  }
  return slopes;
}

class NeuralBound final : public ValueBound {
 public:
  explicit NeuralBound(const float* weights) : first_(weights), second_(weights), last_(weights) {}

  RgbRange over(const PairBox& box) const override {
    // The difference vector in the frame of the half vector; azimuths beyond pi are folded to its opposite, as are
    // those of the mirrored set.
    const Range x = box.cosO * box.sinH - box.sinO * box.cosH * box.cosPsi, y = abs(box.sinO * sine(box.psi));
    const Range sinD = sqrt(Range(1) - square(box.cosD));
    const Range along = {std::max(x.low, -sinD.high), std::min(x.high, sinD.high)};
    const Range across = {std::min(y.low, sinD.high), std::min(y.high, sinD.high)};
    RgbRange result{Rgb(std::numeric_limits<double>::infinity()), Rgb(0)};
    for (const Range& side : {along, -along}) {
      const RgbRange one = networkOver({box.sinH, Range(0), box.cosH, side, across, box.cosD});
      result.low = glm::min(result.low, one.low);
      result.high = glm::max(result.high, one.high);
    }
    return result;
  }
  // The exponential widens the bounds of large sets, so that a large bound does not indicate a peak.
  bool isLocal() const override { return false; }

 private:
  RgbRange networkOver(const std::array<Range, inputs>& box) const {
    Ball<inputs> x, centre;
    for (std::size_t i = 0; i < inputs; ++i) {
      constexpr double rounding = 1e-7;
      x.middle[i] = centre.middle[i] = (box[i].low + box[i].high) / 2;
      x.radius[i] = (box[i].high - box[i].low) / 2 + rounding;
    }
    const Ball<hidden> first = first_.over(x), second = second_.over(rectified(first));
    const Ball<outputs> whole = last_.over(rectified(second));
    const Ball<outputs> middle = last_.over(rectified(second_.over(rectified(first_.over(centre)))));
    RgbRange result;
    for (std::size_t c = 0; c < outputs; ++c) {
      Ball<outputs> one;
      one.middle[c] = 1;
      const Ball<inputs> slopes =
          first_.slopes(throughRectifier(second_.slopes(throughRectifier(last_.slopes(one), second)), first));
      double change = middle.radius[c];
      for (std::size_t i = 0; i < inputs; ++i) change += (std::abs(slopes.middle[i]) + slopes.radius[i]) * x.radius[i];
      const double low = std::max(whole.middle[c] - whole.radius[c], middle.middle[c] - change);
      const double high = std::min(whole.middle[c] + whole.radius[c], middle.middle[c] + change);
      const auto valueOf = [](double exponent) {
        return std::max(0.0, std::expm1(std::min(exponent, double(maxExponent))));
      };
      constexpr double rounding = 1e-6;
      result.low[int(c)] = valueOf(low) * (1 - rounding);
      result.high[int(c)] = valueOf(high) * (1 + rounding);
    }
    return result;
  }

  Weights<inputs, hidden> first_;
  Weights<hidden, hidden> second_;
  Weights<hidden, outputs> last_;
};

}  // namespace

std::shared_ptr<const ValueBound> NeuralBrdf::valueBound() const {
  return std::make_shared<const NeuralBound>(weights_.data());
}

void NeuralBrdf::evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [wi, wo] = pairs[i];
    const HalfDifference at = toHalfDifference(wi, wo);
    values[i] = Rgb(0);
    if (isBelowHorizon(wi) || isBelowHorizon(wo) || !at.valid) continue;
    const float* weights = weights_.data();
    const auto first = rectified(layer<inputs, hidden>(weights, inputsAt(at)));
    const auto second = rectified(layer<hidden, hidden>(weights, first));
    const auto result = layer<hidden, outputs>(weights, second);
    // Where weights overflow, the result may be NaN, which becomes 0.
    for (int c = 0; c < 3; ++c)
      values[i][c] = std::max(0.0, fastExpm1(std::clamp(result[std::size_t(c)], 0.0f, maxExponent)));
  }
}

}  // namespace gonio
