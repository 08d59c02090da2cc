// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/lobe_change.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "core/editing/lobe_warp.h"
#include "core/support/error.h"

namespace gonio::editing {

namespace {

Rgb ratioOf(const Rgb& measured, const Rgb& fitted) {
  return (glm::max(measured, Rgb(0)) + LobeChange::epsilon) / (fitted + LobeChange::epsilon);
}

double scaleOf(const models::ModelLobe& fitted, const models::ModelLobe& edited) {
  if (fitted.parameters == edited.parameters) return 0;
  return fitted.roughness > 0 && edited.roughness > 0 ? fitted.roughness / edited.roughness : 1;
}

}  // namespace

LobeChange::LobeChange(const DifferentialEdit& edit) : fitted_(edit.model->instantiate(edit.fitted)) {
  if (!edit.model->hasLobes())
    throw Error("the model " + std::string(edit.model->spec().id) +
                " is no sum of lobes, so its edit cannot be composed by lobes; expected additive or log-plus");
  std::vector<models::ModelLobe> fitted = edit.model->lobes(edit.fitted), edited = edit.model->lobes(edit.edited);
  for (std::size_t k = 0; k < fitted.size(); ++k)
    if (const double scale = scaleOf(fitted[k], edited[k]); scale > 0)
      lobes_.push_back({std::move(fitted[k].brdf), std::move(edited[k].brdf), scale});
}

std::vector<double> lobeScales(const DifferentialEdit& edit) {
  const std::vector<models::ModelLobe> fitted = edit.model->lobes(edit.fitted), edited = edit.model->lobes(edit.edited);
  std::vector<double> scales;
  for (std::size_t k = 0; k < fitted.size(); ++k) scales.push_back(scaleOf(fitted[k], edited[k]));
  return scales;
}

void LobeChange::evaluate(const Brdf& base, std::span<const DirectionPair> pairs, std::span<const Rgb> values,
                          std::span<Rgb> changes) const {
  assert(pairs.size() <= maxPairs);
  std::array<Rgb, maxPairs> scratch;
  const auto ratios = std::span(scratch).first(pairs.size());
  fitted_->evaluate(pairs, ratios);
  for (std::size_t i = 0; i < pairs.size(); ++i) ratios[i] = ratioOf(values[i], ratios[i]);
  for (const Lobe& lobe : lobes_) add(lobe, base, pairs, ratios, changes);
}

void LobeChange::add(const Lobe& lobe, const Brdf& base, std::span<const DirectionPair> pairs,
                     std::span<const Rgb> ratios, std::span<Rgb> changes) const {
  std::array<Rgb, maxPairs> fitted, edited, carried;
  const auto first = [&](auto& all) { return std::span(all).first(pairs.size()); };
  lobe.fitted->evaluate(pairs, first(fitted));
  lobe.edited->evaluate(pairs, first(edited));
  std::ranges::copy(ratios, carried.begin());
  if (lobe.scale != 1) carryRatios(lobe.scale, base, pairs, first(carried));
  for (std::size_t i = 0; i < pairs.size(); ++i) changes[i] += edited[i] * carried[i] - fitted[i] * ratios[i];
}

void LobeChange::carryRatios(double scale, const Brdf& base, std::span<const DirectionPair> pairs,
                             std::span<Rgb> carried) const {
  std::array<DirectionPair, maxPairs> moved;
  std::array<Rgb, maxPairs> measured, model;
  const auto first = [&](auto& all) { return std::span(all).first(pairs.size()); };
  std::ranges::transform(pairs, moved.begin(),
                         [&](const DirectionPair& pair) { return withScaledHalfTangent(pair, scale); });
  base.evaluate(first(moved), first(measured));
  fitted_->evaluate(first(moved), first(model));
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (measured[i] != Rgb(0) || base.hasData(moved[i])) carried[i] = ratioOf(measured[i], model[i]);
}

}  // namespace gonio::editing
