// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/brdf/value_bound.h"
#include "core/editing/lobe_change.h"

namespace gonio::editing {

/// The bounds of values with an edit by lobes (LobeChange), from the bounds of the base and of each lobe, at the
/// directions and where the lobes are carried from. Immutable.
class LobeBound {
 public:
  /// A lobe of the fit that is not black.
  struct Part {
    std::shared_ptr<const ValueBound> values;
    models::LobeWidth width;
    bool isHighlight;
  };
  static constexpr std::size_t noPart = std::size_t(-1);
  /// A lobe that changes; the members are those of LobeChange::Lobe.
  struct Lobe {
    std::shared_ptr<const ValueBound> edited;
    LobeWarp warp;
    std::size_t part;  ///< noPart: black in the fit
    bool isDiffuse, isRecoloured, isScaled;
  };

  LobeBound(std::vector<Part> parts, std::vector<Lobe> lobes, const AlbedoScale& scale, bool keepsAlbedo)
      : parts_(std::move(parts)), lobes_(std::move(lobes)), scale_(scale), keepsAlbedo_(keepsAlbedo) {}

  using Channels = std::array<Range, 3>;
  using Base = std::function<Channels(const PairBox&)>;
  /// Contains value + strength * change of all pairs of a set. @param values of the base in the set. @param base bounds
  /// of the base's values, for other sets; must contain 0 where the base has no data.
  Channels over(const PairBox& box, const Channels& values, double strength, const Base& base) const;

 private:
  struct Ratios;
  struct Origin;
  Ratios ratiosOver(const PairBox& box, const Channels& values) const;
  void fillPeaks(const PairBox& box, const Channels& values, Ratios& ratios) const;
  Range peakShare(std::size_t part, const Ratios& ratios, std::size_t channel) const;
  Channels carried(const Lobe& lobe, const Ratios& ratios) const;
  Channels edited(const Lobe& lobe, const PairBox& box, const Ratios& here, const Base& base,
                  std::optional<Origin>& origin) const;
  Range unchanged(std::size_t channel, const Ratios& here, const Range& value, double strength) const;

  std::vector<Part> parts_;
  std::vector<Lobe> lobes_;
  AlbedoScale scale_;
  bool keepsAlbedo_;
};

/// Contains the warped pairs (editing::warp()) of all pairs of a set.
PairBox warped(const LobeWarp& warp, const PairBox& box);

}  // namespace gonio::editing
