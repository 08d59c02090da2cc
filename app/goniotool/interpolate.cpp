// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <chrono>
#include <filesystem>

#include "app/goniotool/materials.h"
#include "app/goniotool/outputs.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/brdf/weighted_sum.h"
#include "core/dictionary/decode.h"
#include "core/formats/code.h"
#include "core/formats/formats.h"
#include "core/formats/pdv.h"
#include "core/interpolation/native_form_blend.h"
#include "core/models/registry.h"
#include "core/support/error.h"

namespace gonio::tool {

namespace {

using namespace editing;
using materials::hasSuffixOf;

constexpr int maxMaterials = 16, maxSteps = 1000;

struct InterpolateArguments {
  std::vector<std::string> materials;
  std::string space{interpolation::interpolationSpaceNames[0]}, model = "ggx", dictionary, out;
  std::vector<double> weights;
  double at = 0.5;
  int steps = 0, terms = 10;
  std::size_t coefficients = 1024;
  bool atGiven = false, discardsDetail = false;

  /// Files of curves and codes hold none.
  bool preservesDetail() const {
    return !discardsDetail && !hasSuffixOf(formats::pdvFormat, out) && !hasSuffixOf(formats::codeFormat, out);
  }

  interpolation::InterpolationSpace spaceChosen() const {
    const auto& names = interpolation::interpolationSpaceNames;
    return interpolation::InterpolationSpace(std::find(names.begin(), names.end(), space) - names.begin());
  }
};

/// The weights of every blend that is wanted.
std::vector<std::vector<double>> weightsOf(const InterpolateArguments& options) {
  const auto between = [](double t) { return std::vector{1 - t, t}; };
  std::vector<std::vector<double>> all;
  if (!options.weights.empty()) return {options.weights};
  if (options.steps == 0) return {between(options.at)};
  all.reserve(std::size_t(options.steps));
  for (int step = 0; step < options.steps; ++step) all.push_back(between(double(step) / (options.steps - 1)));
  return all;
}

void checkOptions(const InterpolateArguments& options) {
  const bool weighted = !options.weights.empty();
  if (weighted + (options.steps > 0) + options.atGiven > 1)
    throw UsageError("interpolate: --at, --weights and --steps cannot be combined");
  if (!weighted && options.materials.size() != 2)
    throw UsageError("interpolate: found " + std::to_string(options.materials.size()) +
                     " materials, expected --weights with one number each; --at and --steps are for two");
  try {
    checkWeights(weightsOf(options).front(), options.materials.size());
  } catch (const Error& error) {
    throw UsageError(std::string("interpolate: ") + error.what());
  }
  if (hasSuffixOf(formats::pdvFormat, options.out)) {
    if (options.spaceChosen() != interpolation::InterpolationSpace::factors)
      throw UsageError("interpolate: " + options.out + " is a factor file, which needs --space factors");
  } else if (hasSuffixOf(formats::codeFormat, options.out)) {
    if (options.spaceChosen() != interpolation::InterpolationSpace::dictionary)
      throw UsageError("interpolate: " + options.out + " is a code file, which needs --space dictionary");
  } else if (options.spaceChosen() == interpolation::InterpolationSpace::factors) {
    materials::checkWritableSuffix(options.out, formats::pdvFormat.suffix());
  } else if (options.spaceChosen() == interpolation::InterpolationSpace::dictionary) {
    materials::checkWritableSuffix(options.out, formats::codeFormat.suffix());
  } else {
    materials::checkWritableSuffix(options.out);
  }
}

/// The code of a file over a given dictionary.
interpolation::InterpolationMaterial openCode(const std::string& path, const materials::NamedEnsemble& dictionary) {
  const formats::CodeFile file = formats::readCode(path);
  withFileInErrors(path, [&] { formats::checkDictionary(file, dictionary); });
  return {.table = dictionary::decode(dictionary.ensemble, file.code),
          .code = std::make_shared<const dictionary::SparseCode>(file.code)};
}

/// @param isGiven whether `dictionary` is that of --dictionary. Otherwise it is set to that of the first code.
interpolation::InterpolationMaterial openEnd(const std::string& material, bool isGiven,
                                             std::shared_ptr<const materials::NamedEnsemble>& dictionary,
                                             const Tool& tool) {
  if (isGiven && hasSuffixOf(formats::codeFormat, material)) return openCode(material, *dictionary);
  const materials::Material opened = documents::openMaterial(material, tool.control("reading " + material));
  interpolation::InterpolationMaterial end{.table = opened.tabulated(tool.control("tabulating " + opened.name))};
  if (formats::isPdv(material))
    end.factors = std::make_shared<const factorization::PdvFactors>(formats::readPdv(material));
  if (!isGiven && opened.code) {
    end.code = opened.code;
    end.ensemble = {opened.dictionary, &opened.dictionary->ensemble};
    if (!dictionary) dictionary = opened.dictionary;
  }
  if (!opened.table) end.base = opened.brdf;
  return end;
}

/// OUT of one step of a series: out-00.binary, out-01.binary, ...
std::string fileOf(const InterpolateArguments& options, std::size_t step) {
  if (options.steps == 0) return options.out;
  const std::filesystem::path out(options.out);
  const std::size_t digits = std::to_string(options.steps - 1).size();
  std::string number = std::to_string(step);
  number.insert(0, digits - number.size(), '0');
  return (out.parent_path() / (out.stem().string() + "-" + number + out.extension().string())).string();
}

void checkSeries(const InterpolateArguments& options) {
  std::vector<std::filesystem::path> read;
  for (const std::string& material : options.materials)
    std::ranges::copy(documents::filesOf(material), std::back_inserter(read));
  for (int step = 0; step < options.steps; ++step) checkOutput(fileOf(options, std::size_t(step)), read);
}

/// "0.5 A + 0.5 B"
std::string materialsText(std::span<const double> weights, std::span<const std::string> names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) text += (i > 0 ? " + " : "") + number(weights[i]) + " " + names[i];
  return text;
}

/// Writes the blend as a material and returns the report. A blend of tables is one, cell by cell.
Json writeBlend(const interpolation::Interpolation& interpolation, interpolation::InterpolationSpace space,
                std::span<const double> weights, std::span<const std::string> names, const std::string& out,
                const Tool& tool) {
  materials::EditedMaterial material =
      materials::unedited(std::filesystem::path(out).stem().string(), interpolation.brdf(weights));
  material.base.name = materialsText(weights, names) + ", space " +
                       std::string(interpolation::interpolationSpaceNames[std::size_t(space)]);
  material.base.source = {.format = "blend", .sha256 = "none"};
  const bool tables = std::ranges::all_of(interpolation.ends(), [](const auto& end) { return !end.base; });
  if (tables) material.shown.table = interpolation.table(weights, tool.control("blending"));
  const auto own = interpolation::nativeFormBlend(interpolation, weights, tool.control("blending"));
  if (own) material.base.brdf = own->brdf;
  Json json = writeMaterial(material, out, tool).json();
  if (own && json["losses"].empty()) json["nodes"] = own->nodesOf;
  return json;
}

/// Writes one blend; returns what is reported about it.
Json blend(const interpolation::Interpolation& interpolation, interpolation::InterpolationSpace space,
           const models::ModelSpec& spec, std::uint64_t dictionary, std::span<const double> weights,
           std::span<const std::string> names, const std::string& out, const Tool& tool) {
  const auto factors = interpolation.factors(weights);
  const auto code = interpolation.code(weights);
  Json json{{"weights", std::vector<double>(weights.begin(), weights.end())}};
  if (hasSuffixOf(formats::pdvFormat, out))
    formats::writePdv(factors.value(), out);
  else if (hasSuffixOf(formats::codeFormat, out))
    formats::writeCode(code.value(), dictionary, out);
  else
    json.update(writeBlend(interpolation, space, weights, names, out, tool));
  addCost(json, study::measureUse(*interpolation.brdf(weights), tool.control("measuring")));
  if (const auto parameters = interpolation.parameters(weights)) json["parameters"] = parametersJson(spec, *parameters);
  if (factors) json["terms"] = factors->terms();
  if (code) {
    json["coefficients"] = code->coefficients();
    json["transform"] = dataTransformNames[std::size_t(code->transform)];
  }
  json["out"] = out;
  return json;
}

/// The accuracy of a file of a material; empty for curves and codes.
std::string accuracyText(const Json& step) {
  if (!step.contains("snr")) return {};
  std::string text =
      step["snr"].is_number() ? "  rendered SNR " + number(step["snr"]) + " dB\n" : "  images are identical\n";
  for (const Json& loss : step["losses"]) text += "  note: " + loss.get<std::string>() + "\n";
  return text;
}

int interpolate(const InterpolateArguments& options, const Tool& tool) {
  checkOptions(options);
  if (!tool.force) checkSeries(options);
  const bool isGiven = !options.dictionary.empty();
  std::shared_ptr<const materials::NamedEnsemble> dictionary;
  if (isGiven) dictionary = materials::readDictionary(options.dictionary);
  std::vector<interpolation::InterpolationMaterial> ends;
  for (const std::string& material : options.materials) ends.push_back(openEnd(material, isGiven, dictionary, tool));
  if (!dictionary && options.spaceChosen() == interpolation::InterpolationSpace::dictionary)
    dictionary = materials::bundledEnsemble();
  interpolation::InterpolationOptions preparation;
  if (dictionary) preparation.ensemble = {dictionary, &dictionary->ensemble};
  preparation.encode.coefficients = preparation.codeCoefficients = options.coefficients;
  preparation.model = &models::findModel(options.model);
  preparation.pdv.terms = options.terms;
  preparation.preserveDetail = options.preservesDetail();
  const auto start = std::chrono::steady_clock::now();
  const auto interpolation =
      interpolation::prepareInterpolation(options.spaceChosen(), ends, preparation, tool.control("preparing"));
  const double seconds = secondsSince(start);
  Json steps = Json::array();
  std::string text;
  const auto all = weightsOf(options);
  for (std::size_t step = 0; step < all.size(); ++step) {
    steps.push_back(blend(*interpolation, options.spaceChosen(), preparation.model->spec(),
                          dictionary ? dictionary->id : 0, all[step], options.materials, fileOf(options, step), tool));
    text += fileOf(options, step) + ": " + options.space + ", weights";
    for (const double weight : all[step]) text.append(" ").append(number(weight));
    text += "\n" + accuracyText(steps.back());
    if (const auto parameters = interpolation->parameters(all[step]))
      text += parametersText(preparation.model->spec(), *parameters);
  }
  Json json{{"space", options.space}, {"materials", options.materials}, {"seconds", seconds}};
  if (interpolation::losesDetail(options.spaceChosen())) json["keepDetail"] = interpolation->preservesDetail();
  if (options.steps > 0)
    json["steps"] = steps;
  else
    json.update(steps[0]);
  print(tool, json, text);
  return 0;
}

}  // namespace

void addInterpolate(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<InterpolateArguments>();
  CLI::App* command = app.add_subcommand("interpolate", "Interpolates between two or more materials");
  command
      ->add_option(
          "MATERIAL", options->materials,
          "Two to " + std::to_string(maxMaterials) + " materials: files, .gonio documents, or library:SOURCE/NAME")
      ->required()
      ->expected(2, maxMaterials);
  auto* at = command->add_option("--at,--t", options->at,
                                 "Position between two materials: 0 is the first, 1 the second (0.5)");
  at->check(CLI::Range(0.0, 1.0));
  command->add_option("--weights", options->weights, "Weights, one per material, separated by commas; their sum is 1")
      ->delimiter(',')
      ->expected(1, maxMaterials);
  command
      ->add_option("--steps", options->steps,
                   "Number of files in a series from the first to the second: OUT-0, OUT-1, ...")
      ->check(CLI::Range(2, maxSteps));
  command->add_option("--space", options->space, "Interpolation space (linear)")
      ->check(CLI::IsMember(std::vector<std::string>(interpolation::interpolationSpaceNames.begin(),
                                                     interpolation::interpolationSpaceNames.end())));
  command->add_option("--model", options->model, "Model for --space parameters or --space differential (ggx)")
      ->check(CLI::IsMember(modelIds()));
  command->add_option("--terms", options->terms, "Number of terms for --space factors (10)")
      ->check(CLI::Range(1, factorization::maxPdvTerms));
  command->add_flag("--discard-detail", options->discardsDetail,
                    "For --space parameters, factors and dictionary: blend the representations alone, without the "
                    "measured detail that they miss");
  command
      ->add_option("--dictionary", options->dictionary, "Dictionary file for --space dictionary (bundled dictionary)")
      ->type_name("FILE");
  command
      ->add_option("--coefficients", options->coefficients,
                   "Max. coefficients per channel for --space dictionary (1024)")
      ->check(CLI::Range(1, 65535));
  command
      ->add_option("--out", options->out,
                   outputHelp("Material file to write") + "; for --space factors also the curves (" +
                       suffixOf(formats::pdvFormat) + "), for --space dictionary also the code (" +
                       suffixOf(formats::codeFormat) + ")")
      ->group(outputGroup)
      ->required();
  command->callback([options, at, &tool] {
    options->atGiven = at->count() > 0;
    tool.run = [options, &tool] { return interpolate(*options, tool); };
  });
}

}  // namespace gonio::tool
