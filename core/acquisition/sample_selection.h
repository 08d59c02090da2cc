// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/acquisition/measurable_directions.h"
#include "core/dictionary/principal_components.h"
#include "core/support/task_control.h"

/// Which few directions a goniometer should visit so that a material follows from what it reads there.
namespace gonio::acquisition {

enum class SelectionMethod {
  simultaneousPursuit,              ///< FROST over all training signals (dissertation, Algorithm 4)
  simultaneousPursuitFirstColumns,  ///< as the authors' released code: over the first p training signals alone
  conditionNumber,                  ///< the search of Nielsen et al. 2015
  random,                           ///< every measurable cell as likely as any other
  uniform                           ///< spread evenly over the solid angles of light and viewer, the same every time
};

struct SelectionOptions {
  SelectionMethod method = SelectionMethod::simultaneousPursuit;
  int samples = 20;    ///< m
  int components = 0;  ///< p, that the pursuits use; 0: as many as samples. At most those of the basis
  MeasurableDirections measurable;
  std::uint64_t seed = 1;  ///< of conditionNumber and random
  int restarts = 5;        ///< of conditionNumber: searches from random starts, of which the best is kept
};

struct SampleSelection {
  std::vector<std::uint32_t> cells;  ///< of the basis' grid, in the order of choice, distinct
  /// Of the pursuits: |R| / |S| before the first choice and after each, in Frobenius norms; never rises.
  std::vector<double> residuals;
  /// Of the chosen rows of the dictionary U Sigma, largest over smallest singular value: of as many components as the
  /// method looked at (p of the pursuits, else min(m, count())). Infinite where the rows are dependent, 0 of none.
  double conditionNumber = 0;
  std::string warning;  ///< why there are fewer cells than were asked for; empty otherwise
};

/// Chooses cells of the basis' grid among those of its mapping that can be measured; of the cells of one pair of
/// directions, the one that is read (pairNode()). Deterministic: the same cells for any number of threads; of equally
/// good cells the lowest index. @param chosen called on this thread with each cell as it is fixed, in the order of
/// choice.
/// @throws Error when fewer than one sample or a negative number of components is asked for, limits are wrong, nothing
/// can be measured, or (of the pursuits and conditionNumber) the basis has no components; Cancelled.
SampleSelection selectSamples(const dictionary::PrincipalComponents& basis, const SelectionOptions& options,
                              const TaskControl& control = {},
                              const std::function<void(std::uint32_t cell)>& chosen = {});

}  // namespace gonio::acquisition
