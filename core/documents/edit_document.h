// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/brdf/incident_slot.h"
#include "core/editing/edit.h"

namespace gonio::editing {

struct BlendSource;

inline constexpr std::string_view documentSuffix = ".gonio";
/// Whether a name ends in documentSuffix, in either case.
bool isDocumentName(const std::filesystem::path& path);

/// What a .gonio file holds: which source, which edits; never measured data. JSON, versioned:
///   {"format": "gonio document", "version": 6, "source": {"path": "a.binary", "sha256": "..."},
///    "edits": [{"type": "differential", "model": "ggx", "fitted": {..}, "edited": {..},
///               "composition": "lobes", "controls": {"roughness": 2, ..}, "strength": 1, "enabled": true,
///               "name": "wetter"}], "view": {..}}
/// "name" is left out where the user gave none, "controls" (artistControls()) where none changes anything. Edits of
/// factors hold what toJson(FactorEdit) writes beside strength, eye and name; a source that is blended of several is
/// written by toJson(BlendSource). Version 2 knew no edits of factors, version 3 no blends, version 4 no compositions
/// (all were additive), version 5 no controls: they refuse newer documents.
struct EditDocument {
  static constexpr int currentVersion = 6;

  /// Absolute, or relative to the folder of the document; "library:sgd/chrome" for a bundled material.
  std::string sourcePath;
  std::string sourceSha256;                            ///< of a blend that of blendSha256()
  std::shared_ptr<const BlendSource> blend = nullptr;  ///< instead of a path
  IncidentSlot incident = IncidentSlot::viewer;        ///< of a source that is an RGL or UTIA file
  std::vector<Edit> edits;
  nlohmann::json view = nlohmann::json::object();  ///< camera, light, exposure: opaque to core; null: none
};

/// @throws Error when an edit's values do not fit its model.
nlohmann::json toJson(const EditDocument& document);
/// Keys that this version does not know are left out; older versions open with the same numbers.
/// @throws Error that states the key, what was found and what was expected; unknown models and newer versions too.
EditDocument documentFromJson(const nlohmann::json& json);

/// @throws Error naming the file.
EditDocument readDocument(const std::filesystem::path& path);
/// The same of text; the error names no file.
EditDocument documentFromText(std::string_view text);
/// Atomic. An absolute `sourcePath` beside or below the document's folder is written relative to it, so that both can
/// be moved together. @throws Error naming the file.
void writeDocument(const EditDocument& document, const std::filesystem::path& path);
/// The source's path (of one that is no blend) as readMaterial() takes it: relative ones resolved against the
/// document's folder.
std::filesystem::path resolveSource(const EditDocument& document, const std::filesystem::path& documentPath);

/// The document with paths that need no folder: its own, and those of all materials of a blend.
EditDocument resolved(EditDocument document, const std::filesystem::path& documentPath);

}  // namespace gonio::editing
