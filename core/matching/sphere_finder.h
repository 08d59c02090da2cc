// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/image.h"

/// Pictures of a sphere as references: where the sphere is, and the controls of an edit that reproduce it.
namespace gonio::matching {

/// The disc of a sphere in a picture, in pixels: pixel (x, y) covers [x, x + 1] x [y, y + 1], y down.
struct Disc {
  double x = 0, y = 0, radius = 0;
  bool operator==(const Disc&) const = default;
};

/// Smallest radius of a disc, in pixels.
inline constexpr double minDiscRadius = 8;

/// Finds the outline of the largest sphere in a picture: in its alpha if it has a transparent background, otherwise
/// where colours change. The strongest circle of a generalised Hough transform of the edges (Ballard 1981,
/// "Generalizing the Hough Transform to Detect Arbitrary Shapes") is refined at full resolution by a robust
/// least-squares fit of a circle. Less than a pixel from the true outline if most of it is visible. At most 0.2 s for 4
/// million pixels.
/// @throws Error if there is no circle with edges along at least half of it.
Disc findSphere(const Image& picture);

}  // namespace gonio::matching
