// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/brdf/value_bound.h"

/// Peaks of a BRDF that are narrower than a quadrature or a sampling density: one cell of a table with a value of 1e6,
/// a band of a degree. No fixed set of directions finds them all, but the bounds of the values (ValueBound) do.
namespace gonio {

/// A set of direction pairs in which a BRDF may reflect far more than the samples of a density show.
struct NarrowPeak {
  PairBox box;  ///< for isotropic BRDFs with psi in [0, pi]; the mirrored half vectors (-psi) belong to the set, too
  double most = 0;  ///< upper bound of the integral of f cos theta_i over the lights of any viewer, largest channel
};

/// Where narrowPeaks() searches, and how finely.
struct PeakSearch {
  Range thetaO;       ///< polar angles of the viewers, rad
  Range phiO = 0;     ///< their azimuths, rad; {0, 0} for isotropic BRDFs
  double albedo = 0;  ///< what the samples of the density show: largest channel of the directional albedo
  /// Size of the smallest sets, in cells of a MERL grid of theta_h and theta_d.
  double cells = 0.5;
  int steps = 4000;  ///< maximum number of bounds that are computed
};

/// The sets of half vectors in which the bound of the values exceeds 32 times the albedo that the density expects
/// there, split until they are as fine as a cell. Empty if they reflect at most 0.5 % of the albedo in total: then the
/// samples of the density suffice; and if the bounds are not local (ValueBound::isLocal()). The sets do not overlap.
/// About 2 microseconds per step for a table.
/// @param density of the sampled directions of light, 1/sr, for a pair above the horizon.
std::vector<NarrowPeak> narrowPeaks(const ValueBound& values, bool isotropic, const PeakSearch& search,
                                    const std::function<double(const DirectionPair&)>& density);

/// The mean of weights f cos theta_i / pdf, each at most 32 times the mean: a chance hit of a narrow peak does not
/// count, so that the result is suitable as PeakSearch::albedo.
double albedoWithoutPeaks(const std::vector<double>& weights);

/// A pair with its half vector in a set, for one of the set's viewers, and its part of the integral.
struct PeakPair {
  DirectionPair pair;
  double weight = 0;  ///< cos theta_i times the solid angle of the lights of the whole set; 0 below the horizon
};
/// Uniformly distributed over the half vectors of the set if all numbers are uniform in [0, 1). @param u azimuth and
/// polar angle of the half vector. @param viewer polar angle and azimuth of the viewer.
PeakPair pairInPeak(const NarrowPeak& peak, bool isotropic, const glm::dvec2& u, const glm::dvec2& viewer);

}  // namespace gonio
