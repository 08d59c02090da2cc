// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/brdf/brdf.h"

/// Densities for importance sampling are compared by the second moment of the estimator f cos theta_i / pdf, with equal
/// weight for every viewer.
namespace gonio {

/// One direction pair at which the estimator is evaluated.
struct MomentProbe {
  DirectionPair pair;
  double energy = 0;  ///< (f cos theta_i)^2 times the solid angle, divided by the viewer's squared albedo and the
                      ///< number of viewers
};

/// Probes where the BRDF is not 0: for four polar angles of the viewer (anisotropic BRDFs: three polar angles, five
/// azimuths each) and half vectors on logarithmic rings about the normal. 1,400 evaluations (anisotropic: 20,000).
std::vector<MomentProbe> momentProbes(const Brdf& brdf);
/// The same for three polar angles of the viewer at one azimuth, also for anisotropic BRDFs; used to fit lobes.
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

}  // namespace gonio
