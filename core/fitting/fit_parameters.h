// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/models/model.h"

/// How a fit treats each parameter of a model.
namespace gonio::fitting {

/// Whether the data depend on the azimuth of the half vector.
enum class DataSymmetry { isotropic, anisotropic };

enum class FitRole {
  linear,     ///< solved per channel for each trial of the others (solveLinearParameters())
  nonlinear,  ///< found by a non-linear search
  twin,       ///< copies another parameter, because the data are isotropic
  fixed  ///< not changed: a choice, a parameter that is inactive with the current choices, or a grain in isotropic data
};

/// @param base values of all parameters; only those of the choices (parameters with ParameterSpec::choices) are used.
FitRole fitRole(const models::ModelSpec& spec, const models::ParameterValues& base, std::size_t parameter,
                DataSymmetry symmetry = DataSymmetry::isotropic);
std::vector<std::size_t> parametersOf(const models::ModelSpec& spec, const models::ParameterValues& base, FitRole role,
                                      DataSymmetry symmetry = DataSymmetry::isotropic);

/// The choices that can switch off a lobe that is on by default. A choice is one of them if a width of a highlight is
/// active only with the default of this choice (ParameterSpec::activeWith).
std::vector<std::size_t> optionalLobes(const models::ModelSpec& spec);

/// Sets every twin to the value of the parameter that it copies.
void copyToTwins(const models::ModelSpec& spec, models::ParameterValues& values,
                 DataSymmetry symmetry = DataSymmetry::isotropic);

/// The number of values that a fit determines, with choices at their defaults: linear and non-linear parameters, where
/// per-channel parameters count three times.
std::size_t fittedParameterCount(const models::ModelSpec& spec, DataSymmetry symmetry = DataSymmetry::isotropic);

}  // namespace gonio::fitting
