// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <chrono>
#include <filesystem>

#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/io/json_text.h"
#include "core/materials/dictionary_file.h"
#include "core/study/training_files.h"

namespace gonio::tool {

namespace {

using namespace dictionary;

struct DictionaryArguments {
  std::vector<std::string> sources, excluded;
  std::string out, checkpoint, extended;
  TrainingOptions training;
  bool onlyComplete = false, half = false;
};

/// What makes two trainings the same, for a checkpoint.
std::string describe(const DictionaryArguments& options, const TrainingMaterials& materials) {
  const TrainingOptions& t = options.training;
  Json json{{"dictionaries", t.dictionaries},
            {"sparsities", t.sparsities},
            {"iterations", t.iterations},
            {"passes", t.passes},
            {"tolerance", t.tolerance},
            {"subspaceLoss", t.subspaceLoss},
            {"seed", t.seed},
            {"grid", {materials.grid.thetaHCount, materials.grid.thetaDCount, materials.grid.phiDCount}},
            {"materials", materials.names}};
  if (t.signals.normalised) json["normalised"] = true;
  if (t.signals.scaled)
    json["orders"] = "both";
  else
    json["scaled"] = false;
  return io::jsonText(json);
}

/// Codes as published represent the mean of both orders.
study::TrainingOrders ordersOf(const TrainingOptions& options) {
  return options.signals.scaled ? study::TrainingOrders::both : study::TrainingOrders::mean;
}

TrainingResult trainWithCheckpoints(const DictionaryArguments& options, const TrainingMaterials& materials,
                                    const Tool& tool) {
  const std::string training = describe(options, materials);
  std::optional<TrainingState> resumed;
  if (!options.checkpoint.empty() && std::filesystem::exists(options.checkpoint))
    resumed = materials::readCheckpoint(training, options.checkpoint);
  auto written = std::chrono::steady_clock::now();
  const TaskControl control = tool.control("learning from " + std::to_string(materials.names.size()) + " materials");
  return train(materials, options.training, control, resumed ? &*resumed : nullptr, [&](const TrainingState& state) {
    if (options.checkpoint.empty()) return;
    const auto now = std::chrono::steady_clock::now();
    if (now - written < std::chrono::seconds(20)) return;
    materials::writeCheckpoint(state, training, options.checkpoint);
    written = now;
  });
}

int train(const DictionaryArguments& options, const Tool& tool) {
  std::shared_ptr<const materials::NamedEnsemble> extended;
  if (!options.extended.empty()) extended = materials::readDictionary(options.extended);
  const std::vector<std::string> files = study::trainingFiles(options.sources, options.excluded);
  const TrainingMaterials materials =
      study::trainingMaterials(files, study::trainingGrid(files), ordersOf(options.training));
  const Error interrupted(options.out + ": not written, the training was interrupted");
  TrainingResult result = [&] {
    try {
      return trainWithCheckpoints(options, materials, tool);
    } catch (const Cancelled&) {  // before there were any dictionaries
      throw interrupted;
    }
  }();
  if (options.onlyComplete && !result.complete) throw interrupted;
  Json ensembles = Json::array();
  std::string text;
  for (std::size_t e = 0; e < result.state.errors.size(); ++e) {
    const std::vector<double>& errors = result.state.errors[e];
    Json entry{{"sparsity", options.training.sparsities[e]}, {"rounds", errors.size()}, {"errors", errors}};
    text += "sparsity " + std::to_string(options.training.sparsities[e]);
    text += errors.empty() ? ": stopped before its first round"
                           : ": relative squared error " + number(errors.front()) + " to " + number(errors.back()) +
                                 " in " + std::to_string(errors.size()) + " rounds";
    if (e < result.errorsAfter.size()) {
      entry["errorBeforeSweep"] = result.errorsBefore[e];
      entry["errorAfterSweep"] = result.errorsAfter[e];
      text += "; relative squared error on the complete tables " + number(result.errorsBefore[e]) + " before and " +
              number(result.errorsAfter[e]) + " after the last update, which learns from the complete tables";
    }
    ensembles.push_back(entry);
    text += "\n";
  }
  const Sizes& ranks = result.state.subspace.ranks;
  if (extended) result.ensemble = joined(extended->ensemble, result.ensemble);
  const double orthonormality = orthonormalityError(result.ensemble);
  materials::writeDictionary(result.ensemble, options.out, options.half);
  print(tool,
        {{"complete", result.complete},
         {"materials", materials.names.size()},
         {"dictionaries", result.ensemble.dictionaries.size()},
         {"bytes", result.ensemble.bytes()},
         {"subspace", {{"phiD", ranks[0]}, {"thetaD", ranks[1]}, {"thetaH", ranks[2]}}},
         {"subspaceLoss", result.state.subspace.loss},
         {"ensembles", ensembles},
         {"orthonormality", orthonormality},
         {"scaled", result.ensemble.scaled},
         {"seconds", result.seconds},
         {"out", options.out}},
        std::string(result.complete ? "" : "stopped early: wrote the best dictionaries so far\n") +
            std::to_string(result.ensemble.dictionaries.size()) + " dictionaries from " +
            std::to_string(materials.names.size()) + " materials, " + std::to_string(result.ensemble.bytes()) +
            " bytes, orthonormal to " + number(orthonormality) + ", " + number(result.seconds) + " s\nsubspace " +
            std::to_string(ranks[0]) + " x " + std::to_string(ranks[1]) + " x " + std::to_string(ranks[2]) +
            ", omits " + number(result.state.subspace.loss) + " of the energy\n" + text);
  return 0;
}

int info(const std::string& path, const Tool& tool) {
  const auto named = materials::readDictionary(path);
  const Ensemble& ensemble = named->ensemble;
  std::vector<int> sparsities;
  std::string text;
  for (const Dictionary& dictionary : ensemble.dictionaries) sparsities.push_back(dictionary.sparsity);
  for (const int sparsity : sparsities) text += " " + std::to_string(sparsity);
  const double orthonormality = orthonormalityError(ensemble);
  print(tool,
        {{"dictionaries", ensemble.dictionaries.size()},
         {"grid", {ensemble.grid.thetaHCount, ensemble.grid.thetaDCount, ensemble.grid.phiDCount}},
         {"sparsities", sparsities},
         {"bytes", ensemble.bytes()},
         {"orthonormality", orthonormality},
         {"scaled", ensemble.scaled},
         {"learnedFrom", ensemble.learnedFrom}},
        std::to_string(ensemble.dictionaries.size()) +
            (ensemble.scaled ? " dictionaries, " : " dictionaries without cell scaling, ") +
            std::to_string(ensemble.bytes()) + " bytes, orthonormal to " + number(orthonormality) + "\nsparsities" +
            text + "\nlearned from " + std::to_string(ensemble.learnedFrom.size()) + " materials\n");
  return 0;
}

void addTrain(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<DictionaryArguments>();
  TrainingOptions& training = options->training;
  CLI::App* command = app.add_subcommand("train", "Learns an ensemble of dictionaries from materials");
  command->add_option("SOURCE", options->sources, study::trainingHelp())->required();
  command->add_option("--out", options->out, "File to write (.dictionary)")->group(outputGroup)->required();
  command->add_option("--exclude", options->excluded, "Names of materials to exclude")
      ->type_name("NAME")
      ->delimiter(',');
  command->add_option("--dictionaries", training.dictionaries, "Dictionaries for each number of coefficients (8)")
      ->check(CLI::Range(1, 64));
  command
      ->add_option("--sparsities", training.sparsities,
                   "Numbers of coefficients per signal; each has its own dictionaries (32,64,128,256)")
      ->delimiter(',')
      ->check(CLI::Range(1, 65535));
  command->add_option("--iterations", training.iterations, "Max. rounds for each number of coefficients (24)")
      ->check(CLI::Range(1, 10000));
  command->add_option("--passes", training.passes, "Passes over the dictionaries per round (4)")
      ->check(CLI::Range(1, 100));
  command
      ->add_option("--tolerance", training.tolerance,
                   "End the rounds when one lowers the error by less than this fraction (0.0005)")
      ->check(CLI::Range(0.0, 1.0));
  command
      ->add_option("--subspace-loss", training.subspaceLoss,
                   "Max. fraction of the energy that the common subspace of all dictionaries omits (3e-5)")
      ->check(CLI::Range(0.0, 0.5));
  command->add_flag(
      "--as-published", [&training](std::int64_t) { training.signals.scaled = false; },
      "Learn from transformed values without cell scaling, of the mean of both orders of the directions");
  command
      ->add_option("--extend", options->extended,
                   "Dictionary file whose dictionaries precede the learned ones in the file to write")
      ->type_name("FILE");
  command->add_flag("--half", options->half, "Store the dictionaries in half precision: half the size of the file");
  command->add_flag("--normalise", training.signals.normalised,
                    "Divide each signal by its norm, so that dark materials count as much as bright ones");
  command->add_option("--seed", training.seed, "Seed of the initial assignment of signals to dictionaries (1)");
  command
      ->add_option("--checkpoint", options->checkpoint,
                   "File for the training state; if it exists, training resumes from it")
      ->type_name("FILE");
  command->add_flag("--only-complete", options->onlyComplete,
                    "After an interrupt, write nothing instead of the best dictionary so far");
  command->callback([options, &tool] {
    tool.keepsPartialResults = true;
    tool.run = [options, &tool] { return train(*options, tool); };
  });
}

}  // namespace

void addDictionary(CLI::App& app, Tool& tool) {
  CLI::App* command = app.add_subcommand("dictionary", "Learns dictionaries and shows their contents");
  command->require_subcommand(1);
  addTrain(*command, tool);
  const auto path = std::make_shared<std::string>();
  CLI::App* infoCommand = command->add_subcommand("info", "Shows the contents of a dictionary");
  infoCommand->add_option("DICTIONARY", *path, "Dictionary file (.dictionary)")->required();
  infoCommand->callback([path, &tool] { tool.run = [path, &tool] { return info(*path, tool); }; });
}

}  // namespace gonio::tool
