// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/image_errors.h"

#include "core/metrics/colour_difference.h"
#include "core/metrics/flip.h"
#include "core/metrics/image_metrics.h"
#include "core/metrics/structural_similarity.h"

namespace gonio::metrics {

namespace {

constexpr std::string_view linearDomain = "linear radiance", displayDomain = "displayed: clamped to [0, 1]";

constexpr ImageMetricRecord imageRecords[] = {
    {"mse", "MSE", linearDomain, "<(r - t)^2>", "mean squared error", meanSquaredError},
    {"log-mse", "log MSE", linearDomain, "<(ln(1 + r) - ln(1 + t))^2>", "mean squared error of the logarithm",
     meanSquaredLogError},
    {"relative-mse", "relative MSE", linearDomain, "<(r - t)^2 / (r^2 + 0.01)>",
     "after Rousselle, Knaus and Zwicker 2011, \"Adaptive Sampling and Reconstruction using Greedy Error "
     "Minimization\"",
     relativeMeanSquaredError},
    {"ssim", "SSIM", "luminance, clamped to [0, 1], encoded as sRGB",
     "<(2 mr mt + C1)(2 crt + C2) / ((mr^2 + mt^2 + C1)(cr + ct + C2))>",
     "Wang, Bovik, Sheikh and Simoncelli 2004, \"Image Quality Assessment: From Error Visibility to Structural "
     "Similarity\"",
     structuralSimilarity, true},
    {"flip", "FLIP", displayDomain, "<colour error^(1 - feature error)>",
     "Andersson et al. 2020, \"FLIP: A Difference Evaluator for Alternating Images\"", flip},
    {"ciede2000", "CIEDE2000", displayDomain, "<dE00>",
     "Sharma, Wu and Dalal 2005, \"The CIEDE2000 Color-Difference Formula\"", meanColourDifference},
};

}  // namespace

std::span<const ImageMetricRecord> imageMetricRecords() { return imageRecords; }

std::vector<double> imageErrors(const Image& reference, const Image& test) {
  std::vector<double> errors;
  for (const ImageMetricRecord& record : imageRecords) errors.push_back(record.compute(reference, test));
  return errors;
}

}  // namespace gonio::metrics
