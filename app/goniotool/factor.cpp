// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <filesystem>

#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/factorization/pdv_operations.h"
#include "core/materials/pdv_file.h"
#include "core/metrics/brdf_metrics.h"
#include "core/study/evaluation_time.h"

namespace gonio::tool {

namespace {

using namespace factorization;

constexpr std::array<const char*, 2> formNames{"2d", "3d"};  // in the order of PdvForm

struct FactorArguments {
  std::string material, form = formNames[1], transform{dataTransformNames[0]}, out, decode, swapF1, swapF2;
  int terms = 10;
  bool keepFurther = false, formGiven = false, transformGiven = false;

  PdvOptions pdvOptions() const {
    return {.form = static_cast<PdvForm>(std::find(formNames.begin(), formNames.end(), form) - formNames.begin()),
            .transform =
                static_cast<DataTransform>(std::find(dataTransformNames.begin(), dataTransformNames.end(), transform) -
                                           dataTransformNames.begin()),
            .terms = swaps() && !keepFurther ? 1 : terms};
  }
  bool swaps() const { return !swapF1.empty() || !swapF2.empty(); }
};

bool isFactorsFile(const std::string& path) { return materials::hasSuffixOf(materials::FormatId::pdv, path); }

/// The factors of FILE: its own, where it is a file of factors.
PdvFactorization factorsOf(const FactorArguments& options, const materials::Material& material,
                           const TabulatedBrdf& table, const Tool& tool) {
  if (!materials::isPdv(options.material))
    return factorizePdv(table, options.pdvOptions(), tool.control("factorising " + material.name));
  if (options.formGiven || options.transformGiven)
    throw UsageError("factor: " + options.material + " contains factors already: leave out --form and --transform");
  return {.factors = materials::readPdv(options.material).truncated(options.terms),
          .residuals = {},
          .cells = 0,
          .seconds = 0};
}

/// The factors of another material for a swap: one term over the same nodes, where they are not given.
PdvFactors otherFactors(const std::string& other, const PdvFactors& target, const Tool& tool) {
  if (materials::isPdv(other)) return materials::readPdv(other);
  const materials::Material material = openMaterial(other, tool.control("reading " + other));
  return factorizePdv(
             *material.tabulated(tool.control("tabulating")),
             {.form = target.form, .transform = target.transform, .terms = 1, .deviationNodes = target.deviationNodes},
             tool.control("factorising " + material.name))
      .factors;
}

PdvFactors swapped(const FactorArguments& options, PdvFactors factors, const Tool& tool) {
  const FurtherTerms further = options.keepFurther ? FurtherTerms::keep : FurtherTerms::drop;
  if (!options.swapF1.empty()) factors = takeF1(factors, otherFactors(options.swapF1, factors, tool), further);
  if (!options.swapF2.empty()) factors = takeF2(factors, otherFactors(options.swapF2, factors, tool), further);
  return factors;
}

void checkOptions(const FactorArguments& options) {
  if (options.keepFurther && !options.swaps()) throw UsageError("factor: --keep-terms is for --swap-f1 and --swap-f2");
  if (!options.out.empty() && !isFactorsFile(options.out)) materials::writableFormat(options.out);
  if (!options.decode.empty()) materials::writableFormat(options.decode);
}

int factor(const FactorArguments& options, const Tool& tool) {
  checkOptions(options);
  const materials::Material material = openMaterial(options.material, tool.control("reading"));
  const auto table = material.tabulated(tool.control("tabulating"));
  PdvFactorization result = factorsOf(options, material, *table, tool);
  result.factors = swapped(options, std::move(result.factors), tool);
  const auto brdf = makePdvBrdf(result.factors);
  const std::vector<double> errors = metrics::brdfErrors(*table, *brdf);
  const double snr = metrics::brdfSignalToNoiseRatio(*table, *brdf);
  const double nanoseconds = study::measureEvaluation(*brdf).median;
  if (isFactorsFile(options.out)) materials::writePdv(result.factors, options.out);
  for (const std::string& path : {isFactorsFile(options.out) ? std::string() : options.out, options.decode})
    if (!path.empty()) materials::writeMaterial(*bakeTable(*brdf, table->grid(), tool.control("decoding")), path);

  const PdvFactors& f = result.factors;
  if (!result.residuals.empty()) result.residuals.erase(result.residuals.begin());
  result.residuals.resize(std::min(result.residuals.size(), std::size_t(f.terms())));
  Json json{{"terms", f.terms()},
            {"form", formNames[std::size_t(f.form)]},
            {"transform", dataTransformNames[std::size_t(f.transform)]},
            {"grid", {f.thetaNodes.size(), f.deviationNodes.size(), f.phiNodes.size()}},
            {"bytes", materials::pdvFileBytes(f)},
            {"residuals", result.residuals},
            {"seconds", result.seconds},
            {"errors", errorsJson(errors)},
            {"brdfSnr", decibelsJson(snr)},
            {"evaluationNs", nanoseconds}};
  if (!options.out.empty()) json["out"] = options.out;
  if (!options.decode.empty()) json["decoded"] = options.decode;
  print(tool, json,
        std::to_string(f.terms()) + " terms, " + std::to_string(materials::pdvFileBytes(f)) + " bytes, residual " +
            (result.residuals.empty() ? "not known" : number(result.residuals.back())) + ", BRDF SNR " + number(snr) +
            " dB, " + number(result.seconds) + " s, " + number(nanoseconds) + " ns per value\n" + errorsText(errors));
  return 0;
}

}  // namespace

void addFactor(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<FactorArguments>();
  CLI::App* command =
      app.add_subcommand("factor", "Factorises a material into curves in projected-deviation coordinates (PDV)");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  command->add_option("--terms", options->terms, "Number of terms, products of curves that are summed (10)")
      ->check(CLI::Range(1, maxPdvTerms));
  auto* form = command->add_option("--form", options->form, "2d: two curves per term; 3d: three (3d)");
  form->check(CLI::IsMember(std::vector<std::string>(formNames.begin(), formNames.end())));
  auto* transform = command->add_option("--transform", options->transform, "Transform of the BRDF values (log-plus)");
  transform->check(CLI::IsMember(std::vector<std::string>(dataTransformNames.begin(), dataTransformNames.end())));
  command->add_option("--out", options->out,
                      "File to write: factors (" + suffixOf(materials::FormatId::pdv) + "), or " +
                          outputHelp("the material that they represent"));
  command->add_option("--decode", options->decode,
                      outputHelp("Bake the material that the factors represent to this file"));
  command->add_option("--swap-f1", options->swapF1,
                      "Replace F1 of the first term (specular strength vs. angle) by that of this material");
  command->add_option("--swap-f2", options->swapF2,
                      "Replace F2 of the first term (highlight profile) by that of this material");
  command->add_flag("--keep-terms", options->keepFurther, "Retain the further terms when F1 or F2 is replaced");
  command->callback([options, form, transform, &tool] {
    options->formGiven = form->count() > 0;
    options->transformGiven = transform->count() > 0;
    tool.run = [options, &tool] { return factor(*options, tool); };
  });
}

}  // namespace gonio::tool
