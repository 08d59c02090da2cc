// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/documents/open_material.h"

#include <algorithm>
#include <cctype>
#include <fstream>

#include "core/documents/blend_source.h"

namespace gonio::editing {

bool isDocument(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  char first = 0;
  while (stream.get(first) && std::isspace(static_cast<unsigned char>(first))) {
  }
  return stream && first == '{';
}

EditedMaterial openWithEdits(const std::string& path, const TaskControl& control) {
  if (isDocument(path)) return editedMaterial(path, control);
  const materials::Material material = materials::readMaterial(path, control);
  return {.shown = material, .base = material};
}

materials::Material openMaterial(const std::string& path, const TaskControl& control) {
  return openWithEdits(path, control).shown;
}

std::vector<std::filesystem::path> filesOf(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};
  std::vector<std::filesystem::path> files{path};
  if (!isDocument(path)) return files;
  try {
    std::ranges::copy(sourceFiles(resolved(readDocument(path), path)), std::back_inserter(files));
  } catch (const Error&) {  // opening the document reports the error
  }
  return files;
}

}  // namespace gonio::editing
