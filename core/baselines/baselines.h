// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/support/task_control.h"

/// Factorisations from the literature beside that over projected-deviation coordinates, for comparisons at equal bytes.
namespace gonio::factorization {

struct ComparedModel {
  std::shared_ptr<const Brdf> brdf;  ///< evaluated from its factors; samples by the cosine
  std::size_t bytes = 0;             ///< of its factors and colours in single precision; nodes of axes are not counted
};

struct Baseline {
  std::string_view id;  ///< on the command line
  std::string_view name;
  std::string_view reference;
  /// One model per budget, in their order: the best it does with at most that many bytes, as many terms, or as fine a
  /// table, as they hold; at least one term. A baseline without terms gives the same model for each. What the models
  /// share is computed once. Deterministic. @throws Cancelled.
  std::vector<ComparedModel> (*build)(const TabulatedBrdf& table, std::span<const std::size_t> byteBudgets,
                                      const TaskControl& control);
};

/// All of them.
std::span<const Baseline> baselines();

}  // namespace gonio::factorization
