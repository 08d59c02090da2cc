// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"

namespace gonio::tool {

namespace {

int convert(const std::string& file, const std::string& out, const Tool& tool) {
  const materials::MaterialFormat& format = materials::writableFormat(out);
  const materials::Material material = openMaterial(file, tool.control("reading"));
  materials::writeMaterial(material, out, tool.control("converting"));
  const auto bytes = std::filesystem::file_size(out);
  print(tool, {{"from", material.source.format}, {"format", format.name}, {"out", out}, {"bytes", bytes}},
        out + ": " + std::string(format.name) + ", " + std::to_string(bytes) + " bytes\n");
  return 0;
}

}  // namespace

void addConvert(CLI::App& app, Tool& tool) {
  const auto file = std::make_shared<std::string>(), out = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("convert", "Between formats; an unchanged MERL file stays byte-identical");
  command->add_option("MATERIAL", *file, materialHelp)->required();
  command->add_option("OUT", *out, outputHelp("File to write; its suffix chooses the format"))->required();
  command->callback([=, &tool] { tool.run = [=, &tool] { return convert(*file, *out, tool); }; });
}

}  // namespace gonio::tool
