// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/brdf.h"
#include "core/math/marginal_warp.h"

namespace gonio::exports {

/// A distribution of microfacet normals over the square of core/brdf/normal_square.h (rows azimuth, columns polar
/// angle), and the projected area of the microfacets over directions of the same square. One slice each.
struct NormalDensity {
  SliceStack<float> ndf, sigma;
};

/// Sizes of the distribution of a material. The polar angle has more nodes than the measurement of a highlight needs;
/// the azimuth counts for anisotropic materials alone.
struct DensitySize {
  std::size_t columns = 128;
  std::size_t rows = 2;  ///< with both ends of the circle; 2 for an isotropic material
};

/// The distribution from which the material's own retro-reflection would come if it were one bounce of mirrors: the
/// dominant eigenvector of Dupuy et al. 2015, "Extracting Microfacet-based BRDF Parameters from Arbitrary Materials
/// with Power Iterations", by four iterations, normalised to the integral 1 of D cos theta. Up to half of it is
/// replaced by the highlights that viewers at six polar angles see (what rises above the smallest value within 41
/// degrees of the normal), then `floor` of the uniform distribution 1/pi is mixed in. A parameterisation, no claim
/// about the material: any positive D is right. Where the material sends nothing back it is uniform. (columns rows)^2
/// steps: some ms isotropic, some 0.1 s anisotropic.
NormalDensity normalDensity(const Brdf& material, const DensitySize& size, double floor);

/// The field `vndf` for one polar angle of the incident direction and all its azimuths, a slice each:
/// D(m) max(0, w . m) du on `rows` x as many columns as the ndf.
SliceStack<float> visibleNormalSlices(const SliceStack<float>& ndf, std::span<const float> phis, double theta,
                                      std::size_t rows, bool isotropic);

}  // namespace gonio::exports
