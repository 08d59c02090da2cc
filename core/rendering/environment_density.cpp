// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/environment_density.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/math/parallel.h"
#include "core/math/sampling.h"
#include "core/rendering/environment.h"

namespace gonio::rendering {

namespace {

/// Of the reduced map; of wider ones the tables would take as much memory as the map.
constexpr std::size_t maxWidth = 8192;
constexpr std::size_t rowsAtOnce = 16;
constexpr std::size_t maxCellColumns = 32, maxCellRows = 16;

// Normals are grouped by the squares of an octahedral map (Meyer et al. 2010, "On Floating-Point Normal Vectors").
constexpr std::size_t normalSide = 32;

/// @param place in [-1, 1]^2.
Direction octahedralDirection(const glm::dvec2& place) {
  Direction w(place.x, 1 - std::abs(place.x) - std::abs(place.y), place.y);
  if (w.y < 0) {
    const double x = w.x;
    w.x = std::copysign(1 - std::abs(w.z), x);
    w.z = std::copysign(1 - std::abs(x), w.z);
  }
  return glm::normalize(w);
}

/// A group of normals: all within a cone about `axis`.
struct NormalGroup {
  Direction axis;
  double sineOfRadius, cosineOfRadius;
};

/// Sides of the squares are great circles, so that the corners are farthest from the centre.
std::vector<NormalGroup> makeNormalGroups() {
  std::vector<NormalGroup> groups;
  const auto at = [](double column, double row) {
    return octahedralDirection(glm::dvec2(column, row) * (2.0 / normalSide) - 1.0);
  };
  for (std::size_t i = 0; i < normalSide * normalSide; ++i) {
    const std::size_t below = i / normalSide;
    const double column = double(i % normalSide), row = double(below);
    const Direction axis = at(column + 0.5, row + 0.5);
    double cosine = 1;
    for (const auto& [x, y] : {std::pair{0, 0}, {0, 1}, {1, 0}, {1, 1}})
      cosine = std::min(cosine, glm::dot(axis, at(column + x, row + y)));
    groups.push_back({axis, std::sqrt(1 - cosine * cosine), cosine});
  }
  return groups;
}

const std::vector<NormalGroup>& normalGroups() {
  static const std::vector<NormalGroup> groups = makeNormalGroups();
  return groups;
}

/// The first of `count` parts of `items` equal items, and so on, and the end.
std::vector<std::size_t> startsOf(std::size_t items, std::size_t count) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i <= count; ++i) starts.push_back((i * items + count - 1) / count);
  return starts;
}

std::vector<std::uint8_t> partOf(std::span<const std::size_t> starts) {
  std::vector<std::uint8_t> parts(starts.back());
  for (std::size_t i = 0; i + 1 < starts.size(); ++i)
    std::fill(parts.begin() + std::ptrdiff_t(starts[i]), parts.begin() + std::ptrdiff_t(starts[i + 1]),
              std::uint8_t(i));
  return parts;
}

/// The last of `count` indices with integral(index) <= sought, where the integral does not decrease; the first if there
/// is none. Without branches, which would be as random as the number sought; a few values are compared together.
template <typename Integral>
std::size_t lastStart(std::size_t count, double sought, const Integral& integral) {
  constexpr std::size_t few = 32;
  std::size_t first = 0;
  while (count > few) {
    const std::size_t half = count / 2;
    first = integral(first + half) <= sought ? first + half : first;
    count -= half;
  }
  std::size_t starts = 0;
  for (std::size_t i = 1; i < count; ++i) starts += integral(first + i) <= sought;
  return first + starts;
}

}  // namespace

EnvironmentDensity::EnvironmentDensity(const Image& radiance) {
  reduce(radiance);
  for (std::size_t edge = 0; edge < height_ + 2; ++edge)
    cosEdges_.push_back(std::cos(pi * std::clamp((double(edge) - 0.5) / double(height_), 0.0, 1.0)));
  columnStart_ = startsOf(width_, std::min(width_, maxCellColumns));
  stripStart_ = startsOf(height_ + 1, std::min(height_ + 1, maxCellRows));
  cellColumn_ = partOf(columnStart_);
  cellRow_ = partOf(stripStart_);
  buildCells();
  buildTables();
}

void EnvironmentDensity::reduce(const Image& radiance) {
  const auto columns = std::size_t(radiance.width), rows = std::size_t(radiance.height);
  std::size_t side = 1;
  while (columns > maxWidth * side) side *= 2;
  width_ = (columns + side - 1) / side;
  height_ = (rows + side - 1) / side;
  perAzimuth_ = double(width_) / (2 * pi);
  nodes_.resize(width_ * height_);
  std::vector<double> most(height_, 0.0);
  const auto luminanceOf = [&](std::size_t x, std::size_t y) {
    // Every pixel that a node's part of the map touches: the reduced map is positive wherever the map is.
    const std::size_t left = x * columns / width_, right = ((x + 1) * columns + width_ - 1) / width_;
    const std::size_t top = y * rows / height_, bottom = ((y + 1) * rows + height_ - 1) / height_;
    double sum = 0;
    for (std::size_t row = top; row < bottom; ++row)
      for (std::size_t column = left; column < right; ++column)
        sum += luminance(Rgb(radiance.pixels[row * columns + column]));
    return sum / double((right - left) * (bottom - top));
  };
  parallelForBlocks(height_, rowsAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y)
      for (std::size_t x = 0; x < width_; ++x) {
        const double here = luminanceOf(x, y);
        nodes_[y * width_ + x].luminance = float(here);
        most[y] = std::max(most[y], here);
      }
  });
  const double largest = *std::ranges::max_element(most);
  for (Node& node : nodes_) node.luminance = largest > 0 ? float(node.luminance / largest) : 1.f;
}

EnvironmentDensity::Cell EnvironmentDensity::makeCell(std::size_t column, std::size_t row) const {
  const auto at = [&](double x, double y) {
    const auto within = [](std::span<const std::size_t> starts, std::size_t i, double t) {
      return double(starts[i]) + t * double(starts[i + 1] - starts[i]);
    };
    const double u = (within(columnStart_, column, x) + 0.5) / double(width_);
    const double v = (within(stripStart_, row, y) - 0.5) / double(height_);
    return EnvironmentMap::directionAt(u, std::clamp(v, 0.0, 1.0));
  };
  constexpr int steps = 8;  // along an edge
  const Direction centre = at(0.5, 0.5);
  double cosine = 1;
  for (int i = 0; i <= steps; ++i) {
    const double t = double(i) / steps;
    for (const Direction& w : {at(0, t), at(1, t), at(t, 0), at(t, 1)}) cosine = std::min(cosine, glm::dot(centre, w));
  }
  return {centre, std::sqrt(std::max(0.0, 1 - cosine * cosine)), cosine, 0};
}

void EnvironmentDensity::buildCells() {
  const std::size_t columns = cellColumns();
  acrossCell_.resize(height_ * columns);
  parallelForBlocks(height_, rowsAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      for (std::size_t cell = 0; cell < columns; ++cell) {
        Node* const nodes = &nodes_[row * width_];
        double sum = 0;
        for (std::size_t i = columnStart_[cell]; i < columnStart_[cell + 1]; ++i) {
          nodes[i].across = float(sum);
          sum += 0.5 * (double(nodes[i].luminance) + double(nodes[i + 1 < width_ ? i + 1 : 0].luminance));
        }
        acrossCell_[row * columns + cell] = float(sum);
      }
  });
  down_.resize(columns * (height_ + 1));
  for (std::size_t row = 0; row < cellRows(); ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      double sum = 0;
      for (std::size_t strip = stripStart_[row]; strip < stripStart_[row + 1]; ++strip) {
        down_[column * (height_ + 1) + strip] = float(sum);
        const double above = acrossCell_[rowAbove(strip) * columns + column];
        const double below = acrossCell_[rowBelow(strip) * columns + column];
        sum += 0.5 * (above + below) * (cosEdges_[strip] - cosEdges_[strip + 1]);
      }
      cells_.push_back(makeCell(column, row));
      cells_.back().mass = sum;
    }
}

EnvironmentDensity::Table EnvironmentDensity::tableOf(const Direction& normal) {
  const double size = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
  glm::dvec2 place(normal.x / size, normal.z / size);
  if (normal.y < 0)
    place = {std::copysign(1 - std::abs(place.y), place.x), std::copysign(1 - std::abs(place.x), place.y)};
  const auto index = [](double p) {
    return std::size_t(std::clamp(int((p + 1) * (normalSide / 2.0)), 0, int(normalSide) - 1));
  };
  return 1 + index(place.y) * normalSide + index(place.x);
}

double EnvironmentDensity::factor(Table table, std::size_t cell) const {
  if (table == wholeSphere) return scales_[table];
  const NormalGroup& group = normalGroups()[table - 1];
  const Cell& there = cells_[cell];
  // The sine of the sum of both radii: beyond it below the horizon, no direction of the cell is above that of a normal.
  const double cosine = there.cosineOfRadius * group.cosineOfRadius - there.sineOfRadius * group.sineOfRadius;
  const double raise =
      cosine > 0 ? there.sineOfRadius * group.cosineOfRadius + there.cosineOfRadius * group.sineOfRadius : 1;
  return std::max(0.0, glm::dot(group.axis, there.centre) + raise) * scales_[table];
}

void EnvironmentDensity::buildTables() {
  const std::size_t tables = 1 + normalGroups().size(), entries = cells_.size() + 1;
  scales_.assign(tables, 1);
  cumulative_.resize(tables * entries);
  std::vector<double> masses(cells_.size());
  for (Table table = 0; table < tables; ++table) {
    double total = 0, sum = 0;
    for (std::size_t i = 0; i < masses.size(); ++i) total += masses[i] = factor(table, i) * cells_[i].mass;
    scales_[table] = total > 0 ? 1 / total : 0;
    float* const cumulative = &cumulative_[table * entries];
    std::size_t end = 0;
    for (std::size_t i = 0; i < masses.size(); ++i) {
      if (masses[i] > 0) end = i + 1;
      sum += masses[i];
      cumulative[i + 1] = float(std::min(1.0, sum * scales_[table]));
    }
    // Empty cells at the end have no interval, whatever the rounding.
    std::fill(cumulative + end, cumulative + entries, 1.f);
    cumulative[0] = 0;
  }
}

double EnvironmentDensity::density(Table table, const glm::dvec2& position, double cosTheta) const {
  const double x = position.x * double(width_) - 0.5, fromLeft = x < 0 ? x + double(width_) : x;
  const std::size_t left = std::min(std::size_t(fromLeft), width_ - 1), right = left + 1 < width_ ? left + 1 : 0;
  const std::size_t strip = std::min(std::size_t(position.y * double(height_) + 0.5), height_);
  const double top = cosEdges_[strip], s = fromLeft - double(left);
  const double t = std::clamp((top - cosTheta) / (top - cosEdges_[strip + 1]), 0.0, 1.0);
  const auto inRow = [&](std::size_t row) {
    const Node* const nodes = &nodes_[row * width_];
    return (1 - s) * nodes[left].luminance + s * nodes[right].luminance;
  };
  const double luminance = (1 - t) * inRow(rowAbove(strip)) + t * inRow(rowBelow(strip));
  const std::size_t cell = std::size_t(cellRow_[strip]) * cellColumns() + cellColumn_[left];
  return luminance * factor(table, cell) * perAzimuth_;
}

EnvironmentDensity::Sample EnvironmentDensity::sample(Table table, const glm::dvec2& u) const {
  const float* const cumulative = &cumulative_[table * (cells_.size() + 1)];
  const std::size_t columns = cellColumns();
  const std::size_t cellRow = lastStart(cellRows(), u.x, [&](std::size_t row) { return cumulative[row * columns]; });
  const float* const inRow = cumulative + cellRow * columns;
  const double rowStart = inRow[0], rowMass = inRow[columns] - rowStart, soughtCell = rowStart + u.y * rowMass;
  const std::size_t cellColumn = lastStart(columns, soughtCell, [&](std::size_t column) { return inRow[column]; });
  const std::size_t cell = cellRow * columns + cellColumn;

  const std::size_t firstStrip = stripStart_[cellRow];
  const float* const down = &down_[cellColumn * (height_ + 1) + firstStrip];
  const double soughtStrip = (u.x - rowStart) / rowMass * cells_[cell].mass;
  const std::size_t inCell =
      lastStart(stripStart_[cellRow + 1] - firstStrip, soughtStrip, [&](std::size_t strip) { return down[strip]; });
  const std::size_t strip = firstStrip + inCell, above = rowAbove(strip), below = rowBelow(strip);
  const std::size_t first = columnStart_[cellColumn], end = columnStart_[cellColumn + 1];
  const Node *const rowA = &nodes_[above * width_], *const rowB = &nodes_[below * width_];
  const double height = cosEdges_[strip] - cosEdges_[strip + 1];
  const double aboveMass = acrossCell_[above * columns + cellColumn],
               belowMass = acrossCell_[below * columns + cellColumn];
  const double t = inverseOfRamp(aboveMass, belowMass, (soughtStrip - down[inCell]) / height);

  const double cellStart = inRow[cellColumn], part = (soughtCell - cellStart) / (inRow[cellColumn + 1] - cellStart);
  const double soughtNode = part * ((1 - t) * aboveMass + t * belowMass);
  const auto across = [&](std::size_t i) { return (1 - t) * rowA[first + i].across + t * rowB[first + i].across; };
  const auto luminance = [&](std::size_t i) { return (1 - t) * rowA[i].luminance + t * rowB[i].luminance; };
  const std::size_t node = lastStart(end - first, soughtNode, across), left = first + node;
  const double low = luminance(left), high = luminance(left + 1 < width_ ? left + 1 : 0);
  const double s = inverseOfRamp(low, high, soughtNode - across(node));
  return {(double(left) + s + 0.5) / double(width_), cosEdges_[strip] - t * height,
          ((1 - s) * low + s * high) * factor(table, cell) * perAzimuth_};
}

}  // namespace gonio::rendering
