// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/math/image.h"

namespace gonio::widgets {

/// The possible subjects on the sides of a comparison.
enum class ComparedSubject {
  measured,  ///< the base: the material before edits, in its native form
  fit,       ///< the fitted model alone
  edited,    ///< the base with its edits
  reference  ///< another material
};

/// How two pictures are compared.
enum class CompareMode {
  off,
  split,       ///< the first left of a bar, the second right of it
  flicker,     ///< the first, and the second while a key is held
  difference,  ///< their difference in false colour
  twoUp        ///< side by side, with the same camera
};

/// The quantity of a difference picture of the luminances L1 (first) and L2 (second).
enum class DifferenceKind {
  absolute,     ///< |L1 - L2|, in the scene's unit of radiance
  signedValue,  ///< L1 - L2, in the scene's unit of radiance
  relative      ///< |L1 - L2| / L2, as a ratio
};
/// Minimum denominator of a relative difference, since a relative error of black is undefined.
inline constexpr double minRelativeLuminance = 1e-3;

struct PreviewComparison {
  CompareMode mode = CompareMode::off;
  double split = 0.5;  ///< position of the bar, as a fraction of the width
  DifferenceKind difference = DifferenceKind::absolute;
  /// The difference shown in the last colour of the map; 0: automaticRange().
  double range = 0;
  bool operator==(const PreviewComparison&) const = default;
};

/// The differences of all pixels that either picture covers by at least half, in the unit of the kind. Computes the
/// same as display.frag. The pictures have the same size and contain premultiplied radiance with the coverage in alpha.
std::vector<double> pictureDifferences(const Image& first, const Image& second, DifferenceKind kind);

/// A range that contains nearly all differences: their 99.5th percentile, rounded up to 1, 2 or 5 times a power of ten;
/// 0.001 for equal pictures.
double automaticRange(std::vector<double> differences);

/// "Luminance difference, relative [%]"; and a number in this unit.
QString differenceTitle(DifferenceKind kind);
QString differenceNumber(DifferenceKind kind, double value);

}  // namespace gonio::widgets
