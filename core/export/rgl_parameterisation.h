// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <optional>

#include "core/export/rgl_sampler.h"
#include "core/support/task_control.h"

namespace gonio::exports {

/// Number of polar angles of the incident direction, and of nodes along each side of a slice.
struct RglSize {
  std::size_t thetaCount = 16, size = 32;
};

struct RglOptions {
  double snr = 40;                     ///< rendered SNR in comparisonScene() to reach, dB
  std::optional<RglSize> fixed;        ///< this size instead of the smallest that reaches the SNR
  std::uint64_t maxBytes = 5'000'000;  ///< of the RGB file
  std::size_t azimuths = 12;           ///< for anisotropic materials: intervals of the circle
  /// Whether slices of isotropic materials contain the difference between the two sides of the plane of incidence. Set
  /// false for Mitsuba 3, which does not define how it folds the azimuth of such files.
  bool bothSides = false;
  int pictureSize = 128, samples = 128;  ///< of the pictures that measure the SNR
};

struct RglParameterisation {
  RglData data;
  RglSize size;
  double snr = 0;  ///< rendered SNR of the data, read again, against the material, dB; +infinity for equal pictures
  std::size_t clipped = 0;  ///< number of negative channel values that were set to 0
};

/// Size of the arrays of a file in bytes.
std::uint64_t rglBytes(const RglLayout& layout, const RglSize& size);

/// Samples any material in an adaptive RGL parameterisation, with the viewer as incident direction
/// (IncidentDirection::viewer). Of a series of sizes, uses the smallest one that reaches the SNR, or the best within
/// `maxBytes`; stops when larger sizes gain nothing. Takes a few seconds: one rendering per size. @throws Cancelled.
RglParameterisation parameterise(const Brdf& material, const RglOptions& options = {}, const TaskControl& control = {});

}  // namespace gonio::exports
