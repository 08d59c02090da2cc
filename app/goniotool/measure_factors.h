// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

#include "app/goniotool/tool.h"
#include "core/acquisition/factor_prediction.h"

namespace gonio::tool {

/// Options of `goniotool measure --factors`.
struct MeasureFactorsArguments {
  std::string material;  ///< empty: none
  std::string axes, values, out, predict, bound{acquisition::factorBoundNames[0]};
  double fixedDegrees = 60, maxPolarDegrees = 89, minSeparationDegrees = 2;
  int angles = 90, distances = 90;
  acquisition::MeasurementNoise noise;
};

/// Simulates the readings of both curves of a material, or reads them from a file; predicts the material, and measures
/// the error if the material is given. Without material and readings, writes the directions to measure. @throws
/// UsageError for contradictory options.
int measureFactors(const MeasureFactorsArguments& options, const Tool& tool);

}  // namespace gonio::tool
