// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/document/loaded_material.h"
#include "core/factorization/pdv_residuals.h"

namespace gonio::app {

/// The factors of a material with what each count of terms costs.
struct MeasuredFactors {
  /// What is chosen before a factorisation; the count of terms is chosen after it.
  struct Kind {
    factorization::PdvForm form = factorization::PdvForm::twoFactors;
    DataTransform transform = DataTransform::logPlus;
    bool operator==(const Kind&) const = default;
  };
  LoadedMaterialPtr material;
  factorization::PdvFactorization factorization;
  // Of each count of terms; index 0 is one term.
  std::vector<factorization::PdvResidualsAlong> along;  ///< what is left unexplained at each node
  std::vector<std::size_t> bytes;                       ///< of a file with the factors
  std::vector<double> nanoseconds;  ///< of one evaluation on one core, the median of some runs on this machine

  /// The fraction of the transformed reflectance that so many terms leave unexplained, in [0, 1].
  double residual(int terms) const { return factorization.residuals[std::size_t(terms)]; }
};

inline constexpr int maxEditedTerms = 10;

/// Factorises and measures: some seconds in the 3-D form. @throws Cancelled.
MeasuredFactors measureFactors(const LoadedMaterialPtr& material, const MeasuredFactors::Kind& kind,
                               const TaskControl& control = {});

}  // namespace gonio::app
