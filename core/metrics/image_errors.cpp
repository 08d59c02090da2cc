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
    {"mse", "MSE", linearDomain, "mean((r - t)^2), r: reference, t: test image", "mean squared error",
     meanSquaredError},
    {"log-mse", "log MSE", linearDomain, "mean((ln(1 + r) - ln(1 + t))^2), r: reference, t: test image",
     "mean squared error of the logarithm", meanSquaredLogError},
    {"relative-mse", "relative MSE", linearDomain, "mean((r - t)^2 / (r^2 + 0.01)), r: reference, t: test image",
     "after Rousselle, Knaus and Zwicker 2011, Adaptive Sampling and Reconstruction using Greedy Error "
     "Minimization",
     relativeMeanSquaredError},
    {"ssim", "SSIM", "luminance, clamped to [0, 1], encoded as sRGB",
     "mean((2 mu_r mu_t + C_1)(2 sigma_rt + C_2) / ((mu_r^2 + mu_t^2 + C_1)(sigma_r^2 + sigma_t^2 + C_2))); mu, "
     "sigma^2 and sigma_rt: local means, variances and covariance of the reference r and the test image t, "
     "C_1 = 0.01^2, C_2 = 0.03^2",
     "Wang, Bovik, Sheikh and Simoncelli 2004, Image Quality Assessment: From Error Visibility to Structural "
     "Similarity",
     structuralSimilarity, true},
    {"flip", "FLIP", displayDomain, "mean(colour error^(1 - feature error))",
     "Andersson et al. 2020, FLIP: A Difference Evaluator for Alternating Images", flip},
    {"ciede2000", "CIEDE2000", displayDomain, "mean(Delta E_00)",
     "Sharma, Wu and Dalal 2005, The CIEDE2000 Color-Difference Formula", meanColourDifference},
};

}  // namespace

std::span<const ImageMetricRecord> imageMetricRecords() { return imageRecords; }

std::vector<double> imageErrors(const Image& reference, const Image& test) {
  std::vector<double> errors;
  for (const ImageMetricRecord& record : imageRecords) errors.push_back(record.compute(reference, test));
  return errors;
}

}  // namespace gonio::metrics
