// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/acquisition/sampling_plan.h"
#include "core/brdf/brdf.h"

namespace gonio::acquisition {

/// The values measured at the samples of a plan, in the order of the plan.
struct MeasuredValues {
  std::vector<Rgb> rgb;    ///< BRDF values: linear RGB, 1/sr, without the cosine, >= 0
  std::vector<Rgb> noise;  ///< standard deviations of `rgb`, 1/sr; empty if unknown
};

/// Errors of a simulated goniometer, all Gaussian.
struct MeasurementNoise {
  double relative = 0;      ///< standard deviation as a fraction of the value, independent per channel
  double absolute = 0;      ///< additional standard deviation, 1/sr: the noise floor
  double misalignment = 0;  ///< standard deviation of each arm's pointing error about each of two axes, rad
  std::uint64_t seed = 1;
};

/// Simulates the measurement of a material at the directions of a plan. Negative readings become 0; a direction that
/// the misalignment moves below the horizon is moved back to it. Fills in MeasuredValues::noise if relative or absolute
/// noise is above 0. The random numbers do not depend on the sizes of the errors: twice the noise gives twice each
/// error.
/// @throws Error if a standard deviation is negative or not finite.
MeasuredValues measure(const Brdf& material, const SamplingPlan& plan, const MeasurementNoise& noise = {});

}  // namespace gonio::acquisition
