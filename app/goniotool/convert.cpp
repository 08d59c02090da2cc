// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/formats/formats.h"

namespace gonio::tool {

namespace {

struct ConvertArguments {
  std::string material, out;
  bool wholeCircle = false;
  double snr = materials::EncodeOptions{}.snr;
};

int convert(const ConvertArguments& arguments, const Tool& tool) {
  materials::checkWritableSuffix(arguments.out);
  materials::EncodeOptions options{.snr = arguments.snr};
  if (arguments.wholeCircle) {
    if (!materials::hasSuffixOf(formats::merlFormat, arguments.out))
      throw UsageError("convert: --whole-circle is for .binary, found " + arguments.out);
    options.grid = {.phiDCount = 360, .reciprocal = false};
  }
  const materials::EditedMaterial material = documents::openWithEdits(arguments.material, tool.control("reading"));
  const WrittenMaterial written = writeMaterial(material, arguments.out, tool, options);
  const std::string_view format = materials::writableFormat(arguments.out, *material.shown.brdf, options).name;
  Json json{
      {"from", material.shown.source.format}, {"format", format}, {"out", arguments.out}, {"bytes", written.bytes}};
  json.update(written.json());
  print(tool, json,
        arguments.out + ": " + std::string(format) + ", " + std::to_string(written.bytes) + " bytes\n" + written.text);
  return 0;
}

}  // namespace

void addConvert(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<ConvertArguments>();
  CLI::App* command =
      app.add_subcommand("convert", "Converts between formats; an unchanged MERL file stays byte-identical");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  command->add_option("OUT", options->out, outputHelp("File to write; its suffix sets the format"))
      ->group(outputGroup)
      ->required();
  command->add_flag(
      "--whole-circle", options->wholeCircle,
      "Sample phi_d from 0 to 360 degrees, 90 x 90 x 360 instead of 90 x 90 x 180 cells, as non-reciprocal "
      "materials need");
  command->add_option("--snr", options->snr, "Min. rendered SNR of a .bsdf file, dB (40)")
      ->check(CLI::Range(0.0, 100.0));
  command->callback([=, &tool] { tool.run = [=, &tool] { return convert(*options, tool); }; });
}

}  // namespace gonio::tool
