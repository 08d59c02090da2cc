// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/baselines/baselines.h"
#include "core/factorization/deviation_grid.h"
#include "core/factorization/pdv_operations.h"
#include "core/formats/formats.h"
#include "core/formats/pdv.h"
#include "core/rendering/render_picture.h"

namespace gonio::tool {

namespace {

struct FactorBaselineArguments {
  std::string material, method, out;
  std::size_t bytes = 0;  ///< budget
  int samples = 0;        ///< per pixel, in the pictures for the rendered SNR
};

/// The ids of all baselines, for --method.
std::vector<std::string> baselineIds() {
  std::vector<std::string> ids;
  for (const baselines::Baseline& baseline : baselines::allBaselines()) ids.emplace_back(baseline.id);
  return ids;
}

/// goniotool factor --method METHOD with a baseline of the literature (core/baselines/baselines.h).
int factorByBaseline(const FactorBaselineArguments& options, const Tool& tool) {
  if (materials::hasSuffixOf(formats::pdvFormat, options.out))
    throw UsageError("factor: " + options.method + " has no factor file: --out must be a table (.binary)");
  if (!options.out.empty()) materials::checkWritableSuffix(options.out);
  const baselines::Baseline& baseline = baselines::findBaseline(options.method);
  const materials::Material material = documents::openMaterial(options.material, tool.control("reading"));
  const auto table = meanOfOrders(material.tabulated(tool.control("tabulating")));
  const auto start = std::chrono::steady_clock::now();
  const std::array<std::size_t, 1> budgets{options.bytes};
  const baselines::ComparedModel model =
      baseline.build(*table, budgets, tool.control("factorising " + material.name)).front();
  const double seconds = secondsSince(start);
  const study::MaterialQuality quality = qualityOf(material, *model.brdf, nullptr, options.samples, tool);
  WrittenMaterial written;
  if (!options.out.empty()) written = writeMaterial(material.name, model.brdf, options.out, tool, table->grid());
  Json json{{"method", options.method},
            {"reference", baseline.reference},
            {"byteBudget", options.bytes},
            {"bytes", model.bytes},
            {"seconds", seconds}};
  addQuality(json, quality);
  const std::string tableText = addTableQuality(json, *material.brdf, *table);
  if (!options.out.empty()) {
    json["written"] = written.json();
    json["out"] = options.out;
  }
  print(tool, json,
        options.method + " (" + std::string(baseline.name) + "), " + std::to_string(model.bytes) + " bytes, " +
            qualityText(quality, seconds) + tableText + written.text);
  return 0;
}

using namespace factorization;

constexpr const char* pdvMethod = "pdv";
constexpr std::size_t bytesOfTenTerms = 44'680;  ///< of a .pdv file in the form with three curves

constexpr std::array<const char*, 2> formNames{"2d", "3d"};  // in the order of PdvForm
constexpr const char *nodesOfMaterial = "material", *nodesOfLibrary = "library", *printedNodes = "printed";

struct FactorArguments {
  std::string material, form = formNames[1], transform{dataTransformNames[0]}, out, decode, swapF1, swapF2;
  std::string method = pdvMethod, weights{pdvWeightNames[1]}, deviations = nodesOfMaterial;
  std::size_t bytes = bytesOfTenTerms;
  int terms = 10, samples = rendering::smallComparisonPicture().samples;
  bool keepFurther = false, formGiven = false, transformGiven = false, asPublished = false, joint = false,
       compact = false;

  PdvOptions pdvOptions() const {
    PdvOptions result = separateOptions();
    result.joint = joint;
    return compact ? compactPdvOptions(result) : result;
  }
  /// Of terms that are found one after the other.
  PdvOptions separateOptions() const {
    const auto pdvForm = PdvForm(std::ranges::find(formNames, form) - formNames.begin());
    const int count = swaps() && !keepFurther ? 1 : terms;
    if (asPublished) return publishedPdvOptions(pdvForm, count);
    return {.form = pdvForm,
            .transform = dataTransformNamed(transform).value(),
            .terms = count,
            .weights = PdvWeights(std::ranges::find(pdvWeightNames, weights) - pdvWeightNames.begin()),
            .deviationNodes = deviations == nodesOfLibrary ? libraryDeviationNodes()
                              : deviations == printedNodes ? libraryDeviationNodes(DataTransform::none)
                                                           : std::vector<double>()};
  }
  /// Whether options other than form, transform and terms change the factorisation.
  bool choosesNodesOrWeights() const {
    return asPublished || joint || compact || weights != pdvWeightNames[1] || deviations != nodesOfMaterial;
  }
  bool swaps() const { return !swapF1.empty() || !swapF2.empty(); }
};

bool isFactorsFile(const std::string& path) { return materials::hasSuffixOf(formats::pdvFormat, path); }

/// The factors of FILE: its own, where it is a file of factors.
PdvFactorization factorsOf(const FactorArguments& options, const materials::Material& material,
                           const TabulatedBrdf& table, const Tool& tool) {
  if (!formats::isPdv(options.material))
    return factorizePdv(table, options.pdvOptions(), tool.control("factorising " + material.name));
  if (options.formGiven || options.transformGiven || options.choosesNodesOrWeights())
    throw UsageError("factor: " + options.material +
                     " contains factors already: leave out --form, --transform, --weights, --deviations, "
                     "--joint, --compact and --as-published");
  return {.factors = formats::readPdv(options.material).truncated(options.terms),
          .residuals = {},
          .cells = 0,
          .seconds = 0};
}

/// The factors of another material for a swap: one term over the same nodes, where they are not given.
PdvFactors otherFactors(const std::string& other, const FactorArguments& options, const PdvFactors& target,
                        const Tool& tool) {
  if (formats::isPdv(other)) return formats::readPdv(other);
  const materials::Material material = documents::openMaterial(other, tool.control("reading " + other));
  auto table = material.tabulated(tool.control("tabulating"));
  if (options.asPublished) table = meanOfOrders(table);
  return factorizePdv(*table,
                      {.form = target.form,
                       .transform = target.transform,
                       .terms = 1,
                       .weights = options.pdvOptions().weights,
                       .deviationNodes = target.deviationNodes,
                       .thetaNodes = int(target.thetaNodes.size()),
                       .phiNodes = std::max(2, int(target.phiNodes.size()))},
                      tool.control("factorising " + material.name))
      .factors;
}

PdvFactors swapped(const FactorArguments& options, PdvFactors factors, const Tool& tool) {
  const FurtherTerms further = options.keepFurther ? FurtherTerms::preserve : FurtherTerms::drop;
  if (!options.swapF1.empty())
    factors = withF1Of(factors, otherFactors(options.swapF1, options, factors, tool), further);
  if (!options.swapF2.empty())
    factors = withF2Of(factors, otherFactors(options.swapF2, options, factors, tool), further);
  return factors;
}

void checkOptions(const FactorArguments& options) {
  if (options.asPublished && (options.transformGiven || options.compact || options.weights != pdvWeightNames[1] ||
                              options.deviations != nodesOfMaterial))
    throw UsageError(
        "factor: --as-published sets --transform, --weights and all nodes; leave out --transform, "
        "--weights, --deviations and --compact");
  if (options.joint && options.swaps())
    throw UsageError(
        "factor: --joint cannot be used with --swap-f1 or --swap-f2: --joint refines all terms together, but --swap-f1 "
        "and --swap-f2 replace curves of the first term");
  if (options.keepFurther && !options.swaps()) throw UsageError("factor: --keep-terms is for --swap-f1 and --swap-f2");
  if (!options.out.empty() && !isFactorsFile(options.out)) materials::checkWritableSuffix(options.out);
  if (!options.decode.empty()) materials::checkWritableSuffix(options.decode);
}

int factor(const FactorArguments& options, const Tool& tool) {
  checkOptions(options);
  const materials::Material material = documents::openMaterial(options.material, tool.control("reading"));
  auto table = material.tabulated(tool.control("tabulating"));
  if (options.asPublished) table = meanOfOrders(table);
  PdvFactorization result = factorsOf(options, material, *table, tool);
  result.factors = swapped(options, std::move(result.factors), tool);
  const auto brdf = makePdvBrdf(result.factors);
  const study::MaterialQuality quality = qualityOf(material, *brdf, nullptr, options.samples, tool);
  WrittenMaterial written;
  // Before the factors: an interrupted command leaves no file.
  for (const std::string& path : {options.decode, options.out})
    if (!path.empty() && !isFactorsFile(path)) written = writeMaterial(material.name, brdf, path, tool, table->grid());
  if (isFactorsFile(options.out)) formats::writePdv(result.factors, options.out);

  const PdvFactors& f = result.factors;
  if (!result.residuals.empty()) result.residuals.erase(result.residuals.begin());
  result.residuals.resize(std::min(result.residuals.size(), std::size_t(f.terms())));
  Json json{{"method", pdvMethod},
            {"terms", f.terms()},
            {"form", formNames[std::size_t(f.form)]},
            {"transform", dataTransformNames[std::size_t(f.transform)]},
            {"grid", {f.thetaNodes.size(), f.deviationNodes.size(), f.phiNodes.size()}},
            {"bytes", formats::pdvFileBytes(f)},
            {"residuals", result.residuals},
            {"seconds", result.seconds}};
  addQuality(json, quality);
  std::string tableText;
  if (!formats::isPdv(options.material)) {
    tableText = addTableQuality(json, *material.brdf, *table);
    json["weights"] = options.asPublished ? pdvWeightNames[0] : std::string_view(options.weights);
    json["joint"] = options.joint;
    json["deviations"] = options.asPublished ? nodesOfLibrary : options.deviations.c_str();
  }
  if (written.bytes > 0) json["written"] = written.json();
  if (!options.out.empty()) json["out"] = options.out;
  if (!options.decode.empty()) json["decoded"] = options.decode;
  print(tool, json,
        std::to_string(f.terms()) + (f.terms() == 1 ? " term, " : " terms, ") +
            std::to_string(formats::pdvFileBytes(f)) + " bytes, relative residual " +
            (result.residuals.empty() ? "unknown" : number(result.residuals.back())) + ", " +
            qualityText(quality, result.seconds) + tableText + written.text);
  return 0;
}

/// The options of PDV alone.
std::vector<CLI::Option*> addPdvOptions(CLI::App& command, const std::shared_ptr<FactorArguments>& options) {
  auto* terms = command.add_option("--terms", options->terms, "Number of terms; each is a product of curves (10)");
  terms->check(CLI::Range(1, maxPdvTerms));
  auto* form = command.add_option_function<std::string>(
      "--form",
      [options](const std::string& name) {
        options->form = name;
        options->formGiven = true;
      },
      "2d: two curves per term; 3d: three curves per term (3d)");
  form->check(CLI::IsMember(std::vector<std::string>(formNames.begin(), formNames.end())));
  auto* transform = command.add_option_function<std::string>(
      "--transform",
      [options](const std::string& name) {
        options->transform = name;
        options->transformGiven = true;
      },
      "Transform of the BRDF values (log-plus)");
  transform->check(CLI::IsMember(std::vector<std::string>(dataTransformNames.begin(), dataTransformNames.end())));
  auto* weights = command.add_option("--weights", options->weights,
                                     "Weights of the cells: projected-solid-angle, or equal, as in the papers "
                                     "(projected-solid-angle)");
  weights->check(CLI::IsMember(std::vector<std::string>(pdvWeightNames.begin(), pdvWeightNames.end())));
  auto* deviations = command.add_option(
      "--deviations", options->deviations,
      "Nodes of |Dp|: material, adapted to the material; library, common to the bundled library; printed, the "
      "same with the energy rho instead of ln(1 + rho), as eq. 4.24 is printed (material)");
  deviations->check(CLI::IsMember({nodesOfMaterial, nodesOfLibrary, printedNodes}));
  return {
      terms,
      form,
      transform,
      weights,
      deviations,
      command.add_flag("--as-published", options->asPublished,
                       "Published method: --transform log-plus --weights equal --deviations library"),
      command.add_flag("--joint", options->joint, "Refine all terms jointly after finding them one after the other"),
      command.add_flag("--compact", options->compact,
                       "Fewer nodes of theta_R and |phi|, 60 and 30 instead of 90 and 180: half the bytes per term"),
      command
          .add_option("--decode", options->decode,
                      outputHelp("Also write the material that the factors represent to this file"))
          ->group(outputGroup),
      command
          .add_option("--swap-f1", options->swapF1,
                      "Replace F1 of the first term (specular strength vs. angle) with that of this material")
          ->type_name("MATERIAL"),
      command
          .add_option("--swap-f2", options->swapF2,
                      "Replace F2 of the first term (highlight profile) with that of this material")
          ->type_name("MATERIAL"),
      command.add_flag("--keep-terms", options->keepFurther,
                       "Retain the other terms when F1 or F2 is replaced (otherwise they are dropped)")};
}

}  // namespace

void addFactor(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<FactorArguments>();
  CLI::App* command = app.add_subcommand(
      "factor", "Factorises a material into curves in PDV coordinates (projected deviation vector), or by a baseline");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  std::vector<std::string> methods = baselineIds();
  methods.insert(methods.begin(), pdvMethod);
  command->add_option("--method", options->method, "Factorisation: pdv, or a baseline from the literature (pdv)")
      ->check(CLI::IsMember(methods));
  auto* bytes = command->add_option("--bytes", options->bytes, "Max. size of the factors of a baseline, bytes (44680)");
  bytes->check(CLI::Range(std::size_t(1), std::size_t(100'000'000)));
  command->add_option("--samples", options->samples, "Samples per pixel of the images for the rendered SNR (32)")
      ->check(CLI::Range(1, 1 << 20));
  command
      ->add_option("--out", options->out,
                   "File to write: factors (" + suffixOf(formats::pdvFormat) + "), or " +
                       outputHelp("the material that they represent"))
      ->group(outputGroup);
  const std::vector<CLI::Option*> pdvOptions = addPdvOptions(*command, options);
  command->callback([options, bytes, pdvOptions, &tool] {
    tool.run = [options, bytes, pdvOptions, &tool] {
      if (options->method == pdvMethod) {
        if (bytes->count() > 0) throw UsageError("factor: --bytes is for baselines, see --method");
        return factor(*options, tool);
      }
      for (const CLI::Option* option : pdvOptions)
        if (option->count() > 0)
          throw UsageError("factor: " + option->get_name() + " is for --method pdv, found " + options->method);
      return factorByBaseline({options->material, options->method, options->out, options->bytes, options->samples},
                              tool);
    };
  });
}

}  // namespace gonio::tool
