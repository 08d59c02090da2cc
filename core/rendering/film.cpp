// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/film.h"

#include <algorithm>
#include <cmath>

namespace gonio {

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

}  // namespace gonio
