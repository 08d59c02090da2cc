// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <utility>

#include "core/models/parameter_spec.h"

namespace gonio::widgets {

/// What a parameter's slider spans, first the least value: the soft range, widened where the fitted value lies outside,
/// so that it comes to lie four fifths of the way; never beyond the hard range.
std::pair<double, double> sliderRange(const models::ParameterSpec& spec, double fitted);

}  // namespace gonio::widgets
