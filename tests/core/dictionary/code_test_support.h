// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstring>

#include "core/dictionary/dictionary.h"
#include "tests/core/dictionary/dictionary_test_support.h"

namespace gonio::dictionary::test_support {

/// Root mean square of the differences of valid cells over that of the values.
inline double relativeDifference(const TabulatedBrdf& a, const TabulatedBrdf& b) {
  double difference = 0, total = 0;
  for (std::size_t cell = 0; cell < a.values().size(); ++cell) {
    if (a.valid()[cell] == 0) continue;
    for (int c = 0; c < 3; ++c) {
      difference += std::pow(double(a.values()[cell][c]) - double(b.values()[cell][c]), 2);
      total += std::pow(double(a.values()[cell][c]), 2);
    }
  }
  return std::sqrt(difference / total);
}

inline bool sameBits(const SparseCode& a, const SparseCode& b) {
  for (std::size_t c = 0; c < 3; ++c) {
    const auto &x = a.channels[c].coefficients, &y = b.channels[c].coefficients;
    if (a.channels[c].dictionary != b.channels[c].dictionary || x.size() != y.size()) return false;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (x[i].index != y[i].index || std::memcmp(&x[i].value, &y[i].value, sizeof(float)) != 0) return false;
  }
  return a.transform == b.transform;
}

}  // namespace gonio::dictionary::test_support
