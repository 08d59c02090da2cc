// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/plots/lobe_surface.h"

#include "core/plots/angle_nodes.h"

namespace gonio::plots {

LobeSurface lobeSurface(const Brdf& brdf, double thetaI, CosineFactor cosine, const TabulatedBrdf* coverage, int rings,
                        int sectors) {
  LobeSurface lobe{rings, sectors, {}, {}};
  const std::vector<double> polar = nodesAbout(thetaI, 0, halfPi - horizonMargin, rings);
  // One node more than sectors: pi and -pi are the same.
  const std::vector<double> azimuths = nodesAbout(0, -pi, pi, sectors + 1);
  const Direction wi = fromSpherical(thetaI, pi);
  std::vector<DirectionPair> pairs;
  for (const double theta : polar)
    for (int sector = 0; sector < sectors; ++sector)
      pairs.push_back({wi, fromSpherical(theta, azimuths[std::size_t(sector)])});
  for (const DirectionPair& pair : pairs) lobe.directions.push_back(pair.wo);
  lobe.points = evaluatePlotted(brdf, pairs, cosine, coverage);
  return lobe;
}

}  // namespace gonio::plots
