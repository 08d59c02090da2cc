// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/sample_selection.h"

#include <algorithm>
#include <limits>
#include <string>

#include "core/acquisition/a_optimal_selection.h"
#include "core/acquisition/condition_search.h"
#include "core/acquisition/reconstruction.h"
#include "core/acquisition/sampling_plan.h"
#include "core/acquisition/simultaneous_pursuit.h"
#include "core/acquisition/unguided_selection.h"
#include "core/coordinates/grid_directions.h"
#include "core/math/decompositions.h"
#include "core/math/parallel.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::acquisition {

namespace {

using dictionary::PrincipalComponents;
using Rows = std::vector<std::size_t>;
using Chosen = std::function<void(std::uint32_t cell)>;

/// Indices into basis.mapping.cells of the cells that can be measured, each pair of directions once, ascending.
Rows measurableRows(const PrincipalComponents& basis, const MeasurableDirections& measurable) {
  measurable.check();
  constexpr std::size_t block = 4096;
  const HalfDifferenceGrid& grid = basis.mapping.grid;
  const GridDirections directions(grid);
  std::vector<char> allowed(basis.mapping.cells.size());
  parallelForBlocks(allowed.size(), block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const std::uint32_t cell = basis.mapping.cells[row];
      const GridDirections::Node node = directions.at(cell);
      allowed[row] = pairNode(grid, cell) == cell && node.aboveHorizon && measurable.allows(node.pair);
    }
  });
  Rows rows;
  for (std::size_t row = 0; row < allowed.size(); ++row)
    if (allowed[row]) rows.push_back(row);
  return rows;
}

/// The condition number of the rows of U Sigma in the first components.
double conditionOf(const PrincipalComponents& basis, const Rows& rows, Eigen::Index components) {
  if (rows.empty() || components == 0) return 0;
  Eigen::MatrixXd chosen(Eigen::Index(rows.size()), components);
  for (std::size_t i = 0; i < rows.size(); ++i)
    chosen.row(Eigen::Index(i)) = basis.svd.u.view().row(Eigen::Index(rows[i])).head(components).cast<double>();
  chosen *= basis.svd.singularValues.head(components).asDiagonal();
  const Eigen::VectorXd values = thinSvd(chosen).singularValues;
  const double smallest = values.size() > 0 ? values[values.size() - 1] : 0;
  return smallest > 0 ? values[0] / smallest : std::numeric_limits<double>::infinity();
}

std::string whyFewer(PursuitStop stop, std::size_t chosen, const SelectionOptions& options, Eigen::Index components) {
  if (stop == PursuitStop::enough) return {};
  const std::string counts =
      std::to_string(chosen) + " of " + std::to_string(options.samples) + " samples were chosen: ";
  if (stop == PursuitStop::exhausted) return counts + "no other measurable sample adds information";
  return counts + "they already determine all " + std::to_string(components) + " principal components";
}

SampleSelection pursue(const PrincipalComponents& basis, const SelectionOptions& options, const Rows& rows,
                       const TaskControl& control, const Chosen& chosen) {
  const int components = std::min(usedComponents(options), basis.count());
  const Eigen::Index signals = options.method == SelectionMethod::simultaneousPursuitFirstColumns
                                   ? std::min<Eigen::Index>(components, basis.svd.v.rows())
                                   : basis.svd.v.rows();
  const bool isPrinted = options.method == SelectionMethod::simultaneousPursuitUnnormalised;
  const CellAtoms atoms(basis, components, rows, isPrinted ? AtomLengths::own : AtomLengths::unit);
  const auto cellOf = [&](Eigen::Index atom) { return basis.mapping.cells[atoms.row(atom)]; };
  const SimultaneousPursuitResult pursuit =
      simultaneousPursuit(atoms, basis.svd.v.topLeftCorner(signals, components).transpose(), options.samples, control,
                          [&](Eigen::Index atom) {
                            if (chosen) chosen(cellOf(atom));
                          });
  SampleSelection result{.residuals = pursuit.residuals};
  Rows chosenRows;
  for (const Eigen::Index atom : pursuit.atoms) {
    result.cells.push_back(cellOf(atom));
    chosenRows.push_back(atoms.row(atom));
  }
  result.conditionNumber = conditionOf(basis, chosenRows, components);
  result.warning = whyFewer(pursuit.stop, chosenRows.size(), options, components);
  return result;
}

SampleSelection selectAOptimal(const PrincipalComponents& basis, const SelectionOptions& options, const Rows& rows,
                               const TaskControl& control, const Chosen& chosen) {
  const int components = std::min(usedComponents(options), basis.count());
  const AOptimalSelection found =
      chooseAOptimal(basis, rows, options.samples, components, control, [&](std::size_t row) {
        if (chosen) chosen(basis.mapping.cells[row]);
      });
  SampleSelection result{.residuals = found.residuals, .conditionNumber = conditionOf(basis, found.rows, components)};
  for (const std::size_t row : found.rows) result.cells.push_back(basis.mapping.cells[row]);
  if (found.rows.size() < std::size_t(options.samples))
    result.warning = whyFewer(PursuitStop::exhausted, found.rows.size(), options, components);
  return result;
}

/// The rows that a method without residuals chooses.
Rows otherRows(const PrincipalComponents& basis, const SelectionOptions& options, const Rows& rows,
               const TaskControl& control) {
  if (options.method == SelectionMethod::conditionNumber)
    return searchByCondition(basis, rows, options.samples, options.seed, options.restarts, control).rows;
  std::vector<std::uint32_t> cells;
  for (const std::size_t row : rows) cells.push_back(basis.mapping.cells[row]);
  Rows chosen = options.method == SelectionMethod::random
                    ? randomIndices(rows.size(), std::size_t(options.samples), options.seed)
                    : evenlySpreadIndices(basis.mapping.grid, cells, std::size_t(options.samples));
  for (std::size_t& index : chosen) index = rows[index];
  return chosen;
}

SampleSelection selectOtherwise(const PrincipalComponents& basis, const SelectionOptions& options, const Rows& rows,
                                const TaskControl& control, const Chosen& chosen) {
  const Rows chosenRows = otherRows(basis, options, rows, control);
  SampleSelection result{.conditionNumber =
                             conditionOf(basis, chosenRows, std::min(int(chosenRows.size()), basis.count()))};
  for (const std::size_t row : chosenRows) {
    result.cells.push_back(basis.mapping.cells[row]);
    if (chosen) chosen(result.cells.back());
  }
  if (chosenRows.size() < std::size_t(options.samples))
    result.warning = "only " + std::to_string(chosenRows.size()) + " cells can be measured; " +
                     std::to_string(options.samples) + " samples were requested";
  control.report(1);
  return result;
}

bool isPursuit(SelectionMethod method) {
  return method == SelectionMethod::simultaneousPursuit || method == SelectionMethod::simultaneousPursuitFirstColumns ||
         method == SelectionMethod::simultaneousPursuitUnnormalised;
}

bool needsComponents(SelectionMethod method) {
  return isPursuit(method) || method == SelectionMethod::conditionNumber || method == SelectionMethod::aOptimal;
}

void checkSelection(const PrincipalComponents& basis, const SelectionOptions& options) {
  if (options.samples < 1)
    throw Error("found " + std::to_string(options.samples) + " samples to choose, expected at least 1");
  if (options.components < 0)
    throw Error("found " + std::to_string(options.components) + " components, expected 0 or more");
  if (basis.count() == 0 && needsComponents(options.method))
    throw Error(
        "the training materials are all equal, so they have no principal components and no direction is better than "
        "another");
}

}  // namespace

SelectionMethod usedMethod(const SelectionOptions& options) {
  if (options.method != SelectionMethod::automatic) return options.method;
  return options.samples <= mostAOptimalSamples ? SelectionMethod::aOptimal : SelectionMethod::simultaneousPursuit;
}

int usedComponents(const SelectionOptions& options) {
  if (options.components > 0) return options.components;
  return usedMethod(options) == SelectionMethod::aOptimal ? std::max(options.samples, aOptimalComponents)
                                                          : options.samples;
}

SampleSelection selectSamples(const PrincipalComponents& basis, const SelectionOptions& requested,
                              const TaskControl& control, const Chosen& chosen) {
  SelectionOptions options = requested;
  options.method = usedMethod(requested);
  checkSelection(basis, options);
  const Rows rows = measurableRows(basis, options.measurable);
  if (rows.empty())
    throw Error("no direction pair can be measured: the limits of the rig exclude all cells of the materials");
  SampleSelection result = options.method == SelectionMethod::aOptimal
                               ? selectAOptimal(basis, options, rows, control, chosen)
                           : isPursuit(options.method) ? pursue(basis, options, rows, control, chosen)
                                                       : selectOtherwise(basis, options, rows, control, chosen);
  result.method = selectionMethodNames[std::size_t(options.method)];
  if (result.warning.empty() && result.conditionNumber > maxReliableCondition)
    result.warning = "the chosen directions are nearly dependent (condition number " +
                     numberText(float(result.conditionNumber)) + "): errors of the readings may be amplified";
  return result;
}

}  // namespace gonio::acquisition
