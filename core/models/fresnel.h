// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

namespace gonio::models {

/// Unpolarised Fresnel reflectance of a dielectric in the form of Cook and Torrance (1982).
/// @param cosD cosine of the angle to the (micro)facet normal, [0, 1]; @param eta relative index, > 0.
/// eta = 1 gives 0, total reflection (eta < 1) and grazing give 1. O(1).
double fresnelDielectric(double cosD, double eta);

/// Schlick, "An Inexpensive BRDF Model for Physically-based Rendering" (1994): f0 + (1 - f0)(1 - cosD)^5.
double fresnelSchlick(double cosD, double f0);

/// Index of refraction whose reflectance at normal incidence is f0 in [0, 1); f0 >= 1 gives infinity.
double indexFromNormalReflectance(double f0);

}  // namespace gonio::models
