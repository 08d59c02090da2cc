// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// factor_comparison_study [--size PIXELS] [--samples N] [--budget BYTES] [--without ID]... FILE...: how well
// factorisations keep materials: the PDV model in both forms with 1, 2, 5 and 10 terms, and each rival with as many
// bytes as the first budget that is given (default: the three-factor PDV model of 10 terms). A line a material and
// model: rendered SNR and PSNR in comparisonScene(), SNR of the reflectances, bytes, seconds. At the end the means over
// the materials, and how often the model is the best of all in rendered SNR.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/factorization/pdv_factors.h"
#include "core/io/pdv_file.h"
#include "core/factorization/rivals/rivals.h"
#include "core/io/material.h"
#include "core/metrics/brdf_metrics.h"
#include "core/metrics/image_metrics.h"
#include "core/rendering/rendered_comparison.h"
#include "core/support/error.h"

using namespace gonio;
using namespace gonio::factorization;

namespace {

struct Options {
  int size = 128, samples = 16;
  std::size_t budget = 43'560;
  std::set<std::string> without;
  std::vector<std::filesystem::path> files;

  Options(int count, char** values) {
    for (int i = 1; i < count; ++i) {
      const std::string value = values[i];
      const auto next = [&] { return i + 1 < count ? std::string(values[++i]) : std::string(); };
      if (value == "--size")
        size = std::stoi(next());
      else if (value == "--samples")
        samples = std::stoi(next());
      else if (value == "--budget")
        budget = std::stoul(next());
      else if (value == "--without")
        without.insert(next());
      else
        files.emplace_back(value);
    }
  }
};

struct Scores {
  double rendered = 0, peak = 0, reflectance = 0, kilobytes = 0, seconds = 0;
};

using Table = std::vector<std::pair<std::string, Scores>>;  ///< one material, models in order

/// Scores models of one material against its table.
class Judge {
 public:
  Judge(std::string material, const TabulatedBrdf& table, const Options& options)
      : material_(std::move(material)),
        table_(table),
        comparison_(table, {.width = options.size, .height = options.size, .samples = options.samples}) {}

  void add(const std::string& model, const Brdf& brdf, std::size_t bytes, double seconds) {
    const Image picture = comparison_.render(brdf);
    const Scores s{.rendered = comparison_.signalToNoiseRatio(picture),
                   .peak = metrics::peakSignalToNoiseRatio(comparison_.reference(), picture),
                   .reflectance = metrics::brdfSignalToNoiseRatio(table_, brdf),
                   .kilobytes = double(bytes) / 1000,
                   .seconds = seconds};
    std::printf("%-28s %-14s %7.2f %7.2f %7.2f %7.1f %6.2f\n", material_.c_str(), model.c_str(), s.rendered, s.peak,
                s.reflectance, s.kilobytes, s.seconds);
    std::fflush(stdout);
    scores.emplace_back(model, s);
  }

  Table scores;

 private:
  std::string material_;
  const TabulatedBrdf& table_;
  RenderedComparison comparison_;
};

void addPdv(Judge& judge, const TabulatedBrdf& table, const std::string& name, PdvForm form) {
  const PdvFactorization all = factorizePdv(table, {.form = form});
  for (const int terms : {1, 2, 5, 10}) {
    const PdvFactors factors = all.factors.truncated(terms);
    judge.add(name + " L=" + std::to_string(terms), *makePdvBrdf(factors), io::pdvFileBytes(factors), all.seconds);
  }
}

Table compare(const std::filesystem::path& file, const Options& options) {
  const auto table = io::readMaterial(file).tabulated();
  Judge judge(file.stem(), *table, options);
  if (!options.without.contains("pdv3")) addPdv(judge, *table, "pdv3", PdvForm::threeFactors);
  if (!options.without.contains("pdv2")) addPdv(judge, *table, "pdv2", PdvForm::twoFactors);
  for (const Rival& rival : rivals()) {
    if (options.without.contains(std::string(rival.id))) continue;
    const RivalModel model = rival.build(*table, options.budget, {});
    judge.add(std::string(rival.id), *model.brdf, model.bytes, model.seconds);
  }
  return judge.scores;
}

void printMeans(const std::vector<Table>& materials) {
  if (materials.empty()) return;
  std::printf("\n%zu materials        mean SNR    PSNR    BRDF      KB      s   best of\n", materials.size());
  for (std::size_t m = 0; m < materials.front().size(); ++m) {
    Scores sum;
    double count = 0;
    int best = 0;
    for (const Table& table : materials) {
      const Scores& s = table[m].second;
      // Black materials have no ratio.
      if (!std::isfinite(s.rendered) || !std::isfinite(s.reflectance)) continue;
      ++count;
      sum = {sum.rendered + s.rendered, sum.peak + s.peak, sum.reflectance + s.reflectance, sum.kilobytes + s.kilobytes,
             sum.seconds + s.seconds};
      bool isBest = true;
      for (const auto& [name, other] : table) isBest = isBest && !(other.rendered > s.rendered);
      best += isBest;
    }
    std::printf("%-20s %8.2f %8.2f %7.2f %7.1f %6.2f %4d\n", materials.front()[m].first.c_str(), sum.rendered / count,
                sum.peak / count, sum.reflectance / count, sum.kilobytes / count, sum.seconds / count, best);
  }
}

int run(const Options& options) {
  if (options.files.empty()) {
    std::fprintf(stderr,
                 "usage: factor_comparison_study [--size PIXELS] [--samples N] [--budget BYTES] [--without ID]... "
                 "FILE...\n");
    return 2;
  }
  std::printf("material                     model              SNR    PSNR    BRDF      KB      s\n");
  std::vector<Table> materials;
  for (const std::filesystem::path& file : options.files) materials.push_back(compare(file, options));
  printMeans(materials);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    return run(Options(count, arguments));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
