// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/documents/edited_material.h"

#include <algorithm>

#include "core/documents/blend_source.h"
#include "core/support/error.h"

namespace gonio::editing {

materials::Material withEdits(const materials::Material& base, std::span<const Edit> edits,
                              const TaskControl& control) {
  materials::Material material = base;
  if (isIdentity(edits)) return material;
  material.code = nullptr;
  const bool anisotropic = std::ranges::any_of(edits, [](const Edit& edit) { return isAnisotropic(edit); });
  // A material that is not a table is not sampled: the edits are applied to its BRDF.
  if (base.table) material.brdf = material.table = bakeEdits(base.table, edits, control);
  if (!base.table || anisotropic) material.brdf = applyEdits(base.brdf, edits);
  if (anisotropic) {
    material.source.notes.push_back("the edits are anisotropic: tables contain the mean over " +
                                    std::to_string(bakedAzimuths) + " azimuths");
  }
  return material;
}

EditedMaterial editedMaterial(const std::filesystem::path& path, const TaskControl& control) {
  const EditDocument document = readDocument(path);
  EditedMaterial edited{
      .shown = {}, .base = readSource(document, path, control), .edits = document.edits, .incident = document.incident};
  if (edited.base.source.sha256 != document.sourceSha256)
    throw Error(path.string() + ": its source " +
                (document.blend ? "(" + edited.base.source.description + ")" : edited.base.source.path.string()) +
                " has changed: found SHA-256 " + edited.base.source.sha256 + ", expected " + document.sourceSha256);
  edited.shown = withEdits(edited.base, document.edits, control);
  if (isIdentity(document.edits) && !document.blend) return edited;
  edited.shown.name = path.stem().string();
  edited.shown.source.path = std::filesystem::absolute(path).lexically_normal();
  edited.shown.source.format = "gonio document";
  return edited;
}

}  // namespace gonio::editing
