// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/editing/albedo_scale.h"
#include "core/editing/differential_edit.h"
#include "core/math/types.h"

namespace gonio::editing {

/// Cosine of 85 degrees, the maximum polar angle of warped directions. Models are fitted up to this angle. Beyond it
/// the fit is an extrapolation, and its ratio to the measurement would show as a pattern in a highlight that gets much
/// narrower.
inline constexpr double minWarpCosine = 0.08715574274765817;

/// Scales the slopes h_x / h_z and h_y / h_z of a pair's half vector by `scale`: rotates both directions by the
/// shortest rotation from the old half vector to the new one, which leaves theta_d unchanged. With equal scales the
/// rotation is in the plane of the normal and the half vector and leaves phi_d unchanged too. A rotation that would
/// move a direction to less than 5 degrees above the horizon stops there (minWarpCosine). Returns the pair unchanged if
/// the scale is 1 or the half vector is the normal.
/// @param pair with both directions above the horizon. @param scale > 0.
DirectionPair withScaledHalfSlopes(const DirectionPair& pair, const glm::dvec2& scale);

/// The map from directions of an edited lobe to those of the fitted lobe at the same point of its profile.
struct LobeWarp {
  glm::dvec2 scale{1};            ///< alpha / alpha' along and across the grain
  double edited = 0, fitted = 0;  ///< rotations of the grain from the tangent in the edited and the fitted lobe, rad

  bool operator==(const LobeWarp&) const = default;
  bool isIdentity() const { return scale == glm::dvec2(1) && edited == fitted; }
};

/// Applies the map to pairs: rotates them into the edited grain's frame, scales with withScaledHalfSlopes(), and
/// rotates into the fitted grain's. @param moved receives one pair per input pair.
void warp(const LobeWarp& warp, std::span<const DirectionPair> pairs, std::span<DirectionPair> moved);

class LobeBound;

/// Composition::lobes. For a model M = sum over k of M_k that is fitted to a measurement m, the ratio q(x) = (m(x) +
/// eps) / (M(x) + eps) is what the fit does not explain. Each edited lobe M'_k carries it along:
///
///   edited(x) = m(x) + sum over k of (M'_k(x) q(w_k(x)) - M_k(x) q(x)),
///
/// where w_k scales tan theta_h by alpha_k / alpha'_k, separately along and across the grain (LobeWarp): it maps a
/// direction to the one at which the fitted lobe has the same point of its profile. A highlight widens without a change
/// of colour or shape, and unchanged lobes add exactly 0. Where w_k(x) has no data, q(x) is used instead.
///
/// A lobe of changed colour carries the ratio of each channel only as far as its chromaticity is unchanged, and the
/// ratio of the luminances for the rest (recolouredRatio()): a red diffuse term that becomes grey does not inherit the
/// errors of the channels in which it was dark. The diffuse term, and every other lobe without a width, carries the
/// ratio only where it dominates the model, as 1 + (M_k / M)^4 (q - 1): residuals in a highlight belong to the
/// highlight.
/// A lobe that is black in the fit, such as a coat that is added, carries no ratio: it adds M'_k.
///
/// With DifferentialEdit::keepsAlbedo q = min(m / M, 1 + (m - M) M / (M^2 + eps^2)), which leaves less of a bright peak
/// behind, and two things are added:
/// - A measured peak that the fit does not explain belongs to the highlight. Its part of the ratio is the excess e(x) =
///   (q - 1) S(Y(m) / Y(M)) P, with S a smooth step from 1.25 to 2.25 and P = 1 / (1 + t^4 / 81) in the highlight, t =
///   tan theta_h / alpha. A lobe of the highlight H = sum of the M_k with a width carries g_k e in place of e: g_k =
///   (1 + r + r^2 + r^3 + r^4) y_k^4 / sum_j y_j^5, r = 1 - H / M, y_k = Y(M_k) / Y(H), which sums up to all of e save
///   what the rest keeps where it dominates. It fades as the lobe widens, since it would show as a sharp copy of the
///   former highlight: at w_k times min(1, product of the scales)^2.
/// - The edited highlights, where their width changes, are multiplied by s(theta_i) s(theta_o) (AlbedoScale), with
///   which their directional albedo is that of the same edit with the fitted widths.
class LobeChange {
 public:
  /// @param base what the edit is applied to; used only here, with DifferentialEdit::keepsAlbedo: about 11,000 pairs
  /// for each change of width and once more, twice as many if the base is not mirror-symmetric. @throws Error if the
  /// model is not a sum of lobes.
  LobeChange(const DifferentialEdit& edit, const Brdf& base);

  /// Maximum number of pairs per call of evaluate(): its scratch arrays then fit on the stack, so that it allocates no
  /// memory.
  static constexpr std::size_t maxPairs = 64;

  /// Adds the change, 1/sr, to `changes`, for at most maxPairs pairs above the horizon. @param values of the base at
  /// the pairs. Evaluates the base again for each distinct change of width: once if all lobes widen by the same factor.
  void evaluate(const Brdf& base, std::span<const DirectionPair> pairs, std::span<const Rgb> values,
                std::span<Rgb> changes) const;

  /// The bounds of values with this edit; null if none is known of one of the lobes.
  std::shared_ptr<const LobeBound> bound() const;

  /// s; 1 if no highlight keeps its albedo.
  const AlbedoScale& scale() const { return scale_; }
  bool isIsotropic() const { return isIsotropic_; }
  bool isReciprocal() const { return fitted_->isReciprocal(); }

  /// eps, 1/sr: the ratio is near 1 where measurement and fit are both dark.
  static constexpr double epsilon = 0.001;
  /// How far a peak of a highlight reaches, in units of its width: P is 1/2 there.
  static constexpr double peakExtent = 3;

 private:
  static constexpr std::size_t maxParts = 8, noPart = maxParts;
  /// A lobe of the fit that is not black.
  struct Part {
    std::shared_ptr<const Brdf> brdf;
    models::LobeWidth width;
    bool isHighlight;
  };
  struct Lobe {
    std::unique_ptr<const Brdf> edited;
    std::unique_ptr<const Brdf> reference = nullptr;  ///< with the fitted width, if the lobe keeps its albedo
    std::size_t part = noPart;                        ///< index in parts_; noPart: black in the fit
    bool isDiffuse, isRecoloured;
  };
  /// Lobes with the same warp.
  struct Group {
    LobeWarp warp;
    std::vector<Lobe> lobes;
  };
  struct Ratios;
  struct LobeValues;

  void evaluateParts(std::span<const DirectionPair> pairs, Ratios& ratios) const;
  void fillRatios(std::span<const DirectionPair> pairs, std::span<const Rgb> values, Ratios& ratios) const;
  void addPeak(const DirectionPair& pair, double measured, std::size_t i, Ratios& ratios) const;
  /// Sets `carried` to the ratios at the warped pairs; to those of `here` where the base has no data there.
  void carryRatios(const LobeWarp& warp, const Brdf& base, std::span<const DirectionPair> pairs, const Ratios& here,
                   Ratios& carried) const;
  void fillValues(const Lobe& lobe, const Ratios& here, const Ratios& there, double kept, std::size_t count,
                  LobeValues& of) const;
  /// Calls use(lobe, values) for each lobe that changes.
  template <typename Use>
  void forEachLobe(const Brdf& base, std::span<const DirectionPair> pairs, std::span<const Rgb> values,
                   const Use& use) const;
  AlbedoNode albedoNode(const Brdf& base, double narrowest, double cosine) const;
  AlbedoScale solveScale(const Brdf& base, double narrowest) const;

  std::unique_ptr<const Brdf> fitted_;
  std::vector<Part> parts_;
  std::vector<Group> groups_;  ///< the lobes that change
  AlbedoScale scale_;
  bool isIsotropic_, keepsAlbedo_;
};

/// S: how much of a ratio of luminances is a peak that the fit does not explain.
double peakOf(double ratio);
/// 1 + r + r^2 + r^3 + r^4, relative to the share of the highlight: the rest of the model keeps the excess only where
/// it dominates. @param rest r.
Rgb excessOf(const Rgb& rest);

/// The ratio that a recoloured lobe carries: s q + (1 - s) Y(M_k q) / Y(M_k) with s = min(1, c / c') per channel, Y the
/// luminance, and the chromaticities c = M_k / Y(M_k) and c' = M'_k / Y(M'_k). Equals q if the colour is unchanged.
/// @param ratio q. @param fitted M_k, 1/sr. @param edited M'_k, 1/sr.
Rgb recolouredRatio(const Rgb& ratio, const Rgb& fitted, const Rgb& edited);

/// The effect of an edit on one lobe of the model.
struct LobeEffect {
  enum Kind { none, diffuse, highlight } kind = none;  ///< diffuse: a lobe without a width, such as the diffuse term
  bool isRecoloured = false;
  LobeWarp warp = {};                          ///< for a highlight
  models::LobeWidth width = {};                ///< of the fitted lobe, also if it does not change
  bool wasNonzero = false, isNonzero = false;  ///< whether the fitted and the edited lobe are not black
};
/// The change of each lobe, for the preview's shader. Only for models with lobes.
std::vector<LobeEffect> lobeEffects(const DifferentialEdit& edit);
/// Number of distinct changes of width: LobeChange::evaluate() evaluates the base again for each. Only for models with
/// lobes.
std::size_t widthChanges(const DifferentialEdit& edit);

}  // namespace gonio::editing
