// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "core/editing/differential_edit.h"
#include "core/editing/factor_edit.h"

namespace gonio::editing {

/// One step of the stack of edits that is replayed over a measurement.
using Edit = std::variant<DifferentialEdit, FactorEdit>;

/// Whether it leaves every base as it is, bit for bit.
inline bool isIdentity(const Edit& edit) {
  return std::visit([](const auto& one) { return one.isIdentity(); }, edit);
}
/// Whether it changes a material by something that depends on the azimuth. Factors never do.
inline bool isAnisotropic(const Edit& edit) {
  const auto* differential = std::get_if<DifferentialEdit>(&edit);
  return differential && isAnisotropic(*differential);
}

/// What an editor's document keeps: the factors next to the measurement, then the model; those that are there.
inline std::vector<Edit> editStack(const std::optional<FactorEdit>& factors,
                                   const std::optional<DifferentialEdit>& differential) {
  std::vector<Edit> edits;
  if (factors) edits.push_back(*factors);
  if (differential) edits.push_back(*differential);
  return edits;
}

// As the functions of differential_edit.h, for stacks that hold edits of every kind.
std::shared_ptr<const Brdf> applyEdits(std::shared_ptr<const Brdf> base, std::span<const Edit> edits);
std::shared_ptr<const Brdf> applyEditsUnclamped(std::shared_ptr<const Brdf> base, std::span<const Edit> edits);
std::shared_ptr<const TabulatedBrdf> bakeEdits(const std::shared_ptr<const TabulatedBrdf>& base,
                                               std::span<const Edit> edits, const TaskControl& control = {},
                                               std::size_t* cappedCount = nullptr);

}  // namespace gonio::editing
