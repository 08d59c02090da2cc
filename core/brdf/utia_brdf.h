// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <vector>

#include "core/brdf/brdf.h"

namespace gonio {

/// An anisotropic material of the UTIA database (Filip and Vávra 2014, "Template-Based Sampling of Anisotropic BRDFs"):
/// values for 288 incident by 288 viewing directions, each 6 polar angles (0 to 75 degrees, every 15) by 48 azimuths
/// (every 7.5 degrees). Linear in the four angles between nodes, as in the authors' published interpolation, with these
/// differences:
/// - At polar angle 0 all azimuths are one direction, so the 48 stored values are replaced by their mean, which makes
///   the BRDF continuous there.
/// - From 75 degrees to the horizon the value at 75 degrees is used (the published code extrapolates linearly and can
///   become negative); hasData() is false there.
/// Not reciprocal, as measured, except with IncidentDirection::mean. About 0.2 us per pair.
class UtiaBrdf final : public Brdf {
 public:
  static constexpr std::size_t polarCount = 6, azimuthCount = 48, directionCount = polarCount * azimuthCount;
  static constexpr double polarStep = radians(15), azimuthStep = radians(7.5);
  static constexpr double maxPolarAngle = polarStep * double(polarCount - 1);

  /// @param values [incident direction][viewing direction], where a direction has the index polar angle * 48 + azimuth;
  /// linear RGB, 1/sr, without the cosine. Negative values become 0 (clampedCount()).
  /// @throws Error if there are not 288 x 288 values or one is not finite (the message names it).
  explicit UtiaBrdf(std::vector<glm::vec3> values, IncidentDirection incident = IncidentDirection::viewer);
  /// The same file read with another setting of IncidentDirection; shares the values.
  std::shared_ptr<const UtiaBrdf> withIncident(IncidentDirection incident) const;
  std::optional<IncidentDirection> incidentDirection() const override { return incident_; }
  std::shared_ptr<const Brdf> readWith(IncidentDirection incident) const override { return withIncident(incident); }

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override;
  bool isIsotropic() const override { return false; }
  bool isReciprocal() const override { return incident_ == IncidentDirection::mean; }
  /// Whether both polar angles are at most 75 degrees.
  bool hasData(const DirectionPair& pair) const override;
  std::shared_ptr<const ValueBound> valueBound() const override;

  /// [incident direction][viewing direction]; the 48 values of polar angle 0 are equal. Shared by the BRDFs that
  /// withIncident() returns.
  using Values = std::vector<glm::vec3>;
  const std::shared_ptr<const Values>& values() const { return values_; }
  /// The pairs at the values of one incident direction, in their order, with IncidentDirection::viewer.
  static std::vector<DirectionPair> nodes(std::size_t incident);
  /// Number of channel values that were below 0 and were set to 0.
  std::size_t clampedCount() const { return clampedCount_; }

 private:
  UtiaBrdf(const UtiaBrdf& other, IncidentDirection incident)
      : values_(other.values_), clampedCount_(other.clampedCount_), incident_(incident) {}

  std::shared_ptr<const Values> values_;
  std::size_t clampedCount_ = 0;
  IncidentDirection incident_;
};

}  // namespace gonio
