// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/editing/differential_edit.h"

namespace gonio::editing {

/// What a .gonio file holds: which source, which edits; never measured data. JSON, versioned.
struct EditDocument {
  static constexpr int currentVersion = 1;

  std::string sourcePath;     ///< relative to the document where possible; "library:sgd/chrome" for a bundled material
  std::string sourceSha256;
  std::vector<DifferentialEdit> edits;
  nlohmann::json view = nlohmann::json::object();  ///< the editor's camera, light, exposure: opaque to core
};

nlohmann::json toJson(const EditDocument& document);
/// @throws Error telling the key, what was found and what was expected; unknown models and newer versions too.
EditDocument documentFromJson(const nlohmann::json& json);

/// @throws Error naming the file.
EditDocument readDocument(const std::filesystem::path& path);
/// Atomic. `sourcePath` is written relative to the document's folder when it lies beside or below it.
void writeDocument(const EditDocument& document, const std::filesystem::path& path);
/// The source's path as readMaterial() takes it: relative ones resolved against the document's folder.
std::filesystem::path resolveSource(const EditDocument& document, const std::filesystem::path& documentPath);

}  // namespace gonio::editing
