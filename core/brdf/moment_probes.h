// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/brdf/brdf.h"

/// Densities for importance sampling are judged by the second moment of the estimator f cos theta_i / pdf, in which
/// every viewer counts alike.
namespace gonio {

/// One direction in which the estimator is looked at.
struct MomentProbe {
  DirectionPair pair;
  double energy = 0;  ///< (f cos theta_i)^2 times the solid angle, relative to the viewer's squared albedo and number
};

/// Where the BRDF reflects anything: four polar angles of the viewer, of an anisotropic one three and five azimuths;
/// half vectors on logarithmic rings about the normal. 1,400 evaluations, of an anisotropic one 20,000.
std::vector<MomentProbe> momentProbes(const Brdf& brdf);
/// The same for three polar angles at one azimuth, whatever the BRDF: what lobes are fitted to.
std::vector<MomentProbe> isotropicMomentProbes(const Brdf& brdf);

/// The second moment of the estimator relative to the squared albedo, the mean over the viewers of the probes: 1 where
/// the density is proportional to f cos theta_i. @param density const MomentProbe& -> 1/sr.
template <typename Density>
double secondMoment(const std::vector<MomentProbe>& probes, Density density) {
  double sum = 0;
  for (const MomentProbe& probe : probes) sum += probe.energy / density(probe);
  return sum;
}

/// The same of a sampler with Brdf's pdf().
template <typename Sampler>
double samplerMoment(const std::vector<MomentProbe>& probes, const Sampler& sampler) {
  return secondMoment(probes, [&](const MomentProbe& probe) { return sampler.pdf(probe.pair.wi, probe.pair.wo); });
}

}  // namespace gonio
