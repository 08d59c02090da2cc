// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/coordinates/projected_deviation.h"

#include <algorithm>
#include <cmath>

namespace gonio {

namespace {

/// Cosine and sine of the azimuth of a direction; that of the normal is 0.
glm::dvec2 unitAzimuth(const Direction& w, double sine) {
  constexpr double smallest = 1e-300;
  return sine < smallest ? glm::dvec2(1, 0) : glm::dvec2(w.x, w.y) / sine;
}

}  // namespace

ProjectedDeviation toProjectedDeviation(const Direction& wi, const Direction& wo) {
  const double sinR = std::hypot(wo.x, wo.y);
  const glm::dvec2 o = unitAzimuth(wo, sinR);
  const glm::dvec2 deviation(o.x * wi.x + o.y * wi.y + sinR, o.x * wi.y - o.y * wi.x);
  const double length = std::hypot(deviation.x, deviation.y);
  return {.thetaR = std::atan2(sinR, wo.z),
          .deviation = length,
          .phi = length > 0 ? std::atan2(deviation.y, deviation.x) : 0};
}

ProjectedDirections fromProjectedDeviation(const ProjectedDeviation& c) {
  constexpr double slack = 1e-12;
  const double sinR = std::sin(c.thetaR);
  glm::dvec2 light(c.deviation * std::cos(c.phi) - sinR, c.deviation * std::sin(c.phi));
  double radius = std::hypot(light.x, light.y);
  const bool valid = radius <= 1 + slack;
  if (radius > 1) {
    light /= radius;
    radius = 1;
  }
  return {
      .pair = {.wi = {light.x, light.y, std::sqrt((1 - radius) * (1 + radius))}, .wo = {sinR, 0, std::cos(c.thetaR)}},
      .valid = valid};
}

double azimuthLimit(double deviation, double sinThetaR) {
  if (deviation <= 1 - sinThetaR) return pi;
  if (deviation >= 1 + sinThetaR || !(sinThetaR > 0)) return 0;
  // By the half angle: tan^2(PHI / 2) = (1 - c) / (1 + c), whose factors do not cancel where acos(c) would.
  const double s = sinThetaR, d = deviation;
  const double above = std::max(0.0, (1 - (s - d)) * (1 + (s - d)));  // 1 - (s - d)^2
  const double below = std::max(0.0, ((s + d) - 1) * ((s + d) + 1));  // (s + d)^2 - 1
  return 2 * std::atan2(std::sqrt(above), std::sqrt(below));
}

}  // namespace gonio
