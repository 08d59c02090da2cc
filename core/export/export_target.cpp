// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/export_target.h"

#include <cstdio>
#include <iterator>

#include "core/editing/edit_list.h"
#include "core/metrics/brdf_metrics.h"
#include "core/sampling/directional_albedo.h"
#include "core/support/text.h"

namespace gonio::exports {

namespace fs = std::filesystem;

namespace {

/// Whether the material reflects more light than it receives, with the viewer's angle of the maximum. About 0.1 s.
std::vector<std::string> exportWarnings(const Brdf& material) {
  constexpr double allowed = 1.001;  // the error of the quadrature
  double worst = 0, where = 0;
  const DirectionalAlbedo albedoAt(material);
  for (const double theta : {0.0, 30.0, 60.0, 80.0})
    if (const double albedo = maxChannel(albedoAt(radians(theta))); albedo > worst) {
      worst = albedo;
      where = theta;
    }
  if (!(worst > allowed)) return {};
  char text[160];
  std::snprintf(text, sizeof text,
                "the material reflects more light than it receives: albedo %.3f for a viewer at %.0f degrees", worst,
                where);
  return {text};
}

/// A hint for the case that a target whose size grows with the SNR does not reach it.
std::string shortfall(double snr, const ExportOptions& options) {
  char text[160];
  std::snprintf(text, sizeof text, "rendered SNR %.1f dB, less than the requested %.0f dB: %s", snr, options.snr,
                options.size ? "without a given size, the size follows the material" : "larger files gain nothing");
  return text;
}

}  // namespace

std::uint64_t ExportResult::bytes() const {
  std::uint64_t sum = 0;
  for (const ExportPart& part : parts) sum += part.bytes.size();
  return sum;
}

std::vector<fs::path> ExportTarget::paths(const fs::path& name, const rendering::Scene* withScene) const {
  std::vector<fs::path> result;
  for (const std::string_view suffix : suffixes) result.push_back(fs::path(name) += suffix);
  if (withScene)
    for (const std::string& suffix : sceneSuffixes(*scene, *withScene)) result.push_back(fs::path(name) += suffix);
  return result;
}

fs::path ExportTarget::nameOf(const fs::path& file) const {
  const std::string text = file.string();
  const auto without = [&](std::string_view ending) { return text.substr(0, text.size() - ending.size()); };
  for (const std::string_view suffix : suffixes)
    if (text.size() > suffix.size() && text.ends_with(suffix)) return without(suffix);
  for (const std::string_view suffix : suffixes) {
    const std::string_view last = suffix.substr(suffix.rfind('.'));
    if (text.size() > last.size() && text.ends_with(last)) return without(last);
  }
  return file;
}

ExportResult makeExport(const ExportTarget& target, const materials::EditedMaterial& source,
                        const ExportOptions& options, const TaskControl& control) {
  constexpr double warned = 0.02, poorSnr = 10;
  std::vector<std::string> warnings = exportWarnings(*source.shown.brdf);
  ExportResult made = target.make(source, options, control.between(warned, 0.95));
  if (made.brdf) made.brdfSnr = metrics::brdfSignalToNoiseRatio(*source.shown.brdf, *made.brdf);
  if (made.snr < poorSnr)
    made.warnings.push_back(
        "this target cannot represent the material: renderings of the export look clearly different");
  else if (target.usesSnr && made.snr < options.snr)
    made.warnings.push_back(shortfall(made.snr, options));
  made.warnings.insert(made.warnings.end(), std::make_move_iterator(warnings.begin()),
                       std::make_move_iterator(warnings.end()));
  return made;
}

void addScene(ExportResult& made, const ExportTarget& target, const rendering::Scene& scene, const fs::path& name) {
  for (ExportPart& part : sceneParts(*target.scene, scene, name.filename().string()))
    made.parts.push_back(std::move(part));
}

std::vector<ExportFile> exportedFiles(const ExportResult& made, const fs::path& name) {
  std::vector<ExportFile> files;
  for (const ExportPart& part : made.parts) files.push_back({fs::path(name) += part.suffix, part.bytes});
  return files;
}

std::string proposedName(const std::string& material, const editing::EditList& edits) {
  // An RGL file is named NAME_rgb.bsdf, and the targets add such an ending again.
  std::string_view base = material;
  for (const std::string_view ending : {"_rgb", "_spec"})
    if (base.ends_with(ending)) base.remove_suffix(ending.size());
  std::string name;
  for (const char c : plainText(editing::editedName(std::string(base), edits)))
    if (c != ',') name += c == ' ' ? '_' : c;
  return name;
}

}  // namespace gonio::exports
