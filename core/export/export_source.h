// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/brdf/rgl_brdf.h"

namespace gonio::exports {

/// A material that is to leave Gonio, and where it comes from.
struct ExportSource {
  std::string name;                              ///< "chrome", for people
  std::shared_ptr<const Brdf> brdf;              ///< as it is shown, with its edits
  std::shared_ptr<const RglBrdf> rgl = nullptr;  ///< the file without edits where it is an RGL file, else null
  std::vector<std::byte> rglFile = {};           ///< its bytes; of a blend what it would be as a file
  std::string origin = {};                       ///< source, hash, edits and version, for the files' descriptions
};

/// Sentences for people: that the material reflects more light than it receives, at the angle of the viewer where that
/// is the most. Usually none. About 0.1 s.
std::vector<std::string> exportWarnings(const Brdf& material);

}  // namespace gonio::exports
