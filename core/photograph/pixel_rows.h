// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <vector>

#include "core/dictionary/principal_components.h"
#include "core/photograph/photograph.h"

namespace gonio::photograph {

/// Where the light of a region is integrated, and the fraction of the region's pixels for which the point stands.
struct RegionPoint {
  glm::dvec2 pixel{0};
  double share = 1;
};

/// The mean of the pixels of a square of a photograph that show the surface.
struct Region {
  std::size_t photograph = 0;
  glm::dvec2 centre{0};             ///< in pixels
  std::vector<RegionPoint> points;  ///< the centroids of the quarters of the square
  Rgb value{0};                     ///< of the mean
  Rgb variance{0};                  ///< of the mean's noise, estimated from second differences of the pixels
};

/// The squares into which the surfaces in the photographs are divided, row after row: as small as possible with at most
/// `most` in all. Only pixels within 98.5 % of the radius count (SurfaceView::shows()). Squares with clipped pixels or
/// pixels that are not finite are not used, but a few of many pixels may be. @throws Error if a photograph has no such
/// pixels, or all are 0.
std::vector<Region> regionsOf(const PhotographSet& set, std::size_t most);

/// The same squares of images that are still to be taken: values and variances are 0.
std::vector<Region> plannedRegions(const PhotographSet& set, std::size_t most);

/// Whether an image shows pixels of the surface that count. O(pixels of the image).
bool hasUsedPixels(const Photograph& photograph);

/// Whether a pixel is inside the image, finite, and not clipped.
bool isUsable(const Photograph& photograph, int x, int y);

/// Pixel values as linear functionals of a BRDF table: the value of row r in channel c is the sum of weights[n][c]
/// times the table's value in cell cells[n], over n from first[r] to first[r + 1].
struct PixelRows {
  std::vector<std::size_t> first;    ///< rows + 1 entries
  std::vector<std::uint32_t> cells;  ///< indices into MappedCells::cells
  std::vector<glm::vec3> weights;    ///< irradiance that the pixel's viewer gets by each cell
  /// Fraction of the light (irradiance) of each row that falls into cells without training data, at grazing angles.
  std::vector<float> lost;

  std::size_t count() const { return first.size() - 1; }
  /// The pixel values of a material. @param values BRDF values of the cells, one per entry of MappedCells::cells.
  std::vector<Rgb> values(const std::vector<glm::vec3>& values) const;
};

/// Integrates the light of each region over the cells: an environment as a sum over its texels, which are merged to
/// blocks where the half-difference coordinates change little from texel to texel; distant and small lights exactly.
/// Cells are interpolated trilinearly, as by TabulatedBrdf. Light and viewer may be exchanged, as the grid is that of
/// reciprocal materials. The surfaces are convex: no shadows, no interreflection. @param rotation rad, added to that of
/// every environment. Parallel, deterministic. @throws Cancelled; Error if the grid is not reciprocal.
PixelRows assembleRows(const dictionary::MappedCells& mapping, const PhotographSet& set,
                       const std::vector<Region>& regions, double rotation = 0, const TaskControl& control = {});

}  // namespace gonio::photograph
