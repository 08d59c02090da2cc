// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/editing/differential_edit.h"
#include "core/editing/lobe_warp.h"

namespace gonio::editing {

/// Composition::lobes. A model M = sum over k of M_k is fitted to a measurement m; q(x) = (m(x) + eps) / (M(x) + eps)
/// is what the fit does not explain. Each edited lobe M'_k carries it along:
///
///   edited(x) = m(x) + sum over k of M'_k(x) q(w_k(x)) - M_k(x) q(x),
///
/// where w_k scales tan theta_h by alpha_k / alpha'_k, along and across the grain where there is one (LobeWarp): it
/// maps a direction to where the unedited lobe had the same place in its profile. A highlight keeps its colour and its
/// shape while it widens, and lobes that do not change add exactly nothing. Where w_k(x) was not measured, q(x) is
/// taken.
///
/// A lobe that gets another colour carries the ratio of each channel as far as it keeps its chromaticity, and the ratio
/// of luminance for the rest (recolouredRatio()): a red body that is made grey does not keep the errors of a channel in
/// which it was dark. The body, and every lobe without a width, carries the ratio only where it is nearly all of the
/// model, 1 + (M_k / M)^4 (q - 1): what the fit misses in a highlight belongs to the highlight.
class LobeChange {
 public:
  /// @throws Error where the model is no sum of lobes.
  explicit LobeChange(const DifferentialEdit& edit);

  /// Scratch stays on the stack, so that single look-ups allocate nothing.
  static constexpr std::size_t maxPairs = 64;

  /// Added to `changes`, 1/sr, for at most maxPairs pairs above the horizon. @param values of the base at the pairs.
  /// Evaluates the base once more for each way in which lobes change their width: once where all widen alike.
  void evaluate(const Brdf& base, std::span<const DirectionPair> pairs, std::span<const Rgb> values,
                std::span<Rgb> changes) const;

  bool isIsotropic() const { return isIsotropic_; }
  bool isReciprocal() const { return fitted_->isReciprocal(); }

  /// eps, 1/sr: keeps the ratio near 1 where measurement and fit are both dark.
  static constexpr double epsilon = 0.001;

 private:
  struct Lobe {
    std::unique_ptr<const Brdf> fitted, edited;
    bool isBody, isRecoloured;
  };
  /// Lobes that had the same places.
  struct Group {
    LobeWarp warp;
    std::vector<Lobe> lobes;
  };
  /// What is known at the pairs: the model, and the ratio q there and where the lobe had them.
  struct Ratios {
    std::span<const Rgb> model, here, carried;
  };
  static void add(const Lobe& lobe, std::span<const DirectionPair> pairs, const Ratios& ratios, std::span<Rgb> changes);
  /// The ratios at the places that the lobe had, where they were measured.
  void carryRatios(const LobeWarp& warp, const Brdf& base, std::span<const DirectionPair> pairs,
                   std::span<Rgb> carried) const;

  std::unique_ptr<const Brdf> fitted_;
  std::vector<Group> groups_;  ///< of the lobes that change
  bool isIsotropic_;
};

/// The ratio that a lobe carries. With the chromaticities c = M_k / Y(M_k) and c' = M'_k / Y(M'_k), Y the luminance,
/// and s = min(1, c / c') in each channel: s q + (1 - s) Y(M_k q) / Y(M_k). It is q where the colour stays.
/// @param ratio q; fitted, edited M_k and M'_k, 1/sr.
Rgb recolouredRatio(const Rgb& ratio, const Rgb& fitted, const Rgb& edited);

/// What an edit does to a part of the model.
struct PartChange {
  enum Kind { none, body, highlight } kind = none;  ///< body: without a width
  bool isRecoloured = false;
  LobeWarp warp = {};                  ///< of a highlight
  bool wasLit = false, isLit = false;  ///< the fitted part, the edited one: false where it is black
};
/// Of each part. What the shader reads. Only of models with lobes.
std::vector<PartChange> partChanges(const DifferentialEdit& edit);

}  // namespace gonio::editing
