// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/basis_pursuit.h"

#include <algorithm>
#include <cmath>

namespace gonio::dictionary {

namespace {

/// Of step 0, 1, ...
float momentum(int step) { return float(step) / float(step + 3); }

float keepSoft(const InvalidCellRefinement& cells, std::size_t count, std::vector<Coefficient<float>>& code) {
  cells.selectLargest(count + 1, code);
  return softThreshold(code, count);
}

}  // namespace

float softThreshold(std::vector<Coefficient<float>>& largest, std::size_t count) {
  std::sort(largest.begin(), largest.end(), isLarger<float>);
  if (largest.size() <= count) return 0;
  const float threshold = std::abs(largest[count].value);
  largest.resize(count);
  for (Coefficient<float>& c : largest) c.value = std::copysign(std::abs(c.value) - threshold, c.value);
  std::erase_if(largest, [](const Coefficient<float>& c) { return c.value == 0; });
  return threshold;
}

float pursueBasis(InvalidCellRefinement& cells, std::size_t count, int steps, std::vector<Coefficient<float>>& code,
                  const TaskControl& control) {
  cells.restart();
  float threshold = keepSoft(cells, count, code);
  for (int step = 0; step < steps; ++step) {
    control.throwIfStopped();
    cells.update(code, momentum(step));
    threshold = keepSoft(cells, count, code);
  }
  return threshold;
}

void refitValues(InvalidCellRefinement& cells, int steps, std::vector<Coefficient<float>>& code,
                 const TaskControl& control) {
  cells.restart();
  cells.project(code);
  for (int step = 0; step < steps; ++step) {
    control.throwIfStopped();
    cells.update(code, momentum(step));
    cells.project(code);
  }
}

}  // namespace gonio::dictionary
