// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/alternatives/basis_pursuit.h"

#include <algorithm>
#include <cmath>

namespace gonio::dictionary {

namespace {

/// Of step 0, 1, ...
template <typename Scalar>
Scalar momentum(int step) {
  return Scalar(step) / Scalar(step + 3);
}

template <typename Scalar>
Scalar keepSoft(const InvalidCellRefinement<Scalar>& cells, std::size_t count, std::vector<Coefficient<Scalar>>& code) {
  cells.selectLargest(count + 1, code);
  return softThreshold(code, count);
}

}  // namespace

template <typename Scalar>
Scalar softThreshold(std::vector<Coefficient<Scalar>>& largest, std::size_t count) {
  std::sort(largest.begin(), largest.end(), isLarger<Scalar>);
  if (largest.size() <= count) return 0;
  const Scalar threshold = std::abs(largest[count].value);
  largest.resize(count);
  for (Coefficient<Scalar>& c : largest) c.value = std::copysign(std::abs(c.value) - threshold, c.value);
  std::erase_if(largest, [](const Coefficient<Scalar>& c) { return c.value == 0; });
  return threshold;
}

template <typename Scalar>
Scalar pursueBasis(InvalidCellRefinement<Scalar>& cells, std::size_t count, int steps,
                   std::vector<Coefficient<Scalar>>& code, const TaskControl& control) {
  cells.restart();
  Scalar threshold = keepSoft(cells, count, code);
  for (int step = 0; step < steps; ++step) {
    control.throwIfStopped();
    cells.update(code, momentum<Scalar>(step));
    threshold = keepSoft(cells, count, code);
  }
  return threshold;
}

template <typename Scalar>
void refitValues(InvalidCellRefinement<Scalar>& cells, int steps, std::vector<Coefficient<Scalar>>& code,
                 const TaskControl& control) {
  cells.restart();
  cells.project(code);
  for (int step = 0; step < steps; ++step) {
    control.throwIfStopped();
    cells.update(code, momentum<Scalar>(step));
    cells.project(code);
  }
}

template float softThreshold(std::vector<Coefficient<float>>&, std::size_t);
template float pursueBasis(InvalidCellRefinement<float>&, std::size_t, int, std::vector<Coefficient<float>>&,
                           const TaskControl&);
template void refitValues(InvalidCellRefinement<float>&, int, std::vector<Coefficient<float>>&, const TaskControl&);
template double softThreshold(std::vector<Coefficient<double>>&, std::size_t);
template double pursueBasis(InvalidCellRefinement<double>&, std::size_t, int, std::vector<Coefficient<double>>&,
                            const TaskControl&);
template void refitValues(InvalidCellRefinement<double>&, int, std::vector<Coefficient<double>>&, const TaskControl&);

}  // namespace gonio::dictionary
