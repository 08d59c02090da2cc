// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// gonio_studies factor_measurement [--materials] FILE ...: the table of docs/results/factors.md of factor measurements
// from 20, 60 and 180 readings, without and with bound: median, mean and lowest rendered SNR over the files for each
// pair of axes, and the fraction of files with a warning. --materials prints a line for each file too.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <numeric>

#include "core/acquisition/factor_prediction.h"
#include "core/materials/material.h"
#include "core/rendering/render_picture.h"
#include "tests/studies/study_program.h"

namespace gonio::study::factor_measurement_study {
namespace {

using namespace acquisition;

/// Results of one pair of axes with one number of readings, a value per file.
struct Results {
  std::vector<double> printed, bounded;  ///< rendered SNR, dB
  int warned = 0;                        ///< files whose prediction is said to be unreliable
};

std::string summary(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  const double median = (values[(n - 1) / 2] + values[n / 2]) / 2;
  char text[80];
  std::snprintf(text, sizeof text, "%.2f | %.2f | %.2f", median,
                std::accumulate(values.begin(), values.end(), 0.0) / double(n), values.front());
  return text;
}

void measureFile(const std::filesystem::path& file, bool prints, std::map<std::pair<int, int>, Results>& results) {
  const auto table = meanOfOrders(materials::readMaterial(file).tabulated());
  const rendering::RenderedComparison comparison(*table, {.width = 128, .height = 128, .samples = 16});
  const auto snr = [&](const FactorMeasurement& m, FactorBound bound) {
    return comparison.signalToNoiseRatio(comparison.render(*predictFromFactors(m, bound)));
  };
  for (int axes = 0; axes < int(factorAxesNames.size()); ++axes)
    for (const int readings : {20, 60, 180}) {
      // The fixed angle of docs/results/acquisition-study.md.
      const FactorMeasurement m = measureFactors(
          *table, {.axes = FactorAxes(axes), .fixedAngle = 1, .angles = readings / 2, .distances = readings / 2});
      Results& result = results[{axes, readings}];
      result.printed.push_back(snr(m, FactorBound::none));
      result.bounded.push_back(snr(m, FactorBound::readings));
      const FactorSupport support = supportOf(m);
      result.warned += support.warnings.empty() ? 0 : 1;
      if (!prints) continue;
      std::printf("%-28s %-20s %3d %7.2f %7.2f dB  contradicted %.2f extrapolated %.2f bounded %.2f, %zu warnings\n",
                  file.stem().c_str(), factorAxesNames[std::size_t(axes)].data(), readings, result.printed.back(),
                  result.bounded.back(), support.contradicted, support.extrapolated, support.bounded,
                  support.warnings.size());
      std::fflush(stdout);
    }
}

int study(int argc, char** argv) {
  const bool prints = argc > 1 && std::string(argv[1]) == "--materials";
  std::map<std::pair<int, int>, Results> results;
  for (int i = prints ? 2 : 1; i < argc; ++i) measureFile(argv[i], prints, results);
  std::printf("| axes | m | none: median | mean | lowest | readings: median | mean | lowest | with a warning |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|\n");
  for (const auto& [key, result] : results)
    std::printf("| %s | %d | %s | %s | %d of %zu |\n", factorAxesNames[std::size_t(key.first)].data(), key.second,
                summary(result.printed).c_str(), summary(result.bounded).c_str(), result.warned, result.printed.size());
  return 0;
}

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::factor_measurement_study
