// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// gonio_studies acquisition --csv FILE [--samples M,M,..] [--fold K]... [--seeds N] [--only SELECTION]... [--every N]
// [--reconstructions ID,..] [--components P,P,..] [--training N] [--measured FOLDER] FOLDER...: how accurately
// materials outside the training set are reconstructed from few measurements. 10-fold cross-validation over the .binary
// and .bsdf files of the folders: folder after folder, those of each in the order of names, numbered from 0 through all
// folders; number i belongs to fold i mod 10. Principal components are learned from the other nine folds, directions
// are chosen over them, and each held-out material (every Nth with --every) is measured there without noise and
// reconstructed. With
// --measured, the training set is all files of the folders except those whose name a file of FOLDER has, and the files
// of FOLDER (.binary and .bsdf) are reconstructed. With --training, the training set is N of these materials, at even
// distances in their order. Selections: somp, somp-first-columns, somp-unnormalised, condition-number, a-optimal,
// random, uniform, and pdv, the two curves of a rig with two arms (half the readings each), which needs no training
// set; random selections are repeated with N seeds (5). --components adds reconstructions with P components for the
// directions of somp, with the ridge 40 (ridge-40-P) and by leave-one-out (ridge-auto-P). One line per case; records
// are kept in the file, and what is in it is not computed again. At the end tables.
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "core/acquisition/factor_prediction.h"
#include "core/acquisition/reconstruction.h"
#include "core/acquisition/sample_selection.h"
#include "core/materials/material.h"
#include "core/metrics/brdf_metrics.h"
#include "core/rendering/render_picture.h"
#include "core/support/error.h"
#include "tests/studies/acquisition_records.h"
#include "tests/studies/comparison_judge.h"
#include "tests/studies/study_files.h"
#include "tests/studies/study_program.h"

namespace gonio::study::acquisition_study {
namespace fs = std::filesystem;

namespace {

constexpr int folds = 10;
constexpr rendering::RenderOptions picture{.width = 128, .height = 128, .samples = 16};

struct Selection {
  const char* id;
  std::optional<acquisition::SelectionMethod> method;  ///< none: two arms
  bool draws;
  acquisition::FactorAxes axes = acquisition::FactorAxes::projectedDeviation;  ///< of two arms
};
constexpr Selection selections[] = {
    {"somp", acquisition::SelectionMethod::simultaneousPursuit, false},
    {"somp-first-columns", acquisition::SelectionMethod::simultaneousPursuitFirstColumns, false},
    {"somp-unnormalised", acquisition::SelectionMethod::simultaneousPursuitUnnormalised, false},
    {"condition-number", acquisition::SelectionMethod::conditionNumber, true},
    {"a-optimal", acquisition::SelectionMethod::aOptimal, false},
    {"random", acquisition::SelectionMethod::random, true},
    {"uniform", acquisition::SelectionMethod::uniform, false},
    {"pdv", std::nullopt, false},
    {"pdv-symmetric", std::nullopt, false, acquisition::FactorAxes::symmetricDeviation}};

struct Way {
  std::string id;
  acquisition::ReconstructionOptions options;  // 0 components: as many as samples
};
/// All but the first for the directions of `somp` alone.
const std::vector<Way> standardWays = {
    {"ridge-40", {.ridge = acquisition::publishedRidge, .uncertainty = false}},
    {"ridge-auto", {.ridge = std::nullopt, .uncertainty = false}},
    {"ridge-40-all", {.ridge = acquisition::publishedRidge, .components = 1 << 20, .uncertainty = false}},
    {"ridge-auto-all", {.ridge = std::nullopt, .components = 1 << 20, .uncertainty = false}},
    {"local-ridge",
     {.method = acquisition::ReconstructionMethod::localRidge, .components = 1 << 20, .uncertainty = false}},
    {"sparse", {.method = acquisition::ReconstructionMethod::sparse, .uncertainty = false}}};

struct Options {
  fs::path csv, measured;
  std::vector<int> samples{5, 10, 20, 30, 40, 60};
  std::set<int> onlyFolds;
  std::set<std::string> only, reconstructions;
  int seeds = 5;
  std::size_t every = 1;
  std::size_t training = 0;  ///< materials of the training set; 0: all
  std::vector<Way> ways = standardWays;
  std::vector<fs::path> folders;

  Options(int count, char** values) {
    for (int i = 1; i < count; ++i) {
      const std::string value = values[i];
      const auto next = [&] { return i + 1 < count ? std::string(values[++i]) : std::string(); };
      if (value == "--csv")
        csv = next();
      else if (value == "--measured")
        measured = next();
      else if (value == "--samples") {
        samples.clear();
        for (const std::string& one : split(next())) samples.push_back(std::stoi(one));
      } else if (value == "--fold")
        onlyFolds.insert(std::stoi(next()));
      else if (value == "--only")
        only.insert(next());
      else if (value == "--reconstructions")
        for (const std::string& one : split(next())) reconstructions.insert(one);
      else if (value == "--seeds")
        seeds = std::stoi(next());
      else if (value == "--every")
        every = std::max<std::size_t>(1, std::stoul(next()));
      else if (value == "--training")
        training = std::stoul(next());
      else if (value == "--components")
        for (const std::string& one : split(next())) addComponents(std::stoi(one));
      else
        folders.emplace_back(value);
    }
  }

  void addComponents(int count) {
    const std::pair<const char*, std::optional<double>> ridges[] = {{"ridge-40-", acquisition::publishedRidge},
                                                                    {"ridge-auto-", std::nullopt}};
    for (const auto& [id, ridge] : ridges)
      ways.push_back({id + std::to_string(count), {.ridge = ridge, .components = count, .uncertainty = false}});
    ways.push_back(
        {"local-ridge-" + std::to_string(count),
         {.method = acquisition::ReconstructionMethod::localRidge, .components = count, .uncertainty = false}});
  }

  bool wants(const Selection& selection) const { return only.empty() || only.contains(selection.id); }
  bool wants(const Selection& selection, const Way& way) const {
    const std::string id = selection.id;
    return id == "somp" || id == "a-optimal" ? reconstructions.empty() || reconstructions.contains(way.id)
                                             : way.id == ways.front().id;
  }
};

const std::initializer_list<std::string_view> extensions{".binary", ".bsdf"};

/// "satin_purple" of "satin_purple_rgb.bsdf" and of "satin_purple.binary".
std::string materialName(const fs::path& file) {
  const std::string name = file.stem();
  return name.ends_with("_rgb") ? name.substr(0, name.size() - 4) : name;
}

/// A material that was held out: its picture and errors of what stands for it.
class HeldOut {
 public:
  explicit HeldOut(const fs::path& file)
      : name_(materialName(file)),
        collection_(collectionOf(file)),
        brdf_(materials::readMaterial(file).brdf),
        comparison_(*brdf_, picture) {}

  const Brdf& brdf() const { return *brdf_; }
  AcquisitionRecord caseOf(const std::string& selection, const std::string& way, int samples,
                           std::uint64_t seed) const {
    return {name_, collection_, selection, way, samples, seed, 0, 0, 0};
  }
  void judge(AcquisitionRecord& record, const Brdf& found) const {
    using metrics::BrdfMetric;
    record.rendered = comparison_.signalToNoiseRatio(comparison_.render(found));
    record.linear = std::pow(metrics::brdfError(BrdfMetric::rms, *brdf_, found), -2);
    record.logRelative = std::pow(metrics::brdfError(BrdfMetric::logRelative, *brdf_, found), -2);
  }

 private:
  std::string name_, collection_;
  std::shared_ptr<const Brdf> brdf_;  ///< in its native form
  rendering::RenderedComparison comparison_;
};

/// `count` of the materials, at even distances; all where there are no more, or `count` is 0.
std::vector<fs::path> spreadOver(const std::vector<fs::path>& materials, std::size_t count) {
  if (count == 0 || count >= materials.size()) return materials;
  std::vector<fs::path> some;
  for (std::size_t i = 0; i < count; ++i) some.push_back(materials[i * materials.size() / count]);
  return some;
}

/// One training set and what it has not seen.
class Trial {
 public:
  Trial(const std::vector<fs::path>& training, std::vector<fs::path> tested, const Options& options,
        AcquisitionRecords& records)
      : training_(spreadOver(training, options.training)),
        tested_(std::move(tested)),
        options_(options),
        records_(records) {}

  void run() {
    for (std::size_t i = 0; i < tested_.size(); i += options_.every) {
      const HeldOut material(tested_[i]);
      for (const int samples : options_.samples)
        for (const Selection& selection : selections)
          if (options_.wants(selection)) measure(material, selection, samples);
    }
  }

 private:
  void measure(const HeldOut& material, const Selection& selection, int samples) {
    if (!selection.method) {
      AcquisitionRecord record = material.caseOf(selection.id, "two-arms", samples, 0);
      if (records_.contains(record)) return;
      const auto curves = acquisition::measureFactors(material.brdf(), {.axes = selection.axes,
                                                                        .fixedAngle = 1,
                                                                        .angles = (samples + 1) / 2,
                                                                        .distances = std::max(2, samples / 2)});
      return add(material, record, *acquisition::predictFromFactors(curves, acquisition::FactorBound::none));
    }
    for (std::uint64_t seed = 1; seed <= (selection.draws ? std::uint64_t(options_.seeds) : 1); ++seed)
      for (const Way& way : options_.ways) {
        AcquisitionRecord record = material.caseOf(selection.id, way.id, samples, seed);
        if (!options_.wants(selection, way) || records_.contains(record)) continue;
        const acquisition::SamplingPlan& plan = planOf(selection, samples, seed);
        acquisition::ReconstructionOptions options = way.options;
        if (options.components == 0) options.components = int(plan.samples.size());
        const auto found =
            acquisition::reconstruct(basis(), plan, acquisition::measure(material.brdf(), plan), options);
        add(material, record, *found.table);
      }
  }

  void add(const HeldOut& material, AcquisitionRecord& record, const Brdf& found) {
    material.judge(record, found);
    records_.add(record);
    std::printf("%-28s %-18s %-14s %3d %2d %7.2f dB %10.4g %8.3f\n", record.material.c_str(), record.selection.c_str(),
                record.reconstruction.c_str(), record.samples, int(record.seed), record.rendered, record.linear,
                record.logRelative);
    std::fflush(stdout);
  }

  const dictionary::PrincipalComponents& basis() {
    if (!basis_)
      basis_ = dictionary::learnPrincipalComponents(training_.size(), [&](std::size_t material) {
        return meanOfOrders(materials::readMaterial(training_[material]).tabulated());
      });
    return *basis_;
  }

  const acquisition::SamplingPlan& planOf(const Selection& selection, int samples, std::uint64_t seed) {
    const auto key = std::tuple(std::string(selection.id), samples, seed);
    auto found = plans_.find(key);
    if (found == plans_.end()) {
      const acquisition::SampleSelection chosen =
          acquisition::selectSamples(basis(), {.method = *selection.method, .samples = samples, .seed = seed});
      found = plans_.emplace(key, acquisition::planFor(basis().mapping.grid, chosen.cells)).first;
    }
    return found->second;
  }

  std::vector<fs::path> training_, tested_;
  const Options& options_;
  AcquisitionRecords& records_;
  std::optional<dictionary::PrincipalComponents> basis_;
  std::map<std::tuple<std::string, int, std::uint64_t>, acquisition::SamplingPlan> plans_;
};

void crossValidate(const std::vector<fs::path>& files, const Options& options, AcquisitionRecords& records) {
  for (int fold = 0; fold < folds; ++fold) {
    if (!options.onlyFolds.empty() && !options.onlyFolds.contains(fold)) continue;
    std::vector<fs::path> training, tested;
    for (std::size_t i = 0; i < files.size(); ++i) (int(i % folds) == fold ? tested : training).push_back(files[i]);
    Trial(training, tested, options, records).run();
  }
}

void testMeasured(const std::vector<fs::path>& files, const Options& options, AcquisitionRecords& records) {
  const std::vector<fs::path> tested = filesIn({options.measured}, extensions);
  std::set<std::string> names;
  for (const fs::path& file : tested) names.insert(materialName(file));
  std::vector<fs::path> training;
  for (const fs::path& file : files)
    if (!names.contains(materialName(file))) training.push_back(file);
  Trial(training, tested, options, records).run();
}

int run(const Options& options) {
  if (options.folders.empty() || options.csv.empty()) {
    std::fprintf(stderr,
                 "usage: gonio_studies acquisition --csv FILE [--samples M,M,..] [--fold K]... [--seeds N] [--only "
                 "SELECTION]... "
                 "[--every N] [--reconstructions ID,..] [--components P,P,..] [--training N] [--measured FOLDER] "
                 "FOLDER...\n");
    return 2;
  }
  const std::vector<fs::path> files = filesIn(options.folders, extensions);
  AcquisitionRecords records(options.csv);
  options.measured.empty() ? crossValidate(files, options, records) : testMeasured(files, options, records);
  std::printf("\nRendered SNR, dB:\n\n%s\nInverse MSE, linear, sr^2:\n\n%s\nInverse MSE, log-relative:\n\n%s",
              records.table(&AcquisitionRecord::rendered, 1).c_str(),
              records.table(&AcquisitionRecord::linear, 2).c_str(),
              records.table(&AcquisitionRecord::logRelative, 1).c_str());
  if (!options.measured.empty())
    for (const int samples : options.samples)
      std::printf("\nRendered SNR of m = %d, dB:\n\n%s", samples, records.materials(samples).c_str());
  return 0;
}

int study(int count, char** arguments) { return run(Options(count, arguments)); }

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::acquisition_study
