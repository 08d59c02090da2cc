// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/incident_slot.h"
#include "core/editing/edit.h"
#include "core/materials/material.h"

namespace gonio::editing {

/// A material with edits.
struct EditedMaterial {
  materials::Material shown;  ///< with its edits
  materials::Material base;   ///< without
  EditList edits = {};
  IncidentSlot incident = IncidentSlot::viewer;  ///< in which `base` is, where it is an RGL or UTIA file
};

/// A material with edits applied: a table where it is one, else its own form under the edits. The material itself where
/// no edit changes anything. @throws Cancelled.
materials::Material withEdits(const materials::Material& base, std::span<const Edit> edits,
                              const TaskControl& control = {});

/// The material of a .gonio file, its edits applied as by withEdits(). Named after the file. `source.sha256` is that of
/// the source.
/// @throws Error naming the file; where the source has changed since; Cancelled.
EditedMaterial editedMaterial(const std::filesystem::path& document, const TaskControl& control = {});

}  // namespace gonio::editing
