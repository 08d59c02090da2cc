// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "core/brdf/neural_brdf.h"
#include "core/support/task_control.h"

namespace gonio::baselines {

inline constexpr int inputCount = int(NeuralBrdf::inputs), hiddenCount = int(NeuralBrdf::hidden),
                     outputCount = int(NeuralBrdf::outputs), weightCount = int(NeuralBrdf::weightCount);

/// The weights in the order of NeuralBrdf.
using Weights = Eigen::Matrix<double, weightCount, 1>;

/// Values to reproduce, one sample per column.
struct Batch {
  Eigen::Matrix<double, inputCount, Eigen::Dynamic> inputs;    ///< half vector (azimuth 0) and difference vector
  Eigen::Matrix<double, outputCount, Eigen::Dynamic> targets;  ///< ln(1 + rho cos theta_i), rho in 1/sr
  Eigen::RowVectorXd cosines;                                  ///< cos theta_i, > 0

  void resize(Eigen::Index samples) {
    inputs.resize(Eigen::NoChange, samples);
    targets.resize(Eigen::NoChange, samples);
    cosines.resize(samples);
  }
};

/// The loss of Sztrajman et al. 2021 (eq. 2): the mean over samples and channels of |e|, e = ln(1 + rho' cos theta_i) -
/// ln(1 + rho cos theta_i), where the network's output x gives rho' = exp(x) - 1. Near 0, |e| is smoothed to
/// sqrt(e^2 + d^2) - d with d = 0.001, so that its derivative is continuous. Reuses its buffers between calls.
class Loss {
 public:
  static constexpr double smoothing = 1e-3;  ///< d

  /// Returns the loss and sets its derivative with respect to each weight. About 2 kflop per sample.
  double evaluate(const Weights& weights, const Batch& batch, Weights& gradient);

 private:
  using Hidden = Eigen::Matrix<double, hiddenCount, Eigen::Dynamic>;
  using Outputs = Eigen::Matrix<double, outputCount, Eigen::Dynamic>;
  Hidden first_, second_, firstSlope_, secondSlope_;
  Outputs output_;
};

// Training of the networks of Sztrajman et al. 2021 (NeuralBrdf).

struct NeuralFitOptions {
  int steps = 40'000;          ///< number of steps of Adam: about 0.3 ms each on one thread, 12 s for the default
  int samples = 1 << 19;       ///< number of pairs of directions at which the material is evaluated before training
  int batch = 512;             ///< samples per step
  double learningRate = 1e-2;  ///< at the first step; decays to 1/1000 of it along half a cosine
  std::uint64_t seed = 1;      ///< of the initial weights, the sampled directions and the batches
};

struct NeuralFit {
  std::array<float, NeuralBrdf::weightCount> weights;
  std::vector<double> losses;  ///< mean loss (core/baselines/neural_fit.h) over each twentieth of the steps
  double seconds = 0;
};

/// Trains a network to reproduce a material: Adam (Kingma and Ba 2015) on random batches of `samples` pairs of
/// directions, stratified in half-difference angles with theta_h = u^2 pi / 2 like the rows of a MERL table.
/// Evaluates the material in parallel, then trains on one thread. Deterministic for a seed. 33 MB. @throws Error if an
/// option is not positive or no direction has data; Cancelled.
NeuralFit fitNeural(const Brdf& material, const NeuralFitOptions& options = {}, const TaskControl& control = {});

}  // namespace gonio::baselines
