// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/io/byte_source.h"
#include "core/io/marginal_warp.h"

namespace gonio::io {

/// What an RGL file holds, as far as evaluation needs it. The unit square of the microfacet normal has
/// x = sqrt(theta 2/pi), y = (phi + pi) / 2 pi.
struct RglData {
  ParameterGrid incident{{0}, {0}};  ///< azimuths and polar angles of the incident direction, rad
  SliceStack<float> ndf;             ///< distribution of microfacet normals, one slice
  SliceStack<float> sigma;           ///< projected microfacet area seen from the incident direction, one slice
  SliceStack<float> vndf;            ///< distribution of visible normals, a slice an incident direction
  SliceStack<glm::vec3> rgb;         ///< reflectance over the square that the vndf warps to, a slice each
  bool isotropic = true;
  /// How many times the measured range of incident azimuths covers the circle: 2 for materials that are the same after
  /// half a turn, 4 for those with two planes of symmetry. The range starts at -pi.
  int azimuthReduction = 1;
  bool jacobian = true;  ///< rgb is divided by ndf / (4 sigma)
};

/// A material of the EPFL RGL database in its own adaptive parameterisation: Dupuy and Jakob, "An Adaptive
/// Parameterization for Efficient Material Acquisition and Rendering" (2018), section 5. wi is the direction in which
/// the file is sampled coarsely. What the file stores includes the cosine of wo, so that evaluation divides by it (by
/// 0.001 at least); negative values become 0, directions on the horizon give 0. Not exactly reciprocal, as measured.
/// About 0.2 us a pair.
class RglBrdf final : public Brdf {
 public:
  /// @throws Error where the vndf is no density.
  explicit RglBrdf(RglData data);

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override;
  bool isIsotropic() const override { return data_.isotropic; }
  bool isReciprocal() const override { return false; }

 private:
  Rgb evaluateOne(Direction wi, Direction wo) const;

  RglData data_;
  MarginalWarp visibleNormals_;
};

struct RglFile {
  std::shared_ptr<const RglBrdf> brdf;
  std::string description;
  std::vector<int> grid;            ///< sizes of the field `rgb`
  std::uint64_t negativeCount = 0;  ///< negative values in `rgb`
};

/// Reads an `_rgb` file of the database, isotropic or anisotropic.
/// @throws FormatMismatch; Error naming the first value that is not finite.
RglFile readRgl(const ByteSource& source);

}  // namespace gonio::io
