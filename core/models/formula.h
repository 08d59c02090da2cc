// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>
#include <type_traits>

#include "core/math/fast_functions.h"
#include "core/models/surface_geometry.h"

/// The formulas of the models, core/models/*.glsl, are both GLSL and C++: each is included by its model's file in the
/// namespace `glsl`. Here are the words that they use, in double precision: the twin of shaders/formula.glsl. All are
/// inlined and without branches, so that loops over directions are vectorised.
#define INLINE [[gnu::always_inline]] inline
#define OUT
namespace gonio::models::glsl {

using REAL = double;
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using glm::dot, glm::length;

INLINE REAL abs(REAL x) { return std::abs(x); }
INLINE REAL sqrt(REAL x) { return std::sqrt(x); }
INLINE REAL min(REAL a, REAL b) { return std::min(a, b); }
INLINE REAL max(REAL a, REAL b) { return std::max(a, b); }
INLINE REAL clamp(REAL x, REAL low, REAL high) { return std::min(std::max(x, low), high); }
INLINE REAL exp(REAL x) { return fastExp(x); }
INLINE REAL log(REAL x) { return fastLog(x); }
INLINE REAL expMinusOne(REAL x) { return fastExpm1(x); }
INLINE REAL logOnePlus(REAL x) { return fastLog1p(x); }
/// The angle of a sine and a cosine that are not negative.
INLINE REAL acuteAngle(REAL sine, REAL cosine) { return fastAtan2(sine, cosine); }

/// ln cos theta_h. The correction is for the rounding of h.z, which matters near the normal.
INLINE REAL logCosH(const SurfaceGeometry& g) {
  const REAL correction = ((1 - g.h.z) - g.oneMinusCosH) / g.h.z;
  return logWithCorrection(g.h.z, g.oneMinusCosH < 0.5 ? correction : 0.0);
}

/// A direction as seen along a grain whose x axis is (cos, sin) in the frame of the tangent.
INLINE vec3 inGrain(const vec3& w, const vec2& axis) {
  return {axis.x * w.x + axis.y * w.y, axis.x * w.y - axis.y * w.x, w.z};
}

}  // namespace gonio::models::glsl

namespace gonio::models {

/// A formula with its arguments, as a function of the geometry, for makeGeometryBrdf(). @tparam formula of a .glsl
/// file: returns the value, or puts the diffuse term and the highlight into an array, its last argument.
template <auto formula, typename... Arguments>
auto bound(const std::tuple<Arguments...>& arguments) {
  return [arguments](const SurfaceGeometry& g) {
    return std::apply(
        [&g](const Arguments&... each) {
          if constexpr (std::is_invocable_v<decltype(formula), SurfaceGeometry, Arguments...>) {
            return formula(g, each...);
          } else {
            Rgb lobes[2];
            formula(g, each..., lobes);
            return lobes[0] + lobes[1];
          }
        },
        arguments);
  };
}

}  // namespace gonio::models
