// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

namespace gonio::plots {

/// `count` >= 2 ascending values from exactly `first` to exactly `last`, dense about `centre` (clamped to the range),
/// for curves with a narrow highlight: the spacing grows with the distance from the centre as a hyperbolic sine, by a
/// factor of about `density` at the far end.
std::vector<double> nodesAbout(double centre, double first, double last, int count, double density = 30);

}  // namespace gonio::plots
