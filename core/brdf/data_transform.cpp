// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/data_transform.h"

#include <cassert>

#include "core/math/parallel.h"

namespace gonio {

float medianOf(std::span<float> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return float((double(*std::max_element(values.begin(), middle)) + double(*middle)) / 2);
}

std::vector<float> medianReference(std::span<const std::span<const float>> columns) {
  if (columns.empty()) return {};
  constexpr std::size_t block = 256;  // cells that are gathered at once: a cache line of every column and more
  const std::size_t cells = columns[0].size(), count = columns.size();
  std::vector<float> medians(cells);
  parallelForBlocks(cells, block, [&](std::size_t begin, std::size_t end) {
    std::vector<float> gathered((end - begin) * count);
    for (std::size_t column = 0; column < count; ++column) {
      assert(columns[column].size() == cells);
      for (std::size_t cell = begin; cell < end; ++cell)
        gathered[(cell - begin) * count + column] = columns[column][cell];
    }
    for (std::size_t cell = begin; cell < end; ++cell)
      medians[cell] = medianOf(std::span(gathered).subspan((cell - begin) * count, count));
  });
  return medians;
}

}  // namespace gonio
