// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// gonio_studies factor_comparison [--size PIXELS] [--samples N] [--csv FILE] [--only ID]... [--npf FILE] [--materials]
// FILE...: how well factorisations keep materials at equal bytes. Budgets are the bytes of the three-factor PDV model
// of 1, 2, 5 and 10 terms, found one by one (pdv3) or fitted together (pdv3-joint), and twice as
// many terms over the compact nodes, fitted together (pdv3-compact); the two-factor form and each
// baseline get as many terms as a budget holds. A line a
// material, model and budget: rendered SNR and PSNR in comparisonScene(), SNR of the reflectances, bytes, seconds. At
// the end a table of means over the materials. With --csv records are kept in a file, and what is in it is not computed
// again; --only leaves other models out; --npf adds Bagher's published table for the materials that it names;
// --materials prints all materials at the largest budget. "symmetric" and "pdv-grid", with L = 0, are no models but
// bounds of them (comparison_bounds.h).
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/baselines/baselines.h"
#include "core/factorization/pdv_factors.h"
#include "core/formats/pdv.h"
#include "core/materials/npf_file.h"
#include "core/support/error.h"
#include "tests/studies/comparison_bounds.h"
#include "tests/studies/comparison_judge.h"
#include "tests/studies/comparison_records.h"
#include "tests/studies/study_program.h"

namespace gonio::study::factor_comparison_study {
using namespace gonio::baselines;
using namespace gonio::factorization;
using study::ComparisonRecord;
using study::ComparisonRecords;

namespace {

constexpr int budgetTerms[] = {1, 2, 5, 10};

struct Options {
  int size = 128, samples = 16;
  std::filesystem::path csv, npf;
  std::set<std::string> only;
  bool materials = false;
  std::vector<std::filesystem::path> files;

  Options(int count, char** values) {
    for (int i = 1; i < count; ++i) {
      const std::string value = values[i];
      const auto next = [&] { return i + 1 < count ? std::string(values[++i]) : std::string(); };
      if (value == "--size")
        size = std::stoi(next());
      else if (value == "--samples")
        samples = std::stoi(next());
      else if (value == "--csv")
        csv = next();
      else if (value == "--npf")
        npf = next();
      else if (value == "--only")
        only.insert(next());
      else if (value == "--materials")
        materials = true;
      else
        files.emplace_back(value);
    }
  }
};

/// Bytes of the three-factor PDV model, by the axes of a factorisation of no account.
std::vector<std::size_t> byteBudgets() {
  std::vector<std::size_t> budgets;
  PdvFactors factors{.thetaNodes = std::vector<double>(90),
                     .deviationNodes = std::vector<double>(90),
                     .phiNodes = std::vector<double>(180),
                     .channels = {}};
  for (const int terms : budgetTerms) {
    for (auto& channel : factors.channels) channel.resize(std::size_t(terms));
    budgets.push_back(formats::pdvFileBytes(factors));
  }
  return budgets;
}

using Table = std::shared_ptr<const TabulatedBrdf>;
/// Models of all budgets, in their order; of a bound one.
using Build = std::function<std::vector<ComparedModel>(const Table& table, std::span<const std::size_t> budgets)>;
struct Contestant {
  std::string id;
  Build build;
  bool isBound = false;

  int lastTerms() const { return isBound ? 0 : *std::rbegin(budgetTerms); }
};

std::vector<ComparedModel> buildPdv(const TabulatedBrdf& table, std::span<const std::size_t> budgets, PdvForm form) {
  const auto bytesOf = [](const PdvFactors& f) { return formats::pdvFileBytes(f); };
  const PdvFactors one = factorizePdv(table, {.form = form, .terms = 1}).factors;
  const std::size_t first = bytesOf(one);
  PdvFactors two = one;
  for (auto& channel : two.channels) channel.push_back(channel.front());
  const std::size_t term = bytesOf(two) - first;
  std::vector<int> terms;
  for (const std::size_t budget : budgets)
    terms.push_back(std::clamp(1 + int((std::max(budget, first) - first) / term), 1, maxPdvTerms));
  const PdvFactors all =
      factorizePdv(table, {.form = form, .terms = *std::max_element(terms.begin(), terms.end())}).factors;
  std::vector<ComparedModel> models;
  for (const int count : terms) {
    const PdvFactors factors = all.truncated(count);
    models.push_back({makePdvBrdf(factors), bytesOf(factors)});
  }
  return models;
}

/// A fit of its own for each budget: fewer terms of a joint fit are not the best ones.
std::vector<ComparedModel> buildJointPdv(const TabulatedBrdf& table, bool compact) {
  std::vector<ComparedModel> models;
  for (const int terms : budgetTerms) {
    const PdvFactors factors = factorizePdv(table, compact ? compactPdvOptions({.terms = 2 * terms, .joint = true})
                                                           : PdvOptions{.terms = terms, .joint = true})
                                   .factors;
    models.push_back({makePdvBrdf(factors), formats::pdvFileBytes(factors)});
  }
  return models;
}

std::vector<Contestant> contestants(const Options& options) {
  const auto bound = [](auto make) {
    return [make](const Table& table, auto) { return std::vector<ComparedModel>{{make(table), 0}}; };
  };
  std::vector<Contestant> all = {
      {"symmetric", bound(study::symmetricMean), true},
      {"pdv-grid", bound(study::deviationGrid), true},
      {"pdv3", [](const Table& table, auto budgets) { return buildPdv(*table, budgets, PdvForm::threeFactors); }},
      {"pdv3-joint", [](const Table& table, auto) { return buildJointPdv(*table, false); }},
      {"pdv3-compact", [](const Table& table, auto) { return buildJointPdv(*table, true); }},
      {"pdv2", [](const Table& table, auto budgets) { return buildPdv(*table, budgets, PdvForm::twoFactors); }}};
  for (const Baseline& baseline : baselines::allBaselines())
    all.push_back({std::string(baseline.id),
                   [build = baseline.build](const Table& table, auto budgets) { return build(*table, budgets, {}); }});
  if (!options.only.empty()) std::erase_if(all, [&](const Contestant& c) { return !options.only.contains(c.id); });
  return all;
}

/// Adds the records of one contestant for one material.
void judge(const study::ComparisonJudge& court, const Contestant& contestant, const std::vector<std::size_t>& budgets,
           ComparisonRecords& records) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<ComparedModel> models = contestant.build(court.table(), budgets);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ComparisonRecord record;
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (i == 0 || models[i].brdf != models[i - 1].brdf) record = court.score(contestant.id, models[i], seconds);
    record.terms = contestant.isBound ? 0 : budgetTerms[i];
    records.add(record);
    std::printf("%-28s %-14s %3d %7.2f %7.2f %7.2f %7.1f %6.2f\n", record.material.c_str(), record.model.c_str(),
                record.terms, record.rendered, record.peak, record.reflectance, double(record.bytes) / 1000, seconds);
    std::fflush(stdout);
  }
}

int run(const Options& options) {
  if (options.files.empty()) {
    std::fprintf(
        stderr,
        "usage: gonio_studies factor_comparison [--size PIXELS] [--samples N] [--csv FILE] [--only ID]... [--npf FILE] "
        "[--materials] FILE...\n");
    return 2;
  }
  ComparisonRecords records(options.csv);
  const std::vector<std::size_t> budgets = byteBudgets();
  const std::optional<materials::NpfTable> published =
      options.npf.empty() ? std::nullopt : std::optional(materials::readNpf(options.npf));
  std::printf("material                     model            L     SNR    PSNR    BRDF      KB      s\n");
  for (const std::filesystem::path& file : options.files) {
    std::vector<Contestant> all = contestants(options);
    if (const NonparametricFactors* factors = published ? published->find(file.stem().string()) : nullptr)
      all.push_back(
          {"npf-published", [factors](const Table&, auto sizes) {
             return std::vector<ComparedModel>(sizes.size(), {makeNonparametricBrdf(*factors), factors->bytes()});
           }});
    std::erase_if(all, [&](const Contestant& c) { return records.contains(file.stem(), c.id, c.lastTerms()); });
    if (all.empty()) continue;
    const study::ComparisonJudge court(file, file.extension() == ".bsdf" ? "RGL" : "MERL",
                                       {.width = options.size, .height = options.size, .samples = options.samples});
    for (const Contestant& contestant : all) judge(court, contestant, budgets, records);
  }
  std::printf("\n%s", summaryTable(records.all()).c_str());
  if (options.materials) std::printf("\n%s", materialTable(records.all(), *std::rbegin(budgetTerms)).c_str());
  return 0;
}

int study(int count, char** arguments) { return run(Options(count, arguments)); }

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::factor_comparison_study
