// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/brdf/brdf.h"
#include "core/sampling/direction_densities.h"
#include "core/sampling/half_vector_densities.h"

/// Closed-form densities fitted to a BRDF, and the measure of a fit: the second moment of the estimator
/// f cos theta_i / pdf, with equal weight for every viewer.
namespace gonio {

class TabulatedDensity;

/// One direction pair at which the estimator is evaluated.
struct MomentProbe {
  DirectionPair pair;
  double energy = 0;  ///< (f cos theta_i)^2 times the solid angle, divided by the viewer's squared albedo and the
                      ///< number of viewers
};

/// Probes where the BRDF is not 0: for four polar angles of the viewer (anisotropic BRDFs: three polar angles, five
/// azimuths each) and half vectors on logarithmic rings about the normal. 1,400 evaluations (anisotropic: 20,000).
std::vector<MomentProbe> momentProbes(const Brdf& brdf);
/// The same for three polar angles of the viewer at one azimuth, also for anisotropic BRDFs; used to fit
/// SamplingDensity.
std::vector<MomentProbe> isotropicMomentProbes(const Brdf& brdf);

/// The second moment of the estimator relative to the squared albedo, averaged over the viewers: 1 if the density is
/// proportional to f cos theta_i. @param density callable with a MomentProbe, returns 1/sr.
template <typename Density>
double secondMoment(const std::vector<MomentProbe>& probes, Density density) {
  double sum = 0;
  for (const MomentProbe& probe : probes) sum += probe.energy / density(probe);
  return sum;
}

/// The second moment for a sampler with a member pdf(wi, wo), such as a Brdf.
template <typename Sampler>
double samplerMoment(const std::vector<MomentProbe>& probes, const Sampler& sampler) {
  return secondMoment(probes, [&](const MomentProbe& probe) { return sampler.pdf(probe.pair.wi, probe.pair.wo); });
}

/// An approximate density for importance sampling of any isotropic BRDF: a cosine-weighted part and the visible normals
/// of a GGX distribution (Heitz 2018, "Sampling the GGX Distribution of Visible Normals"). The preview's shader uses
/// the same two parameters. pdf > 0 over the whole hemisphere, so estimates are unbiased even if it fits badly.
struct SamplingDensity {
  double roughness = 0.3;         ///< GGX alpha, [1e-3, 1]
  double specularFraction = 0.5;  ///< fraction of samples taken from the visible normals, [0, 0.95]

  /// Samples wi for a viewer wo (z > 0). `u` in [0, 1)^3: u.x selects the part, u.y and u.z the direction.
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const;
  /// From two numbers: the first one selects the part, is rescaled and used again, as in DensityMixture.
  DirectionSample sample(const Direction& wo, const glm::dvec2& u) const {
    if (u.x < specularFraction) return sample(wo, glm::dvec3(0, u.x / specularFraction, u.y));
    return sample(wo, glm::dvec3(1, (u.x - specularFraction) / (1 - specularFraction), u.y));
  }
  /// Density of sample() at wi, 1/sr; 0 below the horizon.
  double pdf(const Direction& wi, const Direction& wo) const;
};

/// Fits the density to a BRDF: minimises the second moment of the estimator at isotropicMomentProbes(). Takes a few ms.
SamplingDensity estimateSamplingDensity(const Brdf& brdf);

/// Whether two densities sample about equally well.
bool areSimilar(const SamplingDensity& a, const SamplingDensity& b);

/// The part of a sampling density that follows the grain of an anisotropic BRDF: visible normals of an anisotropic GGX
/// distribution (Heitz 2018, "Sampling the GGX Distribution of Visible Normals"), rotated with the grain.
struct GrainDensity {
  double alphaX = 1, alphaY = 1;  ///< [1e-3, 1], along its own x and y axes
  double rotation = 0;            ///< angle of its x axis from the tangent, rad, counter-clockwise
  /// Fraction of this density in the samples that are not cosine-weighted, [0, 0.9]; 0: no grain.
  double fraction = 0;

  RotatedDensity<VisibleNormalDensity> rotated() const { return {VisibleNormalDensity(alphaX, alphaY), rotation}; }
};

/// Fits the grain: it minimises the second moment of the estimator f cos theta_i / pdf over three polar angles and five
/// azimuths of the viewer, in the mixture with cosine-weighted directions and `azimuthMean`. The fraction is 0 for an
/// isotropic BRDF, and if the grain does not at least halve the moment. About 20,000 evaluations and a search, under
/// 0.1 s.
/// @param azimuthMean the TabulatedDensity of the same BRDF, which is its mean over the azimuths.
/// @param cosineFraction fraction of cosine-weighted samples.
GrainDensity estimateGrainDensity(const Brdf& brdf, const TabulatedDensity& azimuthMean, double cosineFraction);

/// Whether two densities sample about equally well.
bool areSimilar(const GrainDensity& a, const GrainDensity& b);

}  // namespace gonio
