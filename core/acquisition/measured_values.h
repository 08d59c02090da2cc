// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/acquisition/sampling_plan.h"
#include "core/brdf/brdf.h"

namespace gonio::acquisition {

/// What was read at the samples of a plan, in their order.
struct MeasuredValues {
  std::vector<Rgb> rgb;    ///< linear RGB in 1/sr without the cosine, >= 0
  std::vector<Rgb> noise;  ///< standard deviations of these, 1/sr; empty where they are not known
};

/// What goes wrong on a simulated goniometer. All Gaussian.
struct MeasurementNoise {
  double relative = 0;      ///< standard deviation of a reading as a fraction of its value, of each channel alone
  double absolute = 0;      ///< and a standard deviation in 1/sr beside it: the floor of the sensor
  double misalignment = 0;  ///< standard deviation, rad, of each arm's direction along each of two axes
  std::uint64_t seed = 1;
};

/// Measures a material at the directions of a plan. Readings below 0 become 0; an arm that misalignment puts below the
/// horizon stands on it. `noise` is filled in where the sensor has some. The numbers that are drawn do not depend on
/// the sizes of the errors: twice the noise is twice each error.
/// @throws Error when an error is negative or not finite.
MeasuredValues measure(const Brdf& material, const SamplingPlan& plan, const MeasurementNoise& noise = {});

}  // namespace gonio::acquisition
