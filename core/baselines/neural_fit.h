// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/brdf/neural_brdf.h"
#include "core/support/task_control.h"

/// Training of the networks of Sztrajman et al. 2021 (NeuralBrdf).
namespace gonio::neural {

struct NeuralFitOptions {
  int steps = 40'000;          ///< number of steps of Adam: about 0.3 ms each on one thread, 12 s for the default
  int samples = 1 << 19;       ///< number of pairs of directions at which the material is evaluated before training
  int batch = 512;             ///< samples per step
  double learningRate = 1e-2;  ///< at the first step; decays to 1/1000 of it along half a cosine
  std::uint64_t seed = 1;      ///< of the initial weights, the sampled directions and the batches
};

struct NeuralFit {
  std::array<float, NeuralBrdf::weightCount> weights;
  std::vector<double> losses;  ///< mean loss (core/baselines/neural_loss.h) over each twentieth of the steps
  double seconds = 0;
};

/// Trains a network to reproduce a material: Adam (Kingma and Ba 2015) on random batches of `samples` pairs of
/// directions, stratified in half-difference angles with theta_h = u^2 pi / 2 like the rows of a MERL table.
/// Evaluates the material in parallel, then trains on one thread. Deterministic for a seed. 33 MB. @throws Error if an
/// option is not positive or no direction has data; Cancelled.
NeuralFit fitNeural(const Brdf& material, const NeuralFitOptions& options = {}, const TaskControl& control = {});

}  // namespace gonio::neural
