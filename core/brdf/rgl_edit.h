// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/rgl_brdf.h"
#include "core/support/task_control.h"

namespace gonio {

struct EditedRgl {
  SliceStack<glm::vec3> rgb;  ///< the field `rgb` after the edits
  bool changed = false;       ///< whether any value of it differs from the file's
  std::size_t clipped = 0;    ///< channels that would have become negative and were set to 0
};

/// What becomes of changed channels that would be negative: colours outside sRGB.
enum class NegativeColours { cut, kept };

/// The colours of an RGL file under edits, at its own nodes: what the file has, plus the difference that the edits make
/// there. So a value that no edit changes stays, bit for bit, negative ones (colours outside sRGB) too. Nodes whose
/// light lies below the horizon, which loaders read for their neighbours, change as the node before them in the row.
/// @param file with the viewer in the slot of the incident direction
/// @param edited the same material as it is shown, or another one that is to have these nodes
EditedRgl editedColours(const RglBrdf& file, const Brdf& edited, const TaskControl& control = {},
                        NegativeColours negative = NegativeColours::cut);

}  // namespace gonio
