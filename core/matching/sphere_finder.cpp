// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/matching/sphere_finder.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <span>

#include "core/math/colour.h"
#include "core/support/error.h"

namespace gonio::matching {

namespace {

/// Longest side of the picture in which circles are searched.
constexpr int searchSide = 160;
/// Radii that are searched, relative to the shorter and the longer side.
constexpr double minRelativeRadius = 0.1, maxRelativeRadius = 0.7;
/// Fraction of the outline that must be an edge.
constexpr double minSupport = 0.5;

/// What changes at the outline: alpha alone, or the colour as it is seen.
Image edgeField(const Image& picture) {
  Image field(picture.width, picture.height);
  const auto isTransparent = [](float alpha) { return alpha < 0.5f; };
  const auto transparent = std::ranges::count_if(picture.alpha, isTransparent);
  const bool usesAlpha = transparent > 0 && std::size_t(transparent) < picture.alpha.size();
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double value = usesAlpha ? double(picture.alpha[i]) : toSrgb(std::clamp(picture.pixels[i][c], 0.f, 1.f));
      field.pixels[i][c] = std::isfinite(value) ? float(value) : 0;
    }
  return field;
}

/// The picture reduced by a whole factor.
Image reduced(const Image& picture, int factor) {
  Image small((picture.width + factor - 1) / factor, (picture.height + factor - 1) / factor);
  std::vector<float> counts(small.pixels.size(), 0);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const std::size_t i = small.index(x / factor, y / factor);
      small.pixels[i] += picture.at(x, y);
      ++counts[i];
    }
  for (std::size_t i = 0; i < counts.size(); ++i) small.pixels[i] /= counts[i];
  return small;
}

/// Gradients along x and y, of the channel that changes most.
class Gradients {
 public:
  explicit Gradients(const Image& field) : width_(field.width), height_(field.height) {
    gradients_.resize(field.pixels.size(), glm::vec2(0));
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) gradients_[field.index(x, y)] = gradientAt(field, x, y);
    std::vector<float> lengths;
    lengths.reserve(gradients_.size());
    for (const glm::vec2& gradient : gradients_) lengths.push_back(glm::length(gradient));
    const auto high = lengths.begin() + std::ptrdiff_t(lengths.size() - 1 - lengths.size() / 50);
    std::ranges::nth_element(lengths, high);
    scale_ = std::max(0.02f, *high);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  const glm::vec2& at(int x, int y) const { return gradients_[std::size_t(y) * std::size_t(width_) + std::size_t(x)]; }
  /// Strength of an edge along a direction, in [0, 1]: saturates at a part of the strong edges, so that a faint part of
  /// an outline counts too.
  double strength(int x, int y, const glm::dvec2& direction) const {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return 0;
    return std::min(1.0, 5 * std::abs(glm::dot(glm::dvec2(at(x, y)), direction)) / double(scale_));
  }

 private:
  static glm::vec2 gradientAt(const Image& field, int x, int y) {
    const auto value = [&](int dx, int dy) -> const glm::vec3& {
      return field.at(std::clamp(x + dx, 0, field.width - 1), std::clamp(y + dy, 0, field.height - 1));
    };
    // Sobel's operator: smooths across the edge.
    const glm::vec3 across =
        value(1, -1) + 2.f * value(1, 0) + value(1, 1) - value(-1, -1) - 2.f * value(-1, 0) - value(-1, 1);
    const glm::vec3 down =
        value(-1, 1) + 2.f * value(0, 1) + value(1, 1) - value(-1, -1) - 2.f * value(0, -1) - value(1, -1);
    glm::vec2 strongest(0);
    for (int c = 0; c < 3; ++c)
      if (const glm::vec2 one(across[c] / 8, down[c] / 8); glm::length(one) > glm::length(strongest)) strongest = one;
    return strongest;
  }

  int width_, height_;
  std::vector<glm::vec2> gradients_;
  float scale_ = 0;
};

struct Candidate {
  Disc disc;
  double support = 0;  ///< mean strength of the edges along the circle
};

/// The best radius of a circle about a centre.
Candidate bestCircle(const Gradients& gradients, const glm::dvec2& centre, double minRadius, double maxRadius) {
  Candidate best;
  for (double radius = minRadius; radius <= maxRadius; radius += 0.5) {
    const int angles = std::max(32, int(2 * pi * radius));
    double support = 0;
    for (int k = 0; k < angles; ++k) {
      const double angle = 2 * pi * k / angles;
      const glm::dvec2 direction(std::cos(angle), std::sin(angle)), place = centre + radius * direction;
      support += gradients.strength(int(std::floor(place.x)), int(std::floor(place.y)), direction);
    }
    support /= angles;
    // Of two circles with equal edges the larger is the outline: the smaller one is a reflection in it.
    if (support * std::sqrt(radius) > best.support * std::sqrt(best.disc.radius))
      best = {{centre.x, centre.y, radius}, support};
  }
  return best;
}

/// Votes of the edges for centres, on both sides of each edge along its gradient.
std::vector<float> centreVotes(const Gradients& gradients, double minRadius, double maxRadius) {
  const int width = gradients.width(), height = gradients.height();
  std::vector<float> votes(std::size_t(width) * std::size_t(height), 0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const glm::dvec2 gradient(gradients.at(x, y));
      const double length = glm::length(gradient);
      if (!(length > 0)) continue;
      const glm::dvec2 direction = gradient / length;
      const double strength = gradients.strength(x, y, direction);
      if (strength < 0.1) continue;
      for (const double side : {-1.0, 1.0})
        for (double radius = minRadius; radius <= maxRadius; ++radius) {
          const glm::dvec2 centre = glm::dvec2(x + 0.5, y + 0.5) + side * radius * direction;
          const int column = int(std::floor(centre.x)), row = int(std::floor(centre.y));
          if (column < 0 || row < 0 || column >= width || row >= height) break;
          // Each radius has as many edges as its circle is long.
          votes[std::size_t(row) * std::size_t(width) + std::size_t(column)] += float(strength / radius);
        }
    }
  return votes;
}

Candidate strongestCircle(const Image& field) {
  const Gradients gradients(field);
  const double minRadius = std::max(4.0, minRelativeRadius * std::min(field.width, field.height));
  const double maxRadius = maxRelativeRadius * std::max(field.width, field.height);
  std::vector<float> votes = centreVotes(gradients, minRadius, maxRadius);
  Candidate best;
  constexpr int candidates = 12, excluded = 4;
  for (int k = 0; k < candidates; ++k) {
    const auto highest = std::ranges::max_element(votes);
    if (highest == votes.end() || !(*highest > 0)) break;
    const int place = int(highest - votes.begin()), x = place % field.width, y = place / field.width;
    for (const double dx : {0.0, 0.5, 1.0})
      for (const double dy : {0.0, 0.5, 1.0})
        if (const Candidate one = bestCircle(gradients, {x + dx, y + dy}, minRadius, maxRadius);
            one.support * std::sqrt(one.disc.radius) > best.support * std::sqrt(best.disc.radius))
          best = one;
    for (int row = std::max(0, y - excluded); row <= std::min(field.height - 1, y + excluded); ++row)
      for (int column = std::max(0, x - excluded); column <= std::min(field.width - 1, x + excluded); ++column)
        votes[std::size_t(row) * std::size_t(field.width) + std::size_t(column)] = 0;
  }
  return best;
}

glm::dvec3 bilinear(const Image& field, const glm::dvec2& place) {
  const glm::dvec2 p = glm::clamp(place - 0.5, glm::dvec2(0), glm::dvec2(field.width - 1, field.height - 1));
  const int x = std::min(int(p.x), std::max(0, field.width - 2)), y = std::min(int(p.y), std::max(0, field.height - 2));
  const int right = std::min(x + 1, field.width - 1), below = std::min(y + 1, field.height - 1);
  const glm::dvec2 f = p - glm::dvec2(x, y);
  return glm::mix(glm::mix(glm::dvec3(field.at(x, y)), glm::dvec3(field.at(right, y)), f.x),
                  glm::mix(glm::dvec3(field.at(x, below)), glm::dvec3(field.at(right, below)), f.x), f.y);
}

/// A point of the outline on a ray from the centre.
struct OutlinePoint {
  glm::dvec2 place;
  double weight;
};

/// The strongest edge on each ray from the centre, with radii that differ from the disc's by at most `reach`.
std::vector<OutlinePoint> outline(const Image& field, const Disc& disc, double reach) {
  constexpr int rays = 360;
  constexpr double step = 0.25;
  std::vector<OutlinePoint> points;
  const int steps = std::max(8, int(std::ceil(2 * reach / step)));
  std::vector<double> changes(static_cast<std::size_t>(steps));
  for (int ray = 0; ray < rays; ++ray) {
    const glm::dvec2 direction(std::cos(2 * pi * ray / rays), std::sin(2 * pi * ray / rays));
    const auto radiusOf = [&](double k) { return disc.radius - reach + 2 * reach * (k + 0.5) / steps; };
    const auto placeOf = [&](double radius) { return glm::dvec2(disc.x, disc.y) + radius * direction; };
    if (const glm::dvec2 end = placeOf(disc.radius);
        end.x < 0 || end.y < 0 || end.x > field.width || end.y > field.height)
      continue;
    for (int k = 0; k < steps; ++k) {
      const glm::dvec3 change =
          bilinear(field, placeOf(radiusOf(k) + 0.75)) - bilinear(field, placeOf(radiusOf(k) - 0.75));
      changes[std::size_t(k)] = glm::dot(change, change);
    }
    const auto strongest = std::ranges::max_element(changes);
    if (!(*strongest > 1e-6)) continue;
    // The middle of the edge, between the steps.
    const int middle = int(strongest - changes.begin()), around = int(std::ceil(1.5 * steps / (2 * reach)));
    double sum = 0, moment = 0;
    for (int k = std::max(0, middle - around); k <= std::min(steps - 1, middle + around); ++k) {
      sum += changes[std::size_t(k)];
      moment += changes[std::size_t(k)] * radiusOf(k);
    }
    points.push_back({placeOf(moment / sum), std::min(1.0, std::sqrt(*strongest) / 0.1)});
  }
  return points;
}

/// The circle through most of the points: Gauss-Newton steps on the distances with Tukey's weights.
Disc fitCircle(std::span<const OutlinePoint> points, Disc disc, double reach) {
  constexpr int steps = 30;
  double tolerance = reach;
  for (int step = 0; step < steps; ++step) {
    Eigen::Matrix3d normal = 1e-9 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d rightSide = Eigen::Vector3d::Zero();
    std::vector<double> distances;
    for (const OutlinePoint& point : points) {
      const glm::dvec2 offset = point.place - glm::dvec2(disc.x, disc.y);
      const double length = glm::length(offset), residual = length - disc.radius;
      distances.push_back(std::abs(residual));
      if (!(length > 0) || std::abs(residual) >= tolerance) continue;
      const double inside = 1 - residual * residual / (tolerance * tolerance);
      const Eigen::Vector3d slope(offset.x / length, offset.y / length, 1);
      normal += point.weight * inside * inside * slope * slope.transpose();
      rightSide += point.weight * inside * inside * residual * slope;
    }
    const Eigen::Vector3d change = normal.ldlt().solve(rightSide);
    disc = {disc.x + change[0], disc.y + change[1], disc.radius + change[2]};
    if (!distances.empty()) {
      std::ranges::nth_element(distances, distances.begin() + std::ptrdiff_t(distances.size() / 2));
      tolerance = std::clamp(6 * distances[distances.size() / 2], 0.75, tolerance);
    }
  }
  return disc;
}

}  // namespace

Disc findSphere(const Image& picture) {
  const auto missing = [] {
    return Error("no sphere was found in the picture: expected one sphere with a visible outline, at least " +
                 std::to_string(int(2 * minDiscRadius)) + " pixels wide");
  };
  if (std::min(picture.width, picture.height) < 2 * minDiscRadius) throw missing();
  const Image field = edgeField(picture);
  const int factor = std::max(1, (std::max(field.width, field.height) + searchSide - 1) / searchSide);
  const Candidate found = strongestCircle(reduced(field, factor));
  if (found.support < minSupport) throw missing();
  Disc disc{found.disc.x * factor, found.disc.y * factor, found.disc.radius * factor};
  for (const double reach : {0.08 * disc.radius, 0.03 * disc.radius, 2.0})
    disc = fitCircle(outline(field, disc, std::max(2.0, reach)), disc, std::max(2.0, reach));
  if (!(disc.radius >= minDiscRadius)) throw missing();
  return disc;
}

}  // namespace gonio::matching
