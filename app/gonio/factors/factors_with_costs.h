// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/document/loaded_material.h"
#include "core/factorization/pdv_residuals.h"

namespace gonio::app {

/// The factors of a material with the error and cost of each number of terms.
struct FactorsWithCosts {
  /// Options selected before the factorisation; the number of terms is selected afterwards.
  struct Kind {
    factorization::PdvForm form = factorization::PdvForm::twoFactors;
    DataTransform transform = DataTransform::logPlus;
    bool operator==(const Kind&) const = default;
  };
  LoadedMaterialPtr material;
  factorization::PdvFactorization factorization;
  // For each number of terms; index 0: one term.
  std::vector<factorization::PdvResidualsAlong> along;  ///< residuals at each node
  std::vector<std::size_t> bytes;                       ///< size of a file with the factors
  std::vector<double> nanoseconds;  ///< per evaluation on one core, median of several runs on this machine

  /// Relative residual |y - y^| / |y| with this number of terms, in the weighted norm of the factorisation; y is the
  /// transformed BRDF, y^ its approximation. In [0, 1].
  double residual(int terms) const { return factorization.residuals[std::size_t(terms)]; }
};

inline constexpr int maxEditedTerms = 10;

/// Factorises and measures the costs; takes a few seconds for three factors. @throws Cancelled.
FactorsWithCosts factorizeWithCosts(const LoadedMaterialPtr& material, const FactorsWithCosts::Kind& kind,
                                    const TaskControl& control = {});

}  // namespace gonio::app
