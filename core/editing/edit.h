// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/editing/albedo_scale.h"
#include "core/editing/differential_edit.h"
#include "core/editing/factor_edit.h"

namespace gonio::editing {

/// One step of an edit stack, which is applied to an immutable measurement: the content of one kind of edit, and the
/// properties that all kinds share.
struct Edit {
  std::variant<DifferentialEdit, FactorEdit> content;
  std::string name = {};  ///< given by the user, UTF-8; empty: none
  double strength = 1;    ///< [0, 1]
  bool enabled = true;

  /// Whether the edit leaves every base bitwise unchanged.
  bool isIdentity() const;
  bool operator==(const Edit&) const = default;
};

/// Edits in the order of application; may contain several of one kind.
using EditList = std::vector<Edit>;

/// Maximum number of edits of a material.
inline constexpr std::size_t maxEdits = 100;
/// Maximum number of evaluations of the base per evaluation of the edited BRDF. An edit by lobes that changes widths
/// evaluates the edits before it again at other directions, for each change of width, so that these numbers multiply.
inline constexpr double maxBaseEvaluations = 1024;
/// @throws Error that states which of the limits is exceeded. Edits without an effect count only as edits.
void checkLimits(std::span<const Edit> edits);

/// Whether all edits leave every base bitwise unchanged.
bool isIdentity(std::span<const Edit> edits);
/// Whether the change depends on the azimuth, so that an isotropic table cannot represent it. Always false for factors.
bool isAnisotropic(const Edit& edit);

/// The edited BRDF: the base with the edits applied in order, each clamped at 0. Pairs without data in the base (such
/// as below the horizon) remain 0.
std::shared_ptr<const Brdf> applyEdits(std::shared_ptr<const Brdf> base, std::span<const Edit> edits);

/// The factors of the highlights that keep their albedo, one per edit; 1 for all other edits. For the preview's shader.
/// About 3 ms per edit with DifferentialEdit::keepsAlbedo that changes a width.
std::vector<AlbedoScale> albedoScales(const std::shared_ptr<const Brdf>& base, std::span<const Edit> edits);

/// applyEdits() without the clamp, for plausibility checks only: values are negative where an edit removes more than
/// was measured.
std::shared_ptr<const Brdf> applyEditsUnclamped(std::shared_ptr<const Brdf> base, std::span<const Edit> edits);

/// Number of azimuths, over half a turn, over which bakeEdits() averages an anisotropic edit: enough for a highlight
/// ten times as wide along one axis as along the other. Half a turn suffices because all models are symmetric under a
/// rotation by pi.
inline constexpr int bakedAzimuths = 64;

/// The edited BRDF as a table on the base's grid. Invalid cells remain invalid; edits without effect return the base
/// itself. For anisotropic edits the table contains the mean over `bakedAzimuths` rotations of both directions about
/// the normal. Values beyond the range of float become the largest float and are counted in `*cappedCount`, if given.
/// Parallel, deterministic. @throws Cancelled.
std::shared_ptr<const TabulatedBrdf> bakeEdits(const std::shared_ptr<const TabulatedBrdf>& base,
                                               std::span<const Edit> edits, const TaskControl& control = {},
                                               std::size_t* cappedCount = nullptr);
/// The same for a base of any form: if it is not a table, it is sampled with its edits on the MERL grid.
std::shared_ptr<const TabulatedBrdf> bakeEdits(const std::shared_ptr<const Brdf>& base, std::span<const Edit> edits,
                                               const TaskControl& control = {});

}  // namespace gonio::editing
