// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/brdf/weighted_sum.h"
#include "core/dictionary/alternatives/patch_dictionary.h"
#include "core/dictionary/code_packing.h"
#include "core/dictionary/decode.h"
#include "core/dictionary/encode.h"
#include "core/formats/code.h"
#include "core/formats/formats.h"
#include "core/materials/basis_file.h"
#include "core/metrics/brdf_metrics.h"
#include "core/study/picture_search.h"
#include "core/study/training_files.h"

namespace gonio::tool {

namespace {

/// Writes a decoded material if there is an output, and adds what was written to the JSON. @return text for the user.
std::string addWritten(Json& json, const std::string& name, std::shared_ptr<const Brdf> decoded, const std::string& out,
                       const Tool& tool) {
  if (out.empty()) return {};
  const WrittenMaterial written = writeMaterial(name, std::move(decoded), out, tool);
  json["written"] = written.json();
  json["out"] = out;
  return written.text;
}

/// Of a code that was made of a material. @param decoded its table.
study::MaterialQuality codeQuality(const materials::Material& material, const Brdf& used, const TabulatedBrdf& decoded,
                                   const Tool& tool) {
  return qualityOf(material, used, &decoded, rendering::smallComparisonPicture().samples, tool);
}

struct ComponentArguments {
  std::string material, basis, out;
  int components = 0;
};

/// `goniotool encode --method components`: represents a material by principal components of a basis file (Nielsen et
/// al. 2015), and writes the material that they represent to `out`, unless it is empty. @throws Error if the basis has
/// fewer components.
int encodeComponents(const ComponentArguments& options, const Tool& tool) {
  if (!options.out.empty()) materials::checkWritableSuffix(options.out);
  const auto file = materials::readBasis(options.basis);
  const dictionary::PrincipalComponents& basis = file->components;
  if (options.components > basis.count())
    throw Error(options.basis + ": found " + std::to_string(basis.count()) + " components, expected at least " +
                std::to_string(options.components) + "; use fewer --coefficients");
  const auto material = documents::openMaterial(options.material, tool.control("reading"));
  const auto table =
      onGrid(material.tabulated(tool.control("tabulating")), basis.mapping.grid, tool.control("sampling"));
  const auto start = std::chrono::steady_clock::now();
  const dictionary::ComponentCode code =
      dictionary::encode(basis, *table, options.components, tool.control("encoding"));
  const double seconds = secondsSince(start);
  const auto decoded = dictionary::decode(basis, code.inHalfPrecision(), tool.control("decoding"));
  const study::MaterialQuality quality = codeQuality(material, *decoded, *decoded, tool);
  const std::size_t bytes = dictionary::ComponentCode::halfBytes(code.components());
  Json json{{"method", "components"}, {"coefficients", code.components()}, {"bytes", bytes}, {"seconds", seconds}};
  addQuality(json, quality);
  const std::string tableText = addTableQuality(json, *material.brdf, *table);
  const std::string writtenText = addWritten(json, material.name, decoded, options.out, tool);
  print(tool, json,
        std::to_string(code.components()) + " components per channel, " + std::to_string(bytes) + " bytes, " +
            qualityText(quality, seconds) + tableText + writtenText);
  return 0;
}

struct PatchArguments {
  std::string material, out;
  std::vector<std::string> train, excluded;
  std::size_t coefficients = 0;
};

/// `goniotool encode --method k-svd`: learns a dictionary of patches by K-SVD (dictionary::PatchDictionary), represents
/// a material by its code, and writes the decoded material to `out`, unless it is empty. @throws Error if a material
/// cannot be read or a training material has another grid than the first one.
int encodePatches(const PatchArguments& options, const Tool& tool) {
  if (!options.out.empty()) materials::checkWritableSuffix(options.out);
  const auto material = documents::openMaterial(options.material, tool.control("reading"));
  auto start = std::chrono::steady_clock::now();
  const std::vector<std::string> files = study::trainingFilesOrLibrary(options.train, options.excluded);
  const auto training = study::trainingMaterials(files, study::trainingGrid(files));
  const auto patches = dictionary::learnPatchDictionary(
      training, {}, tool.control("learning from " + std::to_string(training.names.size()) + " materials"));
  tool.throwIfStopped();
  const double trainingSeconds = secondsSince(start);
  const auto table = onGrid(material.tabulated(tool.control("tabulating")), patches.grid, tool.control("sampling"));
  start = std::chrono::steady_clock::now();
  const dictionary::SparseCode code =
      dictionary::encode(patches, *table, options.coefficients, tool.control("encoding"));
  const double seconds = secondsSince(start);
  const auto decoded = dictionary::decode(patches, code);
  const study::MaterialQuality quality = codeQuality(material, *decoded, *decoded, tool);
  const std::size_t bytes = dictionary::packChannels(code, dictionary::CodePrecision::quantised).size();
  Json json{{"method", "k-svd"},
            {"materials", training.names.size()},
            {"atoms", patches.atoms.count()},
            {"trainingSeconds", trainingSeconds},
            {"coefficients", code.coefficients()},
            {"bytes", bytes},
            {"seconds", seconds}};
  addQuality(json, quality);
  const std::string tableText = addTableQuality(json, *material.brdf, *table);
  const std::string writtenText = addWritten(json, material.name, decoded, options.out, tool);
  print(tool, json,
        std::to_string(patches.atoms.count()) + " atoms from " + std::to_string(training.names.size()) +
            " materials, learned in " + number(trainingSeconds) + " s\n" + std::to_string(code.coefficients()) +
            " coefficients per channel, " + std::to_string(bytes) + " bytes, " + qualityText(quality, seconds) +
            tableText + writtenText);
  return 0;
}

using namespace dictionary;

constexpr const char *componentsMethod = "components", *patchesMethod = "k-svd";

struct EncodeArguments {
  std::string material, dictionary, basis, out, transform, method{codingMethodNames[0]};
  std::vector<std::string> train, excluded;
  EncodeOptions encoding;
  std::optional<std::size_t> coefficients;
  double relativeError = 0, renderedSnr = 0;
  std::size_t bytes = 0;
  bool single = false, asPublished = false;
};

std::string nameOf(DataTransform transform) { return std::string(dataTransformNames[std::size_t(transform)]); }

/// The published method does not quantise, unless a number of bytes asks for it.
bool isQuantised(const EncodeArguments& options) {
  return !options.single && (!options.asPublished || options.bytes > 0);
}

EncodeOptions encodeOptions(const EncodeArguments& options) {
  constexpr std::size_t maxWithinBytes = 4096;
  EncodeOptions encoding = options.encoding;
  if (options.asPublished) {
    encoding = publishedEncodeOptions();
    encoding.gamma = options.encoding.gamma;
  }
  if (options.bytes > 0) encoding.coefficients = maxWithinBytes;
  if (options.coefficients) encoding.coefficients = *options.coefficients;
  encoding.method = CodingMethod(std::ranges::find(codingMethodNames, options.method) - codingMethodNames.begin());
  if (options.relativeError > 0) encoding.relativeError = options.relativeError;
  encoding.quantised = isQuantised(options);
  if (options.bytes > 0) encoding.bytes = options.bytes - std::min(options.bytes, formats::codeHeaderBytes);
  std::erase_if(encoding.transforms,
                [&](DataTransform t) { return !options.transform.empty() && options.transform != nameOf(t); });
  return encoding;
}

int encode(const EncodeArguments& options, const Tool& tool) {
  if (options.asPublished && options.method != codingMethodNames[0])
    throw UsageError("encode: --as-published cannot be used with --method");
  if (options.bytes > 0 && options.single)
    throw UsageError("encode: --bytes counts quantised values; leave out --single");
  const auto dictionary = !options.dictionary.empty() ? materials::readDictionary(options.dictionary)
                          : options.asPublished       ? materials::publishedEnsemble()
                                                      : materials::bundledEnsemble();
  const auto material = documents::openMaterial(options.material, tool.control("reading"));
  auto table =
      onCodeGrid(material.tabulated(tool.control("tabulating")), dictionary->ensemble, tool.control("sampling"));
  if (options.asPublished) table = meanOfOrders(table);
  const Encoder encoder(dictionary->ensemble);
  EncodeResult encoded;
  if (options.renderedSnr > 0)
    encoded = study::encodeForPictures(encoder, *material.brdf, *table, options.renderedSnr, encodeOptions(options),
                                       tool.control("encoding"))
                  .encoded;
  else
    encoded = encoder.encode(*table, encodeOptions(options), tool.control("encoding"));
  const auto precision = isQuantised(options) ? CodePrecision::quantised : CodePrecision::single;
  const std::vector<std::byte> bytes = formats::encodeCode(encoded.code, dictionary->id, precision);
  // Of what the file holds: with the values as they are rounded.
  const SparseCode stored = formats::readCode(io::MemorySource(bytes)).code;
  const auto decoded = decode(dictionary->ensemble, stored);
  const study::MaterialQuality quality =
      codeQuality(material, *makeCodeBrdf(dictionary->ensemble, stored), *decoded, tool);
  if (!options.out.empty()) formats::writeCode(encoded.code, dictionary->id, options.out, precision);
  Json candidates = Json::array(), dictionaries = Json::array();
  std::string text;
  for (const EncodedCandidate& candidate : encoded.candidates) {
    candidates.push_back({{"transform", nameOf(candidate.code.transform)},
                          {"gammaError", candidate.gammaError},
                          {"squaredError", candidate.squaredError}});
    text += nameOf(candidate.code.transform) + ": gamma error " + number(candidate.gammaError) + "\n";
  }
  std::string numbers;
  for (const ChannelCode& channel : encoded.code.channels) {
    dictionaries.push_back(channel.dictionary);
    numbers += (numbers.empty() ? "" : ", ") + std::to_string(channel.dictionary);
  }
  Json json{{"method", options.method}, {"scaled", encoded.code.scaled}, {"coefficients", encoded.code.coefficients()},
            {"bytes", bytes.size()},    {"dictionary", dictionaries},    {"transform", nameOf(encoded.code.transform)},
            {"candidates", candidates}, {"seconds", encoded.seconds}};
  addQuality(json, quality);
  const std::vector<std::string> warnings = lostPeaks(*table, *decoded);
  if (!warnings.empty()) json["warnings"] = warnings;
  for (const std::string& warning : warnings) text += "warning: " + warning + "\n";
  const std::string tableText = addTableQuality(json, *material.brdf, *table);
  if (!options.out.empty()) json["out"] = options.out;
  print(tool, json,
        std::to_string(encoded.code.coefficients()) + " coefficients per channel, " + std::to_string(bytes.size()) +
            " bytes, transform " + nameOf(encoded.code.transform) +
            (encoded.code.scaled ? "" : " without cell scaling") + ", dictionaries " + numbers + "\n" + text +
            qualityText(quality, encoded.seconds) + tableText);
  return 0;
}

int encodeByMethod(const EncodeArguments& options, const CLI::App& command, const Tool& tool) {
  if ((options.method == componentsMethod) != !options.basis.empty())
    throw UsageError("encode: --method components and --basis must be given together");
  const bool patches = options.method == patchesMethod;
  if (!patches && command.count("--train") + command.count("--exclude") > 0)
    throw UsageError("encode: --train and --exclude are for --method k-svd only");
  if (options.method != componentsMethod && !patches) return encode(options, tool);
  for (const char* of :
       {"--dictionary", "--error", "--bytes", "--rendered-snr", "--transform", "--gamma", "--single", "--as-published"})
    if (command.count(of) > 0)
      throw UsageError(std::string("encode: ") + of + " is not for --method " + options.method);
  const std::size_t coefficients = options.coefficients.value_or(EncodeOptions().coefficients);
  if (patches)
    return encodePatches({options.material, options.out, options.train, options.excluded, coefficients}, tool);
  return encodeComponents({options.material, options.basis, options.out, int(coefficients)}, tool);
}

int decode(const EncodeArguments& options, const Tool& tool) {
  materials::checkWritableSuffix(options.out);
  const formats::CodeFile file = formats::readCode(options.material);
  std::shared_ptr<const materials::NamedEnsemble> dictionary;
  if (options.dictionary.empty()) {
    dictionary = formats::bundledDictionaryOf(file);
  } else {
    dictionary = materials::readDictionary(options.dictionary);
    formats::checkDictionary(file, *dictionary);
  }
  const WrittenMaterial written = writeMaterial(std::filesystem::path(options.material).stem().string(),
                                                dictionary::decode(dictionary->ensemble, file.code), options.out, tool);
  Json json{{"coefficients", file.code.coefficients()}, {"transform", nameOf(file.code.transform)}};
  json.update(written.json());
  const study::UseCost cost =
      study::measureUse(*dictionary::makeCodeBrdf(dictionary->ensemble, file.code), tool.control("measuring"));
  json["code"] = Json::object();
  addCost(json["code"], cost);
  json["out"] = options.out;
  print(tool, json,
        "wrote " + options.out + ", decoded from " + std::to_string(file.code.coefficients()) +
            " coefficients per channel; the code itself: " + costText(cost) + "\n" + written.text);
  return 0;
}

}  // namespace

void addEncode(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<EncodeArguments>();
  CLI::App* command = app.add_subcommand("encode", "Encodes a material as a sparse code over a dictionary");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  command->add_option("--dictionary", options->dictionary, "Dictionary file (bundled dictionary)")->type_name("FILE");
  command
      ->add_option("--coefficients", options->coefficients,
                   "Max. coefficients per channel (1024; 4096 with --bytes, 262 with --as-published)")
      ->check(CLI::Range(0, 65535));
  command
      ->add_option(
          "--error", options->relativeError,
          "Use the smallest number of coefficients with a squared error of at most this fraction of the signal's "
          "energy")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--bytes", options->bytes, "Max. size of the file, bytes")->check(CLI::PositiveNumber);
  command
      ->add_option("--rendered-snr", options->renderedSnr,
                   "Use the smallest number of coefficients that reaches this rendered SNR, dB")
      ->check(CLI::Range(1.0, 200.0));
  command
      ->add_option(
          "--transform", options->transform,
          "Transform: log-plus or cosine-log (the one with the smaller gamma error; with --rendered-snr, the one that "
          "needs fewer coefficients)")
      ->check(CLI::IsMember({nameOf(DataTransform::logPlus), nameOf(DataTransform::cosineLog)}));
  command->add_option("--gamma", options->encoding.gamma, "Gamma of the gamma error that selects the transform (2)")
      ->check(CLI::Range(1.0, 3.0));
  command->add_flag("--single", options->single,
                    "Store values in single precision instead of quantised; seven times the bytes");
  std::vector<std::string> methods(codingMethodNames.begin(), codingMethodNames.end());
  methods.insert(methods.end(), {componentsMethod, patchesMethod});
  command
      ->add_option(
          "--method", options->method,
          "iterative-hard-thresholding: the largest coefficients; basis-pursuit: smallest L1 norm; components: "
          "principal components of --basis; k-svd: small blocks of the table (patches), each as atoms of a dictionary "
          "learned from --train (iterative-hard-thresholding)")
      ->check(CLI::IsMember(methods));
  command->add_option("--basis", options->basis, "Basis file of --method components, see goniotool plan")
      ->type_name("FILE");
  command
      ->add_option("--train", options->train, trainingSetHelp("Training set of --method k-svd") + " (bundled library)")
      ->type_name("FILE|FOLDER");
  command->add_option("--exclude", options->excluded, "Names of materials to exclude from the training set")
      ->type_name("NAME");
  command->add_flag("--as-published", options->asPublished,
                    "Published method: the dictionaries that were learned without cell scaling, one for each channel, "
                    "invalid cells filled once before the projection, values neither limited nor quantised, unweighted "
                    "gamma error");
  command
      ->add_option("--out", options->out,
                   "File to write: the code (" + suffixOf(formats::codeFormat) +
                       "), or with --method components or k-svd " + outputHelp("the decoded material"))
      ->group(outputGroup);
  command->callback([options, command, &tool] {
    tool.run = [options, command, &tool] { return encodeByMethod(*options, *command, tool); };
  });
}

void addDecode(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<EncodeArguments>();
  CLI::App* command = app.add_subcommand("decode", "Decodes a sparse code to a material");
  command->add_option("CODE", options->material, "A " + suffixOf(formats::codeFormat) + " file")->required();
  command
      ->add_option("--dictionary", options->dictionary,
                   "Dictionary with which the code was encoded (bundled dictionary)")
      ->type_name("FILE");
  command->add_option("--out", options->out, outputHelp("Material file to write"))->group(outputGroup)->required();
  command->callback([options, &tool] { tool.run = [options, &tool] { return decode(*options, tool); }; });
}

}  // namespace gonio::tool
