// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/types.h"
#include "core/models/parameter_spec.h"

namespace gonio::widgets {

/// The single value of three linked channels: their luminance if none can be negative, else their mean.
double linkedValue(const models::ParameterSpec& spec, const Rgb& channels);

/// The channels after moving the linked value to `target`: scaled by one factor, which preserves the tint (or shifted,
/// if a channel can be negative or all are 0), within the hard range.
Rgb withLinkedValue(const models::ParameterSpec& spec, const Rgb& channels, double target);

/// Whether a parameter is a colour that a swatch can show.
bool isColour(const models::ParameterSpec& spec);

}  // namespace gonio::widgets
