// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>

#include "core/math/fast_functions.h"
#include "core/models/surface_geometry.h"
#include "core/sampling/direction_densities.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

inline constexpr std::string_view ward1992 = "Ward 1992, Measuring and Modeling Anisotropic Reflection";

/// exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2) / (4 pi alpha_x alpha_y): the Gaussian of surface slopes in
/// the models of Ward's family (Ward 1992, eq. 5a without the square root; in the form of Walter 2005, "Notes on the
/// Ward BRDF", without azimuth). x is along the grain, at the angle `rotation` (rad) from the tangent.
class WardLobe {
 public:
  WardLobe(double alphaX, double alphaY, double rotation)
      : toGrain_(-rotation),
        inverseX2_(1 / (alphaX * alphaX)),
        inverseY2_(1 / (alphaY * alphaY)),
        normaliser_(1 / (4 * pi * alphaX * alphaY)) {}

  double operator()(const SurfaceGeometry& g) const {
    const Direction half = toGrain_(g.half);
    const double slopes = half.x * half.x * inverseX2_ + half.y * half.y * inverseY2_;
    return normaliser_ * fastExp(-slopes / (half.z * half.z));
  }

 private:
  AzimuthRotation toGrain_;
  double inverseX2_, inverseY2_, normaliser_;
};

/// k_d / pi + k_s WardLobe * fade: the models differ only in `double fade(const SurfaceGeometry&)`,
/// their factor in the cosines, such as 1 / sqrt(cos theta_i cos theta_o) of Ward 1992.
template <typename Fade>
std::unique_ptr<const Brdf> makeWardBrdf(const Rgb& kd, const Rgb& ks, double alphaX, double alphaY, double rotation,
                                         Fade fade) {
  return makeGeometryBrdf([kd = kd / pi, ks, lobe = WardLobe(alphaX, alphaY, rotation),
                           fade](const SurfaceGeometry& g) { return kd + ks * (lobe(g) * fade(g)); },
                          diffuseMixture(maxChannel(kd), maxChannel(ks),
                                         RotatedDensity(HalfVectorDensity{BeckmannNormals{alphaX, alphaY}}, rotation)),
                          alphaX == alphaY);
}

}  // namespace gonio::models
