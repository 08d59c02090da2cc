// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// gonio_studies dictionary_reconstruction --dictionary FILE --test MATERIAL,.. --plan PLAN.csv,.. FILE|FOLDER...:
// materials reconstructed in an ensemble of dictionaries, beside principal components. The priors of the dictionaries
// are learned from the files that the ensemble names among what it learned from; nor may the bases beside the plans
// have learned from others. The materials of --test are measured by each plan without noise. A line a material and
// plan, and means: rendered SNR (128 x 128, 16 samples per pixel) of the ridge by leave-one-out with all components of
// the basis, and of the dictionaries by each way to learn and to choose.
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "core/acquisition/dictionary_reconstruction.h"
#include "core/acquisition/reconstruction.h"
#include "core/acquisition/sampling_plan.h"
#include "core/materials/basis_file.h"
#include "core/materials/dictionary_file.h"
#include "core/materials/material.h"
#include "core/rendering/render_picture.h"
#include "core/support/error.h"
#include "tests/studies/study_program.h"

namespace gonio::study::dictionary_reconstruction_study {
using namespace gonio::rendering;
using namespace gonio::acquisition;
namespace fs = std::filesystem;

namespace {

struct Options {
  fs::path dictionary;
  std::vector<fs::path> tested, plans, training;

  Options(int count, char** values) {
    for (int i = 1; i < count; ++i) {
      const std::string value = values[i];
      const auto next = [&] {
        std::vector<fs::path> parts;
        std::istringstream stream(i + 1 < count ? values[++i] : "");
        for (std::string part; std::getline(stream, part, ',');) parts.emplace_back(part);
        return parts;
      };
      if (value == "--dictionary")
        dictionary = next().at(0);
      else if (value == "--test")
        tested = next();
      else if (value == "--plan")
        plans = next();
      else if (fs::is_directory(value))
        for (const auto& entry : fs::directory_iterator(value)) training.push_back(entry.path());
      else
        training.emplace_back(value);
    }
    std::sort(training.begin(), training.end());
  }
};

dictionary::TrainingMaterials trainingOf(const dictionary::Ensemble& ensemble, std::vector<fs::path> files) {
  const std::set<std::string> known(ensemble.learnedFrom.begin(), ensemble.learnedFrom.end());
  std::erase_if(files, [&](const fs::path& file) { return !known.contains(file.stem()); });
  dictionary::TrainingMaterials materials;
  for (const fs::path& file : files) materials.names.push_back(file.stem());
  materials.load = [files](std::size_t m) { return meanOfOrders(materials::readMaterial(files[m]).tabulated()); };
  return materials;
}

void print(const std::string& name, std::size_t samples, const Eigen::ArrayXd& scores) {
  std::printf("| %s | %zu", name.c_str(), samples);
  for (const double one : scores) std::printf(" | %.2f", one);
  std::printf(" |\n");
  std::fflush(stdout);
}

int run(int count, char** arguments) {
  const Options options(count, arguments);
  const auto ensemble = materials::readDictionary(options.dictionary);
  const auto materials = trainingOf(ensemble->ensemble, options.training);
  std::printf("%zu materials\n", materials.names.size());
  const auto learn = [&](const DictionaryPriorOptions& prior) {
    return learnDictionaryPrior(ensemble->ensemble, materials, prior);
  };
  const DictionaryPrior own = learn({}), alike = learn({.sharing = 1}),
                        cosineLog = learn({.transform = DataTransform::cosineLog, .sharing = 1});
  struct Way {
    const char* name;
    const DictionaryPrior* prior;
    DictionaryChoice choice;
  };
  const std::vector<Way> ways{{"evidence", &own, DictionaryChoice::evidence},
                              {"leave-one-out", &own, DictionaryChoice::leaveOneOut},
                              {"all signals alike", &alike, DictionaryChoice::evidence},
                              {"the same, leave-one-out", &alike, DictionaryChoice::leaveOneOut},
                              {"the same, cosine-log", &cosineLog, DictionaryChoice::evidence}};
  std::printf("| material | samples | principal components");
  for (const Way& way : ways) std::printf(" | %s", way.name);
  std::printf(" |\n");
  std::map<std::size_t, Eigen::ArrayXd> sums;
  for (const fs::path& file : options.tested) {
    const auto table = meanOfOrders(materials::readMaterial(file).tabulated());
    const RenderedComparison comparison(*table, {.width = 128, .height = 128, .samples = 16});
    const auto score = [&](const Brdf& found) { return comparison.signalToNoiseRatio(comparison.render(found)); };
    for (const fs::path& path : options.plans) {
      const SamplingPlan plan = acquisition::readPlan(path);
      const auto basis = materials::readBasis(fs::path(path).replace_extension(".basis"));
      const MeasuredValues values = measure(*table, plan);
      const auto ridge = reconstruct(basis->components, plan, values,
                                     {.ridge = std::nullopt, .components = 1 << 20, .uncertainty = false});
      Eigen::ArrayXd scores(Eigen::Index(ways.size()) + 1);
      scores[0] = score(*ridge.table);
      for (std::size_t way = 0; way < ways.size(); ++way)
        scores[Eigen::Index(way) + 1] = score(
            *reconstructInDictionaries(ensemble->ensemble, *ways[way].prior, plan, values, {.choice = ways[way].choice})
                 .table);
      print(file.stem(), plan.samples.size(), scores);
      Eigen::ArrayXd& sum = sums.try_emplace(plan.samples.size(), Eigen::ArrayXd::Zero(scores.size())).first->second;
      sum += scores;
    }
  }
  for (const auto& [samples, sum] : sums) print("mean", samples, sum / double(options.tested.size()));
  return 0;
}

int study(int count, char** arguments) { return run(count, arguments); }

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::dictionary_reconstruction_study
