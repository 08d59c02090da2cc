// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <mutex>

#include "core/math/fast_functions.h"
#include "core/math/parallel.h"
#include "core/rendering/environment.h"
#include "core/support/error.h"

namespace gonio::rendering {

namespace {

constexpr int mapWidth = 512, mapHeight = 256;

double smoothRise(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// A flat lamp on a stand: a rounded rectangle in the plane at distance 1 along `toward`, upright.
struct SoftBox {
  Direction toward;
  double halfWidth, halfHeight;  ///< in units of the distance
  double corner;                 ///< radius of the corners
  double falloff;                ///< width of the soft edge, inward
  double hotSpot;                ///< how much brighter the middle is than the rim, as a fraction of `radiance`
  Rgb radiance;
  Direction axis = glm::normalize(toward), right = glm::normalize(glm::cross(axis, Direction{0, 1, 0})),
            up = glm::cross(right, axis);

  Rgb operator()(const Direction& w) const {
    const double along = glm::dot(w, axis);
    if (along <= 0) return Rgb(0);
    const double x = glm::dot(w, right) / along, y = glm::dot(w, up) / along;
    const double dx = std::abs(x) - (halfWidth - corner), dy = std::abs(y) - (halfHeight - corner);
    const double beyond = std::max(dx, dy) - corner;
    if (beyond >= 0) return Rgb(0);
    const double beyondX = std::max(dx, 0.0), beyondY = std::max(dy, 0.0);
    const double outside = std::sqrt(beyondX * beyondX + beyondY * beyondY) + std::min(std::max(dx, dy), 0.0) - corner;
    const double r2 = (x * x) / (halfWidth * halfWidth) + (y * y) / (halfHeight * halfHeight);
    return radiance * (smoothRise(0, falloff, -outside) * (1 - hotSpot + hotSpot * fastExp(-1.5 * r2)));
  }
};

/// A dark grey room: a cyclorama that runs smoothly from the floor into the wall, with a glow where they meet.
Rgb studioRoom(const Direction& w) {
  const double wall = glm::mix(0.030, 0.060, smoothRise(-0.1, 0.9, w.y));
  const double floor = glm::mix(0.020, 0.085, smoothRise(-1.0, -0.02, w.y));
  const double glow = 0.05 * fastExp(-40 * (w.y + 0.12) * (w.y + 0.12));
  return (glm::mix(floor, wall, smoothRise(-0.05, 0.03, w.y)) + glow) * Rgb(0.98, 0.99, 1.03);
}

Rgb studioRadiance(const Direction& w) {
  static const SoftBox boxes[] = {
      // Key: large, high on the left, in front of the sphere.
      {{-0.84, 0.64, 0.60}, 0.42, 0.50, 0.06, 0.10, 0.45, Rgb(12.2, 11.9, 11.4)},
      // Rim: a tall strip behind on the right.
      {{0.92, 0.22, -0.40}, 0.11, 0.80, 0.05, 0.05, 0.25, Rgb(12.0, 12.3, 12.8)},
      // Fill: wide and weak, in front on the right.
      {{0.85, 0.10, 0.75}, 0.50, 0.70, 0.15, 0.40, 0.30, Rgb(0.50, 0.53, 0.58)},
      // Overhead bank behind: draws the upper edge of shiny things.
      {{-0.25, 1.0, -0.75}, 0.62, 0.20, 0.08, 0.12, 0.35, Rgb(3.0, 3.0, 3.0)},
  };
  Rgb sum = studioRoom(w);
  for (const SoftBox& box : boxes) sum += box(w);
  return sum;
}

/// The studio with strips of light all around the back: shiny black things get a bright outline, which the studio alone
/// gives them on one side.
Rgb rimLightsRadiance(const Direction& w) {
  static const SoftBox boxes[] = {
      // Key and fill as in the studio.
      {{-0.84, 0.64, 0.60}, 0.42, 0.50, 0.06, 0.10, 0.45, Rgb(12.0, 11.7, 11.2)},
      {{0.85, 0.10, 0.75}, 0.50, 0.70, 0.15, 0.40, 0.30, Rgb(0.90, 0.95, 1.05)},
      // Tall strips behind on both sides, the one opposite to the key brighter.
      {{0.80, 0.22, -0.52}, 0.13, 1.00, 0.06, 0.06, 0.25, Rgb(20.0, 20.5, 21.3)},
      {{-0.86, 0.12, -0.50}, 0.10, 1.00, 0.06, 0.06, 0.25, Rgb(12.0, 12.3, 12.8)},
      // A wide bank overhead, which joins them.
      {{0.0, 1.0, -0.45}, 1.10, 0.22, 0.10, 0.14, 0.35, Rgb(8.5, 8.5, 8.5)},
  };
  Rgb sum = 2.0 * studioRoom(w);
  for (const SoftBox& box : boxes) sum += box(w);
  return sum;
}

Rgb skyRadiance(const Direction& w) {
  static const Direction sun = glm::normalize(Direction{-0.55, 0.62, 0.56});
  static const double sunRadius = radians(1.25), sunEdge = radians(0.12);
  constexpr double sunRadiance = 2600;
  const double angle = 2 * std::atan2(glm::length(w - sun), glm::length(w + sun));
  const double height = std::max(0.0, w.y);
  const Rgb zenith(0.16, 0.33, 0.78), horizon(0.78, 0.90, 1.05);
  Rgb sky = glm::mix(zenith, horizon, std::exp(-3.2 * height));
  sky += Rgb(1.0, 0.86, 0.62) * (0.9 * std::exp(-angle / radians(9)) + 0.25 * std::exp(-angle / radians(35)));
  sky += Rgb(1.0, 0.93, 0.80) * sunRadiance * (1 - smoothRise(sunRadius - sunEdge, sunRadius + sunEdge, angle));
  const Rgb ground = glm::mix(Rgb(0.20, 0.17, 0.13), Rgb(0.42, 0.40, 0.36), std::exp(4 * std::min(0.0, w.y)));
  return glm::mix(ground, sky, smoothRise(-0.012, 0.012, w.y));
}

/// A low sun behind thin haze: warm from one side, cool from the other, with soft shadows.
Rgb sunsetRadiance(const Direction& w) {
  static const Direction sun = glm::normalize(Direction{-0.86, 0.17, 0.48});
  static const double sunRadius = radians(2.2), sunEdge = radians(1.2);
  constexpr double sunRadiance = 420;
  const double angle = 2 * std::atan2(glm::length(w - sun), glm::length(w + sun));
  const double height = std::max(0.0, w.y);
  Rgb sky = glm::mix(Rgb(0.16, 0.20, 0.42), Rgb(0.62, 0.42, 0.36), std::exp(-4.5 * height));
  sky += Rgb(1.0, 0.50, 0.20) * (1.6 * std::exp(-angle / radians(12)) + 0.7 * std::exp(-angle / radians(45)));
  sky += Rgb(1.0, 0.62, 0.30) * sunRadiance * (1 - smoothRise(sunRadius - sunEdge, sunRadius + sunEdge, angle));
  const Rgb ground = glm::mix(Rgb(0.07, 0.06, 0.06), Rgb(0.30, 0.21, 0.16), std::exp(5 * std::min(0.0, w.y)));
  return glm::mix(ground, sky, smoothRise(-0.012, 0.012, w.y));
}

/// A dim room with a tall window of four panes in front on the left and a warm lamp behind on the right.
Rgb windowRadiance(const Direction& w) {
  static const std::array<SoftBox, 4> panes = [] {
    constexpr double across = 0.30, upward = 0.40, bar = 0.03;
    constexpr Direction middle{-0.72, 0.34, 0.72}, right{0.707, 0, 0.707}, up{0, 1, 0};
    const auto pane = [&](double x, double y) {
      const Direction toward = middle + x * (across / 2 + bar) * right + y * (upward / 2 + bar) * up;
      return SoftBox{toward, across / 2, upward / 2, 0.01, 0.01, 0.1, Rgb(13.5, 15.5, 18.5)};
    };
    return std::array{pane(-1, -1), pane(-1, 1), pane(1, -1), pane(1, 1)};
  }();
  static const SoftBox lamp{{0.80, 0.42, -0.45}, 0.13, 0.15, 0.1, 0.12, 0.6, Rgb(11.0, 6.8, 3.2)};
  const Rgb wall = glm::mix(Rgb(0.055, 0.050, 0.045), Rgb(0.11, 0.105, 0.10), smoothRise(-0.6, 0.9, w.y));
  const Rgb floor = glm::mix(Rgb(0.05, 0.035, 0.025), Rgb(0.13, 0.095, 0.065), smoothRise(-1, -0.15, w.y));
  Rgb sum = glm::mix(floor, wall, smoothRise(-0.12, -0.06, w.y));
  for (const SoftBox& pane : panes) sum += pane(w);
  sum += lamp(w);
  return sum;
}

struct BundledEnvironment {
  const char* name;
  int perAxis;   ///< positions in a pixel
  double scale;  ///< a white Lambert sphere comes out about mid-bright (its visible half 0.5 on average) at exposure 0
  Rgb (*radiance)(const Direction& world);
};

/// The mean of `perAxis` x `perAxis` positions per pixel: small bright things keep their energy.
std::shared_ptr<const EnvironmentMap> paint(const BundledEnvironment& environment) {
  const int perAxis = environment.perAxis;
  Image image(mapWidth, mapHeight);
  parallelForBlocks(std::size_t(mapHeight), 8, [&](std::size_t begin, std::size_t end) {
    for (int y = int(begin); y < int(end); ++y)
      for (int x = 0; x < mapWidth; ++x) {
        Rgb sum(0);
        for (int i = 0; i < perAxis * perAxis; ++i) {
          const int column = i % perAxis, row = i / perAxis;
          const double u = x + (column + 0.5) / perAxis, v = y + (row + 0.5) / perAxis;
          sum += environment.radiance(EnvironmentMap::directionAt(u / mapWidth, v / mapHeight));
        }
        image.at(x, y) = glm::vec3(sum * (environment.scale / double(perAxis * perAxis)));
      }
  });
  return std::make_shared<const EnvironmentMap>(std::move(image), environment.name);
}

constexpr BundledEnvironment environments[] = {
    {"studio", 2, 0.68, studioRadiance}, {"rim-lights", 2, 0.54, rimLightsRadiance},
    {"sky", 6, 0.5, skyRadiance},        {"sunset", 4, 1.15, sunsetRadiance},
    {"window", 2, 0.46, windowRadiance}, {"furnace", 1, 1, [](const Direction&) { return Rgb(1); }},
};
constexpr std::size_t environmentCount = std::size(environments);

/// Painted once, when it is first asked for.
std::shared_ptr<const EnvironmentMap> environmentAt(std::size_t index) {
  static std::array<std::once_flag, environmentCount> once;
  static std::array<std::shared_ptr<const EnvironmentMap>, environmentCount> maps;
  std::call_once(once[index], [&] { maps[index] = paint(environments[index]); });
  return maps[index];
}

}  // namespace

const std::vector<std::string>& bundledEnvironmentNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const BundledEnvironment& environment : environments) all.emplace_back(environment.name);
    return all;
  }();
  return names;
}

std::string bundledEnvironmentList() {
  std::string list;
  for (const std::string& name : bundledEnvironmentNames()) list += (list.empty() ? "" : ", ") + name;
  return list;
}

std::shared_ptr<const EnvironmentMap> bundledEnvironment(const std::string& name) {
  const std::vector<std::string>& names = bundledEnvironmentNames();
  const auto at = std::ranges::find(names, name);
  if (at == names.end())
    throw Error("found the environment '" + name + "', expected one of " + bundledEnvironmentList());
  return environmentAt(std::size_t(at - names.begin()));
}

std::shared_ptr<const EnvironmentMap> studioEnvironment() { return bundledEnvironment("studio"); }
std::shared_ptr<const EnvironmentMap> skyEnvironment() { return bundledEnvironment("sky"); }
std::shared_ptr<const EnvironmentMap> furnaceEnvironment() { return bundledEnvironment("furnace"); }

}  // namespace gonio::rendering
