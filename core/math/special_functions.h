// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

namespace gonio {

/// ln Gamma(s, x), the natural logarithm of the upper incomplete gamma function: the integral of t^(s-1) e^-t from x to
/// infinity (DLMF 8.2.2). For any real s, including negative values and the poles of Gamma(s), and x > 0. The standard
/// library has no such function, and series about s = 0, -1, .. cancel; this sums positive terms only (Gauss-Legendre
/// in ln t). Relative error of Gamma(s, x) below 1e-13 for s in [-10, 10], x in [1e-12, 100]. About 5 us; allocates
/// nothing.
double logUpperIncompleteGamma(double s, double x);

/// ln |Gamma(x)|, as std::lgamma, which also writes the sign of Gamma(x) to a variable of the whole program: two
/// threads must not call it at the same time.
double logGamma(double x);

}  // namespace gonio
