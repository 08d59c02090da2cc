// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/brdf.h"
#include "core/brdf/rotated_lobe.h"
#include "core/brdf/visible_normal_lobe.h"

namespace gonio {

class TabulatedLobe;

/// The part of a sampling density that follows the grain of an anisotropic BRDF: visible normals of an anisotropic GGX
/// distribution (Heitz 2018, "Sampling the GGX Distribution of Visible Normals"), rotated with the grain.
struct GrainLobe {
  double alphaX = 1, alphaY = 1;  ///< [1e-3, 1], along the lobe's x and y axes
  double rotation = 0;            ///< angle of the lobe's x axis from the tangent, rad, counter-clockwise
  /// Fraction of this lobe in the samples that are not cosine-weighted, [0, 0.9]; 0: no grain.
  double fraction = 0;

  RotatedLobe<VisibleNormalLobe> lobe() const { return {VisibleNormalLobe(alphaX, alphaY), rotation}; }
};

/// Fits the grain: it minimises the second moment of the estimator f cos theta_i / pdf over three polar angles and five
/// azimuths of the viewer, in the mixture with cosine-weighted directions and `azimuthMean`. The fraction is 0 for an
/// isotropic BRDF, and if the grain does not at least halve the moment. About 20,000 evaluations and a search, under
/// 0.1 s.
/// @param azimuthMean the TabulatedLobe of the same BRDF, which is its mean over the azimuths.
/// @param cosineFraction fraction of cosine-weighted samples.
GrainLobe estimateGrainLobe(const Brdf& brdf, const TabulatedLobe& azimuthMean, double cosineFraction);

/// Whether two lobes sample about equally well.
bool areSimilar(const GrainLobe& a, const GrainLobe& b);

}  // namespace gonio
