// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <utility>

#include "core/models/parameter_spec.h"

namespace gonio::widgets {

/// Minimum and maximum of a parameter's slider: the soft range, extended if the fitted value is outside, so that it is
/// at four fifths of the slider; never beyond the hard range.
std::pair<double, double> sliderRange(const models::ParameterSpec& spec, double fitted);

}  // namespace gonio::widgets
