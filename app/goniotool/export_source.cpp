// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/export_source.h"

#include "app/goniotool/materials.h"
#include "core/editing/blend_source.h"
#include "core/export/export_origin.h"

namespace gonio::tool {

OpenedSource openForExport(const std::string& argument, const TaskControl& control) {
  const materials::Material material = openMaterial(argument, control);
  materials::Material base = material;
  editing::EditList edits;
  if (isDocument(argument)) {
    const editing::EditDocument document = editing::readDocument(argument);
    base = editing::readSource(document, argument, control);
    edits = document.edits;
  }
  return {exports::exportSource(material.name, base, material.brdf, edits), exports::sourceFile(base)};
}

}  // namespace gonio::tool
