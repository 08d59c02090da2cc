// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <memory>
#include <tuple>

#include "core/brdf/value_bound.h"
#include "core/models/fresnel.h"

/// The words of the formulas (core/models/*.glsl) in interval arithmetic: a model's file includes its formula a second
/// time in the namespace `ranges`, where REAL is a Range, and bound<formula, rangeFormula>() then knows the bounds of
/// the values over sets of directions. Include this file before the formula.
namespace gonio::models::ranges {

using REAL = Range;

struct vec2 {
  Range x, y;
  vec2() = default;
  vec2(const Range& first, const Range& second) : x(first), y(second) {}
  vec2(const glm::dvec2& v) : x(v.x), y(v.y) {}  // NOLINT: numbers are ranges
};

struct vec3 {
  Range x, y, z;
  vec3() = default;
  vec3(const Range& first, const Range& second, const Range& third) : x(first), y(second), z(third) {}
  vec3(const glm::dvec3& v) : x(v.x), y(v.y), z(v.z) {}  // NOLINT: numbers are ranges
};

inline vec3 operator+(const vec3& a, const vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline vec3 operator-(const vec3& a, const vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline vec3 operator*(const vec3& a, const vec3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline vec3 operator*(const vec3& a, const Range& b) { return {a.x * b, a.y * b, a.z * b}; }
inline vec3 operator*(const Range& a, const vec3& b) { return b * a; }
inline vec3 operator/(const vec3& a, const Range& b) { return {a.x / b, a.y / b, a.z / b}; }

/// A vector times itself: the squares are not negative.
inline Range dot(const vec3& a, const vec3& b) {
  return &a == &b ? square(a.x) + square(a.y) + square(a.z) : a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Range dot(const vec2& a, const vec2& b) { return &a == &b ? square(a.x) + square(a.y) : a.x * b.x + a.y * b.y; }

/// A component of wo, and that of wi, which knows its sum with and difference from it: they vanish at the highlight.
struct ViewerComponent : Range {
  ViewerComponent() = default;
  explicit ViewerComponent(const Range& range) : Range(range) {}
};
struct LightComponent : Range {
  Range sum, difference;
};
inline Range operator+(const LightComponent& wi, const ViewerComponent&) { return wi.sum; }
inline Range operator-(const LightComponent& wi, const ViewerComponent&) { return wi.difference; }

struct ViewerDirection {
  ViewerComponent x, y, z;
  operator vec3() const { return {x, y, z}; }  // NOLINT
};
struct LightDirection {
  LightComponent x, y, z;
  Range apart = 0;                             ///< |wi - wo|
  operator vec3() const { return {x, y, z}; }  // NOLINT
};
/// A difference of directions with its length.
struct Apart {
  Range length;
};
inline Apart operator-(const LightDirection& wi, const ViewerDirection&) { return {wi.apart}; }
inline Range length(const Apart& apart) { return apart.length; }
inline Range dot(const Apart& apart, const Apart&) { return square(apart.length); }

struct SurfaceGeometry {
  LightDirection wi;
  ViewerDirection wo;
  vec3 h;
  Range cosI, cosO, cosD, sin2H, oneMinusCosH;

  explicit SurfaceGeometry(const PairBox& box);
};

// The functions of core/math/fast_functions.h are these to about 1e-15.
inline Range clamp(const Range& x, double low, double high) { return min(max(x, Range(low)), Range(high)); }
inline Range exp(const Range& x) {
  return increasing(x, [](double y) { return std::exp(y); });
}
inline Range log(const Range& x) {
  return increasing(x, [](double y) { return std::log(std::max(y, 0.0)); });
}
inline Range expMinusOne(const Range& x) {
  return increasing(x, [](double y) { return std::expm1(y); });
}
inline Range logOnePlus(const Range& x) {
  return increasing(x, [](double y) { return std::log1p(std::max(y, -1.0)); });
}
/// The angle of a sine and a cosine that are not negative: rises with the sine, falls with the cosine.
inline Range acuteAngle(const Range& sine, const Range& cosine) {
  return {std::atan2(std::max(0.0, sine.low), std::max(0.0, cosine.high)),
          std::atan2(std::max(0.0, sine.high), std::max(0.0, cosine.low))};
}
inline Range logCosH(const SurfaceGeometry& g) { return logOnePlus(-g.oneMinusCosH); }
inline vec3 inGrain(const vec3& w, const vec2& axis) {
  return {axis.x * w.x + axis.y * w.y, axis.x * w.y - axis.y * w.x, w.z};
}

#undef FRESNEL_GLSL
namespace formulas {
#include "core/models/fresnel.glsl"
}
#include "core/models/cosine_power.glsl"
#include "core/models/microfacets.glsl"
// The model's own file includes them in the namespace `glsl`.
#undef COSINE_POWER_GLSL
#undef MICROFACETS_GLSL

/// A Fresnel term by its bounds over steps of cos theta_d: its formula would widen them at every step of the
/// arithmetic.
class FresnelTerm {
 public:
  FresnelTerm(const glsl::FresnelTerm& term);  // NOLINT: numbers are ranges
  Range over(const Range& cosD) const {
    const NodeSpan steps({cosD.low * count - 0.5, cosD.high * count - 0.5}, count);
    Range result = (*steps_)[std::size_t(steps.first)];
    for (int i = steps.first + 1; i <= steps.last; ++i) result = hull(result, (*steps_)[std::size_t(i)]);
    return result;
  }

 private:
  static constexpr int count = 256;
  std::shared_ptr<const std::array<Range, count>> steps_;
};
inline Range fresnel(const FresnelTerm& term, const Range& cosD) { return term.over(cosD); }

inline Range toRange(double value) { return value; }
inline vec2 toRange(const glm::dvec2& value) { return value; }
inline vec3 toRange(const glm::dvec3& value) { return value; }
inline FresnelTerm toRange(const glsl::FresnelTerm& term) { return term; }

/// The bounds of a formula with its arguments.
template <auto formula, typename... Arguments>
class FormulaBound final : public ValueBound {
 public:
  explicit FormulaBound(const std::tuple<Arguments...>& arguments) : arguments_(arguments) {}

  RgbRange over(const PairBox& box) const override {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const SurfaceGeometry g(box);
    RgbRange result{Rgb(infinity), Rgb(-infinity)};
    const bool complete =
        overBranches([&] { return value(g); },
                     [&](const vec3& v) {
                       // Where arithmetic ends in no number there is no bound.
                       const auto known = [](const Range& r) { return r.low <= r.high ? r : Range::all(); };
                       const Range red = known(v.x), green = known(v.y), blue = known(v.z);
                       result.low = glm::min(result.low, Rgb(red.low, green.low, blue.low));
                       result.high = glm::max(result.high, Rgb(red.high, green.high, blue.high));
                     });
    return complete ? result : RgbRange{Rgb(-infinity), Rgb(infinity)};
  }

 private:
  vec3 value(const SurfaceGeometry& g) const {
    return std::apply(
        [&g](const Arguments&... each) {
          if constexpr (std::is_invocable_v<decltype(formula), SurfaceGeometry, Arguments...>) {
            return formula(g, each...);
          } else {
            vec3 lobes[2];
            formula(g, each..., lobes);
            return lobes[0] + lobes[1];
          }
        },
        arguments_);
  }

  std::tuple<Arguments...> arguments_;
};

/// @param arguments of the formula in double precision.
template <auto formula, typename... Arguments>
std::shared_ptr<const ValueBound> formulaBound(const std::tuple<Arguments...>& arguments) {
  return std::apply(
      [](const Arguments&... each) -> std::shared_ptr<const ValueBound> {
        using Bound = FormulaBound<formula, decltype(toRange(each))...>;
        return std::make_shared<const Bound>(std::tuple(toRange(each)...));
      },
      arguments);
}

}  // namespace gonio::models::ranges

namespace gonio::models {

/// As bound<formula>(), with the bounds of its values. @tparam rangeFormula the same formula in the namespace `ranges`.
template <auto formula, auto rangeFormula, typename... Arguments>
auto bound(const std::tuple<Arguments...>& arguments) {
  struct Bounded : decltype(bound<formula>(arguments)) {
    std::tuple<Arguments...> values;
    std::shared_ptr<const ValueBound> valueBound() const { return ranges::formulaBound<rangeFormula>(values); }
  };
  return Bounded{bound<formula>(arguments), arguments};
}

}  // namespace gonio::models
