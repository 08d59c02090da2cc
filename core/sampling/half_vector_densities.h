// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cmath>
#include <functional>

#include "core/coordinates/half_difference.h"
#include "core/math/fast_functions.h"

/// Densities (core/brdf/density_mixture.h) that draw half vectors, the normals of microfacets, and reflect the viewer
/// about them. alphaX and alphaY are the roughness along x and y.
namespace gonio {

/// Samples half vectors and reflects the viewer about them. `Normals` is a density of unit vectors h with z >= 0:
///   Direction sample(const glm::dvec2& u) const;
///   double density(const Direction& h) const; // 1/sr, integrates to 1 over the upper hemisphere
/// d omega_i = 4 |h . wo| d omega_h. Half vectors that face away from the viewer count too, so each direction of the
/// sphere has one half vector above the horizon, and the density integrates to 1 over the sphere.
template <typename Normals>
struct HalfVectorDensity {
  Normals normals;

  Direction sample(const Direction& wo, const glm::dvec2& u) const {
    const Direction h = normals.sample(u);
    return 2 * glm::dot(wo, h) * h - wo;
  }
  double density(const Direction& w, const Direction& wo) const {
    Direction sum = w + wo;
    const double squaredLength = glm::dot(sum, sum);
    if (!(squaredLength > minSquaredHalfLength)) return 0;
    const double length = std::sqrt(squaredLength);  // 2 cos theta_d
    if (sum.z < 0) sum = -sum;
    return normals.density(sum / length) / (2 * length);
  }
};
template <typename Normals>
HalfVectorDensity(Normals) -> HalfVectorDensity<Normals>;

/// D(h) cos theta_h of Beckmann's distribution of slope roughness alphaX, alphaY (Ward 1992, eq. 6, 7; Walter et al.
/// 2007, eq. 25, 28, 29): exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2) / (pi alpha_x alpha_y h_z^3).
struct BeckmannNormals {
  double alphaX, alphaY;

  Direction sample(const glm::dvec2& u) const {
    const double radius = std::sqrt(-std::log1p(-u.x));
    const auto turn = fastSineAndCosine(u.y);
    const double x = alphaX * radius * turn.cosine, y = alphaY * radius * turn.sine;
    return glm::normalize(Direction(x, y, 1));
  }
  double density(const Direction& h) const {
    if (!(h.z > 0)) return 0;
    const double x = h.x / (alphaX * h.z), y = h.y / (alphaY * h.z);
    // In the exponent: 1 / cos^3 overflows where the exponential underflows.
    return std::exp(-(x * x + y * y) - 3 * std::log(h.z)) / (pi * alphaX * alphaY);
  }
};

/// sqrt((n_x + 1)(n_y + 1)) / (2 pi) cos^e theta_h with e = (n_x h_x^2 + n_y h_y^2) / (1 - h_z^2): Ashikhmin and
/// Shirley 2000, eq. 6, 9, 10; with equal exponents a power of the cosine.
struct CosinePowerNormals {
  double exponentX, exponentY;

  Direction sample(const glm::dvec2& u) const {
    // The direction of this vector is in the right quadrant, for which the published formula needs a case distinction.
    const auto turn = fastSineAndCosine(u.y);
    const double x = std::sqrt(exponentY + 1) * turn.cosine, y = std::sqrt(exponentX + 1) * turn.sine;
    const double length = std::sqrt(x * x + y * y), c = x / length, s = y / length;
    const double exponent = exponentX * c * c + exponentY * s * s;
    const double oneMinusCos = -std::expm1(std::log1p(-u.x) / (exponent + 1));
    const double sine = std::sqrt(oneMinusCos * (2 - oneMinusCos));
    return {sine * c, sine * s, 1 - oneMinusCos};
  }
  double density(const Direction& h) const {
    const double sin2 = h.x * h.x + h.y * h.y;
    const double norm = std::sqrt((exponentX + 1) * (exponentY + 1)) / (2 * pi);
    if (!(sin2 > 0)) return norm;
    if (!(h.z > 0)) return 0;
    const double exponent = (exponentX * h.x * h.x + exponentY * h.y * h.y) / sin2;
    // From the sine near the pole and from the cosine near the horizon, so that no digits are lost.
    return norm * std::exp(exponent * (h.z > 0.5 ? std::log1p(-sin2 / (1 + h.z)) : std::log(h.z)));
  }
};

/// Normals of a rotationally symmetric distribution without a closed-form inverse. The density is piecewise linear in
/// 1 - cos theta_h between 97 values of theta_h, logarithmic from 1e-5 rad; it matches sample() exactly and the
/// distribution approximately.
class TabulatedNormals {
 public:
  /// @param weight unnormalised density at theta_h (rad), such as D cos theta_h, >= 0. Called once per node; non-finite
  /// values count as 0. If all are 0, normals are cosine-weighted.
  explicit TabulatedNormals(const std::function<double(double thetaH)>& weight);

  /// Integral of the weight over the upper hemisphere.
  double total() const { return total_; }

  Direction sample(const glm::dvec2& u) const;
  double density(const Direction& h) const;

 private:
  static constexpr std::size_t circles = 97;

  double total_ = 0;
  std::array<double, circles> density_;     ///< 1/sr
  std::array<double, circles> cumulative_;  ///< fraction inside the circle, 0 to 1
};

/// Visible normals of the GGX distribution, with the density of normals D(h) G1(wo) max(0, h . wo) / cos theta_o (Heitz
/// and d'Eon 2014, "Importance Sampling Microfacet-Based BSDFs using the Distribution of Visible Normals"). Heitz 2018,
/// "Sampling the GGX Distribution of Visible Normals".
struct VisibleNormalDensity {
  double alphaX, alphaY;

  explicit VisibleNormalDensity(double alpha) : VisibleNormalDensity(alpha, alpha) {}
  VisibleNormalDensity(double x, double y) : alphaX(x), alphaY(y) {}

  Direction sample(const Direction& wo, const glm::dvec2& u) const;
  /// D(h) G1(wo) / (4 cos theta_o), 1/sr, computed as D(h) / (4 ggxCosineOverG1(wo)), so that it is finite for a viewer
  /// on the horizon.
  double density(const Direction& w, const Direction& wo) const;
};

/// Visible normals of Beckmann's distribution, sampled by inverting the cumulative distribution of the slopes (some
/// evaluations of erf).
struct BeckmannVisibleDensity {
  double alphaX, alphaY;

  Direction sample(const Direction& wo, const glm::dvec2& u) const;
  double density(const Direction& w, const Direction& wo) const;
};

/// exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2) / (pi alpha_x alpha_y h_z^4), 1/sr: Beckmann's distribution.
/// O(1).
double beckmannDensity(const Direction& half, double alphaX, double alphaY);
/// cos theta (1 + Lambda(w)) for Smith's masking of Beckmann's distribution, finite at the horizon (Heitz 2014,
/// "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", with anisotropic roughness). O(1).
double beckmannCosineOverG1(const Direction& w, double alphaX, double alphaY);
/// As beckmannDensity(), for the GGX distribution: D(h), 1/sr. O(1).
inline double ggxDensity(const Direction& half, double alphaX, double alphaY) {
  const double product = alphaX * alphaY;
  const double slope =
      half.x * half.x * (alphaY / alphaX) + half.y * half.y * (alphaX / alphaY) + product * half.z * half.z;
  return product / (pi * slope * slope);
}
/// As beckmannCosineOverG1(), for the GGX distribution. O(1).
inline double ggxCosineOverG1(const Direction& w, double alphaX, double alphaY) {
  const double x = alphaX * w.x, y = alphaY * w.y;
  return (w.z + std::sqrt(x * x + y * y + w.z * w.z)) / 2;
}

}  // namespace gonio
