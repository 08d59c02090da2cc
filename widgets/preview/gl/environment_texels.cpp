// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <map>
#include <mutex>

#include "core/rendering/blurred_environment.h"
#include "widgets/preview/gl/textures.h"

namespace gonio::widgets {

namespace {

std::shared_ptr<const EnvironmentTexels> compute(const EnvironmentMap& environment, const EnvironmentMap& blurred) {
  const Image& image = environment.image();
  auto texels = std::make_shared<EnvironmentTexels>();
  texels->width = image.width;
  texels->height = image.height;
  texels->map.resize(image.pixels.size());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Direction centre = EnvironmentMap::directionAt((x + 0.5) / image.width, (y + 0.5) / image.height);
      texels->map[image.index(x, y)] = glm::vec4(image.at(x, y), static_cast<float>(environment.pdf(centre)));
    }
  constexpr int count = EnvironmentTexels::poolSide * EnvironmentTexels::poolSide;
  for (int i = 0; i < count; ++i) {
    const auto sample = environment.sample(additiveRecurrence(2, 0, i), additiveRecurrence(2, 1, i));
    texels->poolDirection.push_back(glm::vec4(glm::vec3(sample.direction), float(sample.pdf)));
    texels->poolRadiance.push_back(glm::vec4(glm::vec3(sample.radiance), 0.f));
  }
  for (const glm::vec3& radiance : blurred.image().pixels) texels->poolRadiance.push_back(glm::vec4(radiance, 0.f));
  return texels;
}

}  // namespace

std::shared_ptr<const EnvironmentTexels> environmentTexels(const std::shared_ptr<const EnvironmentMap>& environment) {
  static std::mutex mutex;
  // Kept as long as the environment lives: it may come back to the preview, and to other windows.
  static std::map<std::weak_ptr<const EnvironmentMap>, std::shared_ptr<const EnvironmentTexels>, std::owner_less<>>
      known;
  {
    const std::scoped_lock lock(mutex);
    std::erase_if(known, [](const auto& entry) { return entry.first.expired(); });
    if (const auto found = known.find(environment); found != known.end()) return found->second;
  }
  auto texels = compute(*environment, *blurredEnvironment(environment));
  const std::scoped_lock lock(mutex);
  return known.try_emplace(environment, std::move(texels)).first->second;
}

}  // namespace gonio::widgets
