// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/brdf/rgl_brdf.h"

namespace gonio::exports {

/// A material to export, and its origin.
struct ExportSource {
  std::string name;                              ///< for display, e.g. "chrome"; plainText()
  std::shared_ptr<const Brdf> brdf;              ///< with edits, as displayed
  std::shared_ptr<const RglBrdf> rgl = nullptr;  ///< the material without edits if it is an RGL file, else null
  std::vector<std::byte> rglFile = {};  ///< the bytes of that file; for a blend of RGL files, those of an equivalent
                                        ///< file
  std::string origin = {};  ///< source, hash, edits and version of Gonio, for descriptions in the files; plainText()
};

/// Warnings for the user: whether the material reflects more light than it receives, with the viewer's angle of the
/// maximum. Usually empty. About 0.1 s.
std::vector<std::string> exportWarnings(const Brdf& material);

}  // namespace gonio::exports
