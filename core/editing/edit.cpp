// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/edit.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <limits>
#include <optional>

#include "core/brdf/value_bound.h"
#include "core/editing/lobe_bound.h"
#include "core/editing/lobe_change.h"
#include "core/math/parallel.h"
#include "core/math/types.h"
#include "core/support/text.h"

namespace gonio::editing {

namespace {

constexpr std::size_t bakeBlock = 4096;
/// Pairs that are worked on at once: scratch stays on the stack, so single look-ups allocate nothing.
constexpr std::size_t chunkSize = LobeChange::maxPairs;

/// A step of an edit that changes something, ready to evaluate.
struct ActiveEdit {
  std::shared_ptr<const Brdf> edited = {};
  std::shared_ptr<const Brdf> fitted = {};  ///< null: `edited` takes the place of the base
  double strength = 1;
  Composition composition = Composition::additive;
  std::shared_ptr<const LobeChange> lobes = {};  ///< of Composition::lobes, which looks at other directions too
  std::optional<glm::dmat3> colours = {};        ///< of a step that changes colours alone
  std::size_t place = 0;                         ///< of the edit in the list

  bool isIsotropic() const {
    if (colours) return true;
    if (lobes) return lobes->isIsotropic();
    return edited->isIsotropic() && (!fitted || fitted->isIsotropic());
  }
  bool isReciprocal() const {
    if (colours) return true;
    if (lobes) return lobes->isReciprocal();
    return edited->isReciprocal() && (!fitted || fitted->isReciprocal());
  }
};

bool allIsotropic(std::span<const ActiveEdit> edits) {
  return std::all_of(edits.begin(), edits.end(), [](const ActiveEdit& edit) { return edit.isIsotropic(); });
}

ActiveEdit modelChange(const DifferentialEdit& edit, double strength, const Brdf& base) {
  if (edit.composition == Composition::lobes)
    return {
        .strength = strength, .composition = edit.composition, .lobes = std::make_shared<const LobeChange>(edit, base)};
  return {edit.model->instantiate(edit.target()), edit.model->instantiate(edit.fitted), strength, edit.composition};
}

/// @param base with the edits before this one.
void append(std::vector<ActiveEdit>& steps, const DifferentialEdit& edit, double strength, const Brdf& base) {
  assert(edit.model);
  if (edit.changesModel()) steps.push_back(modelChange(edit, strength, base));
  if (edit.changesColours()) steps.push_back({.strength = strength, .colours = edit.colours()});
}

void append(std::vector<ActiveEdit>& steps, const FactorEdit& edit, double strength, const Brdf&) {
  assert(edit.original && edit.edited);
  steps.push_back({factorization::makePdvBrdf(*edit.edited),
                   edit.preserveDetail ? factorization::makePdvBrdf(*edit.original) : nullptr, strength});
}

/// `value` changed, not below the floor, save where the base is below it already, which then gets no lower.
Rgb changed(const Rgb& value, const Rgb& change, const Rgb& floor) {
  return glm::max(glm::min(floor, value), value + change);
}

/// The change that a composition adds: exactly 0 where the edit leaves the model as it is, so that the base survives
/// bit for bit.
Rgb changeOf(const ActiveEdit& edit, const Rgb& value, const Rgb& edited, const Rgb& fitted) {
  return edit.composition == Composition::logPlus ? logPlusChange(value, edited, fitted) : edited - fitted;
}

/// Adds edits that look at no other directions to `values`, which hold the base, for at most chunkSize pairs.
void addEdits(std::span<const ActiveEdit> edits, std::span<const DirectionPair> pairs, std::span<Rgb> values,
              const Rgb& floor = Rgb(0)) {
  std::array<Rgb, chunkSize> edited, fitted;
  for (const ActiveEdit& edit : edits) {
    if (edit.colours) {
      for (Rgb& value : values) value = changed(value, edit.strength * (*edit.colours * value - value), floor);
      continue;
    }
    edit.edited->evaluate(pairs, std::span(edited).first(pairs.size()));
    if (!edit.fitted) {
      for (std::size_t i = 0; i < pairs.size(); ++i)
        values[i] = glm::max(glm::min(floor, values[i]), (1 - edit.strength) * values[i] + edit.strength * edited[i]);
      continue;
    }
    edit.fitted->evaluate(pairs, std::span(fitted).first(pairs.size()));
    for (std::size_t i = 0; i < pairs.size(); ++i)
      values[i] = changed(values[i], edit.strength * changeOf(edit, values[i], edited[i], fitted[i]), floor);
  }
}

/// The bounds of a step of an edit.
struct EditBound {
  std::shared_ptr<const ValueBound> edited, fitted;  ///< null: a change of colours, or one that replaces the base
  std::shared_ptr<const LobeBound> lobes;            ///< of Composition::lobes
  double strength;
  Composition composition;
  std::optional<glm::dmat3> colours;
};

/// One channel of `value` with an edit, as addEdits() computes it, over a set of pairs.
Range editedRange(const EditBound& edit, const Range& value, const Range& edited, const Range& fitted) {
  const Range strength(edit.strength);
  if (!edit.fitted) return (Range(1) - strength) * value + strength * edited;
  if (edit.composition != Composition::logPlus) return value + strength * (edited - fitted);
  // (offset + value) (1 + strength ratio) - offset, in which the value stands once; the ratio rises with `edited`.
  const Range offset(logPlusOffset);
  if (!(value.low >= 0) || !(fitted.low > -logPlusOffset))
    return value + strength * (offset + max(value, Range(0))) * ((edited - fitted) / (offset + fitted));
  const Range ratio = (offset + edited) / (offset + fitted) - Range(1);
  return (offset + value) * (Range(1) + strength * ratio) - offset;
}

/// Step by step what EditedBrdf does, in interval arithmetic.
class EditedBound final : public ValueBound {
 public:
  EditedBound(std::shared_ptr<const ValueBound> base, std::vector<EditBound> edits, double floor)
      : base_(std::move(base)), edits_(std::move(edits)), floor_(floor) {}

  RgbRange over(const PairBox& box) const override {
    const Channels values = overFirst(edits_.size(), box);
    return {Rgb(values[0].low, values[1].low, values[2].low), Rgb(values[0].high, values[1].high, values[2].high)};
  }
  bool isLocal() const override {
    const auto local = [](const std::shared_ptr<const ValueBound>& bound) { return !bound || bound->isLocal(); };
    // Lobes rest on the base in other directions.
    return local(base_) && std::ranges::all_of(edits_, [&](const EditBound& edit) {
             return !edit.lobes && local(edit.edited) && local(edit.fitted);
           });
  }

 private:
  using Channels = LobeBound::Channels;

  /// The values after the first `count` edits.
  Channels overFirst(std::size_t count, const PairBox& box) const {
    Channels values = channels(base_->over(box));
    const bool mayLackData = std::ranges::all_of(values, [](const Range& value) { return value.contains(0); });
    for (std::size_t i = 0; i < count; ++i) {
      const Channels before = values, result = after(i, box, before);
      for (std::size_t c = 0; c < 3; ++c) values[c] = max(min(Range(floor_), before[c]), result[c]);
    }
    // Where the base has no data the value is 0, and so is that of the base.
    if (mayLackData)
      for (Range& value : values) value = hull(value, 0);
    return values;
  }
  /// The values after an edit, not clamped.
  Channels after(std::size_t index, const PairBox& box, const Channels& before) const {
    const EditBound& edit = edits_[index];
    if (edit.lobes)
      return edit.lobes->over(box, before, edit.strength,
                              [&](const PairBox& other) { return overFirst(index, other); });
    const Channels edited = edit.edited ? channels(edit.edited->over(box)) : before;
    const Channels fitted = edit.fitted ? channels(edit.fitted->over(box)) : before;
    Channels result;
    for (std::size_t c = 0; c < 3; ++c)
      result[c] = edit.colours ? recoloured(edit, before, c) : editedRange(edit, before[c], edited[c], fitted[c]);
    return result;
  }

  static std::array<Range, 3> channels(const RgbRange& range) {
    return {Range(range.low.x, range.high.x), Range(range.low.y, range.high.y), Range(range.low.z, range.high.z)};
  }
  static Range recoloured(const EditBound& edit, const std::array<Range, 3>& values, std::size_t channel) {
    Range sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double unchanged = c == channel ? 1 - edit.strength : 0;
      sum += Range(unchanged + edit.strength * (*edit.colours)[int(c)][int(channel)]) * values[c];
    }
    return sum;
  }

  std::shared_ptr<const ValueBound> base_;
  std::vector<EditBound> edits_;
  double floor_;
};

/// A base with edits. All are in one object, so that neither evaluation nor destruction recurses over a long list; only
/// an edit by lobes that changes widths evaluates those before it again (maxBaseEvaluations).
class EditedBrdf final : public Brdf {
 public:
  EditedBrdf(std::shared_ptr<const Brdf> base, std::span<const Edit> edits, double floor)
      : base_(std::move(base)), floor_(floor) {
    for (std::size_t i = 0; i < edits.size(); ++i) {
      if (edits[i].isIdentity()) continue;
      const std::size_t first = edits_.size();
      std::visit([&](const auto& content) { append(edits_, content, edits[i].strength, FirstEdits(*this, first)); },
                 edits[i].content);
      for (std::size_t step = first; step < edits_.size(); ++step) edits_[step].place = i;
    }
  }

  std::span<const ActiveEdit> edits() const { return edits_; }

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t begin = 0; begin < pairs.size(); begin += chunkSize) {
      const std::size_t count = std::min(chunkSize, pairs.size() - begin);
      evaluateFirst(edits_.size(), pairs.subspan(begin, count), values.subspan(begin, count));
    }
  }

  bool hasData(const DirectionPair& pair) const override { return base_->hasData(pair); }
  /// None is known for more than two edits by lobes: the bound of each takes those of all before it twice.
  std::shared_ptr<const ValueBound> valueBound() const override {
    constexpr int maxBoundLobes = 2;
    if (std::ranges::count_if(edits_, [](const ActiveEdit& edit) { return edit.lobes != nullptr; }) > maxBoundLobes)
      return nullptr;
    auto base = base_->valueBound();
    if (!base) return nullptr;
    std::vector<EditBound> edits;
    for (const ActiveEdit& edit : edits_) {
      EditBound& bound =
          edits.emplace_back(EditBound{nullptr, nullptr, nullptr, edit.strength, edit.composition, edit.colours});
      if (edit.edited) bound.edited = edit.edited->valueBound();
      if (edit.fitted) bound.fitted = edit.fitted->valueBound();
      if (edit.lobes) bound.lobes = edit.lobes->bound();
      if ((edit.edited && !bound.edited) || (edit.fitted && !bound.fitted) || (edit.lobes && !bound.lobes))
        return nullptr;
    }
    return std::make_shared<const EditedBound>(std::move(base), std::move(edits), floor_.x);
  }
  bool isIsotropic() const override { return base_->isIsotropic() && allIsotropic(edits_); }
  bool isReciprocal() const override {
    return base_->isReciprocal() &&
           std::all_of(edits_.begin(), edits_.end(), [](const ActiveEdit& edit) { return edit.isReciprocal(); });
  }

 private:
  /// The base with the first edits, for at most chunkSize pairs at once.
  class FirstEdits final : public Brdf {
   public:
    FirstEdits(const EditedBrdf& all, std::size_t count) : all_(all), count_(count) {}
    void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
      all_.evaluateFirst(count_, pairs, values);
    }
    bool hasData(const DirectionPair& pair) const override { return all_.hasData(pair); }
    bool isIsotropic() const override { return all_.base_->isIsotropic() && allIsotropic(first()); }
    /// All isotropic edits are.
    bool isMirrorSymmetric() const override { return all_.base_->isMirrorSymmetric() && allIsotropic(first()); }

   private:
    std::span<const ActiveEdit> first() const { return std::span(all_.edits_).first(count_); }

    const EditedBrdf& all_;
    std::size_t count_;
  };

  /// The base with the first `count` edits, for at most chunkSize pairs.
  void evaluateFirst(std::size_t count, std::span<const DirectionPair> pairs, std::span<Rgb> values) const {
    assert(pairs.size() <= chunkSize);
    base_->evaluate(pairs, values);
    std::array<bool, chunkSize> known;
    for (std::size_t i = 0; i < pairs.size(); ++i) known[i] = values[i] != Rgb(0) || base_->hasData(pairs[i]);
    for (std::size_t i = 0; i < count; ++i)
      if (edits_[i].lobes)
        addLobes(i, pairs, values);
      else
        addEdits(std::span(edits_).subspan(i, 1), pairs, values, floor_);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (!known[i]) values[i] = Rgb(0);
  }

  void addLobes(std::size_t index, std::span<const DirectionPair> pairs, std::span<Rgb> values) const {
    std::array<Rgb, chunkSize> changes{};
    const ActiveEdit& edit = edits_[index];
    edit.lobes->evaluate(FirstEdits(*this, index), pairs, values, std::span(changes).first(pairs.size()));
    for (std::size_t i = 0; i < pairs.size(); ++i) values[i] = changed(values[i], edit.strength * changes[i], floor_);
  }

  std::shared_ptr<const Brdf> base_;
  std::vector<ActiveEdit> edits_;
  Rgb floor_;  ///< of the values
};

/// The mean of the edited base over the azimuths, for at most chunkSize pairs; `values` hold the base.
void addAveragedEdits(std::span<const ActiveEdit> edits, std::span<const DirectionPair> pairs, std::span<Rgb> values) {
  std::array<DirectionPair, chunkSize> turned;
  std::array<Rgb, chunkSize> edited;
  std::array<Rgb, chunkSize> sums{};
  const auto first = [&](auto& all) { return std::span(all).first(pairs.size()); };
  for (int n = 0; n < bakedAzimuths; ++n) {
    const AzimuthRotation turn(pi * n / bakedAzimuths);
    std::transform(pairs.begin(), pairs.end(), turned.begin(), turn);
    std::copy(values.begin(), values.end(), edited.begin());
    addEdits(edits, first(turned), first(edited));
    for (std::size_t i = 0; i < pairs.size(); ++i) sums[i] += edited[i];
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) values[i] = sums[i] / double(bakedAzimuths);
}

/// The mean of a BRDF over the azimuths, for at most chunkSize pairs.
void evaluateMean(const Brdf& brdf, int azimuths, std::span<const DirectionPair> pairs, std::span<Rgb> values) {
  std::array<DirectionPair, chunkSize> turned;
  std::array<Rgb, chunkSize> edited, sums{};
  for (int n = 0; n < azimuths; ++n) {
    std::transform(pairs.begin(), pairs.end(), turned.begin(), AzimuthRotation(pi * n / azimuths));
    brdf.evaluate(std::span(turned).first(pairs.size()), std::span(edited).first(pairs.size()));
    for (std::size_t i = 0; i < pairs.size(); ++i) sums[i] += edited[i];
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) values[i] = sums[i] / double(azimuths);
}

/// The directions of a node as bakeTable() evaluates them: rounding must not push a node on the horizon below it.
DirectionPair bakeDirections(const HalfDifferenceGrid& grid, std::size_t cell) {
  DirectionPair pair = grid.directions(cell);
  for (Direction* w : {&pair.wi, &pair.wo})
    if (!isBelowHorizon(*w)) w->z = std::max(0.0, w->z);
  return pair;
}

/// To float; returns how many channels had to be capped.
std::size_t store(const Rgb& value, TabulatedBrdf::Value& stored) {
  constexpr double largest = std::numeric_limits<float>::max();
  std::size_t capped = 0;
  for (int channel = 0; channel < 3; ++channel) {
    capped += value[channel] > largest;
    stored[channel] = static_cast<float>(std::min(value[channel], largest));
  }
  return capped;
}

/// The base itself without edits.
std::shared_ptr<const Brdf> editedBrdf(std::shared_ptr<const Brdf> base, std::span<const Edit> edits, double floor) {
  if (isIdentity(edits)) return base;
  return std::make_shared<const EditedBrdf>(std::move(base), edits, floor);
}

std::shared_ptr<const TabulatedBrdf> bake(const std::shared_ptr<const TabulatedBrdf>& base, std::span<const Edit> edits,
                                          const TaskControl& control, std::size_t* cappedCount) {
  if (cappedCount) *cappedCount = 0;
  if (isIdentity(edits)) return base;
  const EditedBrdf edited(base, edits, 0);
  const std::span<const ActiveEdit> active = edited.edits();
  const HalfDifferenceGrid& grid = base->grid();
  std::vector<TabulatedBrdf::Value> baked(base->values().begin(), base->values().end());
  std::vector<std::uint8_t> valid(base->valid().begin(), base->valid().end());
  std::atomic<std::size_t> capped = 0;
  const bool isotropic = allIsotropic(active);
  const bool hasLobes = std::ranges::any_of(active, [](const ActiveEdit& edit) { return edit.lobes != nullptr; });
  const auto bakeCells = [&](std::span<const std::size_t> cells) {
    std::array<DirectionPair, chunkSize> pairs;
    std::array<Rgb, chunkSize> values;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      pairs[i] = bakeDirections(grid, cells[i]);
      values[i] = Rgb(baked[cells[i]]);
    }
    const auto chunkPairs = std::span(pairs).first(cells.size());
    const auto chunkValues = std::span(values).first(cells.size());
    if (hasLobes)
      evaluateMean(edited, isotropic ? 1 : bakedAzimuths, chunkPairs, chunkValues);
    else if (isotropic)
      addEdits(active, chunkPairs, chunkValues);
    else
      addAveragedEdits(active, chunkPairs, chunkValues);
    for (std::size_t i = 0; i < cells.size(); ++i) capped += store(values[i], baked[cells[i]]);
  };
  parallelForBlocks(
      grid.size(), bakeBlock,
      [&](std::size_t begin, std::size_t end) {
        std::array<std::size_t, chunkSize> cells;
        std::size_t count = 0;
        for (std::size_t cell = begin; cell < end; ++cell) {
          if (valid[cell]) cells[count++] = cell;
          if (count < chunkSize && cell + 1 < end) continue;
          bakeCells(std::span(cells).first(count));
          count = 0;
        }
      },
      control);
  if (cappedCount) *cappedCount = capped;
  return std::make_shared<const TabulatedBrdf>(grid, std::move(baked), std::move(valid));
}

}  // namespace

bool Edit::isIdentity() const {
  return !enabled || strength == 0 || std::visit([](const auto& one) { return one.isIdentity(); }, content);
}

bool isIdentity(std::span<const Edit> edits) {
  return std::all_of(edits.begin(), edits.end(), [](const Edit& edit) { return edit.isIdentity(); });
}

void checkLimits(std::span<const Edit> edits) {
  if (edits.size() > maxEdits) throw Error("found more than " + std::to_string(maxEdits) + " edits, the limit");
  double evaluations = 1;
  for (const Edit& edit : edits) {
    const auto* change = std::get_if<DifferentialEdit>(&edit.content);
    if (change && change->composition == Composition::lobes && !edit.isIdentity())
      evaluations *= 1 + double(widthChanges(*change));
  }
  if (evaluations > maxBaseEvaluations)
    throw Error("the edits that change the width of highlights are too many: the measurement would be evaluated " +
                numberText(evaluations) + " times for each value, expected at most " + numberText(maxBaseEvaluations) +
                "; use one edit for several changes, or the additive composition");
}

bool isAnisotropic(const Edit& edit) {
  if (const auto* change = std::get_if<DifferentialEdit>(&edit.content))
    return !edit.isIdentity() && change->changesModel() &&
           !(change->model->instantiate(change->fitted)->isIsotropic() &&
             change->model->instantiate(change->target())->isIsotropic());
  return false;
}

std::shared_ptr<const Brdf> applyEdits(std::shared_ptr<const Brdf> base, std::span<const Edit> edits) {
  return editedBrdf(std::move(base), edits, 0);
}

std::vector<AlbedoScale> albedoScales(const std::shared_ptr<const Brdf>& base, std::span<const Edit> edits) {
  std::vector<AlbedoScale> scales(edits.size());
  const auto keepsAlbedo = [](const Edit& edit) {
    const auto* change = std::get_if<DifferentialEdit>(&edit.content);
    return change && change->keepsAlbedo && !edit.isIdentity();
  };
  if (std::ranges::none_of(edits, keepsAlbedo)) return scales;
  const EditedBrdf edited(base, edits, 0);
  for (const ActiveEdit& step : edited.edits())
    if (step.lobes) scales[step.place] = step.lobes->scale();
  return scales;
}

std::shared_ptr<const Brdf> applyEditsUnclamped(std::shared_ptr<const Brdf> base, std::span<const Edit> edits) {
  return editedBrdf(std::move(base), edits, std::numeric_limits<double>::lowest());
}

std::shared_ptr<const TabulatedBrdf> bakeEdits(const std::shared_ptr<const TabulatedBrdf>& base,
                                               std::span<const Edit> edits, const TaskControl& control,
                                               std::size_t* cappedCount) {
  return bake(base, edits, control, cappedCount);
}

std::shared_ptr<const TabulatedBrdf> bakeEdits(const std::shared_ptr<const Brdf>& base, std::span<const Edit> edits,
                                               const TaskControl& control) {
  if (const TabulatedBrdf* table = formOf<TabulatedBrdf>(*base))
    return bakeEdits(std::shared_ptr<const TabulatedBrdf>(base, table), edits, control);
  return bakeTable(*applyEdits(base, edits), {}, control, bakedAzimuths);
}

}  // namespace gonio::editing
