// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/export_target.h"

#include <algorithm>

#include "core/export/blender_target.h"
#include "core/export/glsl_target.h"
#include "core/export/gltf_target.h"
#include "core/export/materialx_targets.h"
#include "core/export/principled_target.h"
#include "core/export/rgl_target.h"
#include "core/export/slices_target.h"
#include "core/export/table_targets.h"
#include "core/export/values_target.h"

namespace gonio::exports {

namespace fs = std::filesystem;

std::uint64_t ExportResult::bytes() const {
  std::uint64_t sum = 0;
  for (const ExportPart& part : parts) sum += part.bytes.size();
  return sum;
}

std::vector<fs::path> ExportTarget::paths(const fs::path& name, const Scene* withScene) const {
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

std::span<const ExportTarget> exportTargets() {
  static const std::vector<ExportTarget> targets{
      mitsubaTarget(), pbrtTarget(),      blenderTarget(), principledTarget(),
      gltfTarget(),    materialXTarget(), openPbrTarget(), standardSurfaceTarget(),
      valuesTarget(),  glslTarget(),      merlTarget(),    merlCircleTarget(),
      utiaTarget(),    csvTarget(),       slicesTarget()};
  return targets;
}

const ExportTarget* findExportTarget(std::string_view id) {
  const auto targets = exportTargets();
  const auto found = std::ranges::find(targets, id, &ExportTarget::id);
  return found == targets.end() ? nullptr : &*found;
}

ExportResult makeExport(const ExportTarget& target, const ExportSource& source, const ExportOptions& options,
                        const TaskControl& control) {
  constexpr double warned = 0.02, poorSnr = 10;
  std::vector<std::string> warnings = exportWarnings(*source.brdf);
  ExportResult made = target.make(source, options, control.between(warned, 1));
  if (made.snr < poorSnr)
    made.warnings.push_back(
        "this target cannot represent the material: renderings of the export look clearly different");
  made.warnings.insert(made.warnings.end(), std::make_move_iterator(warnings.begin()),
                       std::make_move_iterator(warnings.end()));
  return made;
}

void addScene(ExportResult& made, const ExportTarget& target, const Scene& scene, const fs::path& name) {
  for (ExportPart& part : sceneParts(*target.scene, scene, name.filename().string()))
    made.parts.push_back(std::move(part));
}

std::vector<ExportFile> filesOf(const ExportResult& made, const fs::path& name) {
  std::vector<ExportFile> files;
  for (const ExportPart& part : made.parts) files.push_back({fs::path(name) += part.suffix, part.bytes});
  return files;
}

}  // namespace gonio::exports
