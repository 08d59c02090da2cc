// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/support/task_control.h"

namespace gonio::exports {

/// The series of Blender whose shading an export is for: Cycles has other formulas since Blender 4.0.
enum class BlenderVersion { v3 = 3, v4 = 4 };

/// A Lambertian lobe and GGX lobes with colours that depend on the viewer's polar angle, which renderers with a fixed
/// set of closures, such as Cycles, can represent:
///   w_0(theta_o) / pi + sum_j w_j(theta_o) D_j G_j / (4 cos theta_i cos theta_o).
/// D is that of Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", eq. 33. The masking G is
/// that of Cycles: height-correlated in Blender 4 (Heitz 2014, "Understanding the Masking-Shadowing Function in
/// Microfacet-Based BRDFs", eq. 99), separable in Blender 3 (Walter et al., eq. 34). No Fresnel term. Not reciprocal.
struct ViewLobes {
  std::vector<double> alphas;  ///< GGX alphas, ascending
  std::vector<double> thetas;  ///< knots of the viewer's polar angle, rad, ascending; weights are constant beyond them
  std::vector<std::vector<Rgb>> weights;  ///< [0: Lambert, j + 1: alphas[j]][knot], >= 0, linear between the knots
  BlenderVersion blender = BlenderVersion::v4;
};

/// The lobes as a BRDF, 1/sr, without the cosine.
std::shared_ptr<const Brdf> viewLobesBrdf(ViewLobes lobes);

struct ViewLobesSize {
  std::size_t lobes = 4, knots = 12;
  BlenderVersion blender = BlenderVersion::v4;
};

/// Fits the lobes at each knot of the viewer by a non-negative linear least-squares fit per channel to the residuals of
/// PictureCells (Stark and Parker 1995). The alphas are those of a series from 0.002 to 1 that receive most of the
/// energy. For an anisotropic material the mean over the azimuths is fitted.
/// About 1 s. @throws Cancelled.
ViewLobes fitViewLobes(const Brdf& material, const ViewLobesSize& size, const TaskControl& control = {});

}  // namespace gonio::exports
