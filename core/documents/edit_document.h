// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/editing/edit.h"
#include "core/support/json_object.h"

namespace gonio::documents {

struct BlendSource;

inline constexpr std::string_view documentSuffix = ".gonio";
/// Whether a name ends in documentSuffix, in upper or lower case.
bool isDocumentName(const std::filesystem::path& path);

/// The content of a .gonio file: source, edits and view, never measured data. JSON with a version:
///   {"format": "gonio document", "version": 7, "source": {"path": "a.binary", "sha256": "..."},
///    "edits": [{"type": "differential", "model": "ggx", "fitted": {..}, "edited": {..},
///               "composition": "lobes", "keepAlbedo": true, "controls": {"roughness": 2, ..},
///               "strength": 1, "enabled": true, "name": "wetter"}], "view": {..}}
/// "name" is omitted if the user gave none, "controls" (artistControls()) if none has an effect. Edits of factors
/// contain what toJson(FactorEdit) writes, plus strength, enabled and name; toJson(BlendSource) writes a blend as
/// source. New in version 3: edits of factors; 4: blends; 5: compositions (before, all edits were additive); 6:
/// controls; 7: keepAlbedo, and keepDetail of blends (before, always false). Programs reject documents of a newer
/// version.
struct EditDocument {
  static constexpr int currentVersion = 7;

  /// Absolute, or relative to the folder of the document; "library:sgd/chrome" for a bundled material.
  std::string sourcePath;
  std::string sourceSha256;                                ///< of the source file; of a blend: blendSha256()
  std::shared_ptr<const BlendSource> blend = nullptr;      ///< instead of a path
  IncidentDirection incident = IncidentDirection::viewer;  ///< if the source is an RGL or UTIA file
  std::vector<editing::Edit> edits;
  nlohmann::json view = nlohmann::json::object();  ///< camera, light, exposure; opaque to core; null: no view
};

/// @throws Error if an edit's values do not match its model.
nlohmann::json toJson(const EditDocument& document);
/// Unknown keys are ignored; the parameter values of documents of older versions do not change. @throws Error that
/// states the key, what was found and what was expected; also for unknown models and newer versions.
EditDocument documentFromJson(const nlohmann::json& json);

/// @throws Error that names the file.
EditDocument readDocument(const std::filesystem::path& path);
/// The same for text; the error names no file.
EditDocument documentFromText(std::string_view text);
/// Writes atomically. An absolute `sourcePath` in or below the document's folder is written as a relative path, so that
/// both can be moved together. @throws Error that names the file.
void writeDocument(const EditDocument& document, const std::filesystem::path& path);
/// The path of a source file for readMaterial(): relative paths are resolved against the document's folder. Not for
/// blends.
std::filesystem::path resolveSource(const EditDocument& document, const std::filesystem::path& documentPath);

/// The document with its source path, or those of all materials of its blend, as resolveSource() returns them.
EditDocument resolved(EditDocument document, const std::filesystem::path& documentPath);

/// The JSON that documents and the materials of blends share: "source" and "edits".
nlohmann::json contentToJson(const EditDocument& document);
/// @param depth number of enclosing blends. @throws Error as documentFromJson().
EditDocument contentFromJson(const JsonObject& object, int version, int depth = 0);

/// The model named under "model". @throws Error that names the key.
const models::Model& modelFromJson(const JsonObject& object);

}  // namespace gonio::documents
