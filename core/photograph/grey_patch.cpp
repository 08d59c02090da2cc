// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/photograph/grey_patch.h"

#include <algorithm>
#include <cmath>

#include "core/math/parallel.h"
#include "core/photograph/pixel_rows.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::photograph {

namespace {

Rgb environmentIrradiance(const rendering::EnvironmentMap& environment, double angle, const Direction& normal) {
  const Image& image = environment.image();
  const Direction local = rendering::EnvironmentRotation(angle).toEnvironment(normal);
  std::vector<Direction> columns(std::size_t(image.width));  // horizontal directions
  for (int x = 0; x < image.width; ++x)
    columns[std::size_t(x)] = rendering::EnvironmentMap::directionAt((x + 0.5) / image.width, 0.5);
  std::vector<Rgb> rows(std::size_t(image.height), Rgb(0));
  parallelForBlocks(rows.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const double top = pi * double(row) / image.height, bottom = pi * double(row + 1) / image.height;
      const double solidAngle = 2 * pi / image.width * (std::cos(top) - std::cos(bottom));
      const double sine = std::sin(0.5 * (top + bottom)), height = std::cos(0.5 * (top + bottom)) * local.y;
      for (int x = 0; x < image.width; ++x) {
        const Direction& of = columns[std::size_t(x)];
        const double cosine = height + sine * (of.x * local.x + of.z * local.z);
        if (cosine > 0) rows[row] += Rgb(image.at(x, int(row))) * (cosine * solidAngle);
      }
    }
  });
  Rgb sum(0);
  for (const Rgb& row : rows) sum += row;
  return sum;
}

struct PatchValue {
  Rgb value, radiance;
};

/// The mean of a card's pixels.
std::vector<PatchValue> cardValues(const Photograph& photograph, const GreyPatch& patch) {
  Rgb sum(0);
  double inside = 0, count = 0;
  const Image& image = photograph.image;
  for (int y = std::max(0, int(std::ceil(patch.y - 0.5))); y < image.height && y + 0.5 < patch.y + patch.height; ++y)
    for (int x = std::max(0, int(std::ceil(patch.x - 0.5))); x < image.width && x + 0.5 < patch.x + patch.width; ++x) {
      ++inside;
      if (!isUsable(photograph, x, y)) continue;
      sum += Rgb(image.at(x, y));
      ++count;
    }
  constexpr double needed = 0.9;
  if (!(count > 0 && count >= needed * inside)) return {};
  const Rgb irradiance = irradianceOn(photograph.light, patch.normal, patch.position);
  return {{sum / count, irradiance * (patch.reflectance / pi)}};
}

/// A sphere beside the axis of the camera, seen by a camera that looks at it. (Its outline, an ellipse of little
/// eccentricity, counts as a circle.)
Photograph seenAlone(const Photograph& photograph, const matching::Disc& disc) {
  const rendering::CameraFrame frame = rendering::cameraFrame(photograph.camera);
  const auto [centre, perPixel] = imagePlane(photograph);
  const Direction toCamera =
      -glm::normalize(frame.forward + perPixel * ((disc.x - centre.x) * frame.right - (disc.y - centre.y) * frame.up));
  Photograph alone = photograph;
  alone.surface = UnitSphere{};
  alone.disc = disc;
  alone.camera.yaw = std::atan2(toCamera.x, toCamera.z);
  alone.camera.pitch = std::asin(std::clamp(toCamera.y, -1.0, 1.0));
  alone.camera.distance = std::sqrt(1 + 1 / std::pow(disc.radius * perPixel, 2));
  return alone;
}

std::vector<PatchValue> sphereValues(const Photograph& photograph, const GreyPatch& patch) {
  constexpr std::size_t regions = 60;
  constexpr double inside = 0.85;  // of the radius
  PhotographSet grey{.photographs = {seenAlone(photograph, *patch.sphere)}, .warnings = {}};
  const Photograph& view = grey.photographs[0];
  const SurfaceView normals(view);
  std::vector<PatchValue> values;
  for (const Region& region : regionsOf(grey, regions)) {
    if (glm::length(region.centre - glm::dvec2(view.disc.x, view.disc.y)) > inside * view.disc.radius) continue;
    Rgb irradiance(0);
    for (const RegionPoint& point : region.points)
      irradiance += point.share * irradianceOn(view.light, normals.at(point.pixel).normal, patch.position);
    values.push_back({region.value, irradiance * (patch.reflectance / pi)});
  }
  return values;
}

}  // namespace

Rgb irradianceOn(const Light& light, const Direction& normal, const Direction& position) {
  Rgb sum(0);
  if (light.environment) sum += environmentIrradiance(*light.environment, light.rotation, normal);
  for (const rendering::DirectionalLight& distant : light.directional)
    sum += distant.irradiance * std::max(0.0, glm::dot(distant.toLight, normal));
  for (const rendering::PointLight& small : light.points) {
    const Direction offset = small.position - position;
    const double square = glm::dot(offset, offset);
    sum += small.intensity * (std::max(0.0, glm::dot(offset, normal)) / (square * std::sqrt(square)));
  }
  return sum;
}

Rgb exposureOf(const Photograph& photograph, const GreyPatch& patch, std::vector<std::string>& warnings) {
  const std::vector<PatchValue> values = patch.sphere ? sphereValues(photograph, patch) : cardValues(photograph, patch);
  if (values.empty()) throw Error(photograph.name + ": the grey patch contains no pixels that can be used");
  Rgb products(0), squares(0), energy(0);
  for (const PatchValue& of : values) {
    products += of.value * of.radiance;
    squares += of.radiance * of.radiance;
    energy += of.value * of.value;
  }
  const Rgb factor = products / squares;
  for (int channel = 0; channel < 3; ++channel) {
    if (!(squares[channel] > 0)) throw Error(photograph.name + ": no light falls on the grey patch");
    if (!(factor[channel] > 0)) throw Error(photograph.name + ": the grey patch is black");
  }
  constexpr double like = 0.15;
  const Rgb left = energy - factor * products;
  const double difference = std::sqrt(std::max(0.0, left.x + left.y + left.z) / (energy.x + energy.y + energy.z));
  if (difference > like)
    warnings.push_back(photograph.name + ": the grey sphere differs by " + shortText(100 * difference, 2) +
                       " % from a diffuse one under the stated light; check light and outline");
  return factor;
}

}  // namespace gonio::photograph
