// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/brdf/tabulated_brdf.h"
#include "core/models/model.h"

namespace gonio::editing {

/// A differential edit (dissertation 4.4.1, eq. 4.40-4.41, the sign of the residual kept): the change of a fitted
/// model is added to the measurement,
///   edited = max(0, measured + strength (model(edited) - model(fitted))),
/// so that what the model does not explain survives. A small value that is replayed on an immutable base.
struct DifferentialEdit {
  const models::Model* model = nullptr;
  models::ParameterValues fitted;
  models::ParameterValues edited;
  double strength = 1;  ///< [0, 1]
  bool enabled = true;

  /// Whether it leaves every base as it is, bit for bit.
  bool isIdentity() const { return !enabled || strength == 0 || edited == fitted; }
  bool operator==(const DifferentialEdit&) const = default;
};

/// Whether it changes a material by something that depends on the azimuth, so that no isotropic table can hold it.
bool isAnisotropic(const DifferentialEdit& edit);

/// The edited reflectance: the base with the edits applied in order, each clamped at 0.
/// A pair at which the base has no data (below the horizon) stays 0.
std::shared_ptr<const Brdf> applyEdits(std::shared_ptr<const Brdf> base, std::span<const DifferentialEdit> edits);

/// The same without the clamp: where an edit takes away more than was measured, the value is negative. What the
/// plausibility checks judge; nothing to render.
std::shared_ptr<const Brdf> applyEditsUnclamped(std::shared_ptr<const Brdf> base,
                                                std::span<const DifferentialEdit> edits);

/// Over how many azimuths, spread over half a turn, bakeEdits() averages an anisotropic edit. Enough for a highlight
/// ten times as wide along one axis as along the other; every model looks the same from the opposite side.
inline constexpr int bakedAzimuths = 64;

/// The edited reflectance as a table over the base's cells: invalid cells stay invalid; an identity stack returns the
/// base itself. Tables are isotropic: where an edit is not, the table holds the mean over `bakedAzimuths` turns of both
/// directions about the normal. A value that would overflow float is capped at the largest float and counted in
/// `*cappedCount` when given. In parallel, deterministic. @throws Cancelled.
std::shared_ptr<const TabulatedBrdf> bakeEdits(const std::shared_ptr<const TabulatedBrdf>& base,
                                               std::span<const DifferentialEdit> edits, const TaskControl& control = {},
                                               std::size_t* cappedCount = nullptr);

}  // namespace gonio::editing
