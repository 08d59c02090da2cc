// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/materials.h"

#include <cctype>
#include <fstream>

#include "core/documents/edited_material.h"

namespace gonio::tool {

bool isDocument(const std::string& argument) {
  std::ifstream stream(argument, std::ios::binary);
  char first = 0;
  while (stream.get(first) && std::isspace(static_cast<unsigned char>(first))) {
  }
  return stream && first == '{';
}

materials::Material openMaterial(const std::string& argument, const TaskControl& control) {
  return isDocument(argument) ? editing::editedMaterial(argument, control) : materials::readMaterial(argument, control);
}

std::string outputHelp(const std::string& what) {
  return what + " (" + materials::suffixText(materials::isWritable, "or") + ")";
}

}  // namespace gonio::tool
