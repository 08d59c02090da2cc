// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/rgl_brdf.h"
#include "core/support/task_control.h"

namespace gonio {

struct EditedRgl {
  SliceStack<glm::vec3> rgb;  ///< the field `rgb` after the edits
  bool changed = false;       ///< whether any value of it differs from the file's
  std::size_t clipped = 0;    ///< number of channel values that would have become negative and were set to 0
};

/// Treatment of changed channels that would be negative (colours outside the sRGB gamut): set to 0, or left negative.
enum class NegativeColours { clip, preserve };

/// The field `rgb` of an RGL file after edits: the file's values plus the difference edited - file at its own nodes.
/// Values that the edits do not change remain bitwise equal, also negative ones. Nodes with the light below the
/// horizon, which loaders also use for interpolation, are changed by the same difference as the previous node in the
/// row.
/// @param file read with IncidentDirection::viewer.
/// @param edited the material after edits, or another material that is sampled at these nodes. @throws Cancelled.
EditedRgl editedColours(const RglBrdf& file, const Brdf& edited, const TaskControl& control = {},
                        NegativeColours negative = NegativeColours::clip);

}  // namespace gonio
