// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// gonio_studies cross_validation --csv FILE [--dictionary FILE]... [--every N] [--only ID]... [--size PIXELS]
// [--samples N] FOLDER...: how well dictionaries keep materials that they have not seen. Each dictionary is judged by
// the .binary files of the folders that are not among the materials it learned from; of these every Nth, from the
// first, when
// --every is given. A line a material, model and count of coefficients: rendered SNR and PSNR in comparisonScene(), SNR
// of the reflectances, bytes, seconds. Models: "ensemble" (of its two transforms that of the smaller gamma-mapped
// error), "ensemble-squared" (that of the smaller squared error), each transform by its name, and with at most as many
// bytes as "ensemble" has "components" and "patches", which learn from the same materials (held_out_models.h);
// "nonparametric" and "fit" have their own size, whatever the count. --only leaves other models out, but never the
// codes, whose bytes the others may have. Records are kept in the file, and what is in it is not computed again. At the
// end tables of the means, and of what the ensemble is ahead of the others by.
//
// gonio_studies cross_validation --fold K FOLDER...: the names of fold K of 5, for `goniotool dictionary train
// --exclude`: the files of each folder in the order of their names, folder after folder; number i belongs to fold i
// mod 5. The measured file NAME_rgb.bsdf belongs to the fold of the near-measured copy NAME.binary, if there is one.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "core/fitting/fit_data.h"
#include "core/fitting/fit_parameters.h"
#include "core/materials/dictionary_file.h"
#include "core/materials/material.h"
#include "core/models/registry.h"
#include "core/support/error.h"
#include "tests/studies/comparison_judge.h"
#include "tests/studies/comparison_records.h"
#include "tests/studies/held_out_models.h"
#include "tests/studies/study_files.h"
#include "tests/studies/study_program.h"

namespace gonio::study::cross_validation_study {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t folds = 5;
constexpr char copySuffix[] = ".binary";
constexpr std::string_view rglSuffix = "_rgb";
constexpr int counts[] = {64, 128, 262, 512, 1024};
constexpr char ours[] = "ensemble", bySquares[] = "ensemble-squared";

struct Options {
  int size = 128, samples = 32;
  std::size_t every = 1;
  std::optional<int> fold;
  fs::path csv;
  std::set<std::string> only;
  std::vector<fs::path> dictionaries, folders;

  Options(int count, char** values) {
    for (int i = 1; i < count; ++i) {
      const std::string value = values[i];
      const auto next = [&] { return i + 1 < count ? std::string(values[++i]) : std::string(); };
      if (value == "--csv")
        csv = next();
      else if (value == "--dictionary")
        dictionaries.emplace_back(next());
      else if (value == "--every")
        every = std::stoul(next());
      else if (value == "--fold")
        fold = std::stoi(next());
      else if (value == "--only")
        only.insert(next());
      else if (value == "--size")
        size = std::stoi(next());
      else if (value == "--samples")
        samples = std::stoi(next());
      else
        folders.emplace_back(value);
    }
    every = std::max<std::size_t>(every, 1);
  }
};

/// A dictionary, the materials that it has not seen, and what else is learned from those that it has.
class Fold {
 public:
  Fold(const fs::path& dictionary, const std::vector<fs::path>& files)
      : dictionary_(materials::readDictionary(dictionary)), encoder_(dictionary_->ensemble) {
    const std::vector<std::string>& seen = dictionary_->ensemble.learnedFrom;
    for (const fs::path& file : files)
      if (std::ranges::find(seen, file.stem().string()) != seen.end())
        learnedFrom_.push_back(file);
      else if (file.extension() == copySuffix)
        heldOut_.push_back(file);
    if (learnedFrom_.size() != seen.size())
      throw Error(dictionary.string() + ": learned from " + std::to_string(seen.size()) +
                  " materials, of which the folders hold " + std::to_string(learnedFrom_.size()));
  }

  const std::vector<fs::path>& heldOut() const { return heldOut_; }
  const dictionary::Encoder& encoder() const { return encoder_; }

  const dictionary::PrincipalComponents& components() {
    if (!components_) {
      const dictionary::TrainingMaterials materials = training();
      components_ = dictionary::learnPrincipalComponents(materials.names.size(), materials.load);
    }
    return *components_;
  }
  const dictionary::PatchDictionary& patches() {
    if (!patches_) patches_.emplace(dictionary::learnPatchDictionary(training()));
    return *patches_;
  }

 private:
  dictionary::TrainingMaterials training() const {
    dictionary::TrainingMaterials materials{.names = {}, .grid = dictionary_->ensemble.grid, .load = {}};
    for (const fs::path& file : learnedFrom_) materials.names.push_back(file.stem());
    materials.load = [this](std::size_t material) {
      return meanOfOrders(materials::readMaterial(learnedFrom_[material]).tabulated());
    };
    return materials;
  }

  std::shared_ptr<const materials::NamedEnsemble> dictionary_;
  dictionary::Encoder encoder_;
  std::vector<fs::path> heldOut_, learnedFrom_;
  std::optional<dictionary::PrincipalComponents> components_;
  std::optional<dictionary::PatchDictionary> patches_;
};

/// One material: adds the records of the models that are wanted and not there yet.
class Trial {
 public:
  Trial(const fs::path& file, Fold& fold, const Options& options, ComparisonRecords& records)
      : file_(file), fold_(fold), options_(options), records_(records) {}

  void run() {
    if (!records_.contains(file_.stem(), bySquares, *std::rbegin(counts))) addEnsemble();
    for (const int count : counts) budgets_.push_back(records_.find(file_.stem(), ours, count)->bytes);
    using baselines::Baseline;
    const baselines::Baseline& nonparametric =
        *std::ranges::find(baselines::allBaselines(), "nonparametric", &baselines::Baseline::id);
    add("components", [&] { return componentModels(fold_.components(), *court().table(), budgets_); });
    add("patches", [&] { return patchModels(fold_.patches(), *court().table(), budgets_); });
    add("nonparametric", [&] { return nonparametric.build(*court().table(), budgets_, {}); });
    add("fit", [&] { return std::vector<baselines::ComparedModel>(budgets_.size(), bestFit()); });
  }

 private:
  bool wanted(const std::string& model) const {
    return (options_.only.empty() || options_.only.contains(model)) &&
           !records_.contains(file_.stem(), model, *std::rbegin(counts));
  }

  /// Made when something is missing.
  const ComparisonJudge& court() {
    if (!court_)
      court_.emplace(
          file_, collectionOf(file_),
          rendering::RenderOptions{.width = options_.size, .height = options_.size, .samples = options_.samples});
    return *court_;
  }

  void addEnsemble() {
    for (const int count : counts) {
      const auto start = std::chrono::steady_clock::now();
      const EnsembleModels models = ensembleModels(fold_.encoder(), *court().table(), std::size_t(count));
      const double seconds = secondsSince(start);
      std::vector<ComparisonRecord> judged;
      for (const EnsembleModels::Candidate& candidate : models.candidates) {
        judged.push_back(court().score(std::string(candidate.transform), candidate.model, seconds));
        addRecord(judged.back(), judged.back().model, count);
      }
      addRecord(judged[models.byGamma], ours, count);
      addRecord(judged[models.bySquares], bySquares, count);
    }
  }

  void add(const std::string& model, const std::function<std::vector<baselines::ComparedModel>()>& build) {
    if (!wanted(model)) return;
    const auto start = std::chrono::steady_clock::now();
    const std::vector<baselines::ComparedModel> models = build();
    const double seconds = secondsSince(start);
    ComparisonRecord record;
    for (std::size_t i = 0; i < models.size(); ++i) {
      if (i == 0 || models[i].brdf != models[i - 1].brdf) record = court().score(model, models[i], seconds);
      addRecord(record, model, counts[i]);
    }
  }

  void addRecord(ComparisonRecord record, const std::string& model, int count) {
    record.model = model;
    record.terms = count;
    records_.add(record);
    std::printf("%-28s %-16s %4d %7.2f %7.2f %8zu %6.2f\n", record.material.c_str(), model.c_str(), count,
                record.rendered, record.reflectance, record.bytes, record.seconds);
    std::fflush(stdout);
  }

  /// By the rendered SNR, of three common microfacet models: a ranking of all takes a minute a material.
  baselines::ComparedModel bestFit() {
    const fitting::FitData data(*court().table(), {});
    baselines::ComparedModel best;
    double highest = 0;
    for (const models::Model* model : {&models::sgd(), &models::abc(), &models::ggx()}) {
      const fitting::FitResult fit = fitting::fit(data, *model);
      const baselines::ComparedModel built{model->instantiate(fit.parameters),
                                           sizeof(float) * fitting::fittedParameterCount(model->spec())};
      const double snr = court().score({}, built, 0).rendered;
      if (best.brdf && !(snr > highest)) continue;
      highest = snr;
      best = built;
    }
    return best;
  }

  static double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  const fs::path& file_;
  Fold& fold_;
  const Options& options_;
  ComparisonRecords& records_;
  std::vector<std::size_t> budgets_;
  std::optional<ComparisonJudge> court_;
};

/// The name of what a file was measured from: that of RGL files has a suffix for the colours.
std::string materialOf(const fs::path& file) {
  std::string name = file.stem().string();
  if (file.extension() != copySuffix && name.ends_with(rglSuffix)) name.resize(name.size() - rglSuffix.size());
  return name;
}

void printFold(const std::vector<fs::path>& files, int fold) {
  std::string names;
  std::map<std::string, std::size_t> numbers;
  for (const fs::path& file : files) {
    const std::size_t number = numbers.try_emplace(materialOf(file), numbers.size()).first->second;
    if (number % folds == std::size_t(fold)) names += (names.empty() ? "" : ",") + file.stem().string();
  }
  std::printf("%s\n", names.c_str());
}

int run(const Options& options) {
  if (options.folders.empty() || (options.csv.empty() && !options.fold)) {
    std::fprintf(stderr,
                 "usage: gonio_studies cross_validation --csv FILE [--dictionary FILE]... [--every N] [--only ID]... "
                 "[--size PIXELS] [--samples N] FOLDER...\n"
                 "       gonio_studies cross_validation --fold K FOLDER...\n");
    return 2;
  }
  const std::vector<fs::path> files = filesIn(options.folders, {copySuffix, ".bsdf"});
  if (options.fold) {
    printFold(files, *options.fold);
    return 0;
  }
  ComparisonRecords records(options.csv);
  for (const fs::path& dictionary : options.dictionaries) {
    Fold fold(dictionary, files);
    for (std::size_t i = 0; i < fold.heldOut().size(); i += options.every)
      Trial(fold.heldOut()[i], fold, options, records).run();
  }
  std::printf("\n%s\n%s", summaryTable(records.all(), "coefficients").c_str(),
              aheadTable(records.all(), ours, "coefficients").c_str());
  return 0;
}

int study(int count, char** arguments) { return run(Options(count, arguments)); }

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::cross_validation_study
