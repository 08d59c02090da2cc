// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/formula_range.h"

#include <algorithm>

namespace gonio::models::ranges {

SurfaceGeometry::SurfaceGeometry(const PairBox& box)
    : cosI(std::max(box.cosI.low, horizonTolerance), std::max(box.cosI.high, horizonTolerance)),
      cosO(std::max(box.cosO.low, horizonTolerance), std::max(box.cosO.high, horizonTolerance)),
      cosD(box.cosD),
      sin2H(square(box.sinH)) {
  const Range azimuthH = box.phiO + box.psi;
  h = {box.sinH * cosine(azimuthH), box.sinH * sine(azimuthH), box.cosH};
  oneMinusCosH = sin2H / (Range(1) + box.cosH);
  wo.x = ViewerComponent(box.sinO * cosine(box.phiO));
  wo.y = ViewerComponent(box.sinO * sine(box.phiO));
  wo.z = ViewerComponent(cosO);
  const auto set = [](LightComponent& component, const Range& value, const Range& sum, const Range& difference) {
    static_cast<Range&>(component) = value;
    component.sum = sum;
    component.difference = difference;
  };
  const Range length = Range(2) * box.cosD;  // of wi + wo, which is along h
  const Range x = length * h.x, y = length * h.y;
  set(wi.x, x - wo.x, x, x - Range(2) * wo.x);
  set(wi.y, y - wo.y, y, y - Range(2) * wo.y);
  set(wi.z, cosI, length * h.z, box.rise);
  wi.apart = Range(2) * sqrt(Range(1) - square(box.cosD));
}

FresnelTerm::FresnelTerm(const glsl::FresnelTerm& term) {
  constexpr int parts = 4;
  std::array<Range, count> steps;
  const formulas::FresnelTerm ranges{term.exactFraction, term.contrast, term.product, term.constant,
                                     term.risingFraction};
  for (int step = 0; step < count; ++step) {
    Range whole(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
    for (int part = 0; part < parts; ++part) {
      const double low = double(parts * step + part) / (parts * count), high = low + 1.0 / (parts * count);
      const auto include = [&](const Range& value) { whole = hull(whole, value); };
      if (!overBranches([&] { return formulas::fresnel(ranges, {low, high}); }, include) || !(whole.low <= whole.high))
        whole = Range::all();
    }
    steps[std::size_t(step)] = whole;
  }
  steps_ = std::make_shared<const std::array<Range, count>>(steps);
}

}  // namespace gonio::models::ranges
