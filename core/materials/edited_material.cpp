// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/edited_material.h"

#include <algorithm>

#include "core/factorization/pdv_operations.h"
#include "core/support/text.h"

namespace gonio::materials {

namespace {

/// "model ggx (composition lobes), factor curves"
std::string editsText(const editing::EditList& edits) {
  std::string text;
  for (const editing::Edit& edit : edits) {
    if (!edit.enabled) continue;
    text += text.empty() ? "" : ", ";
    if (!edit.name.empty()) text += "\"" + edit.name + "\" ";
    if (const auto* change = std::get_if<editing::DifferentialEdit>(&edit.content))
      text += "model " + std::string(change->model->spec().id) + " (composition " +
              std::string(editing::compositionIds[std::size_t(change->composition)]) + ")";
    else
      text += "factor curves";
  }
  return text.empty() ? "none" : text;
}

}  // namespace

EditedMaterial unedited(const Material& material) { return {.shown = material, .base = material}; }

EditedMaterial unedited(const std::string& name, std::shared_ptr<const Brdf> brdf) {
  Material material{.name = name};
  material.table = formOf<TabulatedBrdf>(brdf);
  material.brdf = std::move(brdf);
  return unedited(material);
}

Material withEdits(const Material& base, std::span<const editing::Edit> edits, const TaskControl& control,
                   std::size_t* cappedCount) {
  Material material = base;
  if (editing::isIdentity(edits)) return material;
  material.code = nullptr;
  material.dictionary = nullptr;
  const bool anisotropic =
      std::ranges::any_of(edits, [](const editing::Edit& edit) { return editing::isAnisotropic(edit); });
  // A material that is not a table is not sampled: the edits are applied to its BRDF.
  if (base.table) material.brdf = material.table = editing::bakeEdits(base.table, edits, control, cappedCount);
  if (!base.table || anisotropic) material.brdf = editing::applyEdits(base.brdf, edits);
  if (anisotropic) {
    material.source.notes.push_back("the edits are anisotropic: tables contain the mean over " +
                                    std::to_string(editing::bakedAzimuths) + " azimuths");
  }
  for (const editing::Edit& edit : edits) {
    const auto* curves = std::get_if<editing::FactorEdit>(&edit.content);
    if (!curves || edit.isIdentity()) continue;
    if (const std::string warning = factorization::curveLimitWarning(*curves->edited); !warning.empty())
      material.source.notes.push_back("warning: " + warning);
  }
  return material;
}

std::string plainName(const EditedMaterial& material) { return plainText(material.shown.name); }

std::string originOf(const EditedMaterial& material) {
  const Material& base = material.base;
  return plainText(material.shown.name + ", exported by Gonio " GONIO_VERSION ". Source: " + base.name + " (" +
                   base.source.format + "), SHA-256 " + base.source.sha256 + ". Edits: " + editsText(material.edits));
}

}  // namespace gonio::materials
