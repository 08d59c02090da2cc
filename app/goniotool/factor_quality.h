// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

#include "app/goniotool/report.h"
#include "core/materials/material.h"

namespace gonio::tool {

/// Errors against a measurement.
struct BrdfQuality {
  std::vector<double> errors;  ///< in the order of metrics::allBrdfMetrics()
  double brdfSnr = 0;          ///< dB
};
BrdfQuality brdfQuality(const Brdf& measurement, const Brdf& test);

/// The errors of the table that a method works on, under the key `table`, if the measurement is not this table itself.
/// @return a line of text, or "".
std::string addTableQuality(Json& json, const Brdf& measurement, const TabulatedBrdf& table);

/// Errors of a factorisation, computed in the same way for all methods of `goniotool factor`.
struct FactorQuality : BrdfQuality {
  double renderedSnr = 0;  ///< dB, in pictures of the size of smallComparisonPicture()
  double evaluationNs = 0;
};

/// Against the material in its native form. @param samples per pixel of the pictures. Takes a few seconds. @throws
/// Cancelled.
FactorQuality factorQuality(const materials::Material& material, const Brdf& factors, int samples, const Tool& tool);

/// Adds errors, brdfSnr, renderedSnr and evaluationNs.
void addQuality(Json& json, const FactorQuality& quality);
/// "BRDF SNR 31 dB, rendered SNR 28 dB", the times, and a line per error.
std::string qualityText(const FactorQuality& quality, double seconds);

}  // namespace gonio::tool
