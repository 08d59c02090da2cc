// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/value_bound.h"

namespace gonio {

namespace {

/// (1 + c) / 2 cos(a - b) + (1 - c) / 2 cos(a + b) = cos a cos b + c sin a sin b, c = cos psi, for sin a sin b >= 0: a
/// form that stays tight for small b.
Range cosineOfSides(const Range& a, const Range& b, const Range& cosPsi) {
  const Range near = cosine(a - b), far = cosine(a + b);
  return {(1 + cosPsi.low) / 2 * near.low + (1 - cosPsi.low) / 2 * far.low,
          (1 + cosPsi.high) / 2 * near.high + (1 - cosPsi.high) / 2 * far.high};
}

Range within(const Range& a, double low, double high) {
  return {std::clamp(a.low, low, high), std::clamp(a.high, low, high)};
}

Range arcCosine(const Range& cosines) { return {std::acos(cosines.high), std::acos(cosines.low)}; }

}  // namespace

PairBox::PairBox(const Range& viewer, const Range& half, const Range& around, const Range& azimuths)
    : thetaO(viewer),
      phiO(azimuths),
      thetaH(half),
      psi(around),
      cosO(within(cosine(viewer), 0, 1)),
      sinO(within(sine(viewer), 0, 1)),
      cosH(within(cosine(half), 0, 1)),
      sinH(within(sine(half), 0, 1)),
      cosPsi(cosine(around)) {
  // cos theta_d = wo . h, and wi.z = 2 (wo . h) h.z - wo.z = cos theta_o cos 2 theta_h + sin theta_o sin 2 theta_h cos
  // psi: both by the law of cosines.
  cosD = within(cosineOfSides(viewer, half, cosPsi), 0, 1);
  cosI = within(cosineOfSides(viewer, half + half, cosPsi), -1, 1);
  rise = Range(2) * sinH * (sinO * cosH * cosPsi - cosO * sinH);
  rise = {std::max(rise.low, cosI.low - cosO.high), std::min(rise.high, cosI.high - cosO.low)};
  // d wi = 4 cos theta_d d h.
  if (!isEmpty()) measure = 4 * cosD.high * cosI.high * std::max(0.0, cosH.high - cosH.low) * around.width();
  cosI.low = std::max(0.0, cosI.low);
}

Range PairBox::thetaD() const { return arcCosine(cosD); }
Range PairBox::thetaI() const { return arcCosine(within(cosI, 0, 1)); }

Range PairBox::phiI() const {
  const Range length = Range(2) * cosD * sinH;
  const Range along = length * cosPsi - sinO, across = length * sine(psi);
  constexpr double halfTurn = 3.141592653589793;
  // Behind the normal, angles jump.
  if (along.low <= 0 && across.contains(0)) return {-halfTurn, halfTurn};
  Range result(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
  for (const double x : {along.low, along.high})
    for (const double y : {across.low, across.high}) result = hull(result, std::atan2(y, x));
  return result;
}

}  // namespace gonio
