// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/signals.h"

#include <cassert>
#include <limits>

namespace gonio::dictionary {

namespace {

void hold(Eigen::ArrayXf& values, const TabulatedBrdf& table) {
  const HalfDifferenceGrid& grid = table.grid();
  const std::size_t slab = std::size_t(grid.thetaDCount) * std::size_t(grid.phiDCount);
  for (std::size_t cell = slab; cell < grid.size(); ++cell)
    if (table.valid()[cell] == 0) values[Eigen::Index(cell)] = values[Eigen::Index(cell - slab)];
}

}  // namespace

Eigen::ArrayXf cosineWeights(const HalfDifferenceGrid& grid) {
  Eigen::ArrayXf weights(Eigen::Index(grid.size()));
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    const DirectionPair pair = grid.directions(cell);
    weights[Eigen::Index(cell)] = float(cosineWeight(std::max(pair.wi.z, 0.0), std::max(pair.wo.z, 0.0)));
  }
  return weights;
}

void transform(Eigen::ArrayXf& values, DataTransform transform, const Eigen::ArrayXf& weights) {
  assert(values.size() == weights.size());
  if (transform == DataTransform::cosineLog) values *= weights;
  if (transform == DataTransform::cosineLog || transform == DataTransform::logPlus) values = values.log1p();
  if (transform == DataTransform::root) values = values.sqrt();
}

void invertTransform(Eigen::ArrayXf& values, DataTransform transform, const Eigen::ArrayXf& weights) {
  assert(values.size() == weights.size());
  constexpr float highest = std::numeric_limits<float>::max();
  values = values.max(0.0f);
  if (transform == DataTransform::root) values = values.square();
  if (transform == DataTransform::cosineLog || transform == DataTransform::logPlus) {
    values = values.min(88.0f).expm1();
    if (transform == DataTransform::cosineLog) values /= weights;
  }
  values = values.min(highest);
}

Signals::Signals(const TabulatedBrdf& table, DataTransform transform, const Values& weights, InvalidFill fill) {
  const Eigen::Index cells = Eigen::Index(table.grid().size());
  const auto interleaved =
      Eigen::Map<const Eigen::Array<float, 3, Eigen::Dynamic>>(&table.values().data()->x, 3, cells);
  for (int c = 0; c < 3; ++c) {
    Values& values = channel(c);
    values = interleaved.row(c);
    dictionary::transform(values, transform, weights);
    if (fill == InvalidFill::hold) hold(values, table);
  }
}

}  // namespace gonio::dictionary
