// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/incident_direction.h"
#include "core/editing/edit.h"
#include "core/materials/material.h"

namespace gonio::editing {

/// A material with edits.
struct EditedMaterial {
  materials::Material shown;  ///< with the edits applied
  materials::Material base;   ///< without edits
  EditList edits = {};
  IncidentDirection incident = IncidentDirection::viewer;  ///< of `base`, if it is an RGL or UTIA file
};

/// A material with edits applied: a table if the material is a table, otherwise its native form evaluated with the
/// edits. Anisotropic edits of a table set both: Material::brdf evaluates the edits, Material::table contains the mean
/// over the azimuths. Returns the material itself if no edit has an effect. @throws Cancelled.
materials::Material withEdits(const materials::Material& base, std::span<const Edit> edits,
                              const TaskControl& control = {});

/// Reads a .gonio file and applies its edits (withEdits()). The material is named after the file if it has edits or is
/// a blend; its source.sha256 is that of the source. @throws Error that names the file, also if the source has changed
/// since the edits were made; Cancelled.
EditedMaterial editedMaterial(const std::filesystem::path& document, const TaskControl& control = {});

}  // namespace gonio::editing
