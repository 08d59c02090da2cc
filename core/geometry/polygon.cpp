// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace gonio::geometry {

namespace {

/// Twice the polygon's area times its unit normal (Newell).
glm::dvec3 areaVector(std::span<const glm::vec3> corners) {
  const glm::dvec3 origin(corners[0]);
  glm::dvec3 sum(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[i + 1]) - origin);
  return sum;
}

/// The polygon as seen along its normal, counter-clockwise, without the axis along which it is thinnest.
std::vector<glm::dvec2> flattened(std::span<const glm::vec3> corners, const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(normal);
  const int dropped = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
  int u = (dropped + 1) % 3, v = (dropped + 2) % 3;
  if (normal[dropped] < 0) std::swap(u, v);
  std::vector<glm::dvec2> points;
  for (const glm::vec3& corner : corners) points.emplace_back(corner[u] - corners[0][u], corner[v] - corners[0][v]);
  return points;
}

/// Twice the signed area of a triangle: positive where it turns to the left. What rounding makes of 0 is 0.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const glm::dvec2 ab = b - a, bc = c - b;
  const double forward = ab.x * bc.y, backward = ab.y * bc.x, area = forward - backward;
  return std::abs(area) > 1e-14 * (std::abs(forward) + std::abs(backward)) ? area : 0;
}

class EarClipping {
 public:
  explicit EarClipping(std::vector<glm::dvec2> points) : points_(std::move(points)), left_(points_.size()) {
    for (std::size_t i = 0; i < left_; ++i) {
      next_.push_back((i + 1) % left_);
      last_.push_back((i + left_ - 1) % left_);
    }
    for (std::size_t i = 0; i < left_; ++i) turns_.push_back(turnAt(i));
    for (std::size_t i = 0; i < left_; ++i)
      if (!(turns_[i] > 0)) blunt_.push_back(i);
    budget_ = std::min<std::size_t>(10000 * left_, 1'000'000'000);
  }

  std::vector<TriangleIndices> triangles() {
    std::size_t corner = 0;
    for (std::size_t tried = 0; left_ > 3 && tried < left_ && budget_ > 0;) {
      if (isEar(corner)) {
        cut(corner);
        tried = 0;
      } else {
        ++tried;
      }
      corner = next_[corner];
    }
    // A fan of what is left: the last triangle, or a polygon that crosses itself.
    for (std::size_t second = next_[corner]; left_ > 2; --left_, second = next_[second])
      add(corner, second, next_[second]);
    return std::move(triangles_);
  }

 private:
  double turnAt(std::size_t i) const { return turn(points_[last_[i]], points_[i], points_[next_[i]]); }

  bool isEar(std::size_t i) {
    if (!(turns_[i] > 0)) return false;
    const glm::dvec2 &a = points_[last_[i]], &b = points_[i], &c = points_[next_[i]];
    for (const std::size_t other : blunt_) {
      if (budget_ > 0) --budget_;
      const glm::dvec2& p = points_[other];
      if (p == a || p == b || p == c) continue;
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
  }

  void add(std::size_t a, std::size_t b, std::size_t c) {
    triangles_.emplace_back(std::uint32_t(a), std::uint32_t(b), std::uint32_t(c));
  }

  void cut(std::size_t i) {
    const std::size_t last = last_[i], next = next_[i];
    add(last, i, next);
    next_[last] = next;
    last_[next] = last;
    --left_;
    turns_[last] = turnAt(last);
    turns_[next] = turnAt(next);
    budget_ -= std::min(budget_, blunt_.size());
    std::erase_if(blunt_, [&](std::size_t corner) { return corner == i || turns_[corner] > 0; });
  }

  std::vector<glm::dvec2> points_;
  std::vector<std::size_t> next_, last_;
  std::vector<double> turns_;
  std::vector<std::size_t> blunt_;  ///< corners that may lie in an ear: those that do not turn to the left
  std::size_t left_, budget_ = 0;
  std::vector<TriangleIndices> triangles_;
};

}  // namespace

std::vector<TriangleIndices> triangulatePolygon(std::span<const glm::vec3> corners) {
  if (corners.size() == 3) return {{0, 1, 2}};
  std::vector<glm::dvec2> p = flattened(corners, areaVector(corners));
  if (corners.size() == 4 && turn(p[3], p[0], p[1]) > 0 && turn(p[0], p[1], p[2]) > 0 && turn(p[1], p[2], p[3]) > 0 &&
      turn(p[2], p[3], p[0]) > 0) {
    const auto length = [&](int a, int b) { return glm::length(glm::dvec3(corners[b]) - glm::dvec3(corners[a])); };
    if (length(1, 3) < length(0, 2)) return {{0, 1, 3}, {1, 2, 3}};
    return {{0, 1, 2}, {0, 2, 3}};
  }
  return EarClipping(std::move(p)).triangles();
}

}  // namespace gonio::geometry
