// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/support/task_control.h"

namespace gonio::exports {

/// A Lambertian lobe and GGX lobes with colours that depend on the viewer's polar angle, which renderers with a fixed
/// set of closures, such as Cycles, can represent:
///   w_0(theta_o) / pi + sum_j w_j(theta_o) D_j G_j / (4 cos theta_i cos theta_o).
/// D and the separable masking G are those of Walter et al. 2007, "Microfacet Models for Refraction through Rough
/// Surfaces", eq. 33-34, as in Cycles of Blender 3.4 (later versions use height-correlated masking), without a Fresnel
/// term. Not reciprocal.
struct ViewLobes {
  std::vector<double> alphas;  ///< GGX alphas, ascending
  std::vector<double> thetas;  ///< knots of the viewer's polar angle, rad, ascending; weights are constant beyond them
  std::vector<std::vector<Rgb>> weights;  ///< [0: Lambert, j + 1: alphas[j]][knot], >= 0, linear between the knots
};

/// The lobes as a BRDF, 1/sr, without the cosine.
std::shared_ptr<const Brdf> viewLobesBrdf(ViewLobes lobes);

struct ViewLobesSize {
  std::size_t lobes = 4, knots = 12;
};

/// Fits the lobes at each knot of the viewer by a non-negative linear least-squares fit per channel to the residuals of
/// PictureCells (Stark and Parker 1995). The alphas are those of a series from 0.002 to 1 that receive most of the
/// energy. For an anisotropic material the mean over the azimuths is fitted.
/// About 1 s. @throws Cancelled.
ViewLobes fitViewLobes(const Brdf& material, const ViewLobesSize& size, const TaskControl& control = {});

}  // namespace gonio::exports
