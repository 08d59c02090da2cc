// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/blurred_environment.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>

#include "core/math/parallel.h"

namespace gonio {

namespace {

constexpr std::size_t blurredPixels = std::size_t(blurredWidth) * std::size_t(blurredHeight);

/// Light from about a pixel of the blurred picture.
struct Patch {
  Direction direction;
  Rgb power{0};  ///< radiance times solid angle
  double solidAngle = 0;
};

double solidAngleOfRow(int y, const Image& image) {
  const double top = std::cos(std::numbers::pi * y / image.height),
               bottom = std::cos(std::numbers::pi * (y + 1) / image.height);
  return 2 * std::numbers::pi / image.width * (top - bottom);
}

/// Gathers the picture's pixels, or the pixels of a small picture as they are.
std::vector<Patch> patchesOf(const Image& image) {
  const int width = std::min(image.width, blurredWidth), height = std::min(image.height, blurredHeight);
  std::vector<Patch> patches(std::size_t(width) * std::size_t(height));
  for (int y = 0; y < image.height; ++y) {
    const double solidAngle = solidAngleOfRow(y, image);
    for (int x = 0; x < image.width; ++x) {
      Patch& patch =
          patches[std::size_t(y * height / image.height) * std::size_t(width) + std::size_t(x * width / image.width)];
      patch.power += solidAngle * Rgb(image.at(x, y));
      patch.solidAngle += solidAngle;
      patch.direction += solidAngle * EnvironmentMap::directionAt((x + 0.5) / image.width, (y + 0.5) / image.height);
    }
  }
  for (Patch& patch : patches) patch.direction = glm::normalize(patch.direction);
  return patches;
}

std::shared_ptr<const EnvironmentMap> blur(const EnvironmentMap& environment) {
  const double minCosine = std::cos(radians(20));
  const std::vector<Patch> patches = patchesOf(environment.image());
  Image blurred(blurredWidth, blurredHeight);
  parallelForBlocks(blurredPixels, blurredWidth, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const int x = int(i) % blurredWidth, y = int(i) / blurredWidth;
      const Direction centre = EnvironmentMap::directionAt((x + 0.5) / blurredWidth, (y + 0.5) / blurredHeight);
      Rgb sum(0);
      double weights = 0;
      for (const Patch& patch : patches) {
        const double cosine = glm::dot(centre, patch.direction);
        if (cosine < minCosine) continue;
        const double weight = std::exp(blurConcentration * (cosine - 1));
        sum += weight * patch.power;
        weights += weight * patch.solidAngle;
      }
      blurred.at(x, y) = glm::vec3(weights > 0 ? sum / weights : environment.radiance(centre));
    }
  });
  return std::make_shared<const EnvironmentMap>(std::move(blurred), environment.name());
}

}  // namespace

std::shared_ptr<const EnvironmentMap> blurredEnvironment(const std::shared_ptr<const EnvironmentMap>& environment) {
  static std::mutex mutex;
  static std::map<std::weak_ptr<const EnvironmentMap>, std::shared_ptr<const EnvironmentMap>, std::owner_less<>> known;
  {
    const std::scoped_lock lock(mutex);
    std::erase_if(known, [](const auto& entry) { return entry.first.expired(); });
    if (const auto found = known.find(environment); found != known.end()) return found->second;
  }
  auto blurred = blur(*environment);
  const std::scoped_lock lock(mutex);
  return known.try_emplace(environment, std::move(blurred)).first->second;
}

}  // namespace gonio
