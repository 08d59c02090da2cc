// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/lobe_change.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/vector_relational.hpp>

#include "core/coordinates/half_difference.h"
#include "core/support/error.h"

namespace gonio::editing {

namespace {

/// The shortest rotation from one half vector to another.
struct HalfTurn {
  Direction axis{0};  ///< times the sine of the angle
  double cosine = 1;

  Direction operator()(const Direction& w) const {
    return w * cosine + glm::cross(axis, w) + axis * (glm::dot(axis, w) / (1 + cosine));
  }
};

HalfTurn halfTurn(const Direction& half, const glm::dvec2& scale) {
  const Direction scaled{half.x * scale.x, half.y * scale.y, half.z};
  const double inverse = 1 / glm::length(scaled);
  // half x scaled, without its cancellation.
  return {inverse * Direction{half.y * half.z * (1 - scale.y), half.x * half.z * (scale.x - 1),
                              half.x * half.y * (scale.y - scale.x)},
          inverse * glm::dot(half, scaled)};
}

/// The cosine of the angle, in [0, pi], about the unit axis at which a direction comes down to the horizon: 1 where it
/// is there and would go on down, -1 where it comes there after half a turn or never.
double cosineToHorizon(const Direction& w, const Direction& axis) {
  // The height at the angle a is along + up cos a + ahead sin a.
  const double along = axis.z * glm::dot(axis, w), up = w.z - along, ahead = axis.x * w.y - axis.y * w.x;
  const double radius = std::hypot(up, ahead);
  if (!(radius > 0)) return -1;
  const double cosine = std::clamp((minWarpCosine - along) / radius, -1.0, 1.0), sine = std::sqrt(1 - cosine * cosine);
  if (ahead * cosine + up * sine >= 0) return (up * cosine - ahead * sine) / radius;
  return ahead < 0 && w.z < minWarpCosine ? 1 : -1;
}

HalfTurn endingAtTheHorizon(const HalfTurn& turn, const DirectionPair& pair) {
  const Direction axis = glm::normalize(turn.axis);
  const double last = std::max(cosineToHorizon(pair.wi, axis), cosineToHorizon(pair.wo, axis));
  if (last <= turn.cosine) return turn;
  return {axis * std::sqrt(std::max(0.0, 1 - last * last)), last};
}

}  // namespace

DirectionPair withScaledHalfSlopes(const DirectionPair& pair, const glm::dvec2& scale) {
  const Direction sum = pair.wi + pair.wo;
  if (!(sum.z > 0 && glm::dot(sum, sum) > minSquaredHalfLength)) return pair;
  HalfTurn turn = halfTurn(glm::normalize(sum), scale);
  if (!(glm::dot(turn.axis, turn.axis) > 1e-24)) return pair;
  const DirectionPair turned{turn(pair.wi), turn(pair.wo)};
  if (std::min(turned.wi.z, turned.wo.z) >= minWarpCosine) return turned;
  turn = endingAtTheHorizon(turn, pair);
  return {turn(pair.wi), turn(pair.wo)};
}

void warp(const LobeWarp& warp, std::span<const DirectionPair> pairs, std::span<DirectionPair> moved) {
  const AzimuthRotation toGrain(-warp.edited), fromGrain(warp.fitted);
  std::ranges::transform(pairs, moved.begin(), [&](const DirectionPair& pair) {
    return fromGrain(withScaledHalfSlopes(toGrain(pair), warp.scale));
  });
}

namespace {

/// Negative where the measurement is, as RGL files are for colours outside sRGB: this part of a highlight widens too.
Rgb ratioOf(const Rgb& measured, const Rgb& fitted) {
  return (measured + LobeChange::epsilon) / (fitted + LobeChange::epsilon);
}

/// The part of the ratio measured / model that the diffuse term carries.
Rgb diffuseRatio(const Rgb& ratio, const Rgb& diffuse, const Rgb& model) {
  constexpr double darkest = 1e-30;
  const Rgb part = diffuse / glm::max(model, Rgb(darkest)), squared = part * part;
  return 1.0 + squared * squared * (ratio - 1.0);
}

/// Scales that differ by rounding alone are made equal: lobes that widen alike then share their places.
void align(LobeWarp& warp, std::span<const LobeEffect> before) {
  constexpr double rounding = 1e-9;
  for (const LobeEffect& other : before)
    if (glm::all(glm::lessThan(glm::abs(warp.scale - other.warp.scale), rounding * warp.scale)))
      warp.scale = other.warp.scale;
}

bool isNonzero(const models::ModelLobe& lobe) {
  return std::ranges::any_of(lobe.colours, [](const Rgb& colour) { return colour != Rgb(0); });
}

LobeEffect changeOf(const models::ModelLobe& fitted, const models::ModelLobe& edited) {
  LobeEffect change{.isRecoloured = fitted.colours != edited.colours,
                    .wasNonzero = isNonzero(fitted),
                    .isNonzero = isNonzero(edited)};
  const bool isSame = !change.isRecoloured && fitted.parameters == edited.parameters;
  if (isSame || !(change.wasNonzero || change.isNonzero)) return change;
  const models::LobeWidth &from = fitted.width, &to = edited.width;
  const bool hasWidth = from.x > 0 && from.y > 0 && to.x > 0 && to.y > 0;
  change.kind = hasWidth ? LobeEffect::highlight : LobeEffect::diffuse;
  if (hasWidth && change.wasNonzero) change.warp = {{from.x / to.x, from.y / to.y}, to.rotation, from.rotation};
  return change;
}

std::vector<LobeEffect> changesOf(std::span<const models::ModelLobe> fitted,
                                  std::span<const models::ModelLobe> edited) {
  std::vector<LobeEffect> changes;
  for (std::size_t k = 0; k < fitted.size(); ++k) {
    LobeEffect change = changeOf(fitted[k], edited[k]);
    align(change.warp, changes);
    changes.push_back(change);
  }
  return changes;
}

}  // namespace

LobeChange::LobeChange(const DifferentialEdit& edit) : fitted_(edit.model->instantiate(edit.fitted)) {
  if (!edit.model->hasLobes())
    throw Error("the model " + std::string(edit.model->spec().id) +
                " is not a sum of lobes, so its edit cannot be composed by lobes; expected additive or log-plus");
  std::vector<models::ModelLobe> fitted = edit.model->lobes(edit.fitted), edited = edit.model->lobes(edit.target());
  const std::vector<LobeEffect> changes = changesOf(fitted, edited);
  isIsotropic_ = fitted_->isIsotropic();
  for (std::size_t k = 0; k < fitted.size(); ++k) {
    if (changes[k].kind == LobeEffect::none) continue;
    isIsotropic_ = isIsotropic_ && edited[k].brdf->isIsotropic();
    auto group = std::ranges::find(groups_, changes[k].warp, &Group::warp);
    if (group == groups_.end()) group = groups_.insert(group, Group{changes[k].warp, {}});
    group->lobes.push_back({std::move(fitted[k].brdf), std::move(edited[k].brdf),
                            changes[k].kind == LobeEffect::diffuse, changes[k].isRecoloured, !changes[k].wasNonzero});
  }
}

std::vector<LobeEffect> lobeEffects(const DifferentialEdit& edit) {
  return changesOf(edit.model->lobes(edit.fitted), edit.model->lobes(edit.target()));
}

std::size_t widthChanges(const DifferentialEdit& edit) {
  std::vector<LobeWarp> warps;
  for (const LobeEffect& effect : lobeEffects(edit))
    if (effect.kind != LobeEffect::none && !effect.warp.isIdentity() &&
        std::ranges::find(warps, effect.warp) == warps.end())
      warps.push_back(effect.warp);
  return warps.size();
}

Rgb recolouredRatio(const Rgb& ratio, const Rgb& fitted, const Rgb& edited) {
  constexpr double darkest = 1e-30, minChannel = 1e-6;
  const double before = luminance(fitted), after = luminance(edited);
  if (before < darkest || after < darkest) return ratio;
  const Rgb kept = glm::min(Rgb(1), (fitted / before) / glm::max(edited / after, Rgb(minChannel)));
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
  for (const Group& group : groups_) {
    std::ranges::copy(ratios, carried.begin());
    if (!group.warp.isIdentity()) carryRatios(group.warp, base, pairs, carried);
    for (const Lobe& lobe : group.lobes) add(lobe, pairs, {model, ratios, carried}, changes);
  }
}

void LobeChange::add(const Lobe& lobe, std::span<const DirectionPair> pairs, const Ratios& ratios,
                     std::span<Rgb> changes) {
  std::array<Rgb, maxPairs> fitted, edited;
  lobe.fitted->evaluate(pairs, std::span(fitted).first(pairs.size()));
  lobe.edited->evaluate(pairs, std::span(edited).first(pairs.size()));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Rgb here = lobe.isDiffuse ? diffuseRatio(ratios.here[i], fitted[i], ratios.model[i]) : ratios.here[i];
    const Rgb carried = lobe.isNew ? Rgb(1) : lobe.isDiffuse ? here : ratios.carried[i];
    changes[i] +=
        edited[i] * (lobe.isRecoloured ? recolouredRatio(carried, fitted[i], edited[i]) : carried) - fitted[i] * here;
  }
}

void LobeChange::carryRatios(const LobeWarp& warp, const Brdf& base, std::span<const DirectionPair> pairs,
                             std::span<Rgb> carried) const {
  std::array<DirectionPair, maxPairs> moved;
  std::array<Rgb, maxPairs> measured, model;
  const auto first = [&](auto& all) { return std::span(all).first(pairs.size()); };
  editing::warp(warp, pairs, first(moved));
  base.evaluate(first(moved), first(measured));
  fitted_->evaluate(first(moved), first(model));
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (measured[i] != Rgb(0) || base.hasData(moved[i])) carried[i] = ratioOf(measured[i], model[i]);
}

}  // namespace gonio::editing
