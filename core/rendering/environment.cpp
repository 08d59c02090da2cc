// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/environment.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <mutex>
#include <numbers>
#include <span>

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

/// Mean luminance of the bilinear interpolant over each pixel, along one axis: neighbours reach an eighth into a pixel.
double filtered(double before, double centre, double after) { return 0.125 * before + 0.75 * centre + 0.125 * after; }

/// filtered() of the luminance along a row of pixels.
void filterRow(const Image& image, int y, std::vector<double>& result) {
  const int width = image.width;
  const auto at = [&](int x) { return luminance(Rgb(image.at(x, y))); };
  double before = at(width - 1), centre = at(0);
  for (int x = 0; x < width; ++x) {
    const double after = at(x + 1 < width ? x + 1 : 0);
    result[std::size_t(x)] = filtered(before, centre, after);
    before = centre;
    centre = after;
  }
}

/// Running sums from 0 to exactly 1; weights that are all 0 count as equal. Returns the sum.
double accumulate(std::span<const double> weights, std::span<float> cumulative) {
  double total = 0, sum = 0;
  for (const double weight : weights) total += weight;
  const bool uniform = !(total > 0);
  cumulative[0] = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sum += uniform ? 1.0 / double(weights.size()) : weights[i] / total;
    cumulative[i + 1] = static_cast<float>(std::min(1.0, sum));
  }
  cumulative[weights.size()] = 1;
  return total;
}

struct Interval {
  std::size_t index;
  double low, high;
  double fraction(double u) const { return (u - low) / (high - low); }
};

/// The last of the `count` intervals from `first` on that starts at u or before. A binary search without branches: they
/// would be as random as u.
std::size_t lastStart(std::span<const float> cumulative, std::size_t first, std::size_t count, double u) {
  while (count > 1) {
    const std::size_t half = count / 2;
    first = double(cumulative[first + half]) <= u ? first + half : first;
    count -= half;
  }
  return first;
}

/// Cells of [0, 1), a power of two, for which a guide knows where to search: about four intervals each.
std::size_t guideCells(std::size_t intervals) { return std::bit_ceil(intervals + 3) / 4; }

/// guideCells() + 1 entries: the interval that contains the start of each cell; the last interval at the end (Chen and
/// Asau 1974, "On Generating Random Variates from an Empirical Distribution").
void buildGuide(std::span<const float> cumulative, std::span<std::uint32_t> guide) {
  const std::size_t intervals = cumulative.size() - 1, cells = guide.size() - 1;
  for (std::size_t cell = 0; cell < cells; ++cell)
    guide[cell] = std::uint32_t(lastStart(cumulative, 0, intervals, double(cell) / double(cells)));
  guide[cells] = std::uint32_t(intervals - 1);
}

/// The interval of a cumulative table that contains u; never an empty one.
Interval find(std::span<const float> cumulative, std::span<const std::uint32_t> guide, double u) {
  const auto cell = std::size_t(u * double(guide.size() - 1));
  const std::size_t index = lastStart(cumulative, guide[cell], guide[cell + 1] - guide[cell] + 1, u);
  return {index, cumulative[index], cumulative[index + 1]};
}

std::size_t pixelOf(double fraction, int count) {
  return std::size_t(std::clamp(static_cast<int>(fraction * count), 0, count - 1));
}

}  // namespace

EnvironmentMap::EnvironmentMap(Image radiance, std::string name, std::vector<std::string> notes)
    : image_(std::move(radiance)), name_(std::move(name)), notes_(std::move(notes)) {
  requireUsableImage(image_, name_);
  if (std::string note = limitToPositive(image_); !note.empty()) notes_.push_back(std::move(note));
  buildTables();
}

/// A row of blocks: the integrals of the mean luminance of the bilinear radiance over the solid angles of the blocks,
/// up to a factor that all rows share.
std::vector<double> EnvironmentMap::blockWeights(std::size_t row) const {
  const auto columns = std::size_t(image_.width);
  std::vector<double> weights(blockColumns_), before(columns), centre(columns), after(columns);
  const int first = int(row) * blockSide_, end = std::min(first + blockSide_, image_.height);
  filterRow(image_, std::max(first - 1, 0), before);
  filterRow(image_, first, centre);
  for (int y = first; y < end; ++y) {
    filterRow(image_, std::min(y + 1, image_.height - 1), after);
    const double height = std::cos(pi * y / image_.height) - std::cos(pi * (y + 1) / image_.height);
    for (std::size_t x = 0; x < columns; ++x)
      weights[x / std::size_t(blockSide_)] += height * filtered(before[x], centre[x], after[x]);
    before.swap(centre);
    centre.swap(after);
  }
  return weights;
}

void EnvironmentMap::buildTables() {
  const auto blocks = [&](int pixels) { return std::size_t(pixels + blockSide_ - 1) / std::size_t(blockSide_); };
  while (image_.width > maxTableWidth * blockSide_) blockSide_ *= 2;
  blockColumns_ = blocks(image_.width);
  const std::size_t width = blockColumns_, height = blocks(image_.height), rowGuide = guideCells(width) + 1;
  const auto edge = [&](std::size_t block, int pixels) { return std::min(int(block) * blockSide_, pixels); };
  for (std::size_t y = 0; y <= height; ++y)
    cosEdges_.push_back(std::cos(pi * edge(y, image_.height) / double(image_.height)));
  conditional_.resize(height * (width + 1));
  conditionalGuide_.resize(height * rowGuide);
  std::vector<double> rowWeights(height);
  constexpr std::size_t rowsAtOnce = 16;
  parallelForBlocks(height, rowsAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) {
      const std::span<float> cumulative = std::span(conditional_).subspan(y * (width + 1), width + 1);
      rowWeights[y] = accumulate(blockWeights(y), cumulative);
      buildGuide(cumulative, std::span(conditionalGuide_).subspan(y * rowGuide, rowGuide));
    }
  });
  if (std::ranges::all_of(rowWeights, [](double weight) { return !(weight > 0); }))
    for (std::size_t y = 0; y < height; ++y) rowWeights[y] = cosEdges_[y] - cosEdges_[y + 1];
  marginal_.resize(height + 1);
  accumulate(rowWeights, marginal_);
  marginalGuide_.resize(guideCells(height) + 1);
  buildGuide(marginal_, marginalGuide_);
}

Direction EnvironmentMap::directionAt(double u, double v) {
  const double theta = pi * v, a = 2 * pi * (u - 0.5), s = std::sin(theta);
  return {s * std::sin(a), std::cos(theta), -s * std::cos(a)};
}

glm::dvec2 EnvironmentMap::positionOf(const Direction& world) {
  const double a = fastAtan2(world.x, -world.z), radius = std::sqrt(world.x * world.x + world.z * world.z);
  return {0.5 + a / (2 * pi), fastAtan2(radius, world.y) / pi};
}

Rgb EnvironmentMap::bilinear(const glm::dvec2& position) const {
  const double x = position.x * image_.width - 0.5,
               y = std::clamp(position.y * image_.height - 0.5, 0.0, image_.height - 1.0);
  const double floorX = std::floor(x);
  const int left = (static_cast<int>(floorX) + image_.width) % image_.width, right = (left + 1) % image_.width;
  const int top = static_cast<int>(y), bottom = std::min(top + 1, image_.height - 1);
  const double s = x - floorX, t = y - top;
  const auto pixel = [&](int column, int row) { return Rgb(image_.at(column, row)); };
  return (1 - t) * ((1 - s) * pixel(left, top) + s * pixel(right, top)) +
         t * ((1 - s) * pixel(left, bottom) + s * pixel(right, bottom));
}

double EnvironmentMap::blockPdf(std::size_t x, std::size_t y) const {
  const float* row = conditional_.data() + y * (blockColumns_ + 1);
  const double probability = (double(marginal_[y + 1]) - double(marginal_[y])) * (double(row[x + 1]) - double(row[x]));
  return probability / (2 * pi * columnsOf(x).fraction * (cosEdges_[y] - cosEdges_[y + 1]));
}

EnvironmentMap::BlockColumns EnvironmentMap::columnsOf(std::size_t block) const {
  const int first = int(block) * blockSide_, count = std::min(blockSide_, image_.width - first);
  return {first, count, double(count) / image_.width};
}

Rgb EnvironmentMap::radiance(const Direction& world) const { return bilinear(positionOf(world)); }

double EnvironmentMap::pdf(const Direction& world) const { return at(world).pdf; }

EnvironmentMap::Sample EnvironmentMap::at(const Direction& world) const {
  const glm::dvec2 position = positionOf(world);
  const auto side = std::size_t(blockSide_);
  return {world, bilinear(position),
          blockPdf(pixelOf(position.x, image_.width) / side, pixelOf(position.y, image_.height) / side)};
}

EnvironmentMap::PixelDirection EnvironmentMap::sampleDirection(double u1, double u2) const {
  const std::size_t width = blockColumns_, rowGuide = guideCells(width) + 1;
  const Interval row = find(marginal_, marginalGuide_, u1);
  const Interval column = find(std::span(conditional_).subspan(row.index * (width + 1), width + 1),
                               std::span(conditionalGuide_).subspan(row.index * rowGuide, rowGuide), u2);
  const double cosTheta = glm::mix(cosEdges_[row.index], cosEdges_[row.index + 1], row.fraction(u1));
  const BlockColumns columns = columnsOf(column.index);
  const double u = (columns.first + column.fraction(u2) * columns.count) / image_.width;
  const double a = 2 * pi * (u - 0.5), sinTheta = std::sqrt(std::max(0.0, (1 - cosTheta) * (1 + cosTheta)));
  return {column.index, row.index, u, cosTheta, sinTheta, {sinTheta * std::sin(a), cosTheta, -sinTheta * std::cos(a)}};
}

EnvironmentMap::Sample EnvironmentMap::at(const PixelDirection& place) const {
  const double v = fastAtan2(place.sinTheta, place.cosTheta) / pi;
  return {place.direction, bilinear({place.u, v}), blockPdf(place.x, place.y)};
}

EnvironmentMap::Sample EnvironmentMap::sample(double u1, double u2) const { return at(sampleDirection(u1, u2)); }

EnvironmentMap::Sample EnvironmentMap::sampleAbove(const Direction& normal, double u1, double u2) const {
  const PixelDirection place = sampleDirection(u1, u2);
  if (!(glm::dot(normal, place.direction) > 0)) return {place.direction, Rgb(0), 0};
  return at(place);
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
