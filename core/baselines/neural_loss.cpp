// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/neural_loss.h"

#include <algorithm>
#include <cmath>

namespace gonio::neural {

namespace {

/// The matrix and the bias of one layer within the weights; `Values` is Weights or const Weights.
template <int inputs, int outputs, typename Values>
auto layerOf(Values& weights, int offset) {
  constexpr bool constant = std::is_const_v<Values>;
  using Matrix = Eigen::Matrix<double, outputs, inputs>;
  using Bias = Eigen::Matrix<double, outputs, 1>;
  struct Layer {
    Eigen::Map<std::conditional_t<constant, const Matrix, Matrix>> matrix;
    Eigen::Map<std::conditional_t<constant, const Bias, Bias>> bias;
  };
  auto* const begin = weights.data() + offset;
  return Layer{{begin, outputs, inputs}, {begin + inputs * outputs, outputs}};
}

constexpr int secondOffset = (inputCount + 1) * hiddenCount,
              thirdOffset = secondOffset + (hiddenCount + 1) * hiddenCount;
constexpr double largestOutput = 80;  ///< as in NeuralBrdf

template <typename Values>
auto firstLayer(Values& weights) {
  return layerOf<inputCount, hiddenCount>(weights, 0);
}
template <typename Values>
auto secondLayer(Values& weights) {
  return layerOf<hiddenCount, hiddenCount>(weights, secondOffset);
}
template <typename Values>
auto thirdLayer(Values& weights) {
  return layerOf<hiddenCount, outputCount>(weights, thirdOffset);
}

/// Adds the derivative with respect to a layer, for the derivative with respect to its outputs.
void setGradient(auto layer, const auto& slope, const auto& from) {
  layer.matrix.noalias() = slope * from.transpose();
  layer.bias = slope.rowwise().sum();
}

}  // namespace

double Loss::evaluate(const Weights& weights, const Batch& batch, Weights& gradient) {
  const auto one = firstLayer(weights);
  const auto two = secondLayer(weights);
  const auto three = thirdLayer(weights);
  first_.noalias() = one.matrix * batch.inputs;
  first_ = (first_.colwise() + one.bias).cwiseMax(0.0);
  second_.noalias() = two.matrix * first_;
  second_ = (second_.colwise() + two.bias).cwiseMax(0.0);
  output_.noalias() = three.matrix * second_;
  output_.colwise() += three.bias;

  const double scale = 1.0 / double(std::max<Eigen::Index>(1, output_.size()));
  double sum = 0;
  for (Eigen::Index sample = 0; sample < output_.cols(); ++sample) {
    const double cosine = batch.cosines[sample];
    for (int c = 0; c < outputCount; ++c) {
      double& x = output_(c, sample);
      const bool capped = x > largestOutput;
      const double value = cosine * std::expm1(std::min(x, largestOutput));
      const double error = std::log1p(value) - batch.targets(c, sample);
      const double root = std::sqrt(error * error + smoothing * smoothing);
      sum += root - smoothing;
      x = capped ? 0 : scale * error / root * (value + cosine) / (1 + value);
    }
  }

  setGradient(thirdLayer(gradient), output_, second_);
  secondSlope_.noalias() = three.matrix.transpose() * output_;
  secondSlope_ = (second_.array() > 0).select(secondSlope_, 0);
  setGradient(secondLayer(gradient), secondSlope_, first_);
  firstSlope_.noalias() = two.matrix.transpose() * secondSlope_;
  firstSlope_ = (first_.array() > 0).select(firstSlope_, 0);
  setGradient(firstLayer(gradient), firstSlope_, batch.inputs);
  return sum * scale;
}

}  // namespace gonio::neural
