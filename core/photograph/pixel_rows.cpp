// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/photograph/pixel_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio::photograph {

namespace {

/// Beyond this part of the radius (of the sides of other surfaces) an error of a pixel in the outline changes much.
constexpr double usedRadius = 0.985;

/// The pixels of a photograph that count: those well inside the surface.
class UsedPixels {
 public:
  explicit UsedPixels(const Photograph& photograph) : right_(photograph.size.x), bottom_(photograph.size.y) {
    if (isSphere(photograph.surface)) {
      const matching::Disc& disc = photograph.disc;
      const double limit = usedRadius * disc.radius;
      left_ = int(std::floor(disc.x - limit));
      top_ = int(std::floor(disc.y - limit));
      right_ = int(std::ceil(disc.x + limit));
      bottom_ = int(std::ceil(disc.y + limit));
    }
    const SurfaceView view(photograph);
    used_.reserve(std::size_t(right_ - left_) * std::size_t(bottom_ - top_));
    for (int y = top_; y < bottom_; ++y)
      for (int x = left_; x < right_; ++x) {
        used_.push_back(view.shows({x + 0.5, y + 0.5}, usedRadius));
        count_ += used_.back();
      }
  }

  std::size_t count() const { return count_; }
  int left() const { return left_; }
  int top() const { return top_; }
  int right() const { return right_; }
  int bottom() const { return bottom_; }
  bool contains(int x, int y) const {
    return x < right_ && y < bottom_ &&
           used_[std::size_t(y - top_) * std::size_t(right_ - left_) + std::size_t(x - left_)];
  }

 private:
  int left_ = 0, top_ = 0, right_, bottom_;
  std::vector<bool> used_;
  std::size_t count_ = 0;
};

/// A square of pixels.
struct Square {
  int left, top, side;
};

bool hasAny(const UsedPixels& used, const Square& square) {
  for (int y = square.top; y < square.top + square.side; ++y)
    for (int x = square.left; x < square.left + square.side; ++x)
      if (used.contains(x, y)) return true;
  return false;
}

/// The squares that contain pixels that count.
std::vector<Square> squaresOf(const UsedPixels& used, int side) {
  std::vector<Square> squares;
  for (int top = used.top(); top < used.bottom(); top += side)
    for (int left = used.left(); left < used.right(); left += side)
      if (const Square square{left, top, side}; hasAny(used, square)) squares.push_back(square);
  return squares;
}

/// The squares of the smallest side of which there are at most `most`.
std::vector<Square> squaresFor(const UsedPixels& used, std::size_t most) {
  int side = std::max(1, int(0.8 * std::sqrt(double(used.count()) / double(most))));
  while (true) {
    std::vector<Square> squares = squaresOf(used, side++);
    if (squares.size() <= most) return squares;
  }
}

/// Calls visit(x, y) for the pixels of a square that count.
template <typename Visit>
void forEachPixel(const Square& square, const UsedPixels& used, const Visit& visit) {
  for (int y = square.top; y < square.top + square.side; ++y)
    for (int x = square.left; x < square.left + square.side; ++x)
      if (used.contains(x, y)) visit(x, y);
}

Region emptyRegion(const Square& square, const UsedPixels& used, std::size_t photograph) {
  Region region{.photograph = photograph, .points = {}};
  std::array<RegionPoint, 4> quarters;
  for (RegionPoint& quarter : quarters) quarter.share = 0;
  double count = 0;
  forEachPixel(square, used, [&](int x, int y) {
    const std::size_t right = 2 * (x - square.left) >= square.side ? 1 : 0;
    const std::size_t lower = 2 * (y - square.top) >= square.side ? 2 : 0;
    RegionPoint& quarter = quarters[right + lower];
    quarter.pixel += glm::dvec2(x + 0.5, y + 0.5);
    quarter.share += 1;
    region.centre += glm::dvec2(x + 0.5, y + 0.5);
    count += 1;
  });
  region.centre /= count;
  for (const RegionPoint& quarter : quarters)
    if (quarter.share > 0) region.points.push_back({quarter.pixel / quarter.share, quarter.share / count});
  return region;
}

/// Sets value and variance. @return whether all but a few pixels are usable.
bool readPixels(const Photograph& photograph, const Square& square, const UsedPixels& used, Region& region) {
  Rgb sum(0), squares(0);
  int inside = 0, count = 0, differences = 0;
  forEachPixel(square, used, [&](int x, int y) {
    ++inside;
    if (!isUsable(photograph, x, y)) return;
    const Rgb pixel(photograph.image.at(x, y));
    sum += pixel;
    ++count;
    for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
      if (!isUsable(photograph, x - step.x, y - step.y) || !isUsable(photograph, x + step.x, y + step.y)) continue;
      const Rgb second = 2.0 * pixel - Rgb(photograph.image.at(x - step.x, y - step.y)) -
                         Rgb(photograph.image.at(x + step.x, y + step.y));
      squares += second * second / 6.0;
      ++differences;
    }
  });
  constexpr double needed = 0.9;
  if (count < needed * inside || differences == 0) return false;
  region.value = sum / double(count);
  region.variance = squares / double(differences) / double(count);
  return true;
}

/// The number of regions of each photograph.
std::size_t regionsOfEach(const PhotographSet& set, std::size_t most) {
  return std::max<std::size_t>(1, most / std::max<std::size_t>(1, set.photographs.size()));
}

}  // namespace

bool hasUsedPixels(const Photograph& photograph) { return UsedPixels(photograph).count() > 0; }

bool isUsable(const Photograph& photograph, int x, int y) {
  const Image& image = photograph.image;
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return false;
  const glm::vec3& pixel = image.at(x, y);
  for (int c = 0; c < 3; ++c)
    if (!std::isfinite(pixel[c]) || !(double(pixel[c]) < photograph.clip)) return false;
  return true;
}

std::vector<Region> plannedRegions(const PhotographSet& set, std::size_t most) {
  std::vector<Region> regions;
  for (std::size_t i = 0; i < set.photographs.size(); ++i) {
    const UsedPixels used(set.photographs[i]);
    for (const Square& square : squaresFor(used, regionsOfEach(set, most)))
      regions.push_back(emptyRegion(square, used, i));
  }
  return regions;
}

std::vector<Region> regionsOf(const PhotographSet& set, std::size_t most) {
  std::vector<Region> regions;
  const std::size_t each = regionsOfEach(set, most);
  for (std::size_t i = 0; i < set.photographs.size(); ++i) {
    const Photograph& photograph = set.photographs[i];
    bool found = false;
    double sum = 0;
    const UsedPixels used(photograph);
    for (const Square& square : squaresFor(used, each)) {
      Region region = emptyRegion(square, used, i);
      if (!readPixels(photograph, square, used, region)) continue;
      found = true;
      sum += luminance(region.value);
      regions.push_back(std::move(region));
    }
    const std::string name(surfaceName(photograph.surface));
    if (!found)
      throw Error(photograph.name + ": the " + (isSphere(photograph.surface) ? "outline of the sphere" : name) +
                  " contains no pixels that can be used");
    if (!(sum > 0)) throw Error(photograph.name + ": the " + name + " is black");
  }
  return regions;
}

std::vector<Rgb> PixelRows::values(const std::vector<glm::vec3>& values) const {
  std::vector<Rgb> result(count());
  parallelForBlocks(count(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      Rgb sum(0);
      for (std::size_t n = first[row]; n < first[row + 1]; ++n) sum += Rgb(weights[n] * values[cells[n]]);
      result[row] = sum;
    }
  });
  return result;
}

namespace {

/// A block of texels: its flux per area perpendicular to the light, and the mean direction, weighted by luminance.
struct Block {
  Rgb irradiance{0};
  Direction direction{0};
};

/// An environment as a pyramid: each block of a level covers 1 or 2 rows and columns of blocks of the level before, so
/// that blocks at the horizon are nearly square.
class BlockPyramid {
 public:
  BlockPyramid(const rendering::EnvironmentMap& environment, const rendering::EnvironmentRotation& rotation) {
    const Image& image = environment.image();
    Level texels{image.width, image.height, 1, 1, {}, {}};
    for (int y = 0; y < image.height; ++y) {
      const double solidAngle =
          2 * pi / image.width * (std::cos(pi * y / image.height) - std::cos(pi * (y + 1) / image.height));
      for (int x = 0; x < image.width; ++x) {
        const Direction direction = rotation.fromEnvironment(
            rendering::EnvironmentMap::directionAt((x + 0.5) / image.width, (y + 0.5) / image.height));
        texels.blocks.push_back({Rgb(image.at(x, y)) * solidAngle, direction});
      }
    }
    levels_.push_back(std::move(texels));
    double height = pi / image.height, width = 2 * pi / image.width;  // of a block at the horizon, rad
    while (true) {
      levels_.back().extents = extentsOf(levels_.back(), height, width);
      constexpr double coarsest = 2 * pi / 20, square = 1.5;
      if (std::max(height, width) > coarsest || levels_.back().width < 2 || levels_.back().height < 2) break;
      const int rows = width > square * height || height < square * width ? 2 : 1,
                columns = height > square * width || width < square * height ? 2 : 1;
      levels_.push_back(merged(levels_.back(), columns, rows));
      height *= rows;
      width *= columns;
    }
  }

  /// Calls accept(block, extent in rad) for blocks that cover the sphere, and divides those for which it returns false.
  template <typename Accept>
  void visit(const Accept& accept) const {
    const Level& top = levels_.back();
    for (int y = 0; y < top.height; ++y)
      for (int x = 0; x < top.width; ++x) descend(levels_.size() - 1, x, y, accept);
  }

 private:
  struct Level {
    int width, height;
    int columns, rows;  ///< blocks of the level before that one block covers
    std::vector<Block> blocks;
    std::vector<double> extents;  ///< of the blocks of each row, rad
  };

  static std::vector<double> extentsOf(const Level& level, double height, double width) {
    std::vector<double> extents;
    for (int y = 0; y < level.height; ++y) {
      const double top = height * y, bottom = std::min(pi, height * (y + 1));
      const double sine = top <= halfPi && bottom >= halfPi ? 1 : std::max(std::sin(top), std::sin(bottom));
      extents.push_back(std::max(height, width * sine));
    }
    return extents;
  }

  static Level merged(const Level& finer, int columns, int rows) {
    Level level{(finer.width + columns - 1) / columns, (finer.height + rows - 1) / rows, columns, rows, {}, {}};
    level.blocks.resize(std::size_t(level.width) * std::size_t(level.height));
    for (int y = 0; y < finer.height; ++y)
      for (int x = 0; x < finer.width; ++x) {
        const Block& child = finer.blocks[std::size_t(y) * std::size_t(finer.width) + std::size_t(x)];
        Block& block = level.blocks[std::size_t(y / rows) * std::size_t(level.width) + std::size_t(x / columns)];
        block.irradiance += child.irradiance;
        // Black blocks have a direction too, of which the length is negligible beside those of others.
        constexpr double trace = 1e-12;
        block.direction += child.direction * (luminance(child.irradiance) + trace);
      }
    return level;
  }

  template <typename Accept>
  void descend(std::size_t level, int x, int y, const Accept& accept) const {
    const Level& of = levels_[level];
    const Block& block = of.blocks[std::size_t(y) * std::size_t(of.width) + std::size_t(x)];
    if (block.irradiance == Rgb(0)) return;
    const double extent = of.extents[std::size_t(y)];
    if (accept(block.irradiance, glm::normalize(block.direction), level == 0 ? 0 : extent)) return;
    const Level& finer = levels_[level - 1];
    for (int row = of.rows * y; row < std::min(of.rows * (y + 1), finer.height); ++row)
      for (int column = of.columns * x; column < std::min(of.columns * (x + 1), finer.width); ++column)
        descend(level - 1, column, row, accept);
  }

  std::vector<Level> levels_;
};

/// A point that a camera sees, with a frame of which z is the normal.
struct FramedPoint {
  SeenPoint seen;
  rendering::ShadingFrame frame = rendering::anyFrame(seen.normal);
};

/// The row of one region: weights of all cells in a dense array, and the cells in use.
class RowBuilder {
 public:
  RowBuilder(const dictionary::MappedCells& mapping, const std::vector<std::int32_t>& places)
      : grid_(mapping.grid), places_(places), dense_(mapping.cells.size(), glm::vec3(0)) {}

  /// Adds the light from a direction at a point. @param irradiance perpendicular to the direction.
  void add(const FramedPoint& point, const Direction& toLight, const Rgb& irradiance) {
    const Direction wi = point.frame.toLocal(toLight);
    if (!(wi.z > 0)) return;
    pairs_[pending_] = {wi, point.frame.toLocal(point.seen.toViewer)};
    irradiances_[pending_] = irradiance * wi.z;
    if (++pending_ == HalfDifferenceBlock::capacity) flush();
  }

  void add(const FramedPoint& point, const BlockPyramid& environment, double share) {
    constexpr double largest = radians(8);
    // Largest angle that a part of the environment covers, relative to the spacing in theta_h of the cells into which
    // it falls.
    constexpr double coarseness = 4;
    const double last = grid_.thetaHCount;
    environment.visit([&](const Rgb& irradiance, const Direction& direction, double extent) {
      const double cosine = glm::dot(direction, point.seen.normal);
      if (cosine < -std::sin(std::min(halfPi, extent))) return true;
      if (extent > 0) {
        const Direction sum = direction + point.seen.toViewer;
        const double length = glm::length(sum), cosH = std::clamp(glm::dot(sum, point.seen.normal) / length, 0.0, 1.0);
        const double cosD = std::max(0.1, 0.5 * length);
        // The half vector turns half as far as the light, or farther where light and viewer are far apart.
        const double thetaH = std::max(0.0, std::acos(cosH) - 0.25 * extent / cosD);
        const double node = last * std::sqrt(thetaH / halfPi);
        const double spacing = halfPi * (2 * node + 1) / (last * last);
        if (extent > std::min(largest, coarseness * 2 * spacing * cosD)) return false;
        // At the horizon the cosine bends.
        if (std::abs(cosine) < extent && extent > 0.4 * largest) return false;
      }
      add(point, direction, irradiance * share);
      return true;
    });
  }

  /// Appends the row and begins the next one.
  void finish(std::vector<std::uint32_t>& cells, std::vector<glm::vec3>& weights, float& lost) {
    flush();
    std::sort(used_.begin(), used_.end());
    for (const std::uint32_t cell : used_) {
      cells.push_back(cell);
      weights.push_back(dense_[cell]);
      dense_[cell] = glm::vec3(0);
    }
    used_.clear();
    lost = total_ > 0 ? float(lost_ / total_) : 0;
    lost_ = total_ = 0;
  }

 private:
  void flush() {
    HalfDifferenceBlock block;
    toHalfDifference(std::span(pairs_).first(pending_), block);
    for (std::size_t i = 0; i < pending_; ++i) {
      const double light = luminance(irradiances_[i]);
      total_ += light;
      if (!block.valid[i]) {
        lost_ += light;
        continue;
      }
      const GridCorners corners(grid_, grid_.position(block.thetaH[i], block.thetaD[i], block.phiD[i]));
      double known = 0;
      for (int corner = 0; corner < 8; ++corner)
        if (places_[corners.cell(corner)] >= 0) known += corners.weight(corner);
      if (!(known > 0)) {
        lost_ += light;
        continue;
      }
      for (int corner = 0; corner < 8; ++corner) {
        const std::int32_t place = places_[corners.cell(corner)];
        const double weight = corners.weight(corner);
        if (place < 0 || !(weight > 0)) continue;
        glm::vec3& sum = dense_[std::size_t(place)];
        if (sum == glm::vec3(0)) used_.push_back(std::uint32_t(place));
        sum += glm::vec3(irradiances_[i] * (weight / known));
      }
    }
    pending_ = 0;
  }

  const HalfDifferenceGrid& grid_;
  const std::vector<std::int32_t>& places_;
  std::vector<glm::vec3> dense_;
  std::vector<std::uint32_t> used_;
  std::array<DirectionPair, HalfDifferenceBlock::capacity> pairs_;
  std::array<Rgb, HalfDifferenceBlock::capacity> irradiances_;
  std::size_t pending_ = 0;
  double lost_ = 0, total_ = 0;
};

struct RowPart {
  std::vector<std::uint32_t> cells;
  std::vector<glm::vec3> weights;
  std::vector<std::size_t> ends;
  std::vector<float> lost;
};

}  // namespace

PixelRows assembleRows(const dictionary::MappedCells& mapping, const PhotographSet& set,
                       const std::vector<Region>& regions, double addedRotation, const TaskControl& control) {
  if (!mapping.grid.reciprocal) throw Error("photographs need principal components of reciprocal materials");
  std::vector<std::int32_t> places(mapping.grid.size(), -1);
  for (std::size_t i = 0; i < mapping.cells.size(); ++i) places[mapping.cells[i]] = std::int32_t(i);
  std::map<std::pair<const rendering::EnvironmentMap*, double>, BlockPyramid> pyramids;
  std::vector<const BlockPyramid*> pyramidOf;
  std::vector<SurfaceView> views;
  for (const Photograph& photograph : set.photographs) {
    views.emplace_back(photograph);
    pyramidOf.push_back(nullptr);
    const rendering::EnvironmentMap* environment = photograph.light.environment.get();
    if (!environment) continue;
    const double rotation = photograph.light.rotation + addedRotation;
    const auto found =
        pyramids.try_emplace({environment, rotation}, *environment, rendering::EnvironmentRotation(rotation));
    pyramidOf.back() = &found.first->second;
  }
  constexpr std::size_t rowsPerPart = 16;
  std::vector<RowPart> parts((regions.size() + rowsPerPart - 1) / rowsPerPart);
  parallelForBlocks(
      regions.size(), rowsPerPart,
      [&](std::size_t begin, std::size_t end) {
        RowBuilder builder(mapping, places);
        RowPart& part = parts[begin / rowsPerPart];
        for (std::size_t row = begin; row < end; ++row) {
          control.throwIfStopped();
          const Region& region = regions[row];
          const Light& light = set.photographs[region.photograph].light;
          for (const auto& [pixel, share] : region.points) {
            const FramedPoint point{views[region.photograph].at(pixel)};
            if (const BlockPyramid* pyramid = pyramidOf[region.photograph]) builder.add(point, *pyramid, share);
            for (const rendering::DirectionalLight& distant : light.directional)
              builder.add(point, distant.toLight, distant.irradiance * share);
            for (const rendering::PointLight& small : light.points) {
              const Direction offset = small.position - point.seen.position;
              const double square = glm::dot(offset, offset);
              builder.add(point, offset / std::sqrt(square), small.intensity * (share / square));
            }
          }
          builder.finish(part.cells, part.weights, part.lost.emplace_back());
          part.ends.push_back(part.cells.size());
        }
      },
      control);
  PixelRows rows;
  rows.first.push_back(0);
  for (RowPart& part : parts) {
    const std::size_t offset = rows.cells.size();
    for (const std::size_t end : part.ends) rows.first.push_back(offset + end);
    rows.cells.insert(rows.cells.end(), part.cells.begin(), part.cells.end());
    rows.weights.insert(rows.weights.end(), part.weights.begin(), part.weights.end());
    rows.lost.insert(rows.lost.end(), part.lost.begin(), part.lost.end());
    part = {};
  }
  return rows;
}

}  // namespace gonio::photograph
