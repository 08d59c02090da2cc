// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <vector>

#include "core/export/shaders/picture_cells.h"
#include "core/export/shaders/shading_formulas.h"
#include "core/support/task_control.h"

namespace gonio::exports {

/// A Lambertian lobe and GGX lobes with the height-correlated Smith term (Heitz 2014, eq. 99), each with its own
/// generalised Schlick term F (tintedSchlick()): diffuse / pi + sum of D G_2 F / (4 cos theta_i cos theta_o).
/// Reciprocal; energy conservation is not enforced.
struct ReciprocalLobes {
  struct Lobe {
    GgxAlpha alpha{1};
    Rgb normal{0};  ///< F_0, >= 0
    /// F_90, >= 0; above 1 if the measurement increases more toward grazing angles than a Fresnel term can.
    Rgb edge{0};
    Rgb tint82{1};  ///< [0, 1], factor of F at 82 degrees; below 1 if the highlight gets weaker with the angle before F
                    ///< rises to F_90
  };
  Rgb diffuse{0};           ///< albedo, [0, 1]
  std::vector<Lobe> lobes;  ///< by decreasing width
  double rotation = 0;      ///< angle of the lobes' x axis from the tangent, rad, counter-clockwise

  bool isIsotropic() const;
};

/// The lobes as a BRDF, 1/sr, without the cosine.
std::unique_ptr<const Brdf> reciprocalLobesBrdf(const ReciprocalLobes& lobes);

/// Fits the lobes with the least squared residuals of the cells, by variable projection (Golub and Pereyra 1973): a
/// non-linear search over the widths, which starts from a greedy selection of one lobe at a time, and inside it a
/// non-negative linear fit of the strengths per channel (Stark and Parker 1995). Anisotropic lobes share one grain
/// direction; the search starts from four. Under 0.2 s for isotropic cells and four lobes, a few seconds for
/// anisotropic ones. @param count number of GGX lobes, >= 1; the result has fewer if more do not lower the error.
/// @throws Cancelled.
ReciprocalLobes fitReciprocalLobes(const Brdf& material, const PictureCells& cells, std::size_t count,
                                   const TaskControl& control = {});

/// A target's own formula of the lobes, as a BRDF.
using LobesFormula = std::unique_ptr<const Brdf> (*)(const ReciprocalLobes&);

/// Refines the colours of the lobes, including tint82, for a target's own formula: least squared residuals of the
/// cells. Widths and rotation do not change. About 1 s for isotropic cells and four lobes. @throws Cancelled.
ReciprocalLobes refineLobes(const Brdf& material, const PictureCells& cells, const ReciprocalLobes& start,
                            LobesFormula formula, const TaskControl& control = {});

}  // namespace gonio::exports
