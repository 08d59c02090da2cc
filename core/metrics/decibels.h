// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <limits>

namespace gonio::metrics {

/// 10 log10(signal / noise) of two energies, dB. +infinity without noise; NaN without signal, with or without noise.
inline double decibels(double signal, double noise) {
  if (!(signal > 0)) return std::numeric_limits<double>::quiet_NaN();
  if (noise == 0) return std::numeric_limits<double>::infinity();
  return 10 * std::log10(signal / noise);
}

}  // namespace gonio::metrics
