// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>

/// The conventions of the whole project.
///
/// Directions are unit vectors in the local shading frame, z is the surface normal. `wi` points toward the light, `wo`
/// toward the viewer: both point away from the surface. A BRDF value is linear RGB (sRGB primaries) in 1/sr, without
/// the cosine. Angles are in radians, except in text for the user. Most computations use double; tables store float.
namespace gonio {

using Direction = glm::dvec3;
using Rgb = glm::dvec3;

/// Of an Rgb's channels, in messages.
inline constexpr std::array channelNames{"red", "green", "blue"};

inline constexpr double pi = std::numbers::pi;
inline constexpr double halfPi = pi / 2;

inline constexpr double radians(double degrees) { return degrees * (pi / 180.0); }
inline constexpr double degrees(double radians) { return radians * (180.0 / pi); }

/// A pair of directions at which a BRDF is evaluated.
struct DirectionPair {
  Direction wi{0, 0, 1};
  Direction wo{0, 0, 1};
};

/// Tolerance of z: rotations may move horizontal directions slightly below the surface; they count as horizontal.
inline constexpr double horizonTolerance = 1e-12;
inline bool isBelowHorizon(const Direction& w) { return !(w.z >= -horizonTolerance); }

/// Relative luminance of linear sRGB (ITU-R BT.709 weights).
inline double luminance(const Rgb& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }
inline double maxChannel(const Rgb& c) { return c.x > c.y ? (c.x > c.z ? c.x : c.z) : (c.y > c.z ? c.y : c.z); }

/// Unit vector of polar angle theta from the normal and azimuth phi (rad).
Direction fromSpherical(double theta, double phi);
/// Polar angle in [0, pi] (rad), by atan2: accurate at the pole, where acos(z) loses half its digits.
double polarAngle(const Direction& w);
/// Azimuth in (-pi, pi] (rad); 0 at the pole.
double azimuth(const Direction& w);

/// Rotates directions about the normal, for example to evaluate an anisotropic material at several azimuths.
class AzimuthRotation {
 public:
  /// @param angle rad, counter-clockwise seen from above.
  explicit AzimuthRotation(double angle) : AzimuthRotation(std::cos(angle), std::sin(angle)) {}
  /// The rotation that turns a direction to azimuth 0; none at the pole.
  static AzimuthRotation toZero(const Direction& w) {
    const double across = std::sqrt(w.x * w.x + w.y * w.y);
    return across > 0 ? AzimuthRotation(w.x / across, -w.y / across) : AzimuthRotation(1, 0);
  }

  // Two sums, not a difference and a sum: despite -ffp-contract=off, GCC 12 fuses the latter in some of the functions
  // where it is inlined, and results would differ in the last bit.
  Direction operator()(const Direction& w) const { return {c_ * w.x + minusS_ * w.y, s_ * w.x + c_ * w.y, w.z}; }
  DirectionPair operator()(const DirectionPair& pair) const { return {(*this)(pair.wi), (*this)(pair.wo)}; }

 private:
  AzimuthRotation(double c, double s) : c_(c), s_(s), minusS_(-s) {}

  double c_, s_, minusS_;
};

struct Ray {
  Direction origin, direction;  ///< world, `direction` unit
};

}  // namespace gonio
