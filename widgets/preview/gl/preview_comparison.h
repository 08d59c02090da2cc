// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/math/image.h"

namespace gonio::widgets {

/// What can stand on either side of a comparison.
enum class ComparedSubject {
  measured,  ///< the table
  fit,       ///< the fitted model alone
  edited,    ///< the table with its edit
  reference  ///< another material
};

/// How two pictures are shown against each other.
enum class CompareMode {
  off,
  split,       ///< the first left of a bar, the second right of it
  flicker,     ///< the first, and the second while a key is held
  difference,  ///< their difference in false colour
  twoUp        ///< side by side, with one camera
};

/// What of the two luminances L1 (first) and L2 (second) a difference shows.
enum class DifferenceKind {
  absolute,     ///< |L1 - L2|, in the scene's unit of radiance
  signedValue,  ///< L1 - L2, in the scene's unit of radiance
  relative      ///< |L1 - L2| / L2, as a ratio
};
/// Below this luminance of the second a relative difference is taken against it instead: black has no relative error.
inline constexpr double smallestRelativeLuminance = 1e-3;

struct PreviewComparison {
  CompareMode mode = CompareMode::off;
  double split = 0.5;  ///< place of the bar, fraction of the width
  DifferenceKind difference = DifferenceKind::absolute;
  /// The difference that has the last colour; 0: found from the pictures.
  double range = 0;
  bool operator==(const PreviewComparison&) const = default;
};

/// The difference of every pixel that either picture covers by half, in the unit of the kind. Twin of display.frag.
/// The pictures have the same size and hold premultiplied radiance with the coverage in alpha.
std::vector<double> pictureDifferences(const Image& first, const Image& second, DifferenceKind kind);

/// A range in which nearly all of the differences lie: their 99.5th percentile, rounded up to 1, 2 or 5 times a power
/// of ten; 0.001 for equal pictures.
double automaticRange(std::vector<double> differences);

/// "Luminance difference, scene radiance", and the unit of its numbers: "" or "%".
QString differenceTitle(DifferenceKind kind);
QString differenceNumber(DifferenceKind kind, double value);

}  // namespace gonio::widgets
