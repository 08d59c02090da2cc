// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/materials.h"
#include "app/goniotool/picture_options.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "app/goniotool/usage.h"
#include "core/brdf/tabulated_brdf.h"
#include "core/rendering/render_picture.h"
#include "core/sampling/directional_albedo.h"

namespace gonio::tool {

namespace {

constexpr int albedoDegrees[] = {0, 30, 60, 80};

Json describe(const materials::Material& material, const TableStatistics& statistics) {
  Json channels = Json::array(), albedo = Json::object();
  for (const ChannelRange& range : statistics.channels) channels.push_back({{"min", range.min}, {"max", range.max}});
  const DirectionalAlbedo albedoAt(*material.brdf);
  for (const int angle : albedoDegrees) albedo[std::to_string(angle)] = rgbJson(albedoAt(radians(angle)));
  return {{"name", material.name},
          {"format", material.source.format},
          {"grid", material.source.grid},
          {"channels", channels},
          {"invalidFraction", statistics.invalidFraction},
          {"dynamicRange", statistics.dynamicRange},
          {"albedo", albedo},
          {"path", material.source.path.string()},
          {"sha256", material.source.sha256},
          {"description", material.source.description},
          {"notes", material.source.notes}};
}

std::string text(const Json& json) {
  std::string grid, result;
  for (const Json& size : json["grid"]) grid += (grid.empty() ? "" : " x ") + std::to_string(size.get<int>());
  result = json["name"].get<std::string>() + ": " + json["format"].get<std::string>() +
           (grid.empty() ? "" : ", " + grid) + "\n";
  if (!json["description"].empty() && json["description"] != "")
    result += "  " + json["description"].get<std::string>() + "\n";
  for (std::size_t c = 0; c < 3; ++c)
    result += std::string("  ") + channelNames[c] + " " + number(json["channels"][c]["min"]) + " to " +
              number(json["channels"][c]["max"]) + " 1/sr\n";
  result += "  dynamic range " + number(json["dynamicRange"]) + ", invalid cells " +
            number(100 * json["invalidFraction"].get<double>()) + " %\n";
  for (const auto& [angle, value] : json["albedo"].items())
    result += "  albedo at " + angle + " degrees " + rgbText({value[0], value[1], value[2]}) + "\n";
  if (json.contains("tableSnr"))
    result += json["tableSnr"].is_null() ? "  rendered SNR of its table: undefined (it is a table itself, or black)\n"
                                         : "  rendered SNR of its table: " + number(json["tableSnr"].get<double>()) +
                                               " dB (used for factors and codes, and for fits if the material is "
                                               "isotropic)\n";
  result += std::string("  evaluated ") +
            (json["shownAs"] == "native" ? "in its native form, without a table\n" : "as a table\n");
  for (const Json& note : json["notes"]) result += "  note: " + note.get<std::string>() + "\n";
  return result;
}

struct InfoArguments {
  std::string material;
  bool tableError = false;
  PictureOptions picture = comparisonPictures();  ///< size and samples of the pictures of the table's error
};

int info(const InfoArguments& options, const Tool& tool) {
  const rendering::RenderOptions pictures = options.picture.renderOptions();  // reports a wrong size before the work
  const materials::Material material = documents::openMaterial(options.material, tool.control("reading"));
  const auto table = material.tabulated(tool.control("tabulating"));
  Json json = describe(material, tableStatistics(*table));
  json["shownAs"] = formOf<TabulatedBrdf>(*material.brdf) ? "table" : "native";
  if (options.tableError) {
    json["tableSnr"] = nullptr;
    if (material.brdf != table) {
      const rendering::RenderedComparison comparison(*material.brdf, pictures, tool.control("rendering the material"));
      json["tableSnr"] =
          decibelsJson(comparison.signalToNoiseRatio(comparison.render(*table, tool.control("rendering the table"))));
    }
  }
  print(tool, json, text(json));
  return 0;
}

}  // namespace

void addInfo(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<InfoArguments>();
  CLI::App* command = app.add_subcommand(
      "info", "Shows format, grid, range of BRDF values, fraction of invalid cells and albedo of a material");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  CLI::Option* tableError =
      command->add_flag("--table-error", options->tableError,
                        "Also measure the rendered SNR of the material's table, which takes a few seconds");
  command->add_option("--size", options->picture.size, "Size of the rendered images, pixels (128)")
      ->type_name("N|WIDTHxHEIGHT")
      ->check(parsedBy(pictureSize))
      ->needs(tableError);
  command->add_option("--samples", options->picture.samples, "Samples per pixel (32)")
      ->check(CLI::Range(1, 1 << 20))
      ->needs(tableError);
  command->callback([options, &tool] { tool.run = [options, &tool] { return info(*options, tool); }; });
}

}  // namespace gonio::tool
