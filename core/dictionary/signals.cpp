// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/signals.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

#include "core/coordinates/grid_directions.h"
#include "core/math/parallel.h"

namespace gonio::dictionary {

namespace {

void hold(Eigen::ArrayXd& values, const TabulatedBrdf& table) {
  const HalfDifferenceGrid& grid = table.grid();
  const std::size_t slab = std::size_t(grid.thetaDCount) * std::size_t(grid.phiDCount);
  for (std::size_t cell = slab; cell < grid.size(); ++cell)
    if (table.valid()[cell] == 0) values[Eigen::Index(cell)] = values[Eigen::Index(cell - slab)];
}

/// Integrals of a density over the cells around the nodes of an axis in [0, pi/2], as the cell scaling of a mode.
template <typename Angle, typename Integral>
Eigen::ArrayXd cellScalingOf(int count, const Angle& angle, const Integral& integral) {
  constexpr double least = 1e-2;
  Eigen::ArrayXd measure(count);
  for (int i = 0; i < count; ++i)
    measure[i] = integral(angle(std::min(i + 0.5, double(count)))) - integral(angle(std::max(i - 0.5, 0.0)));
  measure = measure.max(least * measure.maxCoeff());
  return (measure / measure.mean()).sqrt();
}

std::array<Eigen::ArrayXd, 3> cellScalingOf(const HalfDifferenceGrid& grid) {
  const auto square = [](double x) { return x * x; };
  return {Eigen::ArrayXd::Ones(grid.phiDCount),
          cellScalingOf(
              grid.thetaDCount, [&](double node) { return node / grid.thetaDCount * halfPi; },
              [&](double theta) { return -square(square(std::cos(theta))); }),
          cellScalingOf(
              grid.thetaHCount, [&](double node) { return square(node / grid.thetaHCount) * halfPi; },
              [&](double theta) { return -square(std::cos(theta)) * std::cos(theta); })};
}

std::shared_ptr<const GridGeometry> computed(const HalfDifferenceGrid& grid) {
  auto geometry = std::make_shared<GridGeometry>();
  geometry->cellScaling = cellScalingOf(grid);
  geometry->weights.resize(Eigen::Index(grid.size()));
  geometry->aboveHorizon.resize(grid.size());
  const GridDirections directions(grid);
  parallelForBlocks(grid.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell) {
      const GridDirections::Node node = directions.at(cell);
      geometry->aboveHorizon[cell] = node.aboveHorizon;
      geometry->weights[Eigen::Index(cell)] =
          float(node.aboveHorizon ? cosineWeight(node.pair.wi.z, node.pair.wo.z) : cosineWeight(0, 0));
    }
  });
  return geometry;
}

/// Applies a function to the sizes of values and keeps their signs.
template <typename Values, typename Function>
void keepingSigns(Values& values, const Function& function) {
  using Array = Eigen::Array<typename Values::Scalar, Eigen::Dynamic, 1>;
  const Array signs = values.sign();
  values = values.abs();
  function();
  values *= signs;
}

template <typename Scalar>
void invert(Eigen::Ref<Eigen::Array<Scalar, Eigen::Dynamic, 1>>& values, DataTransform transform,
            const Eigen::Ref<const Eigen::ArrayXf>& weights, Scalar lowest) {
  assert(values.size() == weights.size() && lowest <= 0);
  if (lowest < 0) {
    values = values.max(lowest);
    return keepingSigns(values, [&] { invert<Scalar>(values, transform, weights, 0); });
  }
  values = values.max(Scalar(0));
  if (const double offset = logOffset(transform); offset > 0) {
    constexpr Scalar mostLog = 88;  // e^88 is the last round exponent in the range of float
    values = values.min(mostLog).expm1() * Scalar(offset);
    if (transform == DataTransform::cosineLog) values /= weights.cast<Scalar>();
  } else if (transform == DataTransform::root) {
    values = values.square();
  } else if (transform != DataTransform::none) {
    values = values.pow(Scalar(gammaOf(transform)));
  }
  values = values.min(Scalar(std::numeric_limits<float>::max()));
}

}  // namespace

Eigen::ArrayXf cellScales(const HalfDifferenceGrid& grid, const GridGeometry& geometry) {
  Eigen::ArrayXf scales(Eigen::Index(grid.size()));
  Eigen::Index cell = 0;
  for (int h = 0; h < grid.thetaHCount; ++h)
    for (int d = 0; d < grid.thetaDCount; ++d, cell += grid.phiDCount)
      scales.segment(cell, grid.phiDCount).setConstant(float(geometry.cellScaling[1][d] * geometry.cellScaling[2][h]));
  return scales;
}

SignalRange rangeOf(const Eigen::ArrayXd& signal, const TabulatedBrdf& table, const GridGeometry& geometry,
                    bool scaled) {
  const HalfDifferenceGrid& grid = table.grid();
  double lowest = 0, highest = 0;
  Eigen::Index cell = 0;
  for (int h = 0; h < grid.thetaHCount; ++h)
    for (int d = 0; d < grid.thetaDCount; ++d) {
      double least = 0, most = 0;
      for (int phi = 0; phi < grid.phiDCount; ++phi, ++cell) {
        if (table.valid()[std::size_t(cell)] == 0) continue;
        least = std::min(least, signal[cell]);
        most = std::max(most, signal[cell]);
      }
      const double scale = scaled ? geometry.cellScaling[1][d] * geometry.cellScaling[2][h] : 1;
      lowest = std::min(lowest, least / scale);
      highest = std::max(highest, most / scale);
    }
  return {float(lowest), float(highest)};
}

std::shared_ptr<const GridGeometry> GridGeometry::of(const HalfDifferenceGrid& grid) {
  static std::mutex mutex;
  static std::vector<std::pair<HalfDifferenceGrid, std::shared_ptr<const GridGeometry>>> known;
  {
    const std::lock_guard lock(mutex);
    for (const auto& [key, geometry] : known)
      if (key == grid) return geometry;
  }
  // Not under the lock: the parallel loop may run other work that asks for a geometry.
  auto geometry = computed(grid);
  const std::lock_guard lock(mutex);
  known.emplace_back(grid, geometry);
  return geometry;
}

void transform(Eigen::Ref<Eigen::ArrayXd> values, DataTransform transform,
               const Eigen::Ref<const Eigen::ArrayXf>& weights) {
  assert(values.size() == weights.size());
  if ((values < 0).any()) return keepingSigns(values, [&] { dictionary::transform(values, transform, weights); });
  if (transform == DataTransform::cosineLog) values *= weights.cast<double>();
  if (const double offset = logOffset(transform); offset > 0)
    values = (values / offset).log1p();
  else if (transform == DataTransform::root)
    values = values.sqrt();
  else if (transform != DataTransform::none)
    values = values.pow(1 / gammaOf(transform));
}

void invertTransform(Eigen::Ref<Eigen::ArrayXf> values, DataTransform transform,
                     const Eigen::Ref<const Eigen::ArrayXf>& weights, float lowest) {
  invert<float>(values, transform, weights, lowest);
}
void invertTransform(Eigen::Ref<Eigen::ArrayXd> values, DataTransform transform,
                     const Eigen::Ref<const Eigen::ArrayXf>& weights, float lowest) {
  invert<double>(values, transform, weights, double(lowest));
}

std::array<Eigen::ArrayXd, 3> signalsOf(const TabulatedBrdf& table, DataTransform transform,
                                        const GridGeometry& geometry, bool scaled) {
  const Eigen::Index cells = Eigen::Index(table.grid().size());
  const auto interleaved =
      Eigen::Map<const Eigen::Array<float, 3, Eigen::Dynamic>>(&table.values().data()->x, 3, cells);
  const Eigen::ArrayXf scales = scaled ? cellScales(table.grid(), geometry) : Eigen::ArrayXf();
  std::array<Eigen::ArrayXd, 3> signals;
  for (int c = 0; c < 3; ++c) {
    Eigen::ArrayXd& values = signals[std::size_t(c)];
    values = interleaved.row(c).cast<double>();
    dictionary::transform(values, transform, geometry.weights);
    hold(values, table);
    if (scaled) values *= scales.cast<double>();
  }
  return signals;
}

std::array<Eigen::ArrayXd, 2> partsOfOrders(const Eigen::ArrayXd& signal, int phiDCount) {
  assert(phiDCount % 2 == 0 && signal.size() % phiDCount == 0);
  const Eigen::Index half = phiDCount / 2, rows = signal.size() / phiDCount;
  const Eigen::Map<const Eigen::ArrayXXd> circle(signal.data(), phiDCount, rows);
  std::array<Eigen::ArrayXd, 2> parts{Eigen::ArrayXd(half * rows), Eigen::ArrayXd(half * rows)};
  Eigen::Map<Eigen::ArrayXXd>(parts[0].data(), half, rows) = (circle.topRows(half) + circle.bottomRows(half)) / 2;
  Eigen::Map<Eigen::ArrayXXd>(parts[1].data(), half, rows) = (circle.topRows(half) - circle.bottomRows(half)) / 2;
  return parts;
}

}  // namespace gonio::dictionary
