// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <vector>

#include "core/brdf/brdf.h"

namespace gonio {

/// Values for some angles of incidence, each over the directions about an axis: what instruments and optical design
/// programs measure and write. Angles in radians, ascending.
struct IncidenceTable {
  enum class Axis {
    mirror,  ///< the mirror direction of the light: polar 0 is the highlight, azimuth 0 points from it to the normal
    normal   ///< the normal: polar angle of the viewer, azimuth from that of the light
  };

  Axis axis = Axis::mirror;
  bool symmetric = true;          ///< the other side of the plane of incidence is the mirror image: azimuths in [0, pi]
  std::vector<double> incident;   ///< polar angles of the light, [0, pi/2]
  std::vector<double> azimuths;   ///< about the axis, counter-clockwise seen from outside, [0, 2 pi]
  std::vector<double> polars;     ///< from the axis, [0, pi]
  std::vector<glm::vec3> values;  ///< [incident][azimuth][polar], linear RGB in 1/sr without the cosine
};

/// An isotropic BRDF by such a table. Linear in polar angle and azimuth about the axis; between two angles of incidence
/// linear at equal angles about the mirror direction, so that a highlight moves with the light and does not fade from
/// one place to another. Nodes below the horizon are dropped and the weights renormalised. The values at polar angle 0,
/// one direction, are replaced by their mean. Before the first and after the last node of each coordinate the value at
/// that node stays; hasData() is false there. Not reciprocal, as measured. About 0.3 us per pair.
class IncidenceTableBrdf final : public Brdf {
 public:
  /// Negative values become 0 and are counted.
  /// @throws Error where angles are not ascending in their ranges, the number of values is not that of the nodes, or a
  /// value is not finite, naming it.
  explicit IncidenceTableBrdf(IncidenceTable table);

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override;
  bool isReciprocal() const override { return false; }
  bool hasData(const DirectionPair& pair) const override;

  const IncidenceTable& table() const { return table_; }
  /// Whether the direction of a node, in the order of the values, is above the horizon: others do not count.
  bool isAboveHorizon(std::size_t node) const { return aboveHorizon_[node] != 0; }
  /// Channels of values that were below 0 and were set to 0.
  std::size_t negativeCount() const { return negativeCount_; }

 private:
  struct Weighted;
  Weighted lookup(std::size_t incident, double polar, double azimuth) const;
  Rgb value(const DirectionPair& pair) const;

  IncidenceTable table_;
  std::vector<std::uint8_t> aboveHorizon_;  ///< of each node
  std::size_t negativeCount_ = 0;
};

}  // namespace gonio
