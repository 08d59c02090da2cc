// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/brdf_metric.h"

#include <array>
#include <string>

#include "core/math/colour.h"
#include "core/support/error.h"

namespace gonio::metrics {

namespace {

/// CIE 15:2004, equations 8.6 and following. Both branches are computed, so that loops over it become vector code.
[[gnu::always_inline]] inline double labRoot(double t) {
  constexpr double edge = 6.0 / 29;
  const double root = fastCbrt(t), line = t / (3 * edge * edge) + 4.0 / 29;
  return t > edge * edge * edge ? root : line;
}

/// XYZ of reflectances, each over that of the perfect diffuser.
[[gnu::always_inline]] inline Rgb diffuserRelative(double red, double green, double blue) {
  return whiteRelativeXyz(red * pi, green * pi, blue * pi);
}

}  // namespace

Rgb labOf(const Rgb& value) {
  const Rgb white = diffuserRelative(value.x, value.y, value.z);
  const double fx = labRoot(white.x), fy = labRoot(white.y), fz = labRoot(white.z);
  return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

void labDifferences(const Eigen::Array3Xd& reference, const Eigen::Array3Xd& test, Eigen::Array3Xd& differences) {
  constexpr Eigen::Index block = 128;
  double r[3 * block], t[3 * block];  // roots of XYZ
  for (Eigen::Index begin = 0; begin < reference.cols(); begin += block) {
    const Eigen::Index count = std::min(block, reference.cols() - begin);
    const double *a = reference.data() + 3 * begin, *b = test.data() + 3 * begin;
    for (Eigen::Index i = 0; i < 3 * count; i += 3) {
      const Rgb whiteA = diffuserRelative(a[i], a[i + 1], a[i + 2]),
                whiteB = diffuserRelative(b[i], b[i + 1], b[i + 2]);
      for (int c = 0; c < 3; ++c) {
        r[i + c] = whiteA[c];
        t[i + c] = whiteB[c];
      }
    }
    // The constants of L*, a* and b* cancel.
    for (Eigen::Index i = 0; i < 3 * count; ++i) r[i] = labRoot(r[i]) - labRoot(t[i]);
    double* d = differences.data() + 3 * begin;
    for (Eigen::Index i = 0; i < 3 * count; i += 3) {
      d[i] = 116 * r[i + 1];
      d[i + 1] = 500 * (r[i] - r[i + 1]);
      d[i + 2] = 200 * (r[i + 1] - r[i + 2]);
    }
  }
}

namespace {

constexpr std::string_view bieronPeers =
    "Bieron and Peers 2020, An Adaptive BRDF Fitting Metric, Computer Graphics Forum 39(4)";
constexpr std::string_view lavoue =
    "Lavoué et al. 2021, Perceptual Quality of BRDF Approximations: Dataset and Metrics (there a mean over angles, not "
    "solid angles, and optionally of cube roots)";

// clang-format off
constexpr std::array records{
    MetricRecord{
        .metric = BrdfMetric::log, .id = "log", .alias = "loew-e2", .name = "Log error",
        .formula = "sqrt mean(d^2), d: difference of ln(1 + rho cos theta_i)", .unit = "",
        .reference = "Löw et al. 2012, BRDF Models for Accurate and Efficient Rendering of Glossy Surfaces, E2",
        .factor = MetricFactor::cosI, .domain = MetricDomain::log, .power = MetricPower::square},
    MetricRecord{
        .metric = BrdfMetric::cosineL2, .id = "cosine-l2", .alias = "loew-e1", .name = "Cosine-weighted L2",
        .formula = "sqrt mean(d^2), d: difference of rho cos theta_i", .unit = "1/sr",
        .reference = "Ngan et al. 2005, Experimental Analysis of BRDF Models; weighted by solid angles it is also E1 "
                     "of Löw et al. 2012 and the second distance of Lavoué et al. 2021",
        .factor = MetricFactor::cosI, .domain = MetricDomain::linear, .power = MetricPower::square},
    MetricRecord{
        .metric = BrdfMetric::cubeRoot, .id = "cube-root", .alias = "", .name = "Cube-root error",
        .formula = "sqrt mean(d^2), d: difference of (rho cos theta_i)^(1/3)", .unit = "sr^(-1/3)",
        .reference = bieronPeers,
        .factor = MetricFactor::cosI, .domain = MetricDomain::cubeRoot, .power = MetricPower::square},
    MetricRecord{
        .metric = BrdfMetric::meanAbsoluteLog, .id = "mean-absolute-log", .alias = "",
        .name = "Mean absolute log error",
        .formula = "mean(|d|), d: difference of ln(1 + rho cos theta_i)", .unit = "",
        .reference = "Sztrajman et al. 2021, Neural BRDF Representation and Importance Sampling",
        .factor = MetricFactor::cosI, .domain = MetricDomain::log, .power = MetricPower::absolute, .isRoot = false},
    MetricRecord{
        .metric = BrdfMetric::bieronPeersLog, .id = "bieron-peers-log", .alias = "",
        .name = "Log error, projected solid angle",
        .formula = "sqrt mean(d^2 cos theta_o), d: difference of ln(1 + rho cos theta_i)", .unit = "",
        .reference = bieronPeers,
        .factor = MetricFactor::cosI, .domain = MetricDomain::log, .power = MetricPower::square,
        .weight = MetricWeight::cosO},
    MetricRecord{
        .metric = BrdfMetric::gamma, .id = "gamma", .alias = "", .name = "Gamma",
        .formula = "sqrt mean(d^2), d: difference of (rho cos theta_i)^(1/g), g from 1 to 3", .unit = "sr^(-1/g)",
        .reference = bieronPeers,
        .factor = MetricFactor::cosI, .domain = MetricDomain::gamma, .power = MetricPower::square},
    MetricRecord{
        .metric = BrdfMetric::logRelative, .id = "log-relative", .alias = "lavoue-log-rms",
        .name = "Relative log error",
        .formula = "sqrt mean(d^2), d: difference of ln(rho max(cos theta_i cos theta_o, e) + e), e = 0.001",
        .unit = "",
        .reference = "Nielsen et al. 2015, On Optimal, Minimal BRDF Sampling for Reflectance Acquisition; the ninth "
                     "distance of Lavoué et al. 2021",
        .factor = MetricFactor::cosines, .domain = MetricDomain::logRelative, .power = MetricPower::square},
    MetricRecord{
        .metric = BrdfMetric::rms, .id = "rms", .alias = "", .name = "RMS error",
        .formula = "sqrt mean(d^2), d: difference of rho", .unit = "1/sr", .reference = lavoue,
        .factor = MetricFactor::one, .domain = MetricDomain::linear, .power = MetricPower::square},
    MetricRecord{
        .metric = BrdfMetric::cosineCubeRoot, .id = "cosine-cube-root", .alias = "",
        .name = "Cosine-weighted, cube root",
        .formula = "sqrt mean(|d|^(2/3)), d: difference of rho cos theta_i", .unit = "sr^(-1/3)",
        .reference = "Fores et al. 2012, Toward a Perceptually Based Metric for BRDF Modeling; the third distance of "
                     "Lavoué et al. 2021",
        .factor = MetricFactor::cosI, .domain = MetricDomain::linear, .power = MetricPower::twoThirds},
    MetricRecord{
        .metric = BrdfMetric::projectedRms, .id = "projected-rms", .alias = "",
        .name = "RMS error, projected solid angle",
        .formula = "sqrt mean(d^2 cos theta_o), d: difference of rho", .unit = "1/sr", .reference = lavoue,
        .factor = MetricFactor::one, .domain = MetricDomain::linear, .power = MetricPower::square,
        .weight = MetricWeight::cosO},
    MetricRecord{
        .metric = BrdfMetric::meanAbsolute, .id = "mean-absolute", .alias = "", .name = "Mean absolute error",
        .formula = "mean(|d|), d: difference of rho", .unit = "1/sr", .reference = lavoue,
        .factor = MetricFactor::one, .domain = MetricDomain::linear, .power = MetricPower::absolute, .isRoot = false},
    MetricRecord{
        .metric = BrdfMetric::cosinesCubeRoot, .id = "cosines-cube-root", .alias = "",
        .name = "Both cosines, cube root",
        .formula = "mean(|d|^(2/3)), d: difference of rho max(cos theta_i cos theta_o, e), e = 0.001",
        .unit = "sr^(-2/3)",
        .reference = "Sun et al. 2018, Connecting Measured BRDFs to Analytic BRDFs by Data-Driven Diffuse-Specular "
                     "Separation; the seventh distance of Lavoué et al. 2021",
        .factor = MetricFactor::cosines, .domain = MetricDomain::linear, .power = MetricPower::twoThirds,
        .isRoot = false},
    MetricRecord{
        .metric = BrdfMetric::meanAbsoluteLogRelative, .id = "mean-absolute-log-relative", .alias = "",
        .name = "Mean absolute relative log error",
        .formula = "mean(|d|), d: difference of ln(rho max(cos theta_i cos theta_o, e) + e), e = 0.001", .unit = "",
        .reference = lavoue,
        .factor = MetricFactor::cosines, .domain = MetricDomain::logRelative, .power = MetricPower::absolute,
        .isRoot = false},
    MetricRecord{
        .metric = BrdfMetric::lab, .id = "lab", .alias = "", .name = "CIE L*a*b*",
        .formula = "sqrt mean(Delta E^2 cos theta_i cos theta_o), Delta E: CIE 1976 colour difference of pi rho",
        .unit = "Delta E",
        .reference = "After the sixth distance of Lavoué et al. 2021; white is the perfect diffuser, D65",
        .factor = MetricFactor::one, .domain = MetricDomain::lab, .power = MetricPower::square,
        .weight = MetricWeight::cosines, .minimisable = false},
};
// clang-format on

constexpr auto metricsOf() {
  std::array<BrdfMetric, records.size()> metrics{};
  for (std::size_t i = 0; i < records.size(); ++i) metrics[i] = records[i].metric;
  return metrics;
}
constexpr std::array metrics = metricsOf();

/// metricRecord() finds a record by the value of its metric.
constexpr bool isOrdered() {
  for (std::size_t i = 0; i < records.size(); ++i)
    if (static_cast<std::size_t>(records[i].metric) != i) return false;
  return true;
}
static_assert(isOrdered());

constexpr std::size_t minimisableCount = records.size() - 1;
static_assert(records[minimisableCount - 1].minimisable && !records[minimisableCount].minimisable);

}  // namespace

std::span<const MetricRecord> metricRecords() { return records; }
const MetricRecord& metricRecord(BrdfMetric metric) { return records[static_cast<std::size_t>(metric)]; }
std::span<const BrdfMetric> allBrdfMetrics() { return metrics; }
std::span<const BrdfMetric> minimisableMetrics() { return std::span(metrics).first(minimisableCount); }
std::string_view metricId(BrdfMetric metric) { return metricRecord(metric).id; }

BrdfMetric metricByName(std::string_view name) {
  std::string known;
  for (const MetricRecord& record : records) {
    if (record.id == name || (!record.alias.empty() && record.alias == name)) return record.metric;
    known += (known.empty() ? "" : ", ") + std::string(record.id);
  }
  throw Error("found the metric '" + std::string(name) + "', expected one of " + known);
}

}  // namespace gonio::metrics
