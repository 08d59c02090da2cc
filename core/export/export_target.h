// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "core/export/export_files.h"
#include "core/export/export_source.h"
#include "core/export/rgl_parameterisation.h"
#include "core/export/scene_files.h"

namespace gonio::exports {

struct ExportOptions {
  double snr = 40;                       ///< dB in comparisonScene() that the files should reach
  std::optional<RglSize> size = {};      ///< of `.bsdf` files, instead of the smallest that reaches the SNR
  int pictureSize = 128, samples = 128;  ///< of the pictures by which the SNR is measured
};

/// A number or a property that one target alone reports.
struct ExportFact {
  std::string_view key, label;  ///< of the JSON; for people
  std::variant<bool, std::size_t, double, std::string> value;
};

/// An export in memory.
struct MadeExport {
  std::vector<ExportPart> parts;
  double snr = 0;                    ///< dB of `brdf` against the material; +infinity for equal pictures
  std::shared_ptr<const Brdf> brdf;  ///< what the renderer shows of the files, by the target's own formula
  std::vector<ExportFact> facts;
  std::vector<std::string> warnings;  ///< sentences for people

  std::uint64_t bytes() const;
};

/// A renderer or a format that a material is exported to. The table of all is what the dialog, goniotool and the
/// documentation list.
struct ExportTarget {
  std::string_view id;                     ///< "mitsuba", of --for and of settings
  std::string_view label;                  ///< "Mitsuba 3"
  std::string_view description;            ///< what is written and how it is used, a sentence or two
  std::string_view holds;                  ///< what the files can hold and what not, a sentence
  std::vector<std::string_view> suffixes;  ///< "_rgb.bsdf": the files are NAME with each of them
  bool choosesSize = false;                ///< ExportOptions::size counts
  bool choosesSnr = false;                 ///< ExportOptions::snr counts: the files grow with it
  const SceneFormat* scene = nullptr;      ///< of scenes with the material; null where the target has none
  /// Some seconds. @throws Error; Cancelled.
  MadeExport (*make)(const ExportSource&, const ExportOptions&, const TaskControl&);

  /// NAME with each of the suffixes, and with those of a scene that is written beside them.
  std::vector<std::filesystem::path> paths(const std::filesystem::path& name, const Scene* withScene = nullptr) const;
  /// NAME of what a user calls a file of the export: without a suffix of the target, or without its last part ".bsdf".
  std::filesystem::path nameOf(const std::filesystem::path& file) const;
};

/// All targets, in the order in which they are listed.
std::span<const ExportTarget> exportTargets();
/// Null where no target has this id.
const ExportTarget* findExportTarget(std::string_view id);

/// Makes an export; the warnings that concern the material (exportWarnings()) are among its own.
MadeExport makeExport(const ExportTarget& target, const ExportSource& source, const ExportOptions& options = {},
                      const TaskControl& control = {});
/// Adds the files of a scene. Contract: the target has scenes.
void addScene(MadeExport& made, const ExportTarget& target, const Scene& scene, const std::filesystem::path& name);
/// The parts at the target's paths, for writeExport().
std::vector<ExportFile> filesOf(const MadeExport& made, const std::filesystem::path& name);

}  // namespace gonio::exports
