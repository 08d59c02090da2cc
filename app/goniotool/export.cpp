// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <chrono>
#include <cmath>

#include "app/goniotool/export_source.h"
#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/export/export_files.h"
#include "core/export/rgl_export.h"

namespace gonio::tool {

namespace {

struct ExportArguments {
  std::string material, out, target;
  double snr = 40;
  std::size_t thetaCount = 0, size = 0;
  bool force = false;
};

/// What an export of any target reports.
struct ExportReport {
  std::vector<exports::ExportFile> files;
  Json json = Json::object();  ///< what the target alone reports
  double snr = 0;
  std::vector<std::string> warnings;
};

/// OUT without the suffixes of the files that are made of it.
std::filesystem::path stemOf(const std::string& out) {
  std::string stem = out;
  for (const std::string suffix : {".bsdf", "_rgb", "_spec"})
    if (stem.ends_with(suffix)) stem.resize(stem.size() - suffix.size());
  return stem;
}

std::vector<std::filesystem::path> targetPaths(const ExportArguments& options) {
  const std::string stem = stemOf(options.out).string();
  return {stem + "_rgb.bsdf", stem + "_spec.bsdf"};
}

ExportReport exportBsdf(const exports::ExportSource& source, const ExportArguments& options,
                        std::span<const std::filesystem::path> paths, const Tool& tool) {
  exports::RglOptions rgl;
  rgl.snr = options.snr;
  if (options.size > 0) rgl.fixed = {options.thetaCount, options.size};
  exports::RglExport made = exports::exportRgl(source, rgl, tool.control("exporting"));
  ExportReport report;
  report.snr = made.snr;
  report.json = {{"thetaCount", made.size.thetaCount},
                 {"size", made.size.size},
                 {"unchanged", made.unchanged},
                 {"negativeValues", made.negativeValues},
                 {"clippedValues", made.clippedValues}};
  report.files = {{paths[0], std::move(made.rgb)}, {paths[1], std::move(made.spectral)}};
  if (made.negativeValues > 0)
    report.warnings.push_back(std::to_string(made.negativeValues) +
                              " negative values (colours outside sRGB): renderers clip them differently");
  return report;
}

std::string textOf(const ExportReport& report) {
  std::string text;
  for (const exports::ExportFile& file : report.files)
    text += file.path.string() + ": " + std::to_string(file.bytes.size()) + " bytes\n";
  text += std::isfinite(report.snr) ? "  rendered SNR " + number(report.snr) + " dB\n" : "  equal pictures\n";
  for (const std::string& warning : report.warnings) text += "  warning: " + warning + "\n";
  return text;
}

Json filesJson(const std::vector<exports::ExportFile>& files) {
  Json json = Json::array();
  for (const exports::ExportFile& file : files)
    json.push_back({{"path", file.path.string()}, {"bytes", file.bytes.size()}});
  return json;
}

int exportMaterial(const ExportArguments& options, const Tool& tool) {
  if ((options.thetaCount > 0) != (options.size > 0))
    throw UsageError("export: --theta-count and --size belong together");
  const auto start = std::chrono::steady_clock::now();
  const OpenedSource source = openForExport(options.material, tool.control("reading"));
  const auto paths = targetPaths(options);
  exports::checkTargets(paths, source.path, options.force);
  ExportReport report = exportBsdf(source.material, options, paths, tool);
  for (std::string& warning : exports::exportWarnings(*source.material.brdf))
    report.warnings.push_back(std::move(warning));
  exports::writeExport(report.files);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  Json json{{"target", options.target}, {"files", filesJson(report.files)}, {"snr", decibelsJson(report.snr)}};
  json.update(report.json);
  json["warnings"] = report.warnings;
  json["seconds"] = seconds.count();
  print(tool, json, textOf(report));
  return 0;
}

}  // namespace

void addExport(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<ExportArguments>();
  CLI::App* command = app.add_subcommand("export", "Writes a material, with its edits, as the files of a renderer");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  command->add_option("OUT", options->out, "Name of the files, without their suffix")->required();
  command->add_option("--for", options->target, "The renderer: mitsuba or pbrt (NAME_rgb.bsdf and NAME_spec.bsdf)")
      ->required()
      ->check(CLI::IsMember({"mitsuba", "pbrt"}));
  command->add_option("--snr", options->snr, "Rendered SNR that a file must reach, dB (40)")->check(CLI::Range(0, 100));
  command->add_option("--theta-count", options->thetaCount, "Number of incident polar angles, with --size")
      ->check(CLI::Range(4, 1024));
  command->add_option("--size", options->size, "Nodes along each side of a slice, with --theta-count")
      ->check(CLI::Range(4, 512));
  command->add_flag("--force", options->force, "Replace files that exist");
  command->callback([options, &tool] { tool.run = [options, &tool] { return exportMaterial(*options, tool); }; });
}

}  // namespace gonio::tool
