// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/math/fast_functions.h"

namespace gonio {

/// BRDF values for several angles of incidence, each over polar angle and azimuth about an axis, as instruments and
/// optical design programs write them. Angles are in radians, ascending.
struct IncidenceTable {
  enum class Axis {
    mirror,  ///< the mirror direction of the light: the highlight is at polar angle 0; azimuth 0 points from it to the
             ///< normal
    normal   ///< the normal: polar angle of the viewer; azimuth relative to the light's
  };

  Axis axis = Axis::mirror;
  bool symmetric = true;             ///< the two sides of the plane of incidence are mirror images: azimuths in [0, pi]
  std::vector<double> incident;      ///< polar angles of the light, [0, pi/2]
  std::vector<double> azimuths;      ///< about the axis, counter-clockwise seen from outside, [0, 2 pi]
  std::vector<double> polars;        ///< from the axis, [0, pi]
  std::vector<glm::vec3> values;     ///< [rotation][incident][azimuth][polar], linear RGB, 1/sr, without the cosine
  std::vector<double> rotations{0};  ///< azimuths of the light about the normal, [0, 2 pi); one: isotropic
};

/// A BRDF that interpolates an IncidenceTable: linearly in polar angle and azimuth about the axis, and between two
/// angles of incidence and two azimuths of the light linearly at equal angles about the mirror direction, so that a
/// highlight moves with the light. Isotropic if the light has one azimuth; several wrap around. Nodes below the horizon
/// are dropped and the weights renormalised. All values at polar angle 0 belong to one direction and are replaced by
/// their mean. Beyond the first and last angle of incidence or polar angle the value is constant and hasData() is
/// false; directions that are below the horizon at that angle of incidence have the value at its horizon, at the same
/// azimuth about the mirror direction. Azimuths wrap around; in a symmetric table the value is constant beyond the
/// first and last azimuth, where hasData() remains true. Not reciprocal, as measured. About 0.1 us per pair.
class IncidenceTableBrdf final : public Brdf {
 public:
  /// Negative values become 0 (clampedCount()). @throws Error if angles are out of range or not ascending, the number
  /// of values differs from that of the nodes, or a value is not finite (the message names it).
  explicit IncidenceTableBrdf(IncidenceTable table);

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override;
  bool isIsotropic() const override { return table_.rotations.size() == 1; }
  bool isReciprocal() const override { return false; }
  bool hasData(const DirectionPair& pair) const override;
  std::shared_ptr<const ValueBound> valueBound() const override;

  const IncidenceTable& table() const { return table_; }
  /// Whether the viewing direction of a node is above the horizon; other nodes are ignored. @param node index into the
  /// values.
  bool isAboveHorizon(std::size_t node) const { return aboveHorizon_[node] != 0; }
  /// Number of channel values that were below 0 and were set to 0.
  std::size_t clampedCount() const { return clampedCount_; }

 private:
  struct Weighted;
  Weighted lookup(std::size_t light, double polar, double azimuth) const;
  Rgb value(const DirectionPair& pair) const;

  IncidenceTable table_;
  std::vector<std::uint8_t> aboveHorizon_;  ///< of each node
  std::vector<SineAndCosine> incident_;     ///< of the angles of incidence
  std::size_t clampedCount_ = 0;
};

}  // namespace gonio
