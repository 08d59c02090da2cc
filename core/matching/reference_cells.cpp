// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/matching/reference_cells.h"

#include <algorithm>
#include <cmath>

#include "core/support/error.h"

namespace gonio::matching {

namespace {

/// Cells within this part of the radius are used: beyond it an error of a pixel in the outline changes much.
constexpr double usedRadius = 0.97;

class Cell {
 public:
  /// @param left, top the first pixel. @param side in pixels.
  Cell(const ReferencePicture& picture, int left, int top, int side) {
    if (left < 0 || top < 0 || left + side > picture.image.width || top + side > picture.image.height) return;
    for (int y = top; y < top + side; ++y)
      for (int x = left; x < left + side; ++x) add(picture.image.at(x, y), picture.clip);
  }
  Rgb value() const { return pixels_ > 0 ? sum_ / pixels_ : Rgb(0); }
  ReferenceCells::Known known(int channel) const {
    using enum ReferenceCells::Known;
    if (!(pixels_ > 0) || !isFinite_) return no;
    return clipped_[channel] == 0 ? yes : clipped_[channel] == pixels_ ? atLeast : no;
  }

 private:
  void add(const glm::vec3& pixel, double clip) {
    ++pixels_;
    for (int c = 0; c < 3; ++c) {
      isFinite_ = isFinite_ && std::isfinite(pixel[c]);
      if (double(pixel[c]) >= clip) ++clipped_[c];
    }
    sum_ += Rgb(glm::max(pixel, glm::vec3(0)));
  }

  Rgb sum_{0}, clipped_{0};
  double pixels_ = 0;
  bool isFinite_ = true;
};

}  // namespace

ReferenceCells referenceCells(const ReferencePicture& picture, int maxSide, int stride) {
  using enum ReferenceCells::Known;
  const Disc& disc = picture.disc;
  const int pixels = std::max(1, int(std::ceil(2 * disc.radius / maxSide)));
  const int left = int(std::floor(disc.x - disc.radius)), top = int(std::floor(disc.y - disc.radius));
  ReferenceCells cells;
  cells.side = int(std::ceil((2 * disc.radius + 1) / pixels));
  cells.halfSize = 0.5 * cells.side * pixels / disc.radius;
  cells.centre = {(left - disc.x) / disc.radius + cells.halfSize, -((top - disc.y) / disc.radius + cells.halfSize)};
  double sum = 0;
  std::size_t count = 0;
  for (int row = 0; row < cells.side; ++row)
    for (int column = 0; column < cells.side; ++column) {
      auto& known = cells.known.emplace_back(std::array{no, no, no});
      auto& value = cells.values.emplace_back(0);
      if ((column + row) % stride != 0) continue;
      const double x = left + (column + 0.5) * pixels - disc.x, y = top + (row + 0.5) * pixels - disc.y;
      if (std::hypot(std::abs(x) + 0.5 * pixels, std::abs(y) + 0.5 * pixels) > usedRadius * disc.radius) continue;
      const Cell cell(picture, left + column * pixels, top + row * pixels, pixels);
      value = cell.value();
      for (int c = 0; c < 3; ++c) {
        known[std::size_t(c)] = cell.known(c);
        if (known[std::size_t(c)] == no) continue;
        sum += value[c];
        ++count;
      }
    }
  if (count == 0) throw Error("the reference image shows nothing of the sphere inside the circle");
  if (!(sum > 0)) throw Error("the sphere in the reference image is black");
  cells.mean = sum / double(count);
  return cells;
}

}  // namespace gonio::matching
