// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/lobe_change.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/vector_relational.hpp>
#include <limits>

#include "core/coordinates/half_difference.h"
#include "core/editing/lobe_bound.h"
#include "core/math/parallel.h"
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

constexpr double square(double x) { return x * x; }

/// Negative where the measurement is, as RGL files are for colours outside sRGB: this part of a highlight widens too.
Rgb ratioOf(const Rgb& measured, const Rgb& fitted) {
  return (measured + LobeChange::epsilon) / (fitted + LobeChange::epsilon);
}

constexpr double darkest = 1e-30;

/// The same with an error that falls with the square of the fit: M times the ratio is m where the fit is brighter than
/// m, and close to it where the fit is not dark, so that nothing of a bright peak stays behind.
Rgb closeRatioOf(const Rgb& measured, const Rgb& fitted) {
  const Rgb ratio = 1.0 + (measured - fitted) * fitted / (fitted * fitted + square(LobeChange::epsilon));
  return glm::min(ratio, measured / glm::max(fitted, Rgb(darkest)));
}

/// The part of the ratio measured / model that the diffuse term carries.
Rgb diffuseRatio(const Rgb& ratio, const Rgb& diffuse, const Rgb& model) {
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

bool hasWidth(const models::ModelLobe& lobe) { return lobe.width.x > 0 && lobe.width.y > 0; }

LobeEffect changeOf(const models::ModelLobe& fitted, const models::ModelLobe& edited) {
  LobeEffect change{.isRecoloured = fitted.colours != edited.colours,
                    .width = fitted.width,
                    .wasNonzero = isNonzero(fitted),
                    .isNonzero = isNonzero(edited)};
  const bool isSame = !change.isRecoloured && fitted.parameters == edited.parameters;
  if (isSame || !(change.wasNonzero || change.isNonzero)) return change;
  const models::LobeWidth &from = fitted.width, &to = edited.width;
  const bool isHighlight = hasWidth(fitted) && hasWidth(edited);
  change.kind = isHighlight ? LobeEffect::highlight : LobeEffect::diffuse;
  if (isHighlight && change.wasNonzero) change.warp = {{from.x / to.x, from.y / to.y}, to.rotation, from.rotation};
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

LobeChange::LobeChange(const DifferentialEdit& edit, const Brdf& base)
    : fitted_(edit.model->instantiate(edit.fitted)), keepsAlbedo_(edit.keepsAlbedo) {
  if (!edit.model->hasLobes())
    throw Error("the model " + std::string(edit.model->spec().id) +
                " is not a sum of lobes, so its edit cannot be composed by lobes; expected additive or log-plus");
  std::vector<models::ModelLobe> fitted = edit.model->lobes(edit.fitted), edited = edit.model->lobes(edit.target());
  std::vector<models::ModelLobe> references;
  if (keepsAlbedo_) references = edit.model->lobes(edit.targetWithFittedWidths());
  const std::vector<LobeEffect> changes = changesOf(fitted, edited);
  isIsotropic_ = fitted_->isIsotropic();
  constexpr double none = std::numeric_limits<double>::infinity();
  double narrowest = none;
  for (std::size_t k = 0; k < fitted.size(); ++k) {
    const bool isBlack = !isNonzero(fitted[k]);
    if (!isBlack) parts_.push_back({std::move(fitted[k].brdf), fitted[k].width, hasWidth(fitted[k])});
    if (changes[k].kind == LobeEffect::none) continue;
    isIsotropic_ = isIsotropic_ && edited[k].brdf->isIsotropic();
    auto group = std::ranges::find(groups_, changes[k].warp, &Group::warp);
    if (group == groups_.end()) group = groups_.insert(group, Group{changes[k].warp, {}});
    Lobe lobe{.edited = std::move(edited[k].brdf),
              .part = isBlack ? noPart : parts_.size() - 1,
              .isDiffuse = changes[k].kind == LobeEffect::diffuse,
              .isRecoloured = changes[k].isRecoloured};
    if (keepsAlbedo_ && changes[k].isNonzero && changes[k].warp.scale != glm::dvec2(1)) {
      lobe.reference = std::move(references[k].brdf);
      for (const models::LobeWidth& width : {fitted[k].width, edited[k].width})
        narrowest = std::min({narrowest, width.x, width.y});
    }
    group->lobes.push_back(std::move(lobe));
  }
  assert(parts_.size() <= maxParts);
  if (narrowest < none) scale_ = solveScale(base, narrowest);
}

std::shared_ptr<const LobeBound> LobeChange::bound() const {
  std::vector<LobeBound::Part> parts;
  for (const Part& part : parts_) {
    parts.push_back({part.brdf->valueBound(), part.width, part.isHighlight});
    if (!parts.back().values) return nullptr;
  }
  std::vector<LobeBound::Lobe> lobes;
  for (const Group& group : groups_)
    for (const Lobe& lobe : group.lobes) {
      lobes.push_back({lobe.edited->valueBound(), group.warp, lobe.part == noPart ? LobeBound::noPart : lobe.part,
                       lobe.isDiffuse, lobe.isRecoloured, lobe.reference != nullptr});
      if (!lobes.back().edited) return nullptr;
    }
  return std::make_shared<const LobeBound>(std::move(parts), std::move(lobes), scale_, keepsAlbedo_);
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
  constexpr double minChannel = 1e-6;
  const double before = luminance(fitted), after = luminance(edited);
  if (before < darkest || after < darkest) return ratio;
  const Rgb kept = glm::min(Rgb(1), (fitted / before) / glm::max(edited / after, Rgb(minChannel)));
  return glm::mix(Rgb(luminance(fitted * ratio) / before), ratio, kept);
}

namespace {

/// P: 1 in the centre of a highlight, 0 in its tails.
double centreOf(const Direction& half, const models::LobeWidth& width) {
  constexpr double extent = LobeChange::peakExtent;
  const double c = std::cos(width.rotation), s = std::sin(width.rotation);
  const double x = (c * half.x + s * half.y) / width.x, y = (c * half.y - s * half.x) / width.y;
  return 1 / (1 + square((x * x + y * y) / (extent * extent * std::max(half.z * half.z, 1e-12))));
}

}  // namespace

double peakOf(double ratio) {
  constexpr double first = 1.25, last = 2.25;
  const double t = std::clamp((ratio - first) / (last - first), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Rgb excessOf(const Rgb& rest) { return 1.0 + rest * (1.0 + rest * (1.0 + rest * (1.0 + rest))); }

/// At up to maxPairs pairs.
struct LobeChange::Ratios {
  using Values = std::array<Rgb, maxPairs>;
  std::array<Values, maxParts> parts;  ///< M_k
  Values model, ratio;                 ///< M, q
  // Only with DifferentialEdit::keepsAlbedo.
  Values peak;                          ///< e
  std::array<Values, maxParts> shares;  ///< g_k of highlights
};

void LobeChange::evaluateParts(std::span<const DirectionPair> pairs, Ratios& ratios) const {
  for (std::size_t k = 0; k < parts_.size(); ++k)
    parts_[k].brdf->evaluate(pairs, std::span(ratios.parts[k]).first(pairs.size()));
}

void LobeChange::fillRatios(std::span<const DirectionPair> pairs, std::span<const Rgb> values, Ratios& ratios) const {
  if (!keepsAlbedo_) {
    fitted_->evaluate(pairs, std::span(ratios.model).first(pairs.size()));
    for (std::size_t i = 0; i < pairs.size(); ++i) ratios.ratio[i] = ratioOf(values[i], ratios.model[i]);
    return;
  }
  evaluateParts(pairs, ratios);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Rgb& model = ratios.model[i] = Rgb(0);
    for (std::size_t k = 0; k < parts_.size(); ++k) model += ratios.parts[k][i];
    ratios.ratio[i] = closeRatioOf(values[i], model);
    addPeak(pairs[i], luminance(values[i]), i, ratios);
  }
}

void LobeChange::addPeak(const DirectionPair& pair, double measured, std::size_t i, Ratios& ratios) const {
  ratios.peak[i] = Rgb(0);
  const Rgb& model = ratios.model[i];
  const double step = peakOf((measured + epsilon) / (luminance(model) + epsilon));
  if (step == 0) return;
  const Direction half = glm::normalize(pair.wi + pair.wo);
  Rgb sum(0);
  double centre = 0, powers = 0;
  for (std::size_t k = 0; k < parts_.size(); ++k)
    if (parts_[k].isHighlight) {
      sum += ratios.parts[k][i];
      centre += luminance(ratios.parts[k][i]) * centreOf(half, parts_[k].width);
    }
  if (!(luminance(sum) > darkest)) return;
  ratios.peak[i] = step * centre / luminance(sum) * (ratios.ratio[i] - 1.0);
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    if (!parts_[k].isHighlight) continue;
    const double part = luminance(ratios.parts[k][i]) / luminance(sum), power = square(square(part));
    ratios.shares[k][i] = Rgb(power);
    powers += part * power;
  }
  const Rgb excess = excessOf(glm::max(Rgb(0), 1.0 - sum / glm::max(model, Rgb(darkest))));
  for (std::size_t k = 0; k < parts_.size(); ++k)
    if (parts_[k].isHighlight) ratios.shares[k][i] *= excess / powers;
}

void LobeChange::carryRatios(const LobeWarp& warp, const Brdf& base, std::span<const DirectionPair> pairs,
                             const Ratios& here, Ratios& carried) const {
  std::array<DirectionPair, maxPairs> moved;
  std::array<Rgb, maxPairs> measured;
  const auto first = [&](auto& all) { return std::span(all).first(pairs.size()); };
  editing::warp(warp, pairs, first(moved));
  base.evaluate(first(moved), first(measured));
  fillRatios(first(moved), first(measured), carried);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (measured[i] != Rgb(0) || base.hasData(moved[i])) continue;
    carried.ratio[i] = here.ratio[i];
    if (!keepsAlbedo_) continue;
    carried.peak[i] = here.peak[i];
    for (std::size_t k = 0; k < parts_.size(); ++k) carried.shares[k][i] = here.shares[k][i];
  }
}

/// One lobe at up to maxPairs pairs.
struct LobeChange::LobeValues {
  Ratios::Values fitted;        ///< M_k
  Ratios::Values own, carried;  ///< what it multiplies: r_k where the pairs are, and where they are moved from
};

void LobeChange::fillValues(const Lobe& lobe, const Ratios& here, const Ratios& there, double kept, std::size_t count,
                            LobeValues& of) const {
  for (std::size_t i = 0; i < count; ++i) {
    of.fitted[i] = lobe.part == noPart ? Rgb(0) : here.parts[lobe.part][i];
    of.own[i] = lobe.isDiffuse ? diffuseRatio(here.ratio[i], of.fitted[i], here.model[i]) : here.ratio[i];
    of.carried[i] = lobe.part == noPart ? Rgb(1) : lobe.isDiffuse ? of.own[i] : there.ratio[i];
    if (!keepsAlbedo_ || lobe.part == noPart || lobe.isDiffuse) continue;
    if (here.peak[i] != Rgb(0)) of.own[i] += (here.shares[lobe.part][i] - 1.0) * here.peak[i];
    if (there.peak[i] != Rgb(0)) of.carried[i] += (there.shares[lobe.part][i] * kept - 1.0) * there.peak[i];
  }
}

template <typename Use>
void LobeChange::forEachLobe(const Brdf& base, std::span<const DirectionPair> pairs, std::span<const Rgb> values,
                             const Use& use) const {
  assert(pairs.size() <= maxPairs);
  Ratios here, moved;
  LobeValues of;
  fillRatios(pairs, values, here);
  if (!keepsAlbedo_) evaluateParts(pairs, here);
  for (const Group& group : groups_) {
    const bool isMoved = !group.warp.isIdentity();
    if (isMoved) carryRatios(group.warp, base, pairs, here, moved);
    const double kept = square(std::min(1.0, group.warp.scale.x * group.warp.scale.y));
    for (const Lobe& lobe : group.lobes) {
      fillValues(lobe, here, isMoved ? moved : here, kept, pairs.size(), of);
      use(lobe, of);
    }
  }
}

void LobeChange::evaluate(const Brdf& base, std::span<const DirectionPair> pairs, std::span<const Rgb> values,
                          std::span<Rgb> changes) const {
  forEachLobe(base, pairs, values, [&](const Lobe& lobe, const LobeValues& of) {
    std::array<Rgb, maxPairs> edited;
    lobe.edited->evaluate(pairs, std::span(edited).first(pairs.size()));
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Rgb ratio = lobe.isRecoloured ? recolouredRatio(of.carried[i], of.fitted[i], edited[i]) : of.carried[i];
      if (lobe.reference) edited[i] *= scale_(pairs[i].wi.z) * scale_(pairs[i].wo.z);
      changes[i] += edited[i] * ratio - of.fitted[i] * of.own[i];
    }
  });
}

AlbedoNode LobeChange::albedoNode(const Brdf& base, double narrowest, double cosine) const {
  const AlbedoQuadrature quadrature(cosine, narrowest, isIsotropic_ && base.isIsotropic(), base.isMirrorSymmetric());
  const std::vector<DirectionPair>& pairs = quadrature.pairs;
  const std::vector<double>& weights = quadrature.weights;
  AlbedoNode node;
  std::array<Rgb, maxPairs> values, edited, reference;
  for (std::size_t begin = 0; begin < pairs.size(); begin += maxPairs) {
    const auto chunk = std::span<const DirectionPair>(pairs).subspan(begin, std::min(maxPairs, pairs.size() - begin));
    const auto first = [&](auto& all) { return std::span(all).first(chunk.size()); };
    base.evaluate(chunk, first(values));
    forEachLobe(base, chunk, first(values), [&](const Lobe& lobe, const LobeValues& of) {
      if (!lobe.reference) return;
      lobe.edited->evaluate(chunk, first(edited));
      lobe.reference->evaluate(chunk, first(reference));
      for (std::size_t i = 0; i < chunk.size(); ++i) {
        const auto ratio = [&](const Rgb& carried, const Rgb& now) {
          return lobe.isRecoloured ? recolouredRatio(carried, of.fitted[i], now) : carried;
        };
        node.add(chunk[i].wo.z, weights[begin + i] * edited[i] * ratio(of.carried[i], edited[i]));
        node.before += weights[begin + i] * reference[i] * ratio(of.own[i], reference[i]);
      }
    });
  }
  return node;
}

AlbedoScale LobeChange::solveScale(const Brdf& base, double narrowest) const {
  std::array<AlbedoNode, AlbedoScale::nodes> nodes;
  parallelForBlocks(nodes.size(), 1, [&](std::size_t i, std::size_t) {
    nodes[i] = albedoNode(base, narrowest, AlbedoScale::cosineOf(i));
  });
  return albedoScale(nodes);
}

}  // namespace gonio::editing
