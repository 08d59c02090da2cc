// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>

#include "core/export/export_source.h"
#include "core/support/task_control.h"

namespace gonio::tool {

struct OpenedSource {
  exports::ExportSource material;
  std::filesystem::path path;  ///< of the file that must not be overwritten; empty for a bundled material
};

/// A material argument for an export: an edited RGL file with its own bytes, everything with its origin in a sentence.
/// @throws Error naming the file, as openMaterial().
OpenedSource openForExport(const std::string& argument, const TaskControl& control = {});

}  // namespace gonio::tool
