// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <utility>

#include "core/models/parameter_spec.h"

namespace gonio::widgets {

/// Minimum and maximum of a parameter's slider: the soft range. If the fitted value is outside, the range is extended
/// beyond this value, but not beyond the hard range.
std::pair<double, double> sliderRange(const models::ParameterSpec& spec, double fitted);

}  // namespace gonio::widgets
