// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/documents/edited_material.h"

#include <algorithm>

#include "core/documents/blend_source.h"
#include "core/support/error.h"

namespace gonio::editing {

materials::Material editedMaterial(const std::filesystem::path& path, const TaskControl& control) {
  const EditDocument document = readDocument(path);
  materials::Material material = readSource(document, path, control);
  if (material.source.sha256 != document.sourceSha256)
    throw Error(path.string() + ": its source " +
                (document.blend ? "(" + material.source.description + ")" : material.source.path.string()) +
                " has SHA-256 " + material.source.sha256 + ", the edits were made on " + document.sourceSha256);
  if (isIdentity(document.edits) && !document.blend) return material;
  material.name = path.stem().string();
  const std::shared_ptr<const Brdf> base = material.brdf;
  const bool anisotropic =
      std::any_of(document.edits.begin(), document.edits.end(), [](const auto& edit) { return isAnisotropic(edit); });
  // What is no table keeps its own form under the edits.
  if (material.table) material.brdf = material.table = bakeEdits(material.table, document.edits, control);
  if (!material.table || anisotropic) material.brdf = applyEdits(base, document.edits);
  if (anisotropic) {
    material.source.notes.push_back("the edits are anisotropic: tables hold the mean over " +
                                    std::to_string(bakedAzimuths) + " azimuths");
  }
  material.source.path = std::filesystem::absolute(path).lexically_normal();
  material.source.format = "gonio document";
  return material;
}

}  // namespace gonio::editing
