// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/factors/factors_with_costs.h"

#include "core/formats/pdv.h"
#include "core/study/evaluation_time.h"

namespace gonio::app {

FactorsWithCosts factorizeWithCosts(const LoadedMaterialPtr& material, const FactorsWithCosts::Kind& kind,
                                    const TaskControl& control) {
  FactorsWithCosts measured;
  measured.material = material;
  const auto table = material->table(control);
  measured.factorization = factorization::factorizePdv(
      *table, {.form = kind.form, .transform = kind.transform, .terms = maxEditedTerms}, control);
  measured.along = factorization::residualsAlong(*table, measured.factorization.factors,
                                                 factorization::PdvOptions().weights, control);
  for (int terms = 1; terms <= measured.factorization.factors.terms(); ++terms) {
    control.throwIfStopped();
    const auto factors = measured.factorization.factors.truncated(terms);
    measured.bytes.push_back(formats::pdvFileBytes(factors));
    measured.nanoseconds.push_back(study::measureEvaluation(*factorization::makePdvBrdf(factors)).median);
  }
  return measured;
}

}  // namespace gonio::app
