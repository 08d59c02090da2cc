// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/acquisition/acquisition_result.h"
#include "core/acquisition/factor_prediction.h"

namespace gonio::app {

struct FactorSettings {
  acquisition::FactorPlanOptions plan;
  acquisition::FactorBound bound = acquisition::FactorBound::readings;
  acquisition::MeasurementNoise noise;
};

/// A simulated factor measurement: the curves that were read, and the predicted material with its picture and error.
struct FactorResult : ComparedPicture {
  acquisition::FactorMeasurement curves;
  acquisition::FactorSupport support;
  int blocked = 0;  ///< readings that were left out
  std::shared_ptr<const TabulatedBrdf> table;
};
using FactorResultPtr = std::shared_ptr<const FactorResult>;

/// Measures two curves of a reference and predicts the material, in about a second. @param reference not null.
/// @throws Error, Cancelled.
FactorResultPtr measureFactors(const FactorSettings& settings, const AcquisitionReferencePtr& reference,
                               const TaskControl& control = {});

}  // namespace gonio::app
