// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <optional>

#include "core/export/rgl_sampler.h"
#include "core/support/task_control.h"

namespace gonio::exports {

/// How many polar angles of the incident direction, and how many nodes along each side of a slice.
struct RglSize {
  std::size_t thetaCount = 16, size = 32;
};

struct RglOptions {
  double snr = 40;                     ///< dB in comparisonScene() that the file must reach
  std::optional<RglSize> fixed;        ///< this size instead
  std::uint64_t maxBytes = 5'000'000;  ///< of the RGB file
  std::size_t azimuths = 12;           ///< intervals of the circle, of anisotropic materials
  /// Whether the slices of isotropic materials keep the difference between left and right of the plane of incidence.
  /// Mitsuba 3 leaves to chance how it folds the azimuth of such files: they are symmetric for it.
  bool bothSides = false;
  int pictureSize = 128, samples = 128;  ///< of the pictures by which the SNR is measured
};

struct RglParameterisation {
  RglData data;
  RglSize size;
  double snr = 0;           ///< dB of the data, read again, against the material; +infinity for equal pictures
  std::size_t clipped = 0;  ///< negative channels that were set to 0
};

/// Bytes of the arrays of a file.
std::uint64_t rglBytes(const RglLayout& layout, const RglSize& size);

/// Any material in a parameterisation of its own as RGL files have it: the smallest of some sizes that reaches the SNR,
/// or the best within `maxBytes`; larger ones that gain nothing are not tried. Directions as renderers take them, the
/// viewer in the slot of the incident direction. Some seconds: one rendering a size. @throws Cancelled.
RglParameterisation parameterise(const Brdf& material, const RglOptions& options = {}, const TaskControl& control = {});

}  // namespace gonio::exports
