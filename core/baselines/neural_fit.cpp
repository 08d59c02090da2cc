// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/neural_fit.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

#include "core/coordinates/half_difference.h"
#include "core/math/parallel.h"
#include "core/math/sampling.h"
#include "core/support/error.h"

namespace gonio::baselines {

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

namespace {

constexpr double readFraction = 0.05;  ///< of the progress
constexpr int reports = 20;

struct Sample {
  std::array<float, NeuralBrdf::inputs> inputs;
  std::array<float, 3> targets;
  float cosine;
};

/// The samples that have data. Both orders of light and viewer occur, at the same inputs of the network.
std::vector<Sample> readSamples(const Brdf& material, const NeuralFitOptions& options, const TaskControl& control) {
  const auto count = std::size_t(options.samples);
  std::vector<Sample> all(count);
  const SobolPoints angles(std::uint32_t(options.seed)), azimuths(hashCombine(std::uint32_t(options.seed), 1));
  constexpr std::size_t block = 4096;
  parallelForBlocks(
      count, block,
      [&](std::size_t begin, std::size_t end) {
        std::vector<DirectionPair> pairs;
        for (std::size_t i = begin; i < end; ++i) {
          const glm::dvec2 u = angles[std::uint32_t(i)];
          const double thetaH = u.x * u.x * halfPi, thetaD = u.y * halfPi,
                       phiD = azimuths.first(std::uint32_t(i)) * 2 * pi;
          pairs.push_back(fromHalfDifference(thetaH, thetaD, phiD));
          all[i].inputs = NeuralBrdf::inputsAt({thetaH, thetaD, phiD > pi ? phiD - 2 * pi : phiD});
        }
        std::vector<Rgb> values(pairs.size());
        material.evaluate(pairs, values);
        for (std::size_t i = begin; i < end; ++i) {
          const DirectionPair& pair = pairs[i - begin];
          const bool known = pair.wi.z > 1e-3 && pair.wo.z > 1e-3 && material.hasData(pair);
          all[i].cosine = known ? float(pair.wi.z) : 0;
          for (int c = 0; c < 3; ++c)
            all[i].targets[std::size_t(c)] = float(std::log1p(std::max(0.0, double(values[i - begin][c])) * pair.wi.z));
        }
      },
      control);
  std::erase_if(all, [](const Sample& sample) { return sample.cosine == 0; });
  if (all.empty()) throw Error("a neural BRDF needs a material with data above the horizon");
  return all;
}

/// Uniform in [0, 1), the same on every platform.
double uniform(std::mt19937_64& generator) { return double(generator() >> 11) * 0x1p-53; }

/// Uniform in +-sqrt(6 / inputs) (He et al. 2015), biases 0.
Weights initialWeights(std::mt19937_64& generator) {
  Weights weights = Weights::Zero();
  int at = 0;
  const std::pair<int, int> sizes[] = {
      {inputCount, hiddenCount}, {hiddenCount, hiddenCount}, {hiddenCount, outputCount}};
  for (const auto& [inputs, outputs] : sizes) {
    const double bound = std::sqrt(6.0 / inputs);
    for (int i = 0; i < inputs * outputs; ++i) weights[at++] = bound * (2 * uniform(generator) - 1);
    at += outputs;
  }
  return weights;
}

void fill(Batch& batch, const std::vector<Sample>& samples, std::mt19937_64& generator) {
  for (Eigen::Index column = 0; column < batch.cosines.size(); ++column) {
    const Sample& sample = samples[std::size_t(uniform(generator) * double(samples.size()))];
    for (int i = 0; i < inputCount; ++i) batch.inputs(i, column) = sample.inputs[std::size_t(i)];
    for (int c = 0; c < outputCount; ++c) batch.targets(c, column) = sample.targets[std::size_t(c)];
    batch.cosines[column] = sample.cosine;
  }
}

/// Kingma and Ba 2015, algorithm 1.
class Adam {
 public:
  void step(Weights& weights, const Weights& gradient, double rate) {
    constexpr double decay1 = 0.9, decay2 = 0.999, epsilon = 1e-8;
    power1_ *= decay1;
    power2_ *= decay2;
    mean_ = decay1 * mean_ + (1 - decay1) * gradient;
    square_ = decay2 * square_ + (1 - decay2) * gradient.cwiseAbs2();
    weights.array() -= rate / (1 - power1_) * mean_.array() / ((square_.array() / (1 - power2_)).sqrt() + epsilon);
  }

 private:
  Weights mean_ = Weights::Zero(), square_ = Weights::Zero();
  double power1_ = 1, power2_ = 1;
};

double rateAt(const NeuralFitOptions& options, int step) {
  constexpr double last = 1e-3;
  const double done = double(step) / options.steps;
  return options.learningRate * (last + (1 - last) * (1 + std::cos(pi * done)) / 2);
}

}  // namespace

NeuralFit fitNeural(const Brdf& material, const NeuralFitOptions& options, const TaskControl& control) {
  if (options.steps < 1 || options.samples < 1 || options.batch < 1 || !(options.learningRate > 0))
    throw Error("training of a neural BRDF: steps, samples, batch and learning rate must be positive");
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Sample> samples = readSamples(material, options, control.between(0, readFraction));
  std::mt19937_64 generator(options.seed);
  Weights weights = initialWeights(generator), gradient;
  Batch batch;
  batch.resize(options.batch);
  Loss loss;
  Adam adam;
  NeuralFit fit;
  const int interval = std::max(1, options.steps / reports);
  double sum = 0;
  for (int step = 0; step < options.steps; ++step) {
    fill(batch, samples, generator);
    sum += loss.evaluate(weights, batch, gradient);
    adam.step(weights, gradient, rateAt(options, step));
    if ((step + 1) % interval != 0) continue;
    control.throwIfStopped();
    control.report(readFraction + (1 - readFraction) * double(step + 1) / options.steps);
    fit.losses.push_back(sum / interval);
    sum = 0;
  }
  Eigen::Map<Eigen::Matrix<float, weightCount, 1>>(fit.weights.data()) = weights.cast<float>();
  fit.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return fit;
}

}  // namespace gonio::baselines
