// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <chrono>
#include <cmath>
#include <optional>

#include "app/goniotool/materials.h"
#include "app/goniotool/outputs.h"
#include "app/goniotool/picture_options.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/export/export_target.h"
#include "core/rendering/environment.h"
#include "core/rendering/scene_file.h"

namespace gonio::tool {

namespace {

struct ExportArguments {
  std::string material, out, target;
  double snr = 40;
  int samples = exports::ExportOptions{}.samples;
  std::size_t thetaCount = 0, size = 0;
  std::string blender;      ///< a version, such as 4.3; empty: the default
  std::string scene;        ///< a name or a file; empty: none
  std::string up = "y";     ///< of a mesh as the scene
  std::string environment;  ///< in the place of the scene's own
};

std::string textOf(const exports::ExportResult& made, std::span<const exports::ExportFile> files) {
  std::string text;
  for (const exports::ExportFile& file : files)
    text += file.path.string() + ": " + std::to_string(file.bytes.size()) + " bytes\n";
  if (made.brdf)
    text += std::isfinite(made.snr) ? "  rendered SNR " + number(made.snr) + " dB\n" : "  images are identical\n";
  for (const std::string& loss : made.losses) text += "  note: " + loss + "\n";
  for (const std::string& warning : made.warnings) text += "  warning: " + warning + "\n";
  return text;
}

Json filesJson(std::span<const exports::ExportFile> files) {
  Json json = Json::array();
  for (const exports::ExportFile& file : files)
    json.push_back({{"path", file.path.string()}, {"bytes", file.bytes.size()}});
  return json;
}

/// "mitsuba, pbrt"
std::string sceneTargetList() {
  std::string text;
  for (const exports::ExportTarget& target : exports::exportTargets())
    if (target.scene) text += (text.empty() ? "" : ", ") + std::string(target.id);
  return text;
}

/// 3 of "3" and "3.4".
int blenderSeries(const std::string& version) {
  const std::string series = version.substr(0, version.find('.'));
  if (series == "3" || series == "4") return series == "3" ? 3 : 4;
  throw UsageError("found '" + version + "', expected 3 or 4, or a version of these such as 3.4");
}

exports::ExportOptions exportOptions(const ExportArguments& arguments, const exports::ExportTarget& target) {
  if ((arguments.thetaCount > 0) != (arguments.size > 0))
    throw UsageError("export: --theta-count and --size must be given together");
  exports::ExportOptions options;
  options.snr = arguments.snr;
  options.samples = arguments.samples;
  if (!arguments.blender.empty()) {
    if (!arguments.target.starts_with("blender") && arguments.target != "principled")
      throw UsageError("export: --blender is for blender and principled: found --for " + arguments.target);
    options.blender = blenderSeries(arguments.blender);
  }
  if (arguments.size == 0) return options;
  if (!target.usesSize)
    throw UsageError("export: --theta-count and --size are for .bsdf files: found --for " + arguments.target +
                     ", expected mitsuba or pbrt");
  options.size = {arguments.thetaCount, arguments.size};
  return options;
}

constexpr const char* sphereName = "sphere";

/// What is written beside the material; nothing where it is not asked for.
std::optional<rendering::Scene> exportScene(const ExportArguments& arguments, const exports::ExportTarget& target) {
  if (arguments.scene.empty() && arguments.environment.empty()) return std::nullopt;
  if (!target.scene) throw UsageError("export: --scene is for " + sceneTargetList());
  rendering::Scene scene = rendering::openScene(arguments.scene.empty() ? sphereName : arguments.scene, 1,
                                                rendering::upAxisOf(arguments.up));
  if (!arguments.environment.empty()) scene.environment = rendering::openEnvironment(arguments.environment);
  return scene;
}

int exportMaterial(const ExportArguments& arguments, const Tool& tool) {
  const exports::ExportTarget& target = *exports::findExportTarget(arguments.target);
  const exports::ExportOptions options = exportOptions(arguments, target);
  const auto start = std::chrono::steady_clock::now();
  const std::optional<rendering::Scene> scene = exportScene(arguments, target);
  const materials::EditedMaterial source = documents::openWithEdits(arguments.material, tool.control("reading"));
  const std::filesystem::path name = target.nameOf(arguments.out);
  const std::vector<std::filesystem::path> paths = target.paths(name, scene ? &*scene : nullptr);
  if (!tool.force)
    for (const std::filesystem::path& path : paths) checkOutput(path, documents::filesOf(arguments.material));
  exports::checkTargets(paths, {}, tool.force);
  if (scene) exports::checkSceneName(*target.scene, name.filename().string());
  exports::ExportResult made = exports::makeExport(target, source, options, tool.control("exporting"));
  if (scene) exports::addScene(made, target, *scene, name);
  const std::vector<exports::ExportFile> files = exports::exportedFiles(made, name);
  exports::writeExport(files);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  Json json{{"target", arguments.target},
            {"files", filesJson(files)},
            {"snr", decibelsJson(made.snr)},
            {"brdfSnr", decibelsJson(made.brdfSnr)}};
  std::string costs;
  if (made.brdf) {
    const study::UseCost cost = study::measureUse(*made.brdf, tool.control("measuring"));
    addCost(json, cost);
    costs = costText(cost) + " (the files, evaluated by Gonio)\n";
  }
  for (const exports::ExportFact& fact : made.facts)
    std::visit([&](const auto& value) { json[std::string(fact.key)] = value; }, fact.value);
  json["losses"] = made.losses;
  json["warnings"] = made.warnings;
  json["seconds"] = seconds.count();
  print(tool, json, textOf(made, files) + costs);
  return 0;
}

/// "Targets:\n  mitsuba: Mitsuba 3. Renders in Mitsuba 3 as it looks here." and so on, one target a line
std::string targetList() {
  std::string text = "Targets:";
  for (const exports::ExportTarget& target : exports::exportTargets())
    text += "\n  " + std::string(target.id) + ": " + std::string(target.label) + ". " + std::string(target.purpose);
  return text;
}

std::vector<std::string> targetIds() {
  std::vector<std::string> ids;
  for (const exports::ExportTarget& target : exports::exportTargets()) ids.emplace_back(target.id);
  return ids;
}

}  // namespace

void addExport(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<ExportArguments>();
  CLI::App* command = app.add_subcommand("export", "Exports a material, with its edits, for a renderer or as a table");
  command->footer(targetList());
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  command->add_option("OUT", options->out, "Path of the files to write, without suffix")
      ->group(outputGroup)
      ->required();
  command->add_option("--for", options->target, "Target: the program or the kind of data")
      ->required()
      ->check(CLI::IsMember(targetIds()));
  command->add_option("--snr", options->snr, "Min. rendered SNR of the files, dB (40)")->check(CLI::Range(0.0, 100.0));
  command->add_option("--samples", options->samples, "Samples per pixel of the images for the rendered SNR (32)")
      ->check(CLI::Range(1, 1 << 20));
  command
      ->add_option("--blender", options->blender, "Version of Blender that the export is for, such as 3.4 or 4.3 (4)")
      ->type_name("VERSION")
      ->check(parsedBy(blenderSeries));
  command
      ->add_option("--theta-count", options->thetaCount,
                   "Number of incident polar angles of a .bsdf file; needs --size")
      ->check(CLI::Range(4, 1024));
  command
      ->add_option("--size", options->size,
                   "Nodes per side of the grid for each incident direction of a .bsdf file; needs --theta-count")
      ->check(CLI::Range(4, 512));
  command
      ->add_option("--scene", options->scene,
                   "Also write a scene with the material, for " + sceneTargetList() +
                       ": a bundled scene, a scene file or a mesh; without a value, sphere")
      ->type_name("NAME|FILE")
      ->expected(0, 1)
      ->default_str(sphereName);
  addUpOption(*command, options->up);
  command
      ->add_option(
          "--environment", options->environment,
          "Environment of the written scene: a bundled one or an image; implies --scene (environment of the scene)")
      ->type_name("NAME|FILE");
  command->callback([options, &tool] { tool.run = [options, &tool] { return exportMaterial(*options, tool); }; });
}

}  // namespace gonio::tool
