// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/brdf.h"
#include "core/editing/edit.h"
#include "core/materials/material.h"

namespace gonio::materials {

/// A material with edits: what is displayed, compared, exported and saved.
struct EditedMaterial {
  Material shown;  ///< with the edits applied
  Material base;   ///< without edits, as it was read
  editing::EditList edits = {};
  IncidentDirection incident = IncidentDirection::viewer;  ///< of `base`, if it is an RGL or UTIA file
};

/// A material without edits.
EditedMaterial unedited(const Material& material);
EditedMaterial unedited(const std::string& name, std::shared_ptr<const Brdf> brdf);

/// A material with edits applied: a table if the material is a table, otherwise its native form evaluated with the
/// edits. Anisotropic edits of a table set both: Material::brdf evaluates the edits, Material::table contains the mean
/// over the azimuths. Returns the material itself if no edit has an effect. @param cappedCount as in
/// editing::bakeEdits(). @throws Cancelled.
Material withEdits(const Material& base, std::span<const editing::Edit> edits, const TaskControl& control = {},
                   std::size_t* cappedCount = nullptr);

/// The name for files: plainText(), since it may contain anything.
std::string plainName(const EditedMaterial& material);
/// The origin for descriptions in files, as plainText(): name, source, hash, edits, version of Gonio.
std::string originOf(const EditedMaterial& material);

}  // namespace gonio::materials
