// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <memory>

#include "core/brdf/brdf.h"
#include "core/math/range.h"
#include "core/sampling/fitted_densities.h"

namespace gonio {

/// Directional albedo for viewers at azimuth 0: integral of the BRDF times cos theta_i over the hemisphere, per
/// channel, by importance-sampled quadrature with a fixed pattern (deterministic). Peaks that are narrower than the
/// pattern, such as one cell of a table with a value of 1e6, are found by the bounds of the values (narrowPeaks()) and
/// integrated separately. One object serves many angles, from several threads at once; the BRDF must outlive it.
class DirectionalAlbedo {
 public:
  enum class Peaks { found, ignored };

  /// A few ms, and with Peaks::found the time of Brdf::valueBound(). @param sampleCount of the pattern. @param peaks
  /// whether narrow peaks are searched; without it, operator() is about 8 ms faster.
  explicit DirectionalAlbedo(const Brdf& brdf, std::uint32_t sampleCount = 1 << 14, Peaks peaks = Peaks::found);

  /// @param theta polar angle of the viewer, rad. About 20 ms with 16,384 samples of a code, 5 ms of a table.
  Rgb operator()(double theta) const;

  /// An upper bound of what narrow peaks add to the albedo for any viewer of a range of polar angles (rad), largest
  /// channel; 0 if there are none, no bound of the values is known, or peaks are ignored. @param albedo estimate
  /// without them.
  double mostOfPeaks(const Range& theta, double albedo) const;

 private:
  const Brdf& brdf_;
  SamplingDensity density_;
  std::uint32_t sampleCount_;
  std::shared_ptr<const ValueBound> bound_;
};

/// The directional albedo at one polar angle `theta` (rad).
Rgb directionalAlbedo(const Brdf& brdf, double theta);

}  // namespace gonio
