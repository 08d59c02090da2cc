// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/sgd.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/exponential.hpp>

#include "core/brdf/value_bound.h"
#include "core/math/fast_functions.h"
#include "core/math/special_functions.h"
#include "core/models/common_parameters.h"
#include "core/models/registry.h"
#include "core/models/surface_geometry.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

namespace {

constexpr std::string_view bagher =
    "Bagher, Soler and Holzschuch 2012, Accurate Fitting of Measured Reflectances using a Shifted Gamma Micro-facet "
    "Distribution";
constexpr std::string_view distributionFormula =
    "D = K exp(-A) / (pi A^p cos^4 theta_h), A = alpha + tan^2 theta_h / alpha, K = 1 / (alpha Gamma(1 - p, alpha))";
constexpr std::string_view fresnelFormula = "F = max(0, F_0 - F_1 cos theta_d + (1 - F_0)(1 - cos theta_d)^5)";
constexpr std::string_view maskingFormula = "G1 = clamp(1 - lambda (exp(c max(0, theta - theta_0)^k) - 1), 0, 1)";

enum Index { diffuse, specular, alpha, power, f0, f1, lambda, maskingScale, maskingPower, theta0 };

// clang-format off
// The hard ranges admit every published row of the 100 MERL materials (c reaches 1e109, lambda 1.5e7).
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    specularParameter(1, "k_s F D G1(theta_i) G1(theta_o) / (pi cos theta_i cos theta_o)", bagher),
    {.id = "alpha", .label = "Width", .symbol = "alpha", .unit = "",
     .softMin = 1e-4, .softMax = 1, .hardMin = 1e-6, .hardMax = 10, .defaultValue = 0.03,
     .scale = ParameterScale::logarithmic, .perChannel = true,
     .description = "Width of the core of the highlight; small values are glossy.",
     .formula = distributionFormula, .reference = bagher, .role = ParameterRole::width},
    {.id = "p", .label = "Tail", .symbol = "p", .unit = "",
     .softMin = 0, .softMax = 2, .hardMin = 0, .hardMax = 5, .defaultValue = 0.5,
     .perChannel = true,
     .description = "How fast the core falls off before the exponential tail; 0 is an exponential.",
     .formula = distributionFormula, .reference = bagher},
    {.id = "f0", .label = "Fresnel F0", .symbol = "F_0", .unit = "",
     .softMin = 0, .softMax = 1, .hardMin = 0, .hardMax = 20, .defaultValue = 0.04,
     .group = ParameterGroup::fresnel, .perChannel = true,
     .description = "Reflectance at normal incidence (together with F1); published fits go above 1.",
     .formula = fresnelFormula, .reference = bagher},
    {.id = "f1", .label = "Fresnel F1", .symbol = "F_1", .unit = "",
     .softMin = -1, .softMax = 1, .hardMin = -20, .hardMax = 20, .defaultValue = 0,
     .group = ParameterGroup::fresnel, .perChannel = true,
     .description = "Correction of the Fresnel curve that grows towards normal incidence; 0 is Schlick's curve.",
     .formula = fresnelFormula, .reference = bagher},
    {.id = "lambda", .label = "Shadowing strength", .symbol = "lambda", .unit = "",
     .softMin = 1e-3, .softMax = 1e3, .hardMin = 1e-12, .hardMax = 1e12, .defaultValue = 2.7,
     .scale = ParameterScale::logarithmic, .group = ParameterGroup::shadowing, .perChannel = true,
     .description = "How strongly the microfacets hide each other towards grazing angles.",
     .formula = maskingFormula, .reference = bagher},
    {.id = "c", .label = "Shadowing scale", .symbol = "c", .unit = "",
     .softMin = 1e-8, .softMax = 1e4, .hardMin = 1e-12, .hardMax = 1e120, .defaultValue = 1e-7,
     .scale = ParameterScale::logarithmic, .group = ParameterGroup::shadowing, .perChannel = true,
     .description = "Scale of the shadowing's growth with the angle; spans many decades because of the power k.",
     .formula = maskingFormula, .reference = bagher},
    {.id = "k", .label = "Shadowing power", .symbol = "k", .unit = "",
     .softMin = 5, .softMax = 100, .hardMin = 0.1, .hardMax = 2000, .defaultValue = 36,
     .scale = ParameterScale::logarithmic, .group = ParameterGroup::shadowing, .perChannel = true,
     .description = "How abruptly the shadowing begins.",
     .formula = maskingFormula, .reference = bagher},
    {.id = "theta0", .label = "Shadowing onset", .symbol = "theta_0", .unit = "rad",
     .softMin = -0.7, .softMax = 1.3, .hardMin = -halfPi, .hardMax = halfPi, .defaultValue = 0.07,
     .scale = ParameterScale::angle, .group = ParameterGroup::shadowing, .perChannel = true,
     .description = "Polar angle below which nothing is shadowed.",
     .formula = maskingFormula, .reference = bagher},
};

constexpr ModelSpec sgdSpec = {
    .id = "sgd", .name = "SGD",
    .description = "Shifted gamma distribution of microfacets, made to fit measured materials closely. Reciprocal. Its "
                   "Fresnel term is a fit (may exceed 1), so nothing bounds the energy.",
    .formula = "(k_d + k_s F D G1(theta_i) G1(theta_o) / (cos theta_i cos theta_o)) / pi",
    .reference = bagher, .parameters = parameters};
// clang-format on

/// One colour channel with everything that does not depend on directions.
struct Channel {
  double diffuse, specular;  ///< both already over pi
  double alpha, inverseAlpha, power, logNormalisation;
  double f0, f1;
  double lambda, logMaskingScale, maskingPower, theta0;
};

Channel makeChannel(const ParameterValues& p, int channel) {
  const auto value = [&](Index index) { return p.values[index][channel]; };
  return {.diffuse = value(diffuse) / pi,
          .specular = value(specular) / (pi * pi),
          .alpha = value(alpha),
          .inverseAlpha = 1 / value(alpha),
          .power = value(power),
          .logNormalisation = sgdLogNormalisation(value(alpha), value(power)),
          .f0 = value(f0),
          .f1 = value(f1),
          .lambda = value(lambda),
          .logMaskingScale = std::log(value(maskingScale)),
          .maskingPower = value(maskingPower),
          .theta0 = value(theta0)};
}

[[gnu::always_inline]] inline double masking(const Channel& c, double theta) {
  return sgdMasking(theta, c.lambda, c.logMaskingScale, c.maskingPower, c.theta0);
}

struct Angles {
  double thetaI, thetaO, tan2H, log4CosH, oneMinusCosD5, inverseCosines;
};

[[gnu::always_inline]] inline double evaluateChannel(const Channel& c, const SurfaceGeometry& g, const Angles& a) {
  const double shifted = c.alpha + a.tan2H * c.inverseAlpha;
  // In log space: exp(-A) underflows where 1 / cos^4 overflows. pi is in Channel::specular.
  const double distribution = fastExp(c.logNormalisation - shifted - c.power * fastLog(shifted) - a.log4CosH);
  const double fresnel = std::max(0.0, c.f0 - c.f1 * g.cosD + (1 - c.f0) * a.oneMinusCosD5);
  const double lobe = fresnel * distribution * masking(c, a.thetaI) * masking(c, a.thetaO) * a.inverseCosines;
  return c.diffuse + (c.specular == 0 ? 0.0 : c.specular * lobe);
}

/// The distribution of all channels, each by its strength.
TabulatedNormals makeNormals(const std::array<Channel, 3>& channels) {
  return TabulatedNormals([&](double thetaH) {
    const double logCosH = std::log(std::cos(thetaH)), tan2H = std::tan(thetaH) * std::tan(thetaH);
    double sum = 0;
    for (const Channel& c : channels) {
      const double shifted = c.alpha + tan2H * c.inverseAlpha;
      sum += c.specular * std::exp(c.logNormalisation - shifted - c.power * std::log(shifted) - 3 * logCosH);
    }
    return sum;
  });
}

/// The largest ln D over a range of x = tan^2 theta_h, where ln D = ln K - y - p ln y + 2 ln(1 + x), y = alpha + x /
/// alpha. Its derivative vanishes at the roots of a quadratic polynomial.
double highestLogDistribution(const Channel& c, const Range& x) {
  const auto at = [&c](double tan2) {
    const double y = c.alpha + tan2 * c.inverseAlpha;
    return tan2 < 1e300 ? c.logNormalisation - y - c.power * std::log(y) + 2 * std::log1p(tan2)
                        : -std::numeric_limits<double>::infinity();
  };
  double highest = std::max(at(x.low), at(x.high));
  const double square = -c.inverseAlpha, linear = 2 - c.alpha - c.inverseAlpha - c.power,
               constant = 2 * c.alpha * c.alpha - c.alpha - c.power;
  const double discriminant = linear * linear - 4 * square * constant;
  for (const double sign : {-1.0, 1.0}) {
    const double root = (-linear + sign * std::sqrt(std::max(0.0, discriminant))) / (2 * square);
    if (discriminant >= 0 && x.contains(root)) highest = std::max(highest, at(root));
  }
  return highest;
}

/// The factors of evaluateChannel(), each over its range.
class SgdBound final : public ValueBound {
 public:
  explicit SgdBound(const std::array<Channel, 3>& channels) : channels_(channels) {}

  RgbRange over(const PairBox& box) const override {
    const Range cosI = max(box.cosI, Range(horizonTolerance)), cosO = max(box.cosO, Range(horizonTolerance));
    const Range tan2H = square(box.sinH) / square(box.cosH), m = Range(1) - box.cosD;
    const Range thetaI = box.thetaI();
    RgbRange result;
    for (int i = 0; i < 3; ++i) {
      const Channel& c = channels_[std::size_t(i)];
      const Range polynomial = Range(c.f0) - Range(c.f1) * box.cosD +
                               Range(1 - c.f0) * increasing(m, [](double x) { return x * x * x * x * x; });
      const Range fresnel = max(Range(0), polynomial);
      // G1 falls with the angle.
      const Range lobe = fresnel * Range(0, std::exp(highestLogDistribution(c, tan2H))) *
                         Range(0, masking(c, thetaI.low) / cosI.low) * Range(0, masking(c, box.thetaO.low) / cosO.low);
      const Range value = Range(c.diffuse) + Range(c.specular) * lobe;
      result.low[i] = value.low;
      result.high[i] = value.high;
    }
    return result;
  }

 private:
  std::array<Channel, 3> channels_;
};

struct SgdFunction {
  std::array<Channel, 3> channels;

  [[gnu::always_inline]] Rgb operator()(const SurfaceGeometry& g) const {
    const double cos2H = g.h.z * g.h.z, m = 1 - g.cosD;
    const auto theta = [](const Direction& w) { return fastAtan2(std::sqrt(w.x * w.x + w.y * w.y), w.z); };
    const Angles angles{.thetaI = theta(g.wi),
                        .thetaO = theta(g.wo),
                        .tan2H = g.sin2H / cos2H,
                        .log4CosH = 2 * fastLog(cos2H),
                        .oneMinusCosD5 = (m * m) * (m * m) * m,
                        .inverseCosines = 1 / (g.cosI * g.cosO)};
    return {evaluateChannel(channels[0], g, angles), evaluateChannel(channels[1], g, angles),
            evaluateChannel(channels[2], g, angles)};
  }
  std::shared_ptr<const ValueBound> valueBound() const { return std::make_shared<const SgdBound>(channels); }
};

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const std::array<Channel, 3> channels{makeChannel(p, 0), makeChannel(p, 1), makeChannel(p, 2)};
  return makeGeometryBrdf(SgdFunction{channels},
                          diffuseMixture(maxChannel(p.values[diffuse]), maxChannel(p.values[specular]),
                                         HalfVectorDensity{makeNormals(channels)}));
}

/// c becomes ln c, and ln K stands behind the values: c exceeds float, and the shader has no incomplete gamma.
auto arguments(const ParameterValues& p) {
  const auto& v = p.values;
  const auto logNormalisation = [&](int channel) { return sgdLogNormalisation(v[alpha][channel], v[power][channel]); };
  return std::tuple(v[diffuse], v[specular], v[alpha], v[power], v[f0], v[f1], v[lambda], glm::log(v[maskingScale]),
                    v[maskingPower], v[theta0], Rgb(logNormalisation(0), logNormalisation(1), logNormalisation(2)));
}

}  // namespace

double sgdLogNormalisation(double alpha, double p) { return -std::log(alpha) - logUpperIncompleteGamma(1 - p, alpha); }

const Model& sgd() {
  static const Model model(sgdSpec, {.create = create, .arguments = shaderArguments<arguments>});
  return model;
}

}  // namespace gonio::models
