// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/plots/plotted_values.h"

namespace gonio::plots {

/// The lobe for one direction of the light: values over the hemisphere of the viewer, at the nodes of a mesh of rings
/// about the normal, dense near the mirror direction.
struct LobeSurface {
  int rings = 0;                      ///< number of polar angles, from the normal to the horizon
  int sectors = 0;                    ///< number of azimuths; the last is adjacent to the first
  std::vector<Direction> directions;  ///< wo per node; sectors run fastest
  PlottedValues points;

  std::size_t index(int ring, int sector) const {
    return std::size_t(ring) * std::size_t(sectors) + std::size_t(sector % sectors);
  }
};

/// @param thetaI polar angle of the light, rad; its azimuth is pi, as in Section. @param coverage as in
/// evaluatePlotted(). Takes a few ms.
LobeSurface lobeSurface(const Brdf& brdf, double thetaI, CosineFactor cosine, const TabulatedBrdf* coverage = nullptr,
                        int rings = 64, int sectors = 96);

}  // namespace gonio::plots
