// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/reflection_bound.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/sampling.h"

namespace gonio {

namespace {

constexpr std::uint32_t samples = 512;

/// A sampled direction stands for a piece of the hemisphere: how large that is, and what it reflects.
struct Piece {
  double value;       ///< of the BRDF, 1/sr
  double fraction;    ///< of the cosine-weighted hemisphere
  double reflection;  ///< of a light of radiance 1 from there
};

std::vector<Piece> drawnPieces(const Brdf& brdf, const ReflectionBound::Sampler& sampler, const Direction& wo) {
  std::vector<DirectionPair> pairs;
  std::vector<double> densities;
  for (std::uint32_t i = 0; i < samples; ++i) {
    const glm::dvec2 u = scrambledSobol(i, 1);
    const DirectionSample drawn = sampler(wo, {scrambledVanDerCorput(i, 2), u.x, u.y});
    if (!(drawn.pdf > 0)) continue;
    pairs.push_back({drawn.wi, wo});
    densities.push_back(drawn.pdf);
  }
  std::vector<Rgb> values(pairs.size());
  brdf.evaluate(pairs, values);
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double value = std::max(0.0, maxChannel(values[i])), cosine = pairs[i].wi.z;
    pieces.push_back({value, cosine / (pi * densities[i] * samples), value * cosine / (densities[i] * samples)});
  }
  std::ranges::sort(pieces, std::greater(), &Piece::value);
  return pieces;
}

}  // namespace

ReflectionBound::ReflectionBound(const Brdf& brdf, const Sampler& sampler) {
  for (const double theta : {0, 15, 30, 45, 60, 70, 75, 80, 85, 89})
    for (const double phi : {0, 45, 90, 135})
      if (phi == 0 || !brdf.isIsotropic()) include(brdf, sampler, fromSpherical(radians(theta), radians(phi)));
  for (std::size_t step = 1; step <= steps; ++step) bound_[step] = std::max(bound_[step], bound_[step - 1]);
}

ReflectionBound ReflectionBound::ofDiffuse(double albedo) {
  ReflectionBound bound;
  bound.peak_ = albedo / pi;
  bound.bound_.fill(albedo);  // at() then keeps to the peak's line
  return bound;
}

void ReflectionBound::include(const Brdf& brdf, const Sampler& sampler, const Direction& wo) {
  double fraction = 0, reflection = 0;
  std::size_t step = 1;
  for (const Piece& piece : drawnPieces(brdf, sampler, wo)) {
    peak_ = std::max(peak_, piece.value);
    // A step that ends within the piece has it whole: the bound errs upward.
    reflection += piece.reflection;
    fraction += piece.fraction;
    for (; step < steps && std::pow(double(step) / steps, 2) <= fraction; ++step)
      bound_[step] = std::max(bound_[step], reflection);
  }
  for (; step <= steps; ++step) bound_[step] = std::max(bound_[step], reflection);
}

double ReflectionBound::at(double fraction) const {
  const double place = std::sqrt(std::clamp(fraction, 0.0, 1.0)) * steps;
  const auto step = std::min(steps - 1, std::size_t(place));
  // Within the first step mirrors rise faster than any line.
  const double bound =
      step == 0 ? bound_[1] : bound_[step] + (place - double(step)) * (bound_[step + 1] - bound_[step]);
  return std::min(bound, pi * peak_ * std::clamp(fraction, 0.0, 1.0));
}

}  // namespace gonio
