// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/models/model.h"

/// What a fit does with each parameter of a model.
namespace gonio::fitting {

/// Whether the data depend on the azimuth of the half vector.
enum class DataSymmetry { isotropic, anisotropic };

enum class FitRole {
  linear,     ///< solved in closed form inside every trial, for each channel
  nonlinear,  ///< searched for
  twin,       ///< takes the value of another: the data are isotropic
  fixed       ///< stays as it is: a choice, what matters only with another choice, or a grain in isotropic data
};

/// @param base values of all parameters; only the choices are looked at: a fit leaves them.
FitRole fitRole(const models::ModelSpec& spec, const models::ParameterValues& base, std::size_t parameter,
                DataSymmetry symmetry = DataSymmetry::isotropic);
std::vector<std::size_t> parametersOf(const models::ModelSpec& spec, const models::ParameterValues& base, FitRole role,
                                      DataSymmetry symmetry = DataSymmetry::isotropic);

/// The choices that switch lobes which are on by default: those with which the width of a highlight matters.
std::vector<std::size_t> optionalLobes(const models::ModelSpec& spec);

/// Gives every twin the value of the parameter that it follows.
void copyToTwins(const models::ModelSpec& spec, models::ParameterValues& values,
                 DataSymmetry symmetry = DataSymmetry::isotropic);

/// How many numbers a fit finds: linear and non-linear parameters, those with a value per channel three times; the
/// choices at their defaults.
std::size_t fittedParameterCount(const models::ModelSpec& spec, DataSymmetry symmetry = DataSymmetry::isotropic);

}  // namespace gonio::fitting
