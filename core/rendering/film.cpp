// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/film.h"

#include <algorithm>
#include <cmath>

#include "core/math/parallel.h"

namespace gonio::rendering {

SampleLuminances& SampleLuminances::operator+=(const SampleLuminances& other) {
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
  largest_ = std::max(largest_, other.largest_);
  return *this;
}

double SampleLuminances::sumFrom(double threshold) const {
  double sum = 0;
  for (int i = 0; i < binsPerOctave * octaves; ++i) {
    const double middle = 1 + (i % binsPerOctave + 0.5) / binsPerOctave;
    const double luminance = std::ldexp(middle, i / binsPerOctave + lowestOctave - 1);
    if (luminance >= threshold) sum += double(counts_[std::size_t(i)]) * luminance;
  }
  return sum;
}

Fireflies Film::fireflies() const {
  Rgb total(0);
  double covered = 0;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    total += radiance[i];
    covered += coverage[i];
  }
  const double sum = luminance(total);
  if (!(sum > 0)) return {};
  const double mean = sum / covered;
  return {luminances.largest() / mean, std::min(1.0, luminances.sumFrom(Fireflies::threshold * mean) / sum)};
}

namespace {

/// Values at a time: they stay in the caches.
constexpr std::size_t block = 1024;

/// Sums of a row. @param first index of its first pixel.
std::vector<Rgb> radianceOf(const RecordedPaths::Row& row, const Brdf& brdf, std::size_t first, int width) {
  std::vector<Rgb> radiance(std::size_t(width), Rgb(0)), values(std::min(block, row.pairs.size()));
  for (std::size_t begin = 0; begin < row.pairs.size(); begin += block) {
    const std::size_t count = std::min(block, row.pairs.size() - begin);
    brdf.evaluate(std::span(row.pairs).subspan(begin, count), std::span(values).first(count));
    for (std::size_t i = 0; i < count; ++i)
      radiance[row.pixels[begin + i] - first] += values[i] * row.weights[begin + i];
  }
  return radiance;
}

}  // namespace

RecordedPaths::RecordedPaths(std::vector<Row> rows, Image others, int samples)
    : rows_(std::move(rows)), others_(std::move(others)), samples_(samples) {
  // They are kept for long.
  for (Row& row : rows_) {
    row.pairs.shrink_to_fit();
    row.weights.shrink_to_fit();
    row.pixels.shrink_to_fit();
  }
}

Image RecordedPaths::picture(const Brdf& brdf, const TaskControl& control) const {
  Image image = others_;
  parallelForBlocks(
      rows_.size(), 1,
      [&](std::size_t y, std::size_t) {
        const std::size_t first = image.index(0, int(y));
        const std::vector<Rgb> radiance = radianceOf(rows_[y], brdf, first, image.width);
        for (std::size_t x = 0; x < radiance.size(); ++x)
          image.pixels[first + x] += glm::vec3(radiance[x] / double(samples_));
      },
      control);
  return image;
}

}  // namespace gonio::rendering
