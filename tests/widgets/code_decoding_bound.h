// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <vector>

#include "core/dictionary/decode.h"
#include "tests/core/dictionary/dictionary_test_support.h"

/// Codes to decode, and how far two ways of decoding one in single precision may lie apart.
namespace gonio::test {

using dictionary::Ensemble;
using dictionary::SparseCode;

/// Three different sizes, none a multiple of the layers of a pass.
inline constexpr HalfDifferenceGrid oddGrid{.thetaHCount = 11, .thetaDCount = 7, .phiDCount = 12};

inline Ensemble ensembleOn(const HalfDifferenceGrid& grid, int dictionaries) {
  std::mt19937_64 random(3);
  Ensemble ensemble{.grid = grid, .dictionaries = {}, .learnedFrom = {}};
  for (int d = 0; d < dictionaries; ++d)
    ensemble.dictionaries.push_back(
        {dictionary::test_support::randomDictionary(dictionary::modeSizes(grid), random), 10});
  return ensemble;
}

inline SparseCode randomCode(const Ensemble& ensemble, DataTransform transform, std::array<int, 3> counts) {
  std::mt19937_64 random(5);
  std::normal_distribution<float> normal(0, 4);
  SparseCode code{.grid = ensemble.grid, .transform = transform, .channels = {}};
  for (std::size_t c = 0; c < 3; ++c) {
    code.channels[c].dictionary = int((c + 1) % ensemble.dictionaries.size());
    std::map<std::uint32_t, float> places;
    while (int(places.size()) < counts[c]) places[std::uint32_t(random() % ensemble.grid.size())] = normal(random);
    for (const auto& [index, value] : places) code.channels[c].coefficients.push_back({index, value});
    std::sort(code.channels[c].coefficients.begin(), code.channels[c].coefficients.end(), dictionary::isLarger<float>);
  }
  return code;
}

/// Additions in the longest sum that makes a transformed value, over all three modes.
inline int longestSum(const SparseCode& code) {
  const auto sizes = dictionary::modeSizes(code.grid);
  int longest = 0;
  for (const auto& channel : code.channels) {
    std::map<int, int> perGroup;
    std::map<int, std::map<int, int>> groups;  // of a slab
    for (const auto& c : channel.coefficients) {
      const int pair = int(c.index) / sizes[0];
      ++perGroup[pair];
      groups[pair / sizes[1]][pair] = 1;
    }
    int most = 0, maxGroups = 0;
    for (const auto& [pair, count] : perGroup) most = std::max(most, count);
    for (const auto& [slab, members] : groups) maxGroups = std::max(maxGroups, int(members.size()));
    longest = std::max(longest, most + maxGroups + int(groups.size()));
  }
  return longest;
}

/// The sum of the absolute values of all products that make each transformed value, channel by channel.
inline std::vector<double> absoluteSums(const Ensemble& ensemble, const SparseCode& code, std::size_t c) {
  const auto& channel = code.channels[c];
  auto atoms = dictionary::unscaledAtoms(ensemble.dictionaries[std::size_t(channel.dictionary)],
                                         *dictionary::GridGeometry::of(code.grid));
  for (auto& mode : atoms) mode = mode.cwiseAbs().eval();
  std::vector<dictionary::Coefficient<double>> absolute;
  for (const auto& k : channel.coefficients) absolute.push_back({k.index, std::abs(double(k.value))});
  std::vector<double> sums(code.grid.size());
  dictionary::compose<double>({atoms[0], atoms[1], atoms[2]}, absolute, sums.data());
  return sums;
}

/// How far the reflectances of a channel, decoded in single precision, may lie from others that are too; 0 in invalid
/// cells. Both add the same products in different orders. A sum of n products in precision u is off by at most n u
/// times the sum of their sizes (Higham 2002, section 3.1; five more for products of three rounded factors and the
/// sizes' own rounding), so two lie within twice that in the transformed value. The inverse carries it over, and has an
/// error of its own: 3 + 2 |y| units in the last place, as GLSL allows exp() and as the rounding of y brings about.
inline std::vector<double> allowedErrors(const Ensemble& ensemble, const SparseCode& code, int channel,
                                         const TabulatedBrdf& decoded) {
  constexpr double u = std::numeric_limits<float>::epsilon() / 2;
  const auto geometry = dictionary::GridGeometry::of(code.grid);
  const double sumError = 2 * (longestSum(code) + 5) * u;
  std::vector<double> allowed = absoluteSums(ensemble, code, std::size_t(channel));
  for (std::size_t cell = 0; cell < allowed.size(); ++cell) {
    const double value = decoded.values()[cell][channel], weight = geometry->weights[Eigen::Index(cell)];
    const double y = transformed(code.transform, value, weight);
    const double carried = inverseTransformed(code.transform, y + sumError * allowed[cell], weight) - value;
    allowed[cell] = decoded.valid()[cell] ? carried + value * (3 + 2 * y) * 4 * u + 1e-30 : 0;
  }
  return allowed;
}

}  // namespace gonio::test
