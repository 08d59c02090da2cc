// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/materials.h"

#include <algorithm>
#include <cctype>
#include <fstream>

#include "core/editing/blend_source.h"

namespace gonio::tool {

namespace {

materials::Material replay(const std::filesystem::path& path, const TaskControl& control) {
  const editing::EditDocument document = editing::readDocument(path);
  materials::Material material = editing::readSource(document, path, control);
  if (material.source.sha256 != document.sourceSha256)
    throw Error(path.string() + ": its source " +
                (document.blend ? "(" + material.source.description + ")" : material.source.path.string()) +
                " has SHA-256 " + material.source.sha256 + ", the edits were made on " + document.sourceSha256);
  if (editing::isIdentity(document.edits) && !document.blend) return material;
  material.name = path.stem().string();
  const std::shared_ptr<const Brdf> base = material.brdf;
  const bool anisotropic = std::any_of(document.edits.begin(), document.edits.end(),
                                       [](const auto& edit) { return editing::isAnisotropic(edit); });
  // What is no table keeps its own form under the edits.
  if (material.table) material.brdf = material.table = editing::bakeEdits(material.table, document.edits, control);
  if (!material.table || anisotropic) material.brdf = editing::applyEdits(base, document.edits);
  if (anisotropic) {
    material.source.notes.push_back("the edits are anisotropic: tables hold the mean over " +
                                    std::to_string(editing::bakedAzimuths) + " azimuths");
  }
  material.source.path = std::filesystem::absolute(path).lexically_normal();
  material.source.format = "gonio document";
  return material;
}

}  // namespace

bool isDocument(const std::string& argument) {
  std::ifstream stream(argument, std::ios::binary);
  char first = 0;
  while (stream.get(first) && std::isspace(static_cast<unsigned char>(first))) {
  }
  return stream && first == '{';
}

materials::Material openMaterial(const std::string& argument, const TaskControl& control) {
  return isDocument(argument) ? replay(argument, control) : materials::readMaterial(argument, control);
}

std::string outputHelp(const std::string& what) {
  return what + " (" + materials::suffixText(materials::isWritable, "or") + ")";
}

}  // namespace gonio::tool
