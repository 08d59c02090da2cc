// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/types.h"
#include "core/models/parameter_spec.h"

namespace gonio::widgets {

/// The one number that stands for the three channels of a parameter: their luminance where none can be negative, else
/// their mean.
double linkedValue(const models::ParameterSpec& spec, const Rgb& channels);

/// The channels with the linked value moved to `target`: scaled together, so that the tint stays (or shifted together,
/// where a channel can be negative or all are 0); each inside its hard range.
Rgb withLinkedValue(const models::ParameterSpec& spec, const Rgb& channels, double target);

/// Whether the three channels of a parameter are a colour that a swatch can show.
bool isColour(const models::ParameterSpec& spec);

}  // namespace gonio::widgets
