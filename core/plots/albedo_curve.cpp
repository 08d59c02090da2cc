// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/plots/albedo_curve.h"

#include <cmath>

#include "core/math/parallel.h"
#include "core/sampling/directional_albedo.h"

namespace gonio::plots {

Curve albedoCurve(const Brdf& brdf, int count, int samples, const TaskControl& control) {
  constexpr double last = radians(89);
  const auto size = static_cast<std::size_t>(count);
  Curve curve{std::vector<double>(size), {std::vector<Rgb>(size), std::vector<PointState>(size, PointState::known)}};
  for (std::size_t i = 0; i < size; ++i)
    curve.angles[i] = last * (1 - std::pow(1 - double(i) / double(count - 1), 1.5));
  const SamplingDensity lobe = estimateSamplingDensity(brdf);
  parallelForBlocks(
      size, 1,
      [&](std::size_t begin, std::size_t finish) {
        for (std::size_t i = begin; i < finish; ++i)
          curve.points.values[i] = directionalAlbedo(brdf, curve.angles[i], lobe, std::uint32_t(samples));
      },
      control);
  return curve;
}

}  // namespace gonio::plots
