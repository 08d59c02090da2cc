// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <vector>

#include "core/math/image.h"

namespace gonio::rendering {

/// Densities of directions proportional to the bilinear luminance of a latitude-longitude map, by the marginal and
/// conditional distributions between pixel centres; linear in the cosine instead of the polar angle, which differs
/// inside a row only. All samples of a light of one colour then have the same weight: with a constant density in each
/// pixel, matte materials had twice the noise. Maps above 8,192 pixels wide are reduced by a power of two first.
///
/// The density for a surface is multiplied by a factor for each of up to 32 x 16 cells of the map: the cosine to one
/// of 1,024 normals, raised so that it is positive wherever a normal near that one has a direction above its horizon.
/// Immutable. Eight bytes a pixel, and 2 MB.
class EnvironmentDensity {
 public:
  /// @param radiance no negative values. For a black map the luminance counts as 1 everywhere.
  explicit EnvironmentDensity(const Image& radiance);

  /// Which density: for the whole sphere, or for surfaces.
  using Table = std::size_t;
  static constexpr Table wholeSphere = 0;
  /// @param normal unit, in the map's axes.
  static Table tableOf(const Direction& normal);
  /// Whether no light is above the horizon; nothing can be sampled then.
  bool isEmpty(Table table) const { return !(scales_[table] > 0); }

  struct Sample {
    double u;  ///< position across the map, may be up to half a pixel above 1
    double cosTheta;
    double density;  ///< 1/sr; may be 0 where the radiance is
  };
  /// @param u in [0, 1)^2, for row and column. Precondition: the table is not empty.
  Sample sample(Table table, const glm::dvec2& u) const;
  /// Density of sample(), 1/sr. @param position in the map, [0, 1]^2. @param cosTheta of the same direction.
  double density(Table table, const glm::dvec2& position, double cosTheta) const;

 private:
  struct Node {
    float across;     ///< integral of the luminance from the start of the cell to this node
    float luminance;  ///< at most 1
  };
  struct Cell {
    Direction centre;
    double sineOfRadius, cosineOfRadius;  ///< of a cone about the centre
    double mass;                          ///< integral of the luminance
  };

  void reduce(const Image& radiance);
  void buildCells();
  Cell makeCell(std::size_t column, std::size_t row) const;
  void buildTables();
  double factor(Table table, std::size_t cell) const;
  std::size_t rowAbove(std::size_t strip) const { return strip > 0 ? strip - 1 : 0; }
  std::size_t rowBelow(std::size_t strip) const { return strip < height_ ? strip : height_ - 1; }
  std::size_t cellColumns() const { return columnStart_.size() - 1; }
  std::size_t cellRows() const { return stripStart_.size() - 1; }

  std::size_t width_, height_;  ///< of the reduced map
  double perAzimuth_;           ///< columns, 1/rad
  std::vector<Node> nodes_;     ///< [row][column]
  // Strip i is between the centres of the rows i - 1 and i; the first and the last one reach from the centres to the
  // poles.
  std::vector<double> cosEdges_;                       ///< of the strips, height + 2
  std::vector<std::size_t> columnStart_, stripStart_;  ///< of the cells, and the end
  std::vector<std::uint8_t> cellColumn_, cellRow_;     ///< of a column, of a strip
  std::vector<float> acrossCell_;                      ///< [row][cell column]: integral over the cell
  std::vector<float> down_;  ///< [cell column][strip]: integral from the top of the cell to the strip
  std::vector<Cell> cells_;
  std::vector<float> cumulative_;  ///< [table][cell], from 0 to 1, one entry more than cells
  std::vector<double> scales_;     ///< [table]: of the factors, so that densities integrate to 1
};

}  // namespace gonio::rendering
