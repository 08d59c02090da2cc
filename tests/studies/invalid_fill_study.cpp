// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// gonio_studies invalid_fill [--every N] [--held-out N] FOLDER...: what the values in invalid cells do to dictionaries.
// Of the .binary files of the folders every Nth (7) is taken, and of these every Nth (4) is held out; two small
// ensembles are learned from the others: "held" as always, and "zero" from tables whose invalid cells are measured
// zeros. Rendered SNR of the held-out materials in comparisonScene() for codes over either, and, as "zero in both", of
// codes of tables whose invalid cells are zeros too. At the end the tables of comparison_records.h.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

#include "core/dictionary/training.h"
#include "core/materials/material.h"
#include "core/support/error.h"
#include "tests/studies/comparison_judge.h"
#include "tests/studies/held_out_models.h"
#include "tests/studies/study_program.h"

namespace gonio::study::invalid_fill_study {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t counts[] = {64, 262, 1024};
const dictionary::TrainingOptions training{
    .dictionaries = 4, .sparsities = {64, 256}, .iterations = 3, .subspaceLoss = 1e-4};

using Table = std::shared_ptr<const TabulatedBrdf>;

Table read(const fs::path& file) { return meanOfOrders(materials::readMaterial(file).tabulated()); }

/// Invalid cells hold 0 and count as measured. (A table stores 0 in them already.)
Table zeroFilled(const TabulatedBrdf& table) {
  return std::make_shared<const TabulatedBrdf>(
      table.grid(), std::vector<TabulatedBrdf::Value>(table.values().begin(), table.values().end()),
      std::vector<std::uint8_t>(table.values().size(), 1));
}

dictionary::Ensemble learn(const std::vector<fs::path>& files, bool zeros) {
  dictionary::TrainingMaterials materials{.names = {}, .grid = read(files.front())->grid(), .load = {}};
  for (const fs::path& file : files) materials.names.push_back(file.stem());
  materials.load = [&](std::size_t i) {
    const Table table = read(files[i]);
    return zeros ? zeroFilled(*table) : table;
  };
  return dictionary::train(materials, training).ensemble;
}

struct Options {
  std::size_t every = 7, heldOut = 4;
  std::vector<fs::path> files;

  Options(int count, char** values) {
    for (int i = 1; i < count; ++i) {
      const std::string value = values[i];
      const auto next = [&] { return i + 1 < count ? std::max<std::size_t>(2, std::stoul(values[++i])) : 2; };
      if (value == "--every")
        every = next();
      else if (value == "--held-out")
        heldOut = next();
      else
        for (const auto& entry : fs::directory_iterator(value))
          if (entry.path().extension() == ".binary") files.push_back(entry.path());
    }
    std::ranges::sort(files);
  }
};

void judge(const fs::path& file, const dictionary::Encoder& held, const dictionary::Encoder& zero,
           ComparisonRecords& records) {
  const ComparisonJudge court(file, collectionOf(file), {.width = 128, .height = 128, .samples = 16});
  const Table filled = zeroFilled(*court.table());
  for (const std::size_t count : counts) {
    const auto add = [&](const char* name, const dictionary::Encoder& encoder, const TabulatedBrdf& table) {
      const EnsembleModels models = ensembleModels(encoder, table, count);
      ComparisonRecord record = court.score(name, models.candidates[models.byGamma].model, 0);
      record.terms = int(count);
      records.add(record);
      std::printf("%-28s %-14s %4d %7.2f %7.2f\n", record.material.c_str(), name, record.terms, record.rendered,
                  record.reflectance);
      std::fflush(stdout);
    };
    add("held", held, *court.table());
    add("zero", zero, *court.table());
    add("zero in both", zero, *filled);
  }
}

int run(const Options& options) {
  std::vector<fs::path> learnedFrom, heldOut;
  for (std::size_t i = 0; i < options.files.size(); i += options.every)
    (i / options.every % options.heldOut == 0 ? heldOut : learnedFrom).push_back(options.files[i]);
  if (learnedFrom.empty()) {
    std::fprintf(stderr, "usage: gonio_studies invalid_fill [--every N] [--held-out N] FOLDER...\n");
    return 2;
  }
  std::printf("learning from %zu materials, %zu held out\n", learnedFrom.size(), heldOut.size());
  const dictionary::Ensemble ensembles[] = {learn(learnedFrom, false), learn(learnedFrom, true)};
  const dictionary::Encoder held(ensembles[0]), zero(ensembles[1]);
  ComparisonRecords records({});
  for (const fs::path& file : heldOut) judge(file, held, zero, records);
  std::printf("\n%s\n%s", summaryTable(records.all(), "coefficients").c_str(),
              aheadTable(records.all(), "held", "coefficients").c_str());
  return 0;
}

int study(int count, char** arguments) { return run(Options(count, arguments)); }

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::invalid_fill_study
