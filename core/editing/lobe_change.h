// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/editing/differential_edit.h"

namespace gonio::editing {

/// Composition::lobes. A model M = sum over k of M_k is fitted to a measurement m; q(x) = (m(x) + eps) / (M(x) + eps)
/// is what the fit does not explain. Each edited lobe M'_k carries it along:
///
///   edited(x) = m(x) + sum over k of M'_k(x) q(w_k(x)) - M_k(x) q(x),
///
/// where w_k scales tan theta_h by alpha_k / alpha'_k (withScaledHalfTangent()): it maps a direction to where the
/// unedited lobe had the same place in its profile. A highlight keeps its colour and its shape while it widens, and
/// lobes that do not change add exactly nothing. Where w_k(x) was not measured, q(x) is taken.
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
  /// Evaluates the base once more for each ratio by which lobes change their width: once where all widen alike.
  void evaluate(const Brdf& base, std::span<const DirectionPair> pairs, std::span<const Rgb> values,
                std::span<Rgb> changes) const;

  bool isIsotropic() const { return fitted_->isIsotropic(); }
  bool isReciprocal() const { return fitted_->isReciprocal(); }

  /// eps, 1/sr: keeps the ratio near 1 where measurement and fit are both dark.
  static constexpr double epsilon = 0.001;

 private:
  struct Lobe {
    std::unique_ptr<const Brdf> fitted, edited;
    double scale;  ///< alpha / alpha'; bodyScale of the body
  };
  /// What is known at the pairs: the model, and the ratio q there and where the lobe had them.
  struct Ratios {
    std::span<const Rgb> model, here, carried;
  };
  static void add(const Lobe& lobe, std::span<const DirectionPair> pairs, const Ratios& ratios, std::span<Rgb> changes);
  /// The ratios at the places that the lobe had, where they were measured.
  void carryRatios(double scale, const Brdf& base, std::span<const DirectionPair> pairs, std::span<Rgb> carried) const;

  std::unique_ptr<const Brdf> fitted_;
  std::vector<Lobe> lobes_;  ///< those that change, by their scale
};

/// The ratio that a lobe carries. With the chromaticities c = M_k / Y(M_k) and c' = M'_k / Y(M'_k), Y the luminance,
/// and s = min(1, c / c') in each channel: s q + (1 - s) Y(M_k q) / Y(M_k). It is q where the colour stays.
/// @param ratio q; fitted, edited M_k and M'_k, 1/sr.
Rgb recolouredRatio(const Rgb& ratio, const Rgb& fitted, const Rgb& edited);

/// Stands for alpha / alpha' of a part that has no width.
inline constexpr double bodyScale = -1;
/// alpha / alpha' of each part of the edited model, 1 where it keeps its width, bodyScale where it has none; 0 where it
/// does not change at all. What the shader reads. Only of models with lobes.
std::vector<double> lobeScales(const DifferentialEdit& edit);

}  // namespace gonio::editing
