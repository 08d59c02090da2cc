// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/documents/open_material.h"

#include <cctype>
#include <fstream>

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

}  // namespace gonio::editing
