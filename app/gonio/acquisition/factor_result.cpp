// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/factor_result.h"

namespace gonio::app {

FactorResultPtr measureFactors(const FactorSettings& settings, const AcquisitionReferencePtr& reference,
                               const TaskControl& control) {
  constexpr double predictedFraction = 0.5;
  const acquisition::FactorPlan plan = acquisition::planFactors(settings.plan);
  auto result = std::make_shared<FactorResult>();
  result->blocked = plan.blocked;
  result->curves =
      acquisition::factorMeasurement(plan, acquisition::measure(*reference->table, plan.plan, settings.noise));
  result->support = acquisition::supportOf(result->curves);
  result->table = bakeTable(*acquisition::predictFromFactors(result->curves, settings.bound), reference->table->grid(),
                            control.between(0, predictedFraction));
  static_cast<ComparedPicture&>(*result) =
      comparedPicture(*result->table, reference, control.between(predictedFraction, 1));
  return result;
}

}  // namespace gonio::app
