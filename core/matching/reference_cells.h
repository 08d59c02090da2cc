// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/matching/sphere_finder.h"

namespace gonio::matching {

/// A picture of a sphere that an edit is to reproduce.
struct ReferencePicture {
  Image image;  ///< linear RGB radiance; its alpha is not used
  Disc disc;    ///< of the sphere
  /// Channels of at least this radiance are clipped: the true value is only known not to be less.
  double clip = std::numeric_limits<double>::infinity();
};

/// Means over square cells of a picture, in a square that contains the disc of its sphere. Cells consist of whole
/// pixels: the mean over a part of a pixel would be blurred.
struct ReferenceCells {
  enum class Known : std::uint8_t {
    no,       ///< outside the disc or on its outline; not finite; partly clipped
    atLeast,  ///< clipped everywhere
    yes
  };
  int side = 0;  ///< number of cells per row and column
  /// Centre (y up) and half side of the square, relative to the centre and the radius of the disc.
  glm::dvec2 centre{0};
  double halfSize = 1;
  std::vector<Rgb> values;
  std::vector<std::array<Known, 3>> known;  ///< per channel
  double mean = 0;                          ///< of all values that are not Known::no

  bool isUsed(std::size_t cell) const { return known[cell] != std::array{Known::no, Known::no, Known::no}; }
};

/// @param maxSide largest number of cells per row and column of the disc. @param stride 1 to use all cells, n to use
/// every nth on diagonals. Cells that reach beyond 97 % of the radius are not known. @throws Error if no value is
/// known, or all are 0.
ReferenceCells referenceCells(const ReferencePicture& picture, int maxSide, int stride = 1);

}  // namespace gonio::matching
