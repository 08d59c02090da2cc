// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/editing/differential_edit.h"
#include "core/editing/factor_edit.h"

namespace gonio::editing {

/// One step of the stack of edits that is replayed over an immutable measurement: what each kind of edit is made of,
/// and what all kinds have in common.
struct Edit {
  std::variant<DifferentialEdit, FactorEdit> content;
  std::string name = {};  ///< given by the user, UTF-8; empty: none
  double strength = 1;    ///< [0, 1]
  bool enabled = true;

  /// Whether it leaves every base as it is, bit for bit.
  bool isIdentity() const;
  bool operator==(const Edit&) const = default;
};

/// In the order in which they are applied; several of one kind.
using EditList = std::vector<Edit>;

/// Whether all of them leave every base as it is.
bool isIdentity(std::span<const Edit> edits);
/// Whether it changes a material by something that depends on the azimuth, so that no isotropic table can hold it.
/// Factors never do.
bool isAnisotropic(const Edit& edit);

/// The edited BRDF: the base with the edits applied in order, each clamped at 0.
/// A pair at which the base has no data (below the horizon) stays 0.
std::shared_ptr<const Brdf> applyEdits(std::shared_ptr<const Brdf> base, std::span<const Edit> edits);

/// The same without the clamp: where an edit takes away more than was measured, the value is negative. What the
/// plausibility checks judge; nothing to render.
std::shared_ptr<const Brdf> applyEditsUnclamped(std::shared_ptr<const Brdf> base, std::span<const Edit> edits);

/// Over how many azimuths, spread over half a turn, bakeEdits() averages an anisotropic edit. Enough for a highlight
/// ten times as wide along one axis as along the other; every model looks the same from the opposite side.
inline constexpr int bakedAzimuths = 64;

/// The edited BRDF as a table over the base's cells: invalid cells stay invalid; an identity stack returns the base
/// itself. Tables are isotropic: where an edit is not, the table holds the mean over `bakedAzimuths` turns of both
/// directions about the normal. A value that would overflow float is capped at the largest float and counted in
/// `*cappedCount` when given. In parallel, deterministic. @throws Cancelled.
std::shared_ptr<const TabulatedBrdf> bakeEdits(const std::shared_ptr<const TabulatedBrdf>& base,
                                               std::span<const Edit> edits, const TaskControl& control = {},
                                               std::size_t* cappedCount = nullptr);
/// The same over a base of any form: one that is no table is sampled with its edits onto the MERL grid.
std::shared_ptr<const TabulatedBrdf> bakeEdits(const std::shared_ptr<const Brdf>& base, std::span<const Edit> edits,
                                               const TaskControl& control = {});

}  // namespace gonio::editing
