// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/geometry/bundled_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <mutex>
#include <utility>

#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::geometry {

namespace {

using Profile = std::vector<glm::dvec2>;

void requireProfile(std::span<const glm::dvec2> profile, int segments) {
  if (segments < 3)
    throw Error("surface of revolution: found " + std::to_string(segments) + " segments, expected at least 3");
  if (profile.size() < 3)
    throw Error("surface of revolution: found " + std::to_string(profile.size()) + " points, expected at least 3");
  for (std::size_t i = 0; i < profile.size(); ++i)
    if (!std::isfinite(profile[i].x) || !std::isfinite(profile[i].y) || profile[i].x < 0)
      throw Error("surface of revolution: point " + std::to_string(i) + " is (" + numberText(profile[i].x) + ", " +
                  numberText(profile[i].y) + "), expected finite numbers and a distance that is not negative");
  const bool axisToAxis = profile.front().x == 0 && profile.back().x == 0;
  if (!axisToAxis && profile.front() != profile.back())
    throw Error("surface of revolution: the profile is open, expected a closed profile or one from axis to axis");
}

/// The area of the polygon that the profile and the axis enclose, positive where it runs upward on the side away from
/// the axis.
double enclosedArea(std::span<const glm::dvec2> profile) {
  double twice = 0;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const glm::dvec2 &a = profile[i], &b = profile[(i + 1) % profile.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return twice / 2;
}

/// Appends points on a circle about `centre`; angles (degrees) from the axis's +y, positive away from the axis.
void arc(Profile& profile, const glm::dvec2& centre, double radius, double from, double to, int steps) {
  for (int i = 0; i <= steps; ++i) {
    const double angle = radians(from + (to - from) * i / steps);
    profile.push_back(centre + radius * glm::dvec2(std::sin(angle), std::cos(angle)));
  }
}

/// Puts the ends on the axis, from which sines leave them by rounding.
Profile fromAxisToAxis(Profile profile) {
  profile.front().x = profile.back().x = 0;
  return profile;
}
void append(MeshArrays& arrays, const MeshArrays& added) {
  const auto first = std::uint32_t(arrays.positions.size());
  arrays.positions.insert(arrays.positions.end(), added.positions.begin(), added.positions.end());
  for (const TriangleIndices& t : added.triangles) arrays.triangles.push_back(t + first);
}

/// A cloth over a ball: `along` in [0, 1] from its middle to the hem, `angle` about +y. It lies on the ball at the top
/// and falls from its equator on, in folds that grow toward the hem.
Direction clothPoint(double along, double angle, bool inside) {
  constexpr double ball = 0.55, length = 1.9, folds = 9, deepest = 0.3, thickness = 0.012;
  constexpr double onBall = ball * pi / 2;
  const double s = along * length;
  const double hanging = std::max(0.0, s - onBall);
  double radius = ball * std::sin(std::min(s, onBall) / ball);
  const double height = ball * std::cos(std::min(s, onBall) / ball) - 0.93 * hanging;
  const double fraction = std::min(1.0, std::max(0.0, s - 0.5 * onBall) / (length - 0.5 * onBall));
  const double wave = std::cos(folds * angle + 0.7 * std::sin(2 * angle));
  radius += deepest * fraction * fraction * (0.55 + 0.45 * wave) + 0.08 * fraction * std::cos(3 * angle + 1);
  const double out = inside ? -thickness : 0;
  // From y in [height at the hem, ball] to [-1, ..].
  const double lowest = -0.93 * (length - onBall);
  return {(radius + out * std::min(1.0, s / onBall)) * std::sin(angle), height + out - lowest - 1 + thickness,
          (radius + out * std::min(1.0, s / onBall)) * std::cos(angle)};
}

/// Turns +y to `axis` (unit), then moves the origin to `centre`.
MeshArrays placed(MeshArrays arrays, const Direction& axis, const Direction& centre) {
  const glm::dquat turn(Direction(0, 1, 0), axis);
  for (glm::vec3& p : arrays.positions) p = glm::vec3(turn * Direction(p) + centre);
  return arrays;
}

double smoothStep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

constexpr double ballRadius = 0.8;
const Direction ballCentre(0, 0.2, 0);

/// The ball's shell about +y, its centre at 0: from the inside's lowest point up to the lip, over it and down outside,
/// through the band.
Profile shellProfile() {
  constexpr double opening = 42, lip = 0.05, bandDepth = 0.05, bandFrom = 74, bandTo = 88, bandEdge = 2.5;
  const double lipAngle = radians(opening), middle = ballRadius - lip;
  Profile profile;
  arc(profile, {0, 0}, ballRadius - 2 * lip, 180, opening + 3, 40);
  arc(profile, middle * glm::dvec2(std::sin(lipAngle), std::cos(lipAngle)), lip, opening - 180, opening, 12);
  const auto outside = [&](double from, double to, int steps) {
    for (int i = 1; i <= steps; ++i) {
      const double angle = from + (to - from) * i / steps;
      const double inBand =
          smoothStep(bandFrom, bandFrom + bandEdge, angle) - smoothStep(bandTo - bandEdge, bandTo, angle);
      const double radius = ballRadius - bandDepth * inBand;
      profile.push_back(radius * glm::dvec2(std::sin(radians(angle)), std::cos(radians(angle))));
    }
  };
  outside(opening, bandFrom, 22);
  outside(bandFrom, bandFrom + bandEdge, 10);
  outside(bandFrom + bandEdge, bandTo - bandEdge, 3);
  outside(bandTo - bandEdge, bandTo, 10);
  outside(bandTo, 180, 28);
  return fromAxisToAxis(profile);
}

/// Foot, waist, and a cup that follows the ball at a little distance.
Profile standProfile() {
  constexpr double waist = 0.2, waistHeight = -0.74, footEdge = 0.04, cupGap = 0.012, rimEdge = 0.02, rimAngle = 150;
  Profile profile{{0, -1}};
  arc(profile, {0.56, footEdge - 1}, footEdge, 180, 14, 12);
  const glm::dvec2 foot = profile.back();
  const double cup = ballRadius + cupGap;
  const glm::dvec2 centre(ballCentre.x, ballCentre.y);
  Profile rim;
  arc(rim, centre + (cup + rimEdge) * glm::dvec2(std::sin(radians(rimAngle)), std::cos(radians(rimAngle))), rimEdge,
      155, rimAngle - 180, 8);
  // Two parabolas that meet in the waist.
  const auto flank = [&](const glm::dvec2& end, double t) {
    return glm::dvec2(waist + (end.x - waist) * t * t, waistHeight + (end.y - waistHeight) * t);
  };
  constexpr int steps = 16;
  for (int i = 1; i < steps; ++i) profile.push_back(flank(foot, 1 - double(i) / steps));
  for (int i = 0; i < steps; ++i) profile.push_back(flank(rim.front(), double(i) / steps));
  profile.insert(profile.end(), rim.begin(), rim.end());
  profile.pop_back();
  arc(profile, centre, cup, rimAngle, 180, 12);
  return fromAxisToAxis(profile);
}

Profile bowlProfile() {
  constexpr double radius = 0.95, lip = 0.05, rimHeight = -0.05, footRadius = 0.4, footHeight = 0.08;
  // The outside meets the foot where the sphere is as wide as the foot.
  const glm::dvec2 centre(0, rimHeight), foot(footRadius, footHeight - 1);
  const double depth = (rimHeight - foot.y), outerHalfHeight = depth / std::sqrt(1 - footRadius * footRadius);
  Profile profile{{0, -0.96}, {footRadius - 0.08, -0.96}};
  arc(profile, {footRadius - 0.05, -0.985}, 0.015, 270, 180, 4);
  arc(profile, {footRadius - 0.02, -0.98}, 0.02, 180, 90, 4);
  constexpr int steps = 40;
  const double lowest = std::asin(footRadius / (radius + lip));
  for (int i = 0; i < steps; ++i) {
    const double angle = lowest + (halfPi - lowest) * i / steps;
    profile.push_back(centre + glm::dvec2((radius + lip) * std::sin(angle), -outerHalfHeight * std::cos(angle)));
  }
  arc(profile, {radius, rimHeight}, lip, 90, -90, 12);
  profile.pop_back();
  for (int i = 0; i <= steps; ++i) {
    const double angle = halfPi * (1 - double(i) / steps);
    profile.push_back(centre + (radius - lip) * glm::dvec2(std::sin(angle), -0.94 * std::cos(angle)));
  }
  return fromAxisToAxis(profile);
}

}  // namespace

MeshArrays revolvedArrays(std::span<const glm::dvec2> profile, int segments) {
  requireProfile(profile, segments);
  const bool runsAround = profile.front() == profile.back() && profile.front().x > 0;
  MeshArrays arrays;
  // One vertex on the axis, a ring elsewhere; the last ring of a profile that runs around is the first.
  std::vector<std::uint32_t> ringStart;
  for (const glm::dvec2& point : profile.first(profile.size() - (runsAround ? 1 : 0))) {
    ringStart.push_back(std::uint32_t(arrays.positions.size()));
    for (int i = 0; i < (point.x > 0 ? segments : 1); ++i) {
      const double angle = 2 * pi * i / segments;
      arrays.positions.emplace_back(point.x * std::sin(angle), point.y, point.x * std::cos(angle));
    }
  }
  if (runsAround) ringStart.push_back(ringStart.front());
  const bool outward = enclosedArea(profile) > 0;
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c) arrays.triangles.emplace_back(a, outward ? b : c, outward ? c : b);
  };
  const auto vertex = [&](std::size_t ring, int i) {
    return ringStart[ring] + (profile[ring].x > 0 ? std::uint32_t(i % segments) : 0u);
  };
  for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring)
    for (int i = 0; i < segments; ++i) {
      const std::uint32_t a = vertex(ring, i), b = vertex(ring, i + 1);
      const std::uint32_t c = vertex(ring + 1, i + 1), d = vertex(ring + 1, i);
      add(a, b, c);
      add(a, c, d);
    }
  return arrays;
}

TriangleMesh revolvedMesh(std::span<const glm::dvec2> profile, int segments) {
  return TriangleMesh(revolvedArrays(profile, segments));
}

TriangleMesh torusMesh() {
  constexpr double middle = 0.7, tube = 0.3;
  Profile profile;
  arc(profile, {middle, tube - 1}, tube, 0, 360, 64);
  profile.back() = profile.front();
  return revolvedMesh(profile, 128);
}

TriangleMesh bowlMesh() { return revolvedMesh(bowlProfile(), 128); }

TriangleMesh shaderBallMesh() {
  const Direction towardViewer = glm::normalize(Direction(0.4, 0.75, 0.55));
  Profile core;
  arc(core, {0, 0}, 0.5, 180, 0, 40);
  MeshArrays arrays = revolvedArrays(standProfile(), 96);
  append(arrays, placed(revolvedArrays(shellProfile(), 128), towardViewer, ballCentre));
  append(arrays, placed(revolvedArrays(fromAxisToAxis(core), 80), towardViewer, ballCentre));
  return TriangleMesh(std::move(arrays));
}

TriangleMesh cylinderMesh() {
  constexpr double radius = 0.75, rim = 0.08;
  Profile profile{{0, -1}};
  arc(profile, {radius - rim, rim - 1}, rim, 180, 90, 12);
  arc(profile, {radius - rim, 1 - rim}, rim, 90, 0, 12);
  profile.push_back({0, 1});
  return revolvedMesh(profile, 128);
}

TriangleMesh clothMesh() {
  constexpr int segments = 208, rings = 68;
  MeshArrays arrays;
  // The outside from the top to the hem, then the inside back up.
  const auto ringOf = [&](int ring) { return ring <= rings ? ring : 2 * rings + 1 - ring; };
  const int last = 2 * rings + 1;
  for (int ring = 0; ring <= last; ++ring) {
    const bool inside = ring > rings;
    const double along = double(ringOf(ring)) / rings;
    const bool onAxis = ring == 0 || ring == last;
    for (int i = 0; i < (onAxis ? 1 : segments); ++i)
      arrays.positions.push_back(clothPoint(along, 2 * pi * i / segments, inside));
  }
  const auto vertex = [&](int ring, int i) {
    if (ring == 0) return 0u;
    return 1u + std::uint32_t(ring - 1) * segments + (ring == last ? 0u : std::uint32_t(i % segments));
  };
  for (int ring = 0; ring < last; ++ring)
    for (int i = 0; i < segments; ++i) {
      const std::uint32_t a = vertex(ring, i), b = vertex(ring, i + 1);
      const std::uint32_t c = vertex(ring + 1, i + 1), d = vertex(ring + 1, i);
      if (a != b) arrays.triangles.emplace_back(a, c, b);
      if (c != d) arrays.triangles.emplace_back(a, d, c);
    }
  return TriangleMesh(std::move(arrays));
}

namespace {
using Make = TriangleMesh (*)();
constexpr std::array<std::pair<const char*, Make>, 5> meshes{{{"shader-ball", shaderBallMesh},
                                                              {"torus", torusMesh},
                                                              {"bowl", bowlMesh},
                                                              {"cylinder", cylinderMesh},
                                                              {"cloth", clothMesh}}};
}  // namespace

std::vector<std::string> bundledMeshNames() {
  std::vector<std::string> names(meshes.size());
  std::ranges::transform(meshes, names.begin(), [](const auto& mesh) { return mesh.first; });
  return names;
}

std::shared_ptr<const TriangleMesh> bundledMesh(const std::string& name) {
  static std::array<std::shared_ptr<const TriangleMesh>, meshes.size()> made;
  static std::array<std::once_flag, meshes.size()> flags;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (name != meshes[i].first) continue;
    std::call_once(flags[i], [i] { made[i] = std::make_shared<const TriangleMesh>(meshes[i].second()); });
    return made[i];
  }
  std::string names;
  for (const std::string& known : bundledMeshNames()) names += (names.empty() ? "" : ", ") + known;
  throw Error("found the mesh '" + name + "', expected one of " + names);
}

}  // namespace gonio::geometry
