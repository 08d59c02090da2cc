// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/shaders/picture_cells.h"

#include <algorithm>
#include <cmath>

#include "core/math/parallel.h"
#include "core/math/quadrature.h"
#include "core/math/types.h"

namespace gonio::exports {

namespace {

constexpr int viewerPolarCount = 10, grainPolarCount = 5;
/// Odd: of a grain, which looks the same from both sides, these are as many directions.
constexpr std::size_t grainAzimuthCount = 5;
/// Polar angles of the viewer, up to 77 degrees. Beyond, shaders rise to a mirror, measurements are uncertain and the
/// picture is narrow.
constexpr double maxSquaredSine = 0.95;
constexpr double lampSolidAngle = 0.5;  // sr: a disk of 23 degrees about its centre
constexpr int meanAzimuths = 16;

using PairFunction = std::function<void(std::span<const DirectionPair>, std::span<Rgb>)>;

}  // namespace

PictureCells::PictureCells(bool isotropic)
    : isotropic_(isotropic), nodes_{polarNodes, isotropic ? halfCircleNodes : 2 * halfCircleNodes} {
  // Over the squared sine, in which the picture of a sphere is even.
  const QuadratureRule areas = gaussLegendre(isotropic ? viewerPolarCount : grainPolarCount, 0, maxSquaredSine);
  const std::size_t turns = isotropic ? 1 : grainAzimuthCount;
  for (std::size_t k = 0; k < areas.nodes.size(); ++k)
    for (std::size_t j = 0; j < turns; ++j)
      addViewer(fromSpherical(std::asin(std::sqrt(areas.nodes[k])), 2 * pi * double(j) / double(turns)),
                areas.weights[k] / double(turns));
}

PictureCells::PictureCells(std::span<const double> viewers) : isotropic_(true), nodes_{polarNodes, halfCircleNodes} {
  for (const double theta : viewers) addViewer(fromSpherical(theta, 0), 1);
}

void PictureCells::addViewer(const Direction& wo, double fraction) {
  const double circle = isotropic_ ? pi : 2 * pi, turn = azimuth(wo);
  const std::size_t before = scales_.size();
  std::vector<double> areas;
  for (std::size_t i = 0; i < nodes_.polar; ++i) {
    const double u = (double(i) + 0.5) / double(nodes_.polar), theta = u * u * u * halfPi;
    const double step = 3 * u * u * halfPi / double(nodes_.polar);
    for (std::size_t j = 0; j < nodes_.azimuth; ++j) {
      const double phi = turn + circle * (double(j) + 0.5) / double(nodes_.azimuth);
      const Direction half = fromSpherical(theta, phi);
      const double projection = glm::dot(wo, half);
      const Direction wi = 2 * projection * half - wo;
      const bool seen = projection > 0 && wi.z > 1e-3;
      // d omega_i = 4 (wo . h) d omega_h; the mirrored half of the circle counts here.
      const double area = seen ? 4 * projection * std::sin(theta) * step * 2 * pi / double(nodes_.azimuth) : 0;
      pairs_.push_back({seen ? wi : wo, wo});
      weights_.push_back(seen ? area * wi.z : 0);
      areas.push_back(area);
    }
  }
  for (Grid grid = nodes_;; grid = grid.halved()) {
    for (std::size_t i = 0; i < grid.size(); ++i) scales_.push_back(std::sqrt(fraction / (areas[i] + lampSolidAngle)));
    if (grid.size() == 1) break;
    pool(areas, grid);
  }
  patches_ = scales_.size() - before;
  ++viewers_;
}

void PictureCells::pool(std::vector<double>& sums, const Grid& fine) {
  const Grid coarse = fine.halved();
  std::vector<double> pooled(coarse.size());
  for (std::size_t i = 0; i < fine.polar; ++i)
    for (std::size_t j = 0; j < fine.azimuth; ++j) {
      const std::size_t polar = i * coarse.polar / fine.polar, azimuth = j * coarse.azimuth / fine.azimuth;
      pooled[polar * coarse.azimuth + azimuth] += sums[i * fine.azimuth + j];
    }
  sums = std::move(pooled);
}

void PictureCells::weighViewer(std::size_t viewer, std::span<const double> values, std::span<double> residuals) const {
  const std::size_t first = viewer * nodes_.size();
  std::vector<double> light(nodes_.size());
  for (std::size_t i = 0; i < light.size(); ++i) light[i] = values[i] * weights_[first + i];
  std::size_t patch = 0;
  for (Grid grid = nodes_;; grid = grid.halved()) {
    for (std::size_t i = 0; i < grid.size(); ++i, ++patch)
      residuals[patch] = light[i] * scales_[viewer * patches_ + patch];
    if (grid.size() == 1) break;
    pool(light, grid);
  }
}

void PictureCells::computeResiduals(std::span<const double> values, std::span<double> residuals) const {
  for (std::size_t viewer = 0; viewer < viewers_; ++viewer)
    weighViewer(viewer, values.subspan(viewer * nodes_.size(), nodes_.size()),
                residuals.subspan(viewer * patches_, patches_));
}

std::vector<double> PictureCells::residualsOf(const PairFunction& evaluate) const {
  std::vector<double> residuals(3 * residualCount());
  parallelForBlocks(viewers_, 1, [&](std::size_t viewer, std::size_t) {
    std::vector<Rgb> values(nodes_.size());
    evaluate(pairs().subspan(viewer * nodes_.size(), nodes_.size()), values);
    std::vector<double> channelValues(values.size());
    for (int channel = 0; channel < 3; ++channel) {
      std::ranges::transform(values, channelValues.begin(), [channel](const Rgb& value) { return value[channel]; });
      const std::size_t first = std::size_t(channel) * residualCount() + viewer * patches_;
      weighViewer(viewer, channelValues, std::span(residuals).subspan(first, patches_));
    }
  });
  return residuals;
}

std::vector<double> PictureCells::residualsOf(const Brdf& brdf) const {
  return residualsOf([&](auto pairs, auto values) { brdf.evaluate(pairs, values); });
}

std::vector<double> PictureCells::residualsOfMaterial(const Brdf& material) const {
  if (material.isIsotropic() || !isotropic_) return residualsOf(material);
  return residualsOf([&](std::span<const DirectionPair> pairs, std::span<Rgb> values) {
    std::vector<DirectionPair> turned(pairs.size());
    std::vector<Rgb> part(pairs.size());
    std::ranges::fill(values, Rgb(0));
    for (int k = 0; k < meanAzimuths; ++k) {
      const AzimuthRotation turn(2 * pi * k / meanAzimuths);
      std::ranges::transform(pairs, turned.begin(), turn);
      material.evaluate(turned, part);
      for (std::size_t i = 0; i < part.size(); ++i) values[i] += part[i] / double(meanAzimuths);
    }
  });
}

}  // namespace gonio::exports
