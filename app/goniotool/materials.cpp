// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/materials.h"

namespace gonio::tool {

std::string outputHelp(const std::string& what) {
  return what + " (" + materials::suffixText(materials::isWritable, "or") + ")";
}

}  // namespace gonio::tool
