// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/sampling/half_vector_densities.h"

#include <algorithm>
#include <cmath>

#include "core/math/fast_functions.h"
#include "core/math/sampling.h"

namespace gonio {

namespace {

constexpr double firstCircle = 1e-5;

/// The circles by 1 - cos theta, in which areas are even.
template <std::size_t count>
std::array<double, count> makeCircles() {
  std::array<double, count> circles{};
  for (std::size_t i = 1; i < count; ++i) {
    const double theta = firstCircle * std::pow(halfPi / firstCircle, double(i - 1) / double(count - 2));
    circles[i] = 2 * std::sin(theta / 2) * std::sin(theta / 2);
  }
  circles[count - 1] = 1;
  return circles;
}

template <std::size_t count>
const std::array<double, count>& circlesOf(const std::array<double, count>&) {
  static const std::array<double, count> circles = makeCircles<count>();
  return circles;
}

/// The last circle at or inside of `value`, so that another follows it.
template <std::size_t count>
std::size_t ringOf(const std::array<double, count>& ascending, double value) {
  const auto above = std::upper_bound(ascending.begin() + 1, ascending.end() - 1, value);
  return std::size_t(above - ascending.begin()) - 1;
}

/// D(h) G1(wo) / (4 cos theta_o) of a distribution and its shadowed cosine; 0 without a half vector above the horizon.
template <typename Distribution, typename ShadowedCosine>
double visibleDensity(const Direction& w, const Direction& wo, const Distribution& distribution,
                      const ShadowedCosine& shadowedCosine) {
  const Direction sum = w + wo;
  const double squaredLength = glm::dot(sum, sum);
  if (!(squaredLength > minSquaredHalfLength) || sum.z < 0) return 0;
  const Direction above{wo.x, wo.y, std::max(0.0, wo.z)};
  return distribution(sum / std::sqrt(squaredLength)) / (4 * shadowedCosine(above));
}

/// Solves F(x) = value for a distribution function F, which rises from 0 at `low` to 1 at `high`: Newton's steps,
/// halved intervals where one leaves the bracket.
template <typename Function>
double inverseOf(const Function& valueAndSlope, double value, double low, double high) {
  constexpr int maxSteps = 60;
  double x = (low + high) / 2;
  for (int step = 0; step < maxSteps; ++step) {
    const auto [at, slope] = valueAndSlope(x);
    (at > value ? high : low) = x;
    const double next = x - (at - value) / slope;
    const double previous = x;
    x = next > low && next < high ? next : (low + high) / 2;
    if (std::abs(x - previous) < 1e-12) break;
  }
  return x;
}

struct ValueAndSlope {
  double value, slope;
};

/// Beyond, a Gaussian of slopes has less than 1e-15 of itself.
constexpr double lastSlope = 5.7;

/// A slope along the viewer's azimuth, of a surface of unit roughness seen at `sine`, `cosine`: its density is
/// proportional to exp(-x^2) max(0, cosine - x sine).
double visibleSlope(double sine, double cosine, double u) {
  const double last = cosine < lastSlope * sine ? cosine / sine : lastSlope;
  const auto integral = [&](double x) {
    return cosine * (1 + std::erf(x)) / 2 + sine * std::exp(-x * x) / (2 * std::sqrt(pi));
  };
  const double total = integral(last);
  return inverseOf(
      [&](double x) {
        return ValueAndSlope{integral(x) / total, std::exp(-x * x) * (cosine - x * sine) / (std::sqrt(pi) * total)};
      },
      u, -lastSlope, last);
}

double gaussianSlope(double u) {
  return inverseOf(
      [](double x) {
        return ValueAndSlope{(1 + std::erf(x)) / 2, std::exp(-x * x) / std::sqrt(pi)};
      },
      u, -lastSlope, lastSlope);
}

}  // namespace

TabulatedNormals::TabulatedNormals(const std::function<double(double)>& weight) {
  const auto& x = circlesOf(density_);
  for (const bool cosine : {false, true}) {
    for (std::size_t i = 0; i < circles; ++i) {
      const double value = cosine ? 1 - x[i] : weight(2 * std::asin(std::sqrt(x[i] / 2)));
      density_[i] = std::isfinite(value) ? std::max(0.0, value) : 0;
    }
    cumulative_[0] = 0;
    for (std::size_t i = 1; i < circles; ++i)
      cumulative_[i] = cumulative_[i - 1] + pi * (density_[i - 1] + density_[i]) * (x[i] - x[i - 1]);
    if (!cosine) total_ = cumulative_.back();
    if (cumulative_.back() > 0 && std::isfinite(cumulative_.back())) break;
  }
  const double total = cumulative_.back();
  for (double& value : cumulative_) value /= total;
  for (double& value : density_) value /= total;
}

Direction TabulatedNormals::sample(const glm::dvec2& u) const {
  const auto& x = circlesOf(density_);
  const std::size_t ring = ringOf(cumulative_, u.x);
  const double width = x[ring + 1] - x[ring];
  const double area = std::max(0.0, u.x - cumulative_[ring]) / (2 * pi * width);
  const double oneMinusCos = x[ring] + inverseOfRamp(density_[ring], density_[ring + 1], area) * width;
  const double sine = std::sqrt(oneMinusCos * (2 - oneMinusCos));
  const auto turn = fastSineAndCosine(u.y);
  return {sine * turn.cosine, sine * turn.sine, 1 - oneMinusCos};
}

double TabulatedNormals::density(const Direction& h) const {
  const auto& x = circlesOf(density_);
  const double oneMinusCos = std::min(1.0, (h.x * h.x + h.y * h.y) / (1 + std::max(0.0, h.z)));
  const std::size_t ring = ringOf(x, oneMinusCos);
  const double t = (oneMinusCos - x[ring]) / (x[ring + 1] - x[ring]);
  return density_[ring] + t * (density_[ring + 1] - density_[ring]);
}

double beckmannDensity(const Direction& half, double alphaX, double alphaY) {
  if (!(half.z > 0)) return 0;
  const double x = half.x / (alphaX * half.z), y = half.y / (alphaY * half.z);
  // In the exponent: 1 / cos^4 overflows where the exponential underflows.
  return std::exp(-(x * x + y * y) - 4 * std::log(half.z)) / (pi * alphaX * alphaY);
}

double beckmannCosineOverG1(const Direction& w, double alphaX, double alphaY) {
  const double x = alphaX * w.x, y = alphaY * w.y, slope = std::sqrt(x * x + y * y);
  if (!(slope > 0)) return w.z;
  const double a = w.z / slope;
  return w.z * (1 - std::erfc(a) / 2) + slope * std::exp(-a * a) / (2 * std::sqrt(pi));
}

Direction VisibleNormalDensity::sample(const Direction& wo, const glm::dvec2& u) const {
  // Section 3 of the paper.
  const Direction stretched = glm::normalize(Direction{alphaX * wo.x, alphaY * wo.y, wo.z});
  const double across = std::sqrt(stretched.x * stretched.x + stretched.y * stretched.y);
  const Direction tangent = across > 0 ? Direction{-stretched.y / across, stretched.x / across, 0} : Direction{1, 0, 0};
  const Direction bitangent = glm::cross(stretched, tangent);
  const double r = std::sqrt(u.x);
  const auto turn = fastSineAndCosine(u.y);
  const double s = (1 + stretched.z) / 2;
  const double x = r * turn.cosine;
  const double y = (1 - s) * std::sqrt(1 - x * x) + s * r * turn.sine;
  const double z = std::sqrt(std::max(0.0, 1 - x * x - y * y));
  const Direction n = x * tangent + y * bitangent + z * stretched;
  const Direction h = glm::normalize(Direction{alphaX * n.x, alphaY * n.y, std::max(0.0, n.z)});
  return 2 * glm::dot(wo, h) * h - wo;
}

double VisibleNormalDensity::density(const Direction& w, const Direction& wo) const {
  return visibleDensity(
      w, wo, [this](const Direction& h) { return ggxDensity(h, alphaX, alphaY); },
      [this](const Direction& v) { return ggxCosineOverG1(v, alphaX, alphaY); });
}

Direction BeckmannVisibleDensity::sample(const Direction& wo, const glm::dvec2& u) const {
  // The surface stretched to unit roughness, with the viewer in the plane of x: its slopes are stretched back.
  const Direction stretched = glm::normalize(Direction{alphaX * wo.x, alphaY * wo.y, std::max(0.0, wo.z)});
  const double sine = std::sqrt(stretched.x * stretched.x + stretched.y * stretched.y);
  const glm::dvec2 axis = sine > 0 ? glm::dvec2(stretched.x, stretched.y) / sine : glm::dvec2(1, 0);
  const double along = visibleSlope(sine, stretched.z, u.x), across = gaussianSlope(u.y);
  // A slope is minus the normal's horizontal part.
  const double x = -alphaX * (axis.x * along - axis.y * across), y = -alphaY * (axis.y * along + axis.x * across);
  const Direction h = glm::normalize(Direction(x, y, 1));
  return 2 * glm::dot(wo, h) * h - wo;
}

double BeckmannVisibleDensity::density(const Direction& w, const Direction& wo) const {
  return visibleDensity(
      w, wo, [this](const Direction& h) { return beckmannDensity(h, alphaX, alphaY); },
      [this](const Direction& v) { return beckmannCosineOverG1(v, alphaX, alphaY); });
}

}  // namespace gonio
