// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/acquisition/measurable_directions.h"
#include "core/dictionary/principal_components.h"
#include "core/support/task_control.h"

/// Choice of the few directions that a goniometer measures to reconstruct a whole material.
namespace gonio::acquisition {

enum class SelectionMethod {
  automatic,  ///< usedMethod()
  /// Over all training signals: FROST (Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling and
  /// Acquisition", Algorithm 4).
  simultaneousPursuit,
  simultaneousPursuitFirstColumns,  ///< over the first p training signals only, like the authors' released code
  /// Algorithm 4 as printed: the columns of D^-1 keep their lengths (AtomLengths), which favours cells that depend
  /// mostly on components of small variance.
  simultaneousPursuitUnnormalised,
  conditionNumber,  ///< the search of Nielsen et al. 2015
  random,           ///< all measurable cells with equal probability
  uniform,          ///< evenly spread over the solid angles of light and viewer; deterministic
  aOptimal          ///< smallest expected variance of all cells (a_optimal_selection.h)
};

/// Names in JSON, in plans and on the command line, in the order of the enumeration.
inline constexpr std::array<std::string_view, 8> selectionMethodNames{
    "auto", "somp", "somp-first-columns", "somp-unnormalised", "condition-number", "random", "uniform", "a-optimal"};

/// Number of samples up to which `automatic` chooses aOptimal.
inline constexpr int mostAOptimalSamples = 20;

/// Minimum number of components of aOptimal if SelectionOptions::components is 0.
inline constexpr int aOptimalComponents = 30;

struct SelectionOptions {
  SelectionMethod method = SelectionMethod::automatic;
  int samples = 20;  ///< number of samples m
  /// Number p of components for the pursuits and aOptimal; limited to the number in the basis. 0: as many as samples,
  /// but for aOptimal at least aOptimalComponents.
  int components = 0;
  MeasurableDirections measurable;
  std::uint64_t seed = 1;  ///< for conditionNumber and random
  int restarts = 5;        ///< for conditionNumber: searches from random starts; the best one is used
};

/// The method itself, or what `automatic` stands for: the one with the more accurate reconstructions of measured
/// materials (docs/results/acquisition-study.md), which is aOptimal for up to mostAOptimalSamples samples and
/// simultaneousPursuit for more.
SelectionMethod usedMethod(const SelectionOptions& options);

/// Number p of components that the pursuits and aOptimal use, before it is limited to the number in the basis.
int usedComponents(const SelectionOptions& options);

struct SampleSelection {
  std::string_view method;           ///< name of usedMethod()
  std::vector<std::uint32_t> cells;  ///< indices into the basis' grid, in the order of choice, distinct
  /// Before the first choice and after each; never increases. Pursuits: |R| / |S|, in Frobenius norms; aOptimal:
  /// AOptimalSelection::residuals; others: none.
  std::vector<double> residuals;
  /// Largest over smallest singular value of the chosen rows of the scaled basis U Sigma, in as many components as the
  /// method uses (pursuits and aOptimal: p, others: min(m, count())). Infinite if the rows are dependent, 0 without
  /// rows or components.
  double conditionNumber = 0;
  /// Why there are fewer cells than requested, or that conditionNumber exceeds maxReliableCondition; empty otherwise.
  std::string warning;
};

/// Chooses cells of the basis' grid among the measurable ones of its mapping; where several cells have the same pair of
/// directions (theta_h or theta_d = 0), only the one that reconstruct() reads (pairNode()). Deterministic: the cells do
/// not depend on the number of threads; among equally good cells the lowest index is chosen. @param chosen called on
/// this thread with each cell as it is fixed, in the order of choice.
/// @throws Error if fewer than one sample or a negative number of components is requested, a limit is out of range, no
/// cell can be measured, or (pursuits, conditionNumber and aOptimal) the basis has no components; Cancelled.
SampleSelection selectSamples(const dictionary::PrincipalComponents& basis, const SelectionOptions& options,
                              const TaskControl& control = {},
                              const std::function<void(std::uint32_t cell)>& chosen = {});

}  // namespace gonio::acquisition
