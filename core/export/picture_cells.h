// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <vector>

#include "core/brdf/brdf.h"

namespace gonio::exports {

/// Pairs of directions, and what a picture of a sphere shows of a BRDF at them. The viewers stand for areas of the
/// picture, to 77 degrees; the directions of the light are dense where the half vector is near the normal. A residual
/// is the light that reaches the viewer from a patch of directions: each node alone, patches of 2 x 2 nodes, of 4 x 4
/// and so on to the hemisphere, so that the squares' sum is about the error of the picture under lights of all sizes.
/// Patches smaller than a lamp count by their light, larger ones by its mean square. Linear in the BRDF.
class PictureCells {
 public:
  /// @param isotropic one azimuth of the viewer and, by the mirror symmetry, half of the light's circle, about 2,600
  /// pairs; else five azimuths, about 13,000.
  explicit PictureCells(bool isotropic);
  /// Of one azimuth, for viewers at these polar angles (rad, below pi/2) that count alike. 256 pairs each.
  explicit PictureCells(std::span<const double> viewers);

  bool isIsotropic() const { return isotropic_; }
  std::span<const DirectionPair> pairs() const { return pairs_; }
  /// Residuals of one channel.
  std::size_t residualCount() const { return scales_.size(); }
  /// Of these, one viewer's, which follow each other.
  std::size_t residualsOfViewer() const { return patches_; }

  /// Residuals of one channel. @param values at the pairs, 1/sr without the cosine.
  void weigh(std::span<const double> values, std::span<double> residuals) const;
  /// Residuals of red, then green, then blue, 3 residualCount(). In parallel.
  std::vector<double> residualsOf(const Brdf& brdf) const;
  /// The same of the mean over 16 azimuths where the cells are isotropic and the material is not.
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
  std::vector<double> scales_;        ///< [viewer][patch, the smallest first]
  std::size_t viewers_ = 0, patches_ = 0;
};

}  // namespace gonio::exports
