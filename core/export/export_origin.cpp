// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/export_origin.h"

#include "core/editing/edit_summary.h"
#include "core/export/rgl_fields.h"
#include "core/materials/bundled_library.h"
#include "core/materials/material_file.h"
#include "core/materials/material_formats.h"
#include "core/support/plain_text.h"

namespace gonio::exports {

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

ExportSource exportSource(const std::string& name, const materials::Material& base, std::shared_ptr<const Brdf> shown,
                          const editing::EditList& edits) {
  ExportSource source{.name = plainText(name), .brdf = std::move(shown)};
  source.origin = plainText(source.name + ", exported by Gonio " GONIO_VERSION ". Source: " + base.name + " (" +
                            base.source.format + "), SHA-256 " + base.source.sha256 + ". Edits: " + editsText(edits));
  if (const RglBrdf* rgl = base.brdf ? base.brdf->asRgl() : nullptr) {
    source.rgl = std::shared_ptr<const RglBrdf>(base.brdf, rgl);
    source.rglFile = base.source.format != materials::formatOf(materials::FormatId::rgl).name
                         ? io::encodeTensorFile(rglFields(wholeData(*rgl->tables()), source.origin, RglColours::rgb))
                         : materials::materialFile(base.source);
  }
  return source;
}

std::string proposedName(const std::string& material, const editing::EditList& edits) {
  std::string name;
  for (const char c : plainText(editing::editedName(material, edits)))
    if (c != ',') name += c == ' ' ? '_' : c;
  return name;
}

}  // namespace gonio::exports
