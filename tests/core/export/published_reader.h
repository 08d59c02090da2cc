// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>

#include "core/io/tensor_file.h"
#include "core/math/types.h"

/// An RGL file by the published formula alone (Dupuy and Jakob 2018, eq. 10; powitacq), plain and slow, without any
/// of our own code for it: one incident azimuth, `rgb`, f = rgb(s) ndf(u_m) / (4 sigma(u_i) cos theta_o).
namespace gonio::test {

class PublishedReader {
 public:
  explicit PublishedReader(std::span<const std::byte> bytes) : file_(io::MemorySource(bytes)) {
    thetas_ = file_.floats("theta_i", 1);
    ndf_ = grid("ndf", 2);
    sigma_ = grid("sigma", 2);
    vndf_ = grid("vndf", 4);
    rgb_ = grid("rgb", 5);
  }

  /// @param incident the direction of theta_i
  Rgb value(const Direction& incident, const Direction& outgoing) const {
    const Direction m = glm::normalize(incident + outgoing);
    const double turn = azimuth(m) - azimuth(incident);
    const double x = std::sqrt(polarAngle(m) * 2 / pi), y = turn / (2 * pi) + 0.5;
    const double u = y - std::floor(y);
    const auto [low, fraction] = bracket(polarAngle(incident));
    const auto s = warped(low, fraction, x, u);
    const double sigma = at(sigma_, 0, std::sqrt(polarAngle(incident) * 2 / pi), (azimuth(incident) + pi) / (2 * pi));
    Rgb value(0);
    for (int channel = 0; channel < 3; ++channel) {
      const double below = at(rgb_, 3 * low + std::size_t(channel), s.x, s.y);
      const double above = fraction > 0 ? at(rgb_, 3 * (low + 1) + std::size_t(channel), s.x, s.y) : 0;
      value[channel] = std::max(0.0, (1 - fraction) * below + fraction * above);  // powitacq clips colours
    }
    return value * at(ndf_, 0, x, u) / (4 * sigma * outgoing.z);
  }

 private:
  struct Grid {
    std::size_t width = 0, height = 0;
    std::vector<float> values;
  };
  struct Bracket {
    std::size_t low;
    double fraction;
  };

  Grid grid(const char* name, std::size_t dimensions) const {
    const io::TensorView& tensor = file_.field(name, io::TensorType::float32, dimensions);
    return {tensor.shape[dimensions - 1], tensor.shape[dimensions - 2], tensor.floats()};
  }

  Bracket bracket(double theta) const {
    std::size_t low = 0;
    while (low + 1 < thetas_.size() && thetas_[low + 1] <= theta) ++low;
    if (low + 1 == thetas_.size()) return {low, 0};
    return {low, (theta - thetas_[low]) / (double(thetas_[low + 1]) - thetas_[low])};
  }

  static double at(const Grid& grid, std::size_t slice, double x, double y) {
    const double column = std::clamp(x, 0.0, 1.0) * double(grid.width - 1);
    const double row = std::clamp(y, 0.0, 1.0) * double(grid.height - 1);
    const std::size_t c = std::min(std::size_t(column), grid.width - 2),
                      r = std::min(std::size_t(row), grid.height - 2);
    const auto node = [&](std::size_t i, std::size_t j) {
      return double(grid.values[(slice * grid.height + i) * grid.width + j]);
    };
    return std::lerp(std::lerp(node(r, c), node(r, c + 1), column - double(c)),
                     std::lerp(node(r + 1, c), node(r + 1, c + 1), column - double(c)), row - double(r));
  }

  /// Integral of what runs straight between nodes, from 0 to `x` nodes.
  template <typename Value>
  static double integral(double x, std::size_t count, const Value& value) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < count && double(i) < x; ++i) {
      const double part = std::min(1.0, x - double(i));
      sum += part * (value(i) + 0.5 * part * (value(i + 1) - value(i)));
    }
    return sum;
  }

  /// The marginal of the rows and the conditional inside a row of the vndf between two slices, each of integral 1.
  glm::dvec2 warped(std::size_t low, double fraction, double x, double y) const {
    const std::size_t width = vndf_.width, height = vndf_.height;
    const auto node = [&](std::size_t slice, std::size_t row, std::size_t column) {
      return double(vndf_.values[(slice * height + row) * width + column]);
    };
    const auto rowTotal = [&](std::size_t slice, std::size_t row, double to) {
      return integral(to, width, [&](std::size_t column) { return node(slice, row, column); });
    };
    const double lastColumn = double(width - 1), lastRow = double(height - 1);
    double along = 0, across = 0, total = 0;
    for (const bool upper : {false, true}) {
      const double weight = upper ? fraction : 1 - fraction;
      if (weight == 0) continue;
      const std::size_t slice = low + std::size_t(upper);
      const auto marginal = [&](std::size_t row) { return rowTotal(slice, row, lastColumn); };
      const double all = integral(lastRow, height, marginal), at = y * lastRow;
      along += weight * integral(at, height, marginal) / all;
      const auto row = std::min(std::size_t(at), height - 2);
      for (const bool next : {false, true}) {
        const double part = weight / all * (next ? at - double(row) : 1 - (at - double(row)));
        across += part * rowTotal(slice, row + std::size_t(next), x * lastColumn);
        total += part * rowTotal(slice, row + std::size_t(next), lastColumn);
      }
    }
    return {across / total, along};
  }

  io::TensorFile file_;
  std::vector<float> thetas_;
  Grid ndf_, sigma_, vndf_, rgb_;
};

}  // namespace gonio::test
