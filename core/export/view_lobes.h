// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/support/task_control.h"

namespace gonio::exports {

/// A Lambertian lobe and GGX lobes whose colours depend on the viewer's polar angle, as shaders with fixed closures can
/// show them (Cycles): w_0(theta_o) / pi + sum_j w_j(theta_o) D_j G_j / (4 cos theta_i cos theta_o). D and the
/// separable masking G are those of Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces",
/// eq. 33-34, without a Fresnel term. Not reciprocal.
struct ViewLobes {
  std::vector<double> alphas;             ///< of the GGX lobes, ascending
  std::vector<double> thetas;             ///< knots of the viewer's polar angle, rad, ascending; constant beyond them
  std::vector<std::vector<Rgb>> weights;  ///< [0: Lambert, j + 1: alphas[j]][knot], >= 0, linear between the knots
};

/// The lobes as a BRDF, 1/sr without the cosine.
std::shared_ptr<const Brdf> viewLobesBrdf(ViewLobes lobes);

struct ViewLobesSize {
  std::size_t lobes = 4, knots = 12;
};

/// The lobes of least squared error of the light that reaches the viewer at each knot, by PictureCells: a linear
/// non-negative fit per channel and knot (Stark and Parker 1995). The widths are those of a series from 0.002 to 1 that
/// take most of the energy. Of an anisotropic material the mean over the azimuths.
/// About 1 s. @throws Cancelled.
ViewLobes fitViewLobes(const Brdf& material, const ViewLobesSize& size, const TaskControl& control = {});

}  // namespace gonio::exports
