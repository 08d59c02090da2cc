// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/brdf/brdf.h"

/// Whether directions are drawn from the density that a BRDF states.
namespace gonio::test {

/// The upper hemisphere in polar coordinates about the mirror direction of a viewer, where most lobes have their peak
/// and densities of half vectors a pole: `distance` is the angle from the mirror direction as a fraction of the angle
/// at which the horizon is met, [0, 1]; `phi` the azimuth about it, [0, 2 pi).
class MirrorCoordinates {
 public:
  struct Point {
    double distance, phi;
  };

  explicit MirrorCoordinates(const Direction& wo);
  Point pointOf(const Direction& w) const;
  /// The direction, and the solid angle that a unit of distance times a radian of phi covers there.
  Direction directionOf(const Point& point, double& solidAngle) const;

 private:
  double horizon(double cosPhi, double sinPhi) const;

  Direction mirror_, first_, second_;
};

struct HemisphereCell {
  MirrorCoordinates::Point low, high;
};

/// Cells that are small where directions are drawn often: halved until none holds much more than a 64th of the draws.
std::vector<HemisphereCell> cellsOfDraws(const Brdf& brdf, const Direction& wo);

/// Integral of the density over a cell: adaptive Gauss-Legendre.
double integralOfPdf(const Brdf& brdf, const Direction& wo, const HemisphereCell& cell, double tolerance = 5e-7);

/// The probability that Pearson's chi-squared is as large as found, were counts of draws by chance about what is
/// expected; cells next to each other are pooled until ten are expected.
double pearsonPValue(const std::vector<double>& expected, const std::vector<double>& observed);

struct SamplingCheck {
  double integral = 0;  ///< of the density over the hemisphere: 1 - lost
  double lost = 0;      ///< fraction of the draws that have the density 0
  double pValue = 1;    ///< of Pearson's chi-squared test of the draws against the integrals of the cells
  bool valid = true;    ///< every other draw is a unit vector above the horizon with the positive density of pdf()
};
/// @param draws of the test; more find smaller errors. @param tolerance of the integral over a cell.
SamplingCheck checkSampling(const Brdf& brdf, const Direction& wo, int draws = 1 << 15, double tolerance = 5e-7);

}  // namespace gonio::test
