// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/environment.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <mutex>
#include <numbers>

#include "core/io/image_io.h"
#include "core/math/fast_functions.h"
#include "core/math/parallel.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::rendering {

namespace {

/// Sets negative values to 0. @return a note of their number; empty if there are none.
std::string limitToPositive(Image& image) {
  std::size_t count = 0;
  float lowest = 0;
  for (glm::vec3& pixel : image.pixels) {
    for (int channel = 0; channel < 3; ++channel) lowest = std::min(lowest, pixel[channel]);
    count += pixel.x < 0 || pixel.y < 0 || pixel.z < 0;
    pixel = glm::max(pixel, 0.0f);
  }
  if (count == 0) return {};
  return std::to_string(count) + " pixels with negative values, down to " + numberText(lowest) + ", were limited to 0";
}

void requireUsableImage(const Image& image, const std::string& name) {
  if (image.width <= 0 || image.height <= 0 ||
      image.pixels.size() != std::size_t(image.width) * std::size_t(image.height))
    throw Error("environment '" + name + "': the image is empty");
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    for (int channel = 0; channel < 3; ++channel)
      if (const float value = image.pixels[i][channel]; !std::isfinite(value))
        throw Error("environment '" + name + "': pixel (" + std::to_string(i % std::size_t(image.width)) + ", " +
                    std::to_string(i / std::size_t(image.width)) + "), counted from the upper left, has " +
                    numberText(value) + " in channel " + "RGB"[channel] + "; expected a finite radiance");
}

}  // namespace

EnvironmentMap::EnvironmentMap(Image radiance, std::string name, std::vector<std::string> notes)
    : image_(std::move(radiance)), name_(std::move(name)), notes_(std::move(notes)) {
  requireUsableImage(image_, name_);
  if (std::string note = limitToPositive(image_); !note.empty()) notes_.push_back(std::move(note));
  density_ = std::make_shared<const EnvironmentDensity>(image_);
}

Direction EnvironmentMap::directionAt(double u, double v) {
  const auto theta = fastSineAndCosine(v / 2), a = fastSineAndCosine(u - 0.5);
  return {theta.sine * a.sine, theta.cosine, -theta.sine * a.cosine};
}

glm::dvec2 EnvironmentMap::positionOf(const Direction& world) {
  const double a = fastAtan2(world.x, -world.z), radius = std::sqrt(world.x * world.x + world.z * world.z);
  return {0.5 + a / (2 * pi), fastAtan2(radius, world.y) / pi};
}

Rgb EnvironmentMap::bilinear(const glm::dvec2& position) const {
  const double x = position.x * image_.width - 0.5,
               y = std::clamp(position.y * image_.height - 0.5, 0.0, image_.height - 1.0);
  const double floorX = std::floor(x);
  const auto column = [&](int i) { return i < 0 ? i + image_.width : i < image_.width ? i : i - image_.width; };
  const int left = column(static_cast<int>(floorX)), right = column(static_cast<int>(floorX) + 1);
  const int top = static_cast<int>(y), bottom = std::min(top + 1, image_.height - 1);
  const double s = x - floorX, t = y - top;
  const auto pixel = [&](int i, int row) { return Rgb(image_.at(i, row)); };
  return (1 - t) * ((1 - s) * pixel(left, top) + s * pixel(right, top)) +
         t * ((1 - s) * pixel(left, bottom) + s * pixel(right, bottom));
}

Rgb EnvironmentMap::radiance(const Direction& world) const { return bilinear(positionOf(world)); }

EnvironmentMap::Sample EnvironmentMap::at(EnvironmentDensity::Table table, const Direction& world) const {
  const glm::dvec2 position = positionOf(world);
  return {world, bilinear(position), density_->density(table, position, world.y)};
}

EnvironmentMap::Sample EnvironmentMap::at(const Direction& world) const {
  return at(EnvironmentDensity::wholeSphere, world);
}

EnvironmentMap::Sample EnvironmentMap::atAbove(const Direction& normal, const Direction& world) const {
  return at(EnvironmentDensity::tableOf(normal), world);
}

namespace {

Direction directionOf(const EnvironmentDensity::Sample& sample) {
  const double cosTheta = sample.cosTheta, sinTheta = std::sqrt(std::max(0.0, (1 - cosTheta) * (1 + cosTheta)));
  const auto a = fastSineAndCosine(sample.u - 0.5);
  return {sinTheta * a.sine, cosTheta, -sinTheta * a.cosine};
}

}  // namespace

EnvironmentMap::Sample EnvironmentMap::sampled(const EnvironmentDensity::Sample& sample, const Direction& world) const {
  const double sinTheta = std::sqrt(world.x * world.x + world.z * world.z);
  return {world, bilinear({sample.u, fastAtan2(sinTheta, world.y) / pi}), sample.density};
}

EnvironmentMap::Sample EnvironmentMap::sample(double u1, double u2) const {
  const EnvironmentDensity::Sample sample = density_->sample(EnvironmentDensity::wholeSphere, {u1, u2});
  return sampled(sample, directionOf(sample));
}

EnvironmentMap::Sample EnvironmentMap::sampleAbove(const Direction& normal, double u1, double u2) const {
  const EnvironmentDensity::Table table = EnvironmentDensity::tableOf(normal);
  if (density_->isEmpty(table)) return {normal, Rgb(0), 0};
  const EnvironmentDensity::Sample sample = density_->sample(table, {u1, u2});
  const Direction direction = directionOf(sample);
  if (!(glm::dot(normal, direction) > 0)) return {direction, Rgb(0), 0};
  return sampled(sample, direction);
}

EnvironmentRotation::EnvironmentRotation(double angle) : c_(std::cos(angle)), s_(std::sin(angle)) {}

std::shared_ptr<const EnvironmentMap> openEnvironment(const std::string& nameOrPath,
                                                      const std::filesystem::path& folder) {
  for (const std::string& bundled : bundledEnvironmentNames())
    if (nameOrPath == bundled) return bundledEnvironment(nameOrPath);
  const std::filesystem::path path = folder / nameOrPath;
  if (std::error_code unreadable; !std::filesystem::exists(path, unreadable))
    throw Error(path.string() + ": found neither a bundled environment (" + bundledEnvironmentList() +
                ") nor a file with this name");
  io::ImageFile file = io::readImageFile(path);
  if (!file.layout.empty())
    throw Error(path.string() + ": found an environment with the layout '" + plainText(file.layout) +
                "', which Gonio wrote for another program; expected a latitude-longitude map, such as the one from "
                "which it was exported");
  if (file.image.width != 2 * file.image.height)
    file.notes.push_back("the image of " + std::to_string(file.image.width) + " x " +
                         std::to_string(file.image.height) +
                         " pixels is read as a latitude-longitude map of the whole sphere, which is usually twice as "
                         "wide as high");
  // A map's errors name it, by its path here.
  return std::make_shared<const EnvironmentMap>(std::move(file.image), path.string(), std::move(file.notes));
}

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

}  // namespace gonio::rendering
