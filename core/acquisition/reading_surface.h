// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/acquisition/factor_plan.h"
#include "core/brdf/brdf.h"

namespace gonio::acquisition {

/// A material fitted to all readings of a factor measurement at once, instead of a product of two of its curves:
///
///     rho = exp(k(theta_i) + k(theta_o)) + exp(a(theta_d) + b(v) + c(theta_d, v)),  v = v(sin theta_h cos^p theta_d)
///
/// a body that depends on the two polar angles, and a highlight whose profile b over the distance from the mirror
/// direction changes with the angle by c. With p = 0 the distance is that of FactorAxes::halfDifference, with p = 1
/// half of |Dp| = 2 cos theta_d sin theta_h; the fit is made for p = 0, 1/2 and 1, and the result is the mean of the
/// three, weighted by the inverse of their squared errors. v is a monotone function that spreads the changes of the
/// `across` readings evenly. k, a, b and c are piecewise linear. The method of Levenberg and Marquardt minimises the
/// squared errors of ln(rho + e), e = 1e-4 1/sr plus a hundredth of the median reading and a ten-thousandth of the
/// largest, plus penalties on the roughness of the curves. A reading has the weight cosineWeight(), because images
/// hardly show grazing directions, where measurements are rough; with known noise it is divided by 1 plus the variance
/// of ln(rho + e) over that of a model error of 5 %. Reciprocal.
///
/// @param readings directions in any number and order; the `across` readings determine v. @param isBounded whether
/// values are at most the largest reading of their channel, and at most the larger of two interpolated readings of the
/// curves: in the mirror direction at the same theta_d, and across it at the same |Dp|. A channel whose readings are
/// all 0 is 0. About 0.1 s for 180 readings. @throws Error if the numbers of directions and values differ.
std::shared_ptr<const Brdf> fitReadings(const FactorReadings& readings, bool isBounded);

}  // namespace gonio::acquisition
