// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

namespace gonio::plots {

/// `count` >= 2 ascending values from `first` to `last`, both exactly there, dense about `centre` (clamped to the
/// range): the spacing grows with the distance as a hyperbolic sine, some `density`-fold from the centre to the far
/// end. For highlights that are narrow in an otherwise smooth curve.
std::vector<double> nodesAbout(double centre, double first, double last, int count, double density = 30);

}  // namespace gonio::plots
