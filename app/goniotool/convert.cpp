// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
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

int convert(const ConvertArguments& options, const Tool& tool) {
  const materials::MaterialFormat& format = materials::writableFormat(options.out);
  const materials::Material material = openMaterial(options.material, tool.control("reading"));
  const TabulatedBrdf* own = material.brdf->asTable();
  if (options.wholeCircle && !(own && own->grid() == wholeCircle))
    materials::writeMaterial(*bakeTable(*material.brdf, wholeCircle, tool.control("converting")), options.out);
  else
    materials::writeMaterial(material, options.out, tool.control("converting"));
  const auto bytes = std::filesystem::file_size(options.out);
  print(tool, {{"from", material.source.format}, {"format", format.name}, {"out", options.out}, {"bytes", bytes}},
        options.out + ": " + std::string(format.name) + ", " + std::to_string(bytes) + " bytes\n");
  return 0;
}

}  // namespace

void addConvert(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<ConvertArguments>();
  CLI::App* command = app.add_subcommand("convert", "Between formats; an unchanged MERL file stays byte-identical");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  command->add_option("OUT", options->out, outputHelp("File to write; its suffix chooses the format"))->required();
  command->add_flag("--whole-circle", options->wholeCircle,
                    "A table of 90 x 90 x 360 cells, which keeps what is not reciprocal; without it 90 x 90 x 180");
  command->callback([=, &tool] { tool.run = [=, &tool] { return convert(*options, tool); }; });
}

}  // namespace gonio::tool
