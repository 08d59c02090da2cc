// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/export_source.h"
#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"

namespace gonio::tool {

namespace {

/// Of files that are not reciprocal: phi_d is not folded.
constexpr HalfDifferenceGrid wholeCircle{.phiDCount = 360, .reciprocal = false};

struct ConvertArguments {
  std::string material, out;
  bool wholeCircle = false;
};

void writeTable(const ConvertArguments& options, const Tool& tool, const materials::Material& material) {
  const TabulatedBrdf* own = material.brdf->asTable();
  if (options.wholeCircle && !(own && own->grid() == wholeCircle))
    materials::writeMaterial(*bakeTable(*material.brdf, wholeCircle, tool.control("converting")), options.out);
  else
    materials::writeMaterial(material, options.out, tool.control("converting"));
}

int convert(const ConvertArguments& options, const Tool& tool) {
  checkFormSuffix(options.out);
  std::string from, format;
  std::vector<std::string> losses;
  if (isRglOrUtia(options.out)) {
    if (options.wholeCircle) throw UsageError("convert: --whole-circle is for .binary, found " + options.out);
    const OpenedSource source = openForExport(options.material, tool.control("reading"));
    losses = writeRglOrUtia(source.material, source.base, options.out, tool.control("converting"));
    from = source.base.source.format;
    format = materials::formatOf(exports::formatOf(exports::formBySuffix(options.out, *source.base.brdf))).name;
  } else {
    format = materials::writableFormat(options.out).name;
    const materials::Material material = openMaterial(options.material, tool.control("reading"));
    writeTable(options, tool, material);
    from = material.source.format;
  }
  const auto bytes = std::filesystem::file_size(options.out);
  std::string text = options.out + ": " + format + ", " + std::to_string(bytes) + " bytes\n";
  for (const std::string& loss : losses) text += "  note: " + loss + "\n";
  print(tool, {{"from", from}, {"format", format}, {"out", options.out}, {"bytes", bytes}, {"losses", losses}}, text);
  return 0;
}

}  // namespace

void addConvert(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<ConvertArguments>();
  CLI::App* command =
      app.add_subcommand("convert", "Converts between formats; an unchanged MERL file stays byte-identical");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  command->add_option("OUT", options->out, nativeFormHelp("File to write; its suffix sets the format"))->required();
  command->add_flag(
      "--whole-circle", options->wholeCircle,
      "Sample phi_d from 0 to 360 degrees, 90 x 90 x 360 instead of 90 x 90 x 180 cells, as non-reciprocal "
      "materials need");
  command->callback([=, &tool] { tool.run = [=, &tool] { return convert(*options, tool); }; });
}

}  // namespace gonio::tool
