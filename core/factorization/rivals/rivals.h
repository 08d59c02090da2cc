// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include "core/brdf/tabulated_brdf.h"
#include "core/support/task_control.h"

/// Factorisations from the literature beside that over projected-deviation coordinates, for comparisons at equal bytes.
namespace gonio::factorization {

struct RivalModel {
  std::shared_ptr<const Brdf> brdf;  ///< evaluated from its factors; samples by the cosine
  std::size_t bytes = 0;             ///< of its factors and colours in single precision; nodes of axes are not counted
  double seconds = 0;                ///< that the factorisation took
};

struct Rival {
  std::string_view id;  ///< on the command line
  std::string_view name;
  std::string_view reference;
  /// The best it does with at most that many bytes: as many terms, or as fine a table, as they hold; at least one
  /// term. Deterministic. @throws Cancelled.
  RivalModel (*build)(const TabulatedBrdf& table, std::size_t byteBudget, const TaskControl& control);
};

/// All of them.
std::span<const Rival> rivals();

}  // namespace gonio::factorization
