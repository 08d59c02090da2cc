// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <vector>

#include "core/brdf/brdf.h"

namespace gonio::exports {

/// A quadrature for fits: pairs of directions, and residuals with a sum of squares that approximates the squared error
/// of a picture of a sphere under lights of all sizes. Viewers, up to 77 degrees, are weighted by their area in the
/// picture; directions of the light are dense where the half vector is near the normal. A residual is the light that
/// reaches the viewer from a patch of directions: single nodes, 2 x 2 nodes, 4 x 4 nodes and so on up to the
/// hemisphere. Its square is divided by the sum of the patch's solid angle and 0.5 sr, the solid angle of a large area
/// light. Thus a patch that is small compared with this area light counts by its squared light, and a large patch by
/// its solid angle times the square of its mean light per steradian. Residuals are linear in the BRDF: those of a fit's
/// error are the residuals of the fit minus those of the material.
class PictureCells {
 public:
  /// @param isotropic true: one azimuth of the viewer and, by mirror symmetry, half of the light's azimuths, about
  /// 2,600 pairs; false: five azimuths of the viewer, about 13,000 pairs.
  explicit PictureCells(bool isotropic);
  /// Isotropic cells for viewers at the given polar angles (rad, below pi/2), all with the same weight. 256 pairs each.
  explicit PictureCells(std::span<const double> viewers);

  bool isIsotropic() const { return isotropic_; }
  std::span<const DirectionPair> pairs() const { return pairs_; }
  /// Number of residuals of one channel.
  std::size_t residualCount() const { return scales_.size(); }
  /// Number of residuals of one viewer; they are consecutive.
  std::size_t residualsOfViewer() const { return patches_; }

  /// Computes the residuals of one channel. @param values at the pairs, 1/sr, without the cosine.
  void computeResiduals(std::span<const double> values, std::span<double> residuals) const;
  /// The residuals of red, then green, then blue: 3 residualCount(). Parallel.
  std::vector<double> residualsOf(const Brdf& brdf) const;
  /// residualsOf(), but of the mean over 16 azimuths if the cells are isotropic and the material is not.
  std::vector<double> residualsOfMaterial(const Brdf& material) const;

 private:
  static constexpr std::size_t polarNodes = 32, halfCircleNodes = 8;

  struct Grid {
    std::size_t polar, azimuth;
    std::size_t size() const { return polar * azimuth; }
    Grid halved() const { return {polar > 1 ? polar / 2 : 1, azimuth > 1 ? azimuth / 2 : 1}; }
  };

  /// @param fraction of the picture's area.
  void addViewer(const Direction& wo, double fraction);
  void weighViewer(std::size_t viewer, std::span<const double> values, std::span<double> residuals) const;
  static void pool(std::vector<double>& sums, const Grid& fine);
  std::vector<double> residualsOf(const std::function<void(std::span<const DirectionPair>, std::span<Rgb>)>&) const;

  bool isotropic_;
  Grid nodes_;
  std::vector<DirectionPair> pairs_;  ///< [viewer][polar][azimuth]
  std::vector<double> weights_;       ///< cos theta_i times the solid angle, sr; 0 below the horizon
  std::vector<double> scales_;        ///< [viewer][patch, smallest first]
  std::size_t viewers_ = 0, patches_ = 0;
};

}  // namespace gonio::exports
