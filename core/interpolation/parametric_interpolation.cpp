// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/weighted_sum.h"
#include "core/editing/edit.h"
#include "core/interpolation/interpolation_spaces.h"
#include "core/models/parameter_blend.h"
#include "core/models/registry.h"

namespace gonio::editing {

namespace {

using models::ParameterValues;

/// The model alone at the blended parameters.
class ParameterInterpolation : public Interpolation {
 public:
  ParameterInterpolation(std::span<const InterpolationMaterial> ends, const models::Model& model,
                         std::vector<ParameterValues> fitted)
      : Interpolation(ends), model_(model), fitted_(std::move(fitted)) {}

 protected:
  std::shared_ptr<const Brdf> blendedBrdf(std::span<const double> weights) const override {
    return model_.instantiate(models::blended(model_.spec(), fitted_, weights));
  }
  std::optional<ParameterValues> blendedParameters(std::span<const double> weights) const override {
    return models::blended(model_.spec(), fitted_, weights);
  }

  const models::Model& model_;
  std::vector<ParameterValues> fitted_;
};

/// The materials moved to the blended parameters, blended.
class DifferentialInterpolation final : public ParameterInterpolation {
 public:
  DifferentialInterpolation(std::span<const InterpolationMaterial> ends, const models::Model& model,
                            std::vector<ParameterValues> fitted, const TaskControl& control)
      : ParameterInterpolation(ends, model, std::move(fitted)), sameGrid_(onOneGrid(this->tables(), control)) {}

 private:
  std::vector<DifferentialEdit> blendedEdits(std::span<const double> weights) const override {
    const ParameterValues target = blendedParameters(weights).value();
    std::vector<DifferentialEdit> edits;
    for (const ParameterValues& fitted : fitted_) edits.push_back({&model_, fitted, target});
    return edits;
  }
  std::shared_ptr<const Brdf> blendedBrdf(std::span<const double> weights) const override {
    std::vector<std::shared_ptr<const Brdf>> moved;
    for (DifferentialEdit& move : blendedEdits(weights))
      moved.push_back(applyEdits(ends()[moved.size()].material(), EditList{{std::move(move)}}));
    return weightedSum(std::move(moved), {weights.begin(), weights.end()});
  }
  Table blendedTable(std::span<const double> weights, const TaskControl& control) const override {
    const std::vector<DifferentialEdit> edits = blendedEdits(weights);
    std::vector<Table> moved = sameGrid_;
    for (std::size_t i = 0; i < materials(); ++i) {
      if (!(weights[i] > 0)) continue;
      const double begin = double(i) / double(materials()), end = double(i + 1) / double(materials());
      moved[i] = bakeEdits(sameGrid_[i], EditList{{edits[i]}}, control.between(begin, end));
    }
    return weightedSum(moved, weights, {.stop = control.stop});
  }

  std::optional<TransformedMixture> mixture() const override { return mixtureOf(sameGrid_); }

  std::vector<Table> sameGrid_;
};

}  // namespace

std::shared_ptr<const Interpolation> prepareParametric(std::span<const InterpolationMaterial> ends, bool preserveDetail,
                                                       const InterpolationOptions& options,
                                                       const TaskControl& control) {
  const models::Model& model = options.model ? *options.model : models::ggx();
  std::vector<ParameterValues> fitted;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double begin = double(i) / double(ends.size()), end = double(i + 1) / double(ends.size());
    fitted.push_back(fitting::fit(*ends[i].table, model, options.fit, control.between(begin, end)).parameters);
    control.throwIfStopped();
  }
  if (preserveDetail)
    return std::make_shared<const DifferentialInterpolation>(ends, model, std::move(fitted),
                                                             TaskControl{control.stop, {}});
  return std::make_shared<const ParameterInterpolation>(ends, model, std::move(fitted));
}

}  // namespace gonio::editing
