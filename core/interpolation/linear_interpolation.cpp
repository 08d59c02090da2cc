// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/weighted_sum.h"
#include "core/interpolation/interpolation_spaces.h"

namespace gonio::editing {

namespace {

class LinearInterpolation final : public Interpolation {
 public:
  LinearInterpolation(std::span<const InterpolationMaterial> ends, const TaskControl& control)
      : Interpolation(ends), sameGrid_(onOneGrid(this->tables(), control)) {}

 private:
  std::shared_ptr<const Brdf> blendedBrdf(std::span<const double> weights) const override {
    std::vector<std::shared_ptr<const Brdf>> materials;
    for (const InterpolationMaterial& end : ends()) materials.push_back(end.material());
    return weightedSum(std::move(materials), {weights.begin(), weights.end()});
  }
  Table blendedTable(std::span<const double> weights, const TaskControl& control) const override {
    return weightedSum(sameGrid_, weights, control);
  }
  std::optional<TransformedMixture> mixture() const override { return mixtureOf(sameGrid_); }

  std::vector<Table> sameGrid_;
};

}  // namespace

TransformedMixture mixtureOf(const std::vector<Interpolation::Table>& tables) {
  TransformedMixture mixture{DataTransform::none, {}};
  for (const Interpolation::Table& table : tables)
    mixture.tables.push_back({table->grid(),
                              {table->values().begin(), table->values().end()},
                              {table->valid().begin(), table->valid().end()}});
  return mixture;
}

std::vector<Interpolation::Table> tablesOf(std::span<const InterpolationMaterial> ends) {
  std::vector<Interpolation::Table> tables;
  for (const InterpolationMaterial& end : ends) tables.push_back(end.table);
  return tables;
}

std::vector<Interpolation::Table> onOneGrid(const std::vector<Interpolation::Table>& tables,
                                            const TaskControl& control) {
  std::vector<Interpolation::Table> result;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const double each = 1 / double(tables.size());
    result.push_back(onGrid(tables[i], tables[0]->grid(), control.between(double(i) * each, double(i + 1) * each)));
  }
  return result;
}

std::shared_ptr<const Interpolation> prepareLinear(std::span<const InterpolationMaterial> ends,
                                                   const TaskControl& control) {
  return std::make_shared<const LinearInterpolation>(ends, control);
}

}  // namespace gonio::editing
