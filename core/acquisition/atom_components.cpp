// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/atom_components.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "core/dictionary/signals.h"
#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio::acquisition {

namespace {

using dictionary::Ensemble;

struct ChosenAtom {
  float deviation;  ///< of the coefficient
  std::size_t dictionary;
  std::uint32_t index;
};

/// By decreasing deviation; equal ones by dictionary and index.
std::vector<ChosenAtom> largestAtoms(const DictionaryPrior& prior, std::size_t count) {
  std::vector<ChosenAtom> atoms;
  for (std::size_t d = 0; d < prior.dictionaries.size(); ++d) {
    const CoefficientPrior& one = prior.dictionaries[d];
    for (std::size_t k = 0; k < one.indices.size(); ++k)
      if (const float variance = one.variances[Eigen::Index(k)]; variance > 0)
        atoms.push_back({std::sqrt(variance), d, one.indices[k]});
  }
  std::ranges::sort(atoms, [](const ChosenAtom& a, const ChosenAtom& b) {
    return std::tuple(-a.deviation, a.dictionary, a.index) < std::tuple(-b.deviation, b.dictionary, b.index);
  });
  atoms.resize(std::min(count, atoms.size()));
  return atoms;
}

}  // namespace

dictionary::PrincipalComponents atomComponents(const Ensemble& ensemble, const DictionaryPrior& prior, int atoms,
                                               const TaskControl& control) {
  if (!(prior.grid == ensemble.grid) || prior.dictionaries.size() != ensemble.dictionaries.size())
    throw Error("the prior belongs to another ensemble");
  if (atoms < 1) throw Error("found " + std::to_string(atoms) + " atoms, expected 1 or more");
  const std::vector<ChosenAtom> chosen = largestAtoms(prior, std::size_t(atoms));
  const auto geometry = dictionary::GridGeometry::of(ensemble.grid);
  dictionary::PrincipalComponents result;
  result.mapping.grid = ensemble.grid;
  for (std::size_t cell = 0; cell < ensemble.grid.size(); ++cell) {
    if (geometry->aboveHorizon[cell] == 0) continue;
    result.mapping.cells.push_back(std::uint32_t(cell));
    result.mapping.weights.push_back(geometry->weights[Eigen::Index(cell)]);
  }
  const std::vector<std::uint32_t>& cells = result.mapping.cells;
  result.mapping.reference.assign(cells.size(), 0.0F);
  result.mean.assign(cells.size(), 0.0F);
  TallMatrix columns;
  columns.rows = Eigen::Index(cells.size());
  columns.columns = Eigen::Index(chosen.size());
  columns.values.resize(cells.size() * chosen.size());
  const Eigen::Index n0 = ensemble.grid.phiDCount, n1 = ensemble.grid.thetaDCount;
  parallelForBlocks(
      chosen.size(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          const auto& modes = ensemble.dictionaries[chosen[k].dictionary].modes;
          const auto index = Eigen::Index(chosen[k].index);
          const auto u0 = modes[0].col(index % n0), u1 = modes[1].col(index / n0 % n1),
                     u2 = modes[2].col(index / (n0 * n1));
          float* const column = columns.values.data() + k * cells.size();
          for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto cell = Eigen::Index(cells[i]);
            column[i] = float(double(chosen[k].deviation) * u0[cell % n0] * u1[cell / n0 % n1] * u2[cell / (n0 * n1)]);
          }
        }
      },
      control.between(0, 0.2));
  result.svd = decomposeGramSvd(std::move(columns), int(chosen.size()), control.between(0.2, 1));
  return result;
}

}  // namespace gonio::acquisition
