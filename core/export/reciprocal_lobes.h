// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <vector>

#include "core/export/formula_brdf.h"
#include "core/export/picture_cells.h"
#include "core/support/task_control.h"

namespace gonio::exports {

/// A Lambertian lobe and GGX lobes with the height-correlated Smith term (Heitz 2014, eq. 99), each with a generalised
/// Schlick term F of its own (tintedSchlick()): diffuse / pi + sum of D G_2 F / (4 cos theta_i cos theta_o).
/// Reciprocal; keeps to no energy limit.
struct ReciprocalLobes {
  struct Lobe {
    GgxWidths alpha{1};
    Rgb normal{0};  ///< F_0, >= 0
    Rgb edge{0};    ///< F_90, >= 0; above 1 where the measurement rises more than a mirror would
    Rgb tint82{1};  ///< [0, 1]: below 1 where the highlight gets weaker before it rises
  };
  Rgb diffuse{0};           ///< albedo, [0, 1]
  std::vector<Lobe> lobes;  ///< from wide to sharp
  double rotation = 0;      ///< rad, of the lobes' x axis from the tangent, counter-clockwise

  bool isIsotropic() const;
};

/// The lobes as a BRDF, 1/sr without the cosine.
std::unique_ptr<const Brdf> reciprocalLobesBrdf(const ReciprocalLobes& lobes);

/// The lobes of least error in the cells, by variable projection (Golub and Pereyra 1973): the widths are searched for,
/// from the best of a series that is extended by one lobe at a time; inside, the strengths are a non-negative linear
/// fit for each channel (Stark and Parker 1995). Anisotropic lobes share one direction of the grain, found from four.
/// Under 0.2 s for isotropic cells and four lobes, some seconds for anisotropic ones. @throws Cancelled.
/// @param count of GGX lobes, >= 1; fewer come back where more do not lower the error.
ReciprocalLobes fitReciprocalLobes(const Brdf& material, const PictureCells& cells, std::size_t count,
                                   const TaskControl& control = {});

/// A target's formula for the lobes.
using LobesFormula = std::unique_ptr<const Brdf> (*)(const ReciprocalLobes&);

/// The colours of least error of a target's own formula in the cells, tint82 among them; widths and rotation stay.
/// About 1 s for isotropic cells and four lobes. @throws Cancelled.
ReciprocalLobes refineLobes(const Brdf& material, const PictureCells& cells, const ReciprocalLobes& start,
                            LobesFormula formula, const TaskControl& control = {});

}  // namespace gonio::exports
