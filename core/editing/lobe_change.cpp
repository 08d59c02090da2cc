// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/lobe_change.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/editing/lobe_warp.h"
#include "core/support/error.h"

namespace gonio::editing {

namespace {

Rgb ratioOf(const Rgb& measured, const Rgb& fitted) {
  return (glm::max(measured, Rgb(0)) + LobeChange::epsilon) / (fitted + LobeChange::epsilon);
}

double scaleOf(const models::ModelLobe& fitted, const models::ModelLobe& edited) {
  if (fitted.parameters == edited.parameters) return 0;
  return fitted.roughness > 0 && edited.roughness > 0 ? fitted.roughness / edited.roughness : bodyScale;
}

/// What the body carries of the ratio.
Rgb bodyRatio(const Rgb& ratio, const Rgb& body, const Rgb& model) {
  constexpr double darkest = 1e-30;
  const Rgb part = body / glm::max(model, Rgb(darkest)), squared = part * part;
  return 1.0 + squared * squared * (ratio - 1.0);
}

/// Scales that differ by rounding alone are made equal: lobes that widen alike then share their places.
void alignScales(std::span<double> scales) {
  constexpr double rounding = 1e-9;
  for (std::size_t k = 0; k < scales.size(); ++k)
    for (std::size_t before = 0; before < k; ++before)
      if (std::abs(scales[k] - scales[before]) < rounding * std::abs(scales[k])) scales[k] = scales[before];
}

std::vector<double> scalesOf(std::span<const models::ModelLobe> fitted, std::span<const models::ModelLobe> edited) {
  std::vector<double> scales;
  for (std::size_t k = 0; k < fitted.size(); ++k) scales.push_back(scaleOf(fitted[k], edited[k]));
  alignScales(scales);
  return scales;
}

}  // namespace

LobeChange::LobeChange(const DifferentialEdit& edit) : fitted_(edit.model->instantiate(edit.fitted)) {
  if (!edit.model->hasLobes())
    throw Error("the model " + std::string(edit.model->spec().id) +
                " is no sum of lobes, so its edit cannot be composed by lobes; expected additive or log-plus");
  std::vector<models::ModelLobe> fitted = edit.model->lobes(edit.fitted), edited = edit.model->lobes(edit.target());
  const std::vector<double> scales = scalesOf(fitted, edited);
  for (std::size_t k = 0; k < fitted.size(); ++k)
    if (scales[k] != 0) lobes_.push_back({std::move(fitted[k].brdf), std::move(edited[k].brdf), scales[k]});
  std::ranges::stable_sort(lobes_, {}, &Lobe::scale);
}

std::vector<double> lobeScales(const DifferentialEdit& edit) {
  return scalesOf(edit.model->lobes(edit.fitted), edit.model->lobes(edit.target()));
}

Rgb recolouredRatio(const Rgb& ratio, const Rgb& fitted, const Rgb& edited) {
  constexpr double darkest = 1e-30, leastChannel = 1e-6;
  const double before = luminance(fitted), after = luminance(edited);
  if (before < darkest || after < darkest) return ratio;
  const Rgb kept = glm::min(Rgb(1), (fitted / before) / glm::max(edited / after, Rgb(leastChannel)));
  return glm::mix(Rgb(luminance(fitted * ratio) / before), ratio, kept);
}

void LobeChange::evaluate(const Brdf& base, std::span<const DirectionPair> pairs, std::span<const Rgb> values,
                          std::span<Rgb> changes) const {
  assert(pairs.size() <= maxPairs);
  std::array<Rgb, maxPairs> modelScratch, ratioScratch, carriedScratch;
  const auto model = std::span(modelScratch).first(pairs.size());
  const auto ratios = std::span(ratioScratch).first(pairs.size());
  const auto carried = std::span(carriedScratch).first(pairs.size());
  fitted_->evaluate(pairs, model);
  for (std::size_t i = 0; i < pairs.size(); ++i) ratios[i] = ratioOf(values[i], model[i]);
  double scale = 1;
  for (const Lobe& lobe : lobes_) {
    const bool isMoved = lobe.scale != 1 && lobe.scale != bodyScale;
    if (isMoved && lobe.scale != scale) {
      std::ranges::copy(ratios, carried.begin());
      carryRatios(scale = lobe.scale, base, pairs, carried);
    }
    add(lobe, pairs, {model, ratios, isMoved ? carried : ratios}, changes);
  }
}

void LobeChange::add(const Lobe& lobe, std::span<const DirectionPair> pairs, const Ratios& ratios,
                     std::span<Rgb> changes) {
  std::array<Rgb, maxPairs> fitted, edited;
  lobe.fitted->evaluate(pairs, std::span(fitted).first(pairs.size()));
  lobe.edited->evaluate(pairs, std::span(edited).first(pairs.size()));
  const bool isBody = lobe.scale == bodyScale;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Rgb here = isBody ? bodyRatio(ratios.here[i], fitted[i], ratios.model[i]) : ratios.here[i];
    const Rgb carried = isBody ? here : ratios.carried[i];
    changes[i] += edited[i] * recolouredRatio(carried, fitted[i], edited[i]) - fitted[i] * here;
  }
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
