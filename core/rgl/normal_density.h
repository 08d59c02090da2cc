// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/brdf.h"
#include "core/math/marginal_warp.h"

namespace gonio::rgl {

/// A distribution D of microfacet normals, 1/sr, over the square of core/brdf/normal_square.h (rows azimuth, columns
/// polar angle), and sigma, the projected area of the microfacets, over directions on the same square. One slice each.
struct NormalDensity {
  SliceStack<float> ndf, sigma;
};

/// Number of nodes of a distribution. The polar angle has more nodes than the measurement of a highlight needs.
struct DensitySize {
  std::size_t columns = 128;
  std::size_t rows = 2;  ///< azimuths, including both ends of the circle; 2 for isotropic materials
};

/// Estimates a distribution from the material's retro-reflection, as if it were single reflection by mirror facets: the
/// dominant eigenvector of Dupuy et al. 2015, "Extracting Microfacet-based BRDF Parameters from Arbitrary Materials
/// with Power Iterations", after four iterations, normalised so that D cos theta integrates to 1. Up to half of D is
/// then replaced by the highlights that viewers at six polar angles see. A highlight is the excess of the values over
/// their minimum, for half vectors within 41 degrees of the normal; subtracting the minimum removes the diffuse term.
/// Finally the uniform distribution 1/pi is mixed in with the fraction `floor`. A material without retro-reflection
/// starts from the uniform distribution. The result only serves as a parameterisation, for which any positive D is
/// correct. (columns rows)^2 steps: a few ms isotropic, about 0.1 s anisotropic.
NormalDensity normalDensity(const Brdf& material, const DensitySize& size, double floor);

/// The field `vndf` for one polar angle `theta` of the incident direction (rad) and all azimuths `phis`, one slice
/// each: D(m) max(0, w . m) times the solid angle of normals per area of the square, with `rows` rows and the columns
/// of the ndf.
SliceStack<float> visibleNormalSlices(const SliceStack<float>& ndf, std::span<const float> phis, double theta,
                                      std::size_t rows, bool isotropic);

}  // namespace gonio::rgl
