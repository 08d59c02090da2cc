// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/rgl_brdf.h"
#include "core/support/task_control.h"

namespace gonio::rgl {

struct EditedRgl {
  SliceStack<glm::vec3> rgb;  ///< the field `rgb` after the edits
  bool changed = false;       ///< whether any value of it differs from the file's
};

/// The field `rgb` of an RGL file after edits: the file's values plus the difference edited - file at its own nodes.
/// Values that the edits do not change remain bitwise equal, also negative ones. Nodes with the light below the
/// horizon, which loaders also use for interpolation, are changed by the same difference as the previous node in the
/// row.
/// @param file read with IncidentDirection::viewer.
/// @param edited the material after edits, or another material that is sampled at these nodes. @throws Cancelled.
EditedRgl editedColours(const RglBrdf& file, const Brdf& edited, const TaskControl& control = {});

/// The field `luminance` of an RGL file for a field `rgb`: the luminance, in each slice at least 1/1000 of the slice's
/// maximum, so that every direction can be sampled. A slice of zeros becomes 1: loaders divide by the integral of a
/// slice and would get NaN.
SliceStack<float> samplingLuminance(const SliceStack<glm::vec3>& rgb);

}  // namespace gonio::rgl
