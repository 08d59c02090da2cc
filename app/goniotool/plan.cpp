// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <set>

#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/usage.h"
#include "core/acquisition/atom_components.h"
#include "core/acquisition/dictionary_reconstruction.h"
#include "core/acquisition/sample_selection.h"
#include "core/acquisition/sampling_plan.h"
#include "core/io/atomic_file.h"
#include "core/materials/dictionary_file.h"
#include "core/study/training_files.h"

namespace gonio::tool {

namespace {

using namespace acquisition;

/// What directions are selected over: the principal components of the training set, or the atoms of dictionaries.
constexpr std::array signalSources{"components", "dictionaries"};

struct PlanArguments {
  std::vector<std::string> train, excluded, forbidden;
  std::string over{signalSources[0]}, dictionary;  ///< empty: the bundled one
  std::string out, method{selectionMethodNames[0]}, materialClass{study::materialClassNames[0]};
  SelectionOptions selection;
  int basisComponents = 0;
  double maxPolarDegrees = 85, separationDegrees = 0;
  bool single = false;
};

/// "theta_o=70:90,phi=0:20".
ForbiddenRegion forbiddenRegion(const std::string& text) {
  ForbiddenRegion region;
  std::set<std::string> seen;
  const UsageError wrong("found '" + text +
                         "', expected ranges such as theta_o=70:90 or theta_i=0:10,phi=0:20 (degrees)");
  for (const std::string& part : CLI::detail::split(text, ',')) {
    const auto equals = part.find('='), colon = part.find(':');
    if (equals == std::string::npos || colon == std::string::npos || colon < equals) throw wrong;
    const auto lowest = finiteNumber(part.substr(equals + 1, colon - equals - 1));
    const auto highest = finiteNumber(part.substr(colon + 1));
    const std::string name = part.substr(0, equals);
    const std::map<std::string, AngleRange*> ranges{
        {"theta_i", &region.thetaI}, {"theta_o", &region.thetaO}, {"phi", &region.azimuthDifference}};
    const auto range = ranges.find(name);
    if (range == ranges.end() || !lowest || !highest) throw wrong;
    if (!seen.insert(name).second)
      throw UsageError("found " + name + " twice in '" + text +
                       "', expected one range per angle; use one --forbid for each region");
    *range->second = {radians(*lowest), radians(*highest)};
  }
  return region;
}

SelectionOptions selectionOptions(const PlanArguments& options) {
  SelectionOptions selection = options.selection;
  selection.method =
      SelectionMethod(std::ranges::find(selectionMethodNames, options.method) - selectionMethodNames.begin());
  selection.measurable.maxPolarAngle = radians(options.maxPolarDegrees);
  selection.measurable.minSeparation = radians(options.separationDegrees);
  for (const std::string& text : options.forbidden) selection.measurable.forbidden.push_back(forbiddenRegion(text));
  selection.measurable.check();
  return selection;
}

double travelDegrees(const SamplingPlan& plan) {
  DirectionPair at;
  double sum = 0;
  for (const std::size_t next : plan.measurementOrder()) {
    sum += armTravel(at, plan.samples[next].directions);
    at = plan.samples[next].directions;
  }
  return degrees(sum);
}

/// The kept file gets a second name beside the plan, which costs neither time nor space; where it holds other
/// components, or the file system has no hard links, a file is written. Returns basisDigest().
std::string placeBasis(const study::LearnedBasis& learned, int components, materials::BasisPrecision precision,
                       const std::filesystem::path& path) {
  const materials::BasisFile& basis = *learned.basis;
  if (!learned.file.empty() && components >= basis.components.count()) {
    const std::filesystem::path temporary = path.string() + ".link";
    std::error_code failed;
    std::filesystem::remove(temporary, failed);
    std::filesystem::create_hard_link(learned.file, temporary, failed);
    if (!failed) std::filesystem::rename(temporary, path, failed);
    if (!failed) return learned.digest.substr(0, digestLength);
  }
  materials::writeBasis(basis.components, components, basis.learnedFrom, path, precision);
  return basisDigest(path);
}

/// The selection of one command and what it was made from.
struct Planned {
  SamplingPlan plan;
  SampleSelection selection;
  double seconds = 0, trainingSeconds = 0;
  std::size_t materials = 0;
  Eigen::Index signals = 0;
};

Planned planned(const SelectionOptions& chosen, const dictionary::PrincipalComponents& components,
                std::size_t materials, double trainingSeconds, const Tool& tool) {
  const auto start = std::chrono::steady_clock::now();
  Planned result{.selection = selectSamples(components, chosen, tool.control("choosing directions")),
                 .trainingSeconds = trainingSeconds,
                 .materials = materials,
                 .signals = components.svd.v.rows()};
  result.seconds = secondsSince(start);
  result.plan = planFor(components.mapping.grid, result.selection.cells);
  result.plan.method = result.selection.method;
  return result;
}

/// @param basis the keys of the basis that was written, null without one
/// @param learning a sentence about it
void report(const PlanArguments& options, const Planned& planned, const Json& basis, const std::string& learning,
            const Tool& tool) {
  const SampleSelection& selection = planned.selection;
  const double travel = travelDegrees(planned.plan);
  Json json{{"samples", planned.plan.samples.size()},
            {"method", selection.method},
            {"over", options.over},
            {"seconds", planned.seconds},
            {"trainingSeconds", planned.trainingSeconds},
            {"materials", planned.materials},
            {"signals", planned.signals},
            {"conditionNumber", decibelsJson(selection.conditionNumber)},
            {"residuals", selection.residuals},
            {"travel", travel},
            {"out", options.out}};
  if (!basis.is_null()) json.update(basis);
  if (!selection.warning.empty()) json["warnings"] = Json::array({selection.warning});
  print(tool, json,
        options.out + ": " + std::to_string(planned.plan.samples.size()) + " samples by " +
            std::string(selection.method) + " in " + number(planned.seconds) + " s, condition number " +
            number(selection.conditionNumber) + ", travel of the arms " + number(travel) + " degrees\n" + learning +
            "\n" + (selection.warning.empty() ? "" : selection.warning + "\n"));
}

std::string learnedIn(double seconds) {
  return seconds > 0 ? "learned in " + number(seconds) + " s" : "learned before";
}

/// Over the atoms of dictionaries: no basis is written, since reconstruct --method dictionaries learns its prior
/// itself.
int planOverDictionaries(const PlanArguments& options, const Tool& tool) {
  if (options.basisComponents > 0 || options.single)
    throw UsageError("plan: --basis-components and --single need --over components, which writes a basis file");
  const SelectionOptions chosen = selectionOptions(options);
  io::checkWritable(options.out);
  const auto dictionary =
      options.dictionary.empty() ? materials::bundledEnsemble() : materials::readDictionary(options.dictionary);
  const std::vector<std::string> files =
      study::filesOfClass(study::trainingFilesOrLibrary(options.train, options.excluded),
                          study::materialClassNamed(options.materialClass), tool.control("classifying"));
  const std::string trainingSet = std::to_string(files.size()) + " materials";
  const auto training = study::trainingMaterials(files, dictionary->ensemble.grid);
  const auto start = std::chrono::steady_clock::now();
  const auto prior = acquisition::learnDictionaryPrior(dictionary->ensemble, training, {},
                                                       tool.control("learning from " + trainingSet));
  const auto components = acquisition::atomComponents(
      dictionary->ensemble, prior, std::max({defaultAtomSignals, chosen.samples, usedComponents(chosen)}),
      tool.control("decomposing atoms"));
  Planned result = planned(chosen, components, files.size(), secondsSince(start), tool);
  result.plan.method += ", dictionaries";
  acquisition::writePlan(result.plan, options.out, {"dictionaries, training set: " + trainingSet});
  report(options, result, {},
         std::to_string(result.signals) + " atoms, coefficients of " + trainingSet + " " +
             learnedIn(result.trainingSeconds),
         tool);
  return 0;
}

int plan(const PlanArguments& options, const Tool& tool) {
  if (options.over == signalSources[1]) return planOverDictionaries(options, tool);
  if (!options.dictionary.empty()) throw UsageError("plan: --dictionary needs --over dictionaries");
  const SelectionOptions chosen = selectionOptions(options);
  const std::filesystem::path basisPath = basisBeside(options.out);
  if (basisPath == std::filesystem::path(options.out))
    throw UsageError("plan: --out " + options.out + " is the name of a basis file; use a name such as PLAN.csv");
  // Learning takes minutes: what cannot be written is reported before.
  io::checkWritable(basisPath);
  io::checkWritable(options.out);
  const int used = std::max(chosen.samples, usedComponents(chosen));
  const int wanted =
      options.basisComponents > 0 ? options.basisComponents : std::max(study::defaultBasisComponents, used);
  const auto precision = options.single ? materials::BasisPrecision::single : materials::BasisPrecision::half;
  const study::LearnedBasis learned =
      basisOfSources(options.train, options.excluded, std::max(wanted, used), tool, precision, options.materialClass);
  const materials::BasisFile& basis = *learned.basis;
  Planned result = planned(chosen, basis.components, basis.learnedFrom.size(), learned.seconds, tool);
  const int components = std::min(wanted, basis.components.count());
  const std::string trainingSet = std::to_string(basis.learnedFrom.size()) + " materials";
  // A plan names its basis: without the one the other is not written.
  result.plan.basisDigest = placeBasis(learned, components, precision, basisPath);
  acquisition::writePlan(
      result.plan, options.out,
      {"training set: " + trainingSet,
       "angles in degrees, i is the light, o the viewer; for isotropic materials only phi_o - phi_i matters"});
  report(options, result, {{"components", components}, {"basis", basisPath.string()}},
         basisPath.string() + ": " + std::to_string(components) + " components of " + trainingSet + ", " +
             learnedIn(learned.seconds),
         tool);
  return 0;
}

}  // namespace

void addPlan(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<PlanArguments>();
  SelectionOptions& selection = options->selection;
  CLI::App* command = app.add_subcommand("plan", "Chooses the directions at which to measure a material");
  command->add_option("--train", options->train, trainingSetHelp("Training set") + " (bundled library)")
      ->type_name("FILE|FOLDER");
  command->add_option("--exclude", options->excluded, "Names of materials to exclude")
      ->type_name("NAME")
      ->delimiter(',');
  addClassOption(*command, options->materialClass);
  command
      ->add_option("--over", options->over,
                   "Signals over which directions are selected: components, the channels of the training materials; or "
                   "dictionaries, the atoms with the largest variances, for reconstruct --method dictionaries "
                   "(components)")
      ->check(CLI::IsMember(std::vector<std::string>(signalSources.begin(), signalSources.end())));
  command
      ->add_option("--dictionary", options->dictionary, "Dictionary file of --over dictionaries (bundled dictionary)")
      ->type_name("FILE");
  command->add_option("--samples", selection.samples, "Number of direction pairs")
      ->required()
      ->check(CLI::Range(1, 4096));
  command
      ->add_option("--out", options->out,
                   "CSV file to write; the basis (principal components of the training set) is written to the same "
                   "path with the suffix " +
                       std::string(materials::basisSuffix))
      ->group(outputGroup)
      ->required();
  command
      ->add_option("--method", options->method,
                   "auto: a-optimal for up to " + std::to_string(mostAOptimalSamples) +
                       " samples, somp for more; somp: simultaneous orthogonal matching pursuit (FROST); "
                       "somp-first-columns: the same over the first "
                       "training signals only; somp-unnormalised: Algorithm 4 as printed, without the normalisation of "
                       "the columns; "
                       "condition-number: search for the smallest condition number; random: random "
                       "directions; uniform: evenly spread directions; a-optimal: smallest expected variance of all "
                       "cells (auto)")
      ->check(CLI::IsMember(std::vector<std::string>(selectionMethodNames.begin(), selectionMethodNames.end())));
  command
      ->add_option(
          "--components", selection.components,
          "Number of components that the selection of directions uses (as many as samples; with a-optimal at least " +
              std::to_string(aOptimalComponents) + ")")
      ->check(CLI::Range(1, 65535));
  command
      ->add_option("--basis-components", options->basisComponents,
                   "Number of components in the basis file (" + std::to_string(study::defaultBasisComponents) +
                       ", at least --samples and as many as the selection uses)")
      ->check(CLI::Range(1, 65535));
  command->add_option("--max-polar", options->maxPolarDegrees, "Max. polar angle of light and viewer, degrees (85)")
      ->check(CLI::Range(0.0, 90.0));
  command
      ->add_option("--min-separation", options->separationDegrees, "Min. angle between light and viewer, degrees (0)")
      ->check(CLI::Range(0.0, 180.0));
  command
      ->add_option("--forbid", options->forbidden,
                   "Directions that the rig cannot reach, such as theta_o=70:90 or theta_i=0:10,phi=0:20, degrees "
                   "(phi: difference of the azimuths): the pairs that lie in all ranges of a list; repeatable")
      ->type_name("RANGES")
      ->allow_extra_args(false)
      ->check(parsedBy(forbiddenRegion));
  command->add_option("--seed", selection.seed, "Seed of the methods condition-number and random (1)");
  command
      ->add_option("--restarts", selection.restarts,
                   "Number of searches of the method condition-number, the best of which is used (5)")
      ->check(CLI::Range(1, 10000));
  command->add_flag("--single", options->single, "Store the basis in single instead of half precision");
  command->callback([options, &tool] { tool.run = [options, &tool] { return plan(*options, tool); }; });
}

}  // namespace gonio::tool
