// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <string_view>

#include "core/math/types.h"

namespace gonio::editing {

/// How the change of a fitted model from M to M' is applied to a measurement m (all 1/sr). If M' = M, m is bitwise
/// unchanged. applyEdits() clamps the result at 0.
enum class Composition {
  additive,  ///< m + (M' - M): Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling and
             ///< Acquisition", section 4.4.1, eq. 4.40-4.41
  logPlus,   ///< (rho_0 + m)(rho_0 + M') / (rho_0 + M) - rho_0: a ratio in highlights, a difference in the tails
  lobes      ///< each lobe carries the ratio q = (m + eps) / (M + eps) along as it widens (LobeChange); only for models
             ///< that are sums of lobes (models::Model::hasLobes())
};
inline constexpr std::array<std::string_view, 3> compositionIds{"additive", "log-plus", "lobes"};

/// rho_0 of Composition::logPlus, 1/sr.
inline constexpr double logPlusOffset = 1;

/// The difference that Composition::logPlus adds to a value, 1/sr. @param value m. @param edited M'. @param fitted M.
inline Rgb logPlusChange(const Rgb& value, const Rgb& edited, const Rgb& fitted) {
  return (logPlusOffset + glm::max(value, Rgb(0))) * ((edited - fitted) / (logPlusOffset + fitted));
}

}  // namespace gonio::editing
