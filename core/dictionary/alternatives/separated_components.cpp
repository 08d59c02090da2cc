// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/alternatives/separated_components.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/math/parallel.h"

namespace gonio::dictionary {

namespace {

constexpr double decile = 0.1, maxDiffuseAngle = 75 * pi / 180, maxDifferenceAngle = 60 * pi / 180;

struct WeightedValue {
  float value;
  double weight;
};

/// The value below which `fraction` of the weight lies.
float weightedQuantile(std::vector<WeightedValue>& values, double fraction) {
  std::ranges::sort(values, {}, &WeightedValue::value);
  double total = 0, sum = 0;
  for (const WeightedValue& one : values) total += one.weight;
  for (const WeightedValue& one : values)
    if ((sum += one.weight) >= fraction * total) return one.value;
  return values.back().value;
}

/// d of one theta_d; false if no cell is away from the horizon, or all are close to the highlight.
bool diffuseOf(const TabulatedBrdf& table, int thetaD, TabulatedBrdf::Value& diffuse) {
  const HalfDifferenceGrid& grid = table.grid();
  if (halfPi * thetaD / grid.thetaDCount > maxDifferenceAngle) return false;
  std::array<std::vector<WeightedValue>, 3> values;
  for (int h = 0; h < grid.thetaHCount; ++h)
    for (int p = 0; p < grid.phiDCount; ++p) {
      const std::size_t cell = grid.index(h, thetaD, p);
      if (!table.valid()[cell] || !grid.nodeWithin(cell, maxDiffuseAngle)) continue;
      const double weight = grid.cellMeasure(cell);
      for (int c = 0; c < 3; ++c) values[std::size_t(c)].push_back({table.values()[cell][c], weight});
    }
  if (values[0].empty()) return false;
  for (int c = 0; c < 3; ++c) diffuse[c] = weightedQuantile(values[std::size_t(c)], decile);
  return true;
}

/// d at every theta_d.
std::vector<TabulatedBrdf::Value> diffuseCurve(const TabulatedBrdf& table, const TaskControl& control) {
  const auto count = std::size_t(table.grid().thetaDCount);
  std::vector<TabulatedBrdf::Value> curve(count, TabulatedBrdf::Value(0));
  std::vector<char> known(count);
  parallelForBlocks(
      count, 1, [&](std::size_t d, std::size_t) { known[d] = diffuseOf(table, int(d), curve[d]); }, control);
  for (std::size_t d = 1; d < count; ++d)
    if (!known[d]) curve[d] = curve[d - 1];
  return curve;
}

}  // namespace

SeparatedTable separateDiffuse(const TabulatedBrdf& table, const TaskControl& control) {
  const HalfDifferenceGrid& grid = table.grid();
  const std::vector<TabulatedBrdf::Value> curve = diffuseCurve(table, control);
  std::vector<TabulatedBrdf::Value> diffuse(table.values().begin(), table.values().end()), specular = diffuse;
  const auto perThetaD = std::size_t(grid.phiDCount);
  for (std::size_t cell = 0; cell < diffuse.size(); ++cell) {
    const TabulatedBrdf::Value& level = curve[cell / perThetaD % curve.size()];
    for (int c = 0; c < 3; ++c) diffuse[cell][c] = std::min(diffuse[cell][c], level[c]);
    specular[cell] -= diffuse[cell];
  }
  const std::vector<std::uint8_t> valid(table.valid().begin(), table.valid().end());
  return {std::make_shared<const TabulatedBrdf>(grid, std::move(diffuse), valid),
          std::make_shared<const TabulatedBrdf>(grid, std::move(specular), valid)};
}

int SeparatedComponents::count() const {
  // A code of n components has diffuseCount(n) and the rest.
  int most = 0;
  while (specularCount(most + 1) <= specular.count()) ++most;
  return most;
}

SeparatedComponents learnSeparatedComponents(
    std::size_t materials, const std::function<std::shared_ptr<const TabulatedBrdf>(std::size_t material)>& load,
    const PcaOptions& options, const TaskControl& control) {
  const auto part = [&](std::shared_ptr<const TabulatedBrdf> SeparatedTable::*which) {
    return [&load, which, stop = control.stop](std::size_t material) {
      return separateDiffuse(*load(material), {.stop = stop, .progress = {}}).*which;
    };
  };
  return {learnPrincipalComponents(materials, part(&SeparatedTable::diffuse), options, control.between(0, 0.5)),
          learnPrincipalComponents(materials, part(&SeparatedTable::specular), options, control.between(0.5, 1))};
}

SeparatedCode encode(const SeparatedComponents& basis, const TabulatedBrdf& table, int components,
                     const TaskControl& control) {
  const SeparatedTable parts = separateDiffuse(table, {.stop = control.stop, .progress = {}});
  return {encode(basis.diffuse, *parts.diffuse, basis.diffuseCount(components), control.between(0, 0.5)),
          encode(basis.specular, *parts.specular, basis.specularCount(components), control.between(0.5, 1))};
}

std::shared_ptr<const TabulatedBrdf> decode(const SeparatedComponents& basis, const SeparatedCode& code,
                                            const TaskControl& control) {
  const auto diffuse = decode(basis.diffuse, code.diffuse, control.between(0, 0.5));
  const auto specular = decode(basis.specular, code.specular, control.between(0.5, 1));
  std::vector<TabulatedBrdf::Value> values(diffuse->values().begin(), diffuse->values().end());
  std::vector<std::uint8_t> valid(diffuse->valid().begin(), diffuse->valid().end());
  for (std::size_t cell = 0; cell < values.size(); ++cell) {
    valid[cell] = valid[cell] && specular->valid()[cell];
    for (int c = 0; c < 3; ++c)
      values[cell][c] = std::min(values[cell][c] + specular->values()[cell][c], std::numeric_limits<float>::max());
  }
  return std::make_shared<const TabulatedBrdf>(diffuse->grid(), std::move(values), std::move(valid));
}

}  // namespace gonio::dictionary
