// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/export_source.h"

#include "app/goniotool/materials.h"
#include "core/editing/blend_source.h"
#include "core/materials/bundled_library.h"
#include "core/materials/material_file.h"

namespace gonio::tool {

namespace {

/// "differential (ggx, lobes), factors"
std::string editsText(const editing::EditList& edits) {
  std::string text;
  for (const editing::Edit& edit : edits) {
    if (!edit.enabled) continue;
    text += text.empty() ? "" : ", ";
    if (!edit.name.empty()) text += "\"" + edit.name + "\" ";
    if (const auto* change = std::get_if<editing::DifferentialEdit>(&edit.content))
      text += "change of " + std::string(change->model->spec().id) + " (" +
              std::string(editing::compositionIds[std::size_t(change->composition)]) + ")";
    else
      text += "factors";
  }
  return text.empty() ? "none" : text;
}

}  // namespace

OpenedSource openForExport(const std::string& argument, const TaskControl& control) {
  const materials::Material material = openMaterial(argument, control);
  materials::Material base = material;
  std::string edits = "none";
  if (isDocument(argument)) {
    const editing::EditDocument document = editing::readDocument(argument);
    base = editing::readSource(document, argument, control);
    edits = editsText(document.edits);
  }
  OpenedSource opened{{.name = material.name, .brdf = material.brdf}, {}};
  opened.material.origin = material.name + ", exported by Gonio " GONIO_VERSION ". Source: " + base.name + " (" +
                           base.source.format + "), SHA-256 " + base.source.sha256 + ". Edits: " + edits;
  if (const RglBrdf* rgl = base.brdf->asRgl()) {
    opened.material.rgl = std::shared_ptr<const RglBrdf>(base.brdf, rgl);
    opened.material.rglFile = materials::materialFile(base.source);
  }
  if (!base.source.path.native().starts_with(materials::libraryScheme)) opened.path = base.source.path;
  return opened;
}

}  // namespace gonio::tool
