// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "core/export/export_files.h"
#include "core/export/scenes/scene_files.h"
#include "core/materials/encode.h"

namespace gonio::exports {

using ExportOptions = materials::EncodeOptions;

/// A number or property that only some targets report.
struct ExportFact {
  std::string_view key, label;  ///< key in JSON; label for display
  std::variant<bool, std::size_t, double, std::string> value;
};

/// An export in memory.
struct ExportResult {
  std::vector<ExportPart> parts;
  /// Rendered SNR of `brdf` against the material, dB; +infinity for equal pictures.
  double snr = std::numeric_limits<double>::quiet_NaN();
  double brdfSnr = snr;              ///< BRDF SNR of `brdf`, dB; set by makeExport()
  std::shared_ptr<const Brdf> brdf;  ///< the files as the renderer evaluates them, by the target's own formula; null
                                     ///< for values at individual directions, which have no SNR
  std::vector<ExportFact> facts;
  std::vector<std::string> losses;    ///< what the files do not hold, for the user
  std::vector<std::string> warnings;  ///< for the user

  std::uint64_t bytes() const;
};

/// What a target is for: renderers that read measured values; engines and programs that read parameters of a shading
/// model; tables and data for other programs.
enum class TargetGroup { renderers, engines, data };

/// A renderer or format to which a material can be exported. exportTargets() is the table that the dialog, goniotool
/// and the documentation use.
struct ExportTarget {
  std::string_view id;                     ///< value of --for and of settings, e.g. "mitsuba"
  std::string_view label;                  ///< for display, e.g. "Mitsuba 3"
  std::string_view icon;                   ///< an icon of resources/icons
  std::string_view purpose;                ///< when to choose it, for artists; one sentence
  std::string_view description;            ///< the files and their use, one or two sentences
  std::string_view limitations;            ///< what the files can and cannot represent, one sentence
  std::vector<std::string_view> suffixes;  ///< the files are NAME with each suffix, e.g. "_rgb.bsdf"
  bool usesSize = false;                   ///< uses ExportOptions::size
  bool usesSnr = false;                    ///< uses ExportOptions::snr: files grow with it
  TargetGroup group = TargetGroup::engines;
  const SceneFormat* scene = nullptr;  ///< format of scenes with the material; null if the target has none
  /// Makes the export. Takes a few seconds. @throws Error; Cancelled.
  ExportResult (*make)(const materials::EditedMaterial&, const ExportOptions&, const TaskControl&);

  /// The paths of all files: `name` with each suffix, including those of a scene, if given.
  std::vector<std::filesystem::path> paths(const std::filesystem::path& name,
                                           const rendering::Scene* withScene = nullptr) const;
  /// The name of an export from a file name that the user chose: removes a suffix of the target ("_rgb.bsdf") or its
  /// extension (".bsdf").
  std::filesystem::path nameOf(const std::filesystem::path& file) const;
};

/// All targets, in the order of display.
std::span<const ExportTarget> exportTargets();
/// Null if no target has this id.
const ExportTarget* findExportTarget(std::string_view id);

/// Makes an export. Its warnings include those for a material that reflects more light than it receives, for an SNR
/// below 10 dB, and for less than ExportOptions::snr.
ExportResult makeExport(const ExportTarget& target, const materials::EditedMaterial& source,
                        const ExportOptions& options = {}, const TaskControl& control = {});
/// Adds the files of a scene. Precondition: target.scene is not null. @throws Error as checkSceneName().
void addScene(ExportResult& made, const ExportTarget& target, const rendering::Scene& scene,
              const std::filesystem::path& name);
/// The files of an export for writeExport().
std::vector<ExportFile> exportedFiles(const ExportResult& made, const std::filesystem::path& name);

/// The default name of an export: editing::editedName() as plainText(), without commas and with '_' for spaces, since
/// other programs treat both as separators. Examples: "chrome", "chrome_rougher", "satin_rougher" of satin_rgb.bsdf.
std::string proposedName(const std::string& material, const editing::EditList& edits);

}  // namespace gonio::exports
