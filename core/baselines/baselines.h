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

/// Compact representations from the literature (factorisations, a bivariate table, a cosine series, a Gaussian
/// process), for comparison with the PDV factors at an equal number of bytes.
namespace gonio::baselines {

struct ComparedModel {
  /// sample() uses the factors for the baselines of Lawrence et al. and Bilgili et al., and is cosine-weighted for the
  /// others.
  std::shared_ptr<const Brdf> brdf;
  std::size_t bytes = 0;  ///< of the stored model, values in single precision, without the nodes of the axes
};

struct Baseline {
  std::string_view id;         ///< name on the command line
  std::string_view label;      ///< for legends: authors and year, or the name of the decomposition
  std::string_view name;       ///< the method in words, e.g. "homomorphic factorisation"
  std::string_view reference;  ///< authors, year, title
  std::size_t maxBytes;        ///< size of its largest model; 0: fixed size for every budget, may exceed the budget
  /// One model per budget, in the order of the budgets: the largest one (number of terms, or side of the table) that
  /// fits in that many bytes, with at least one term. A baseline of fixed size returns the same model for every budget.
  /// Steps common to all models are computed once. Deterministic. @throws Cancelled.
  std::vector<ComparedModel> (*build)(const TabulatedBrdf& table, std::span<const std::size_t> byteBudgets,
                                      const TaskControl& control);
};

/// All baselines.
std::span<const Baseline> allBaselines();
/// The baseline with an id. @throws Error that lists the ids.
const Baseline& findBaseline(std::string_view id);

}  // namespace gonio::baselines
