// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/measured_values.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/support/error.h"
#include "core/support/number_text.h"

namespace gonio::acquisition {

namespace {

/// The direction turned by |offset| (rad) along the tangent that `offset` names.
Direction turned(const Direction& w, const glm::dvec2& offset) {
  const double angle = glm::length(offset);
  if (angle == 0) return w;
  const Direction aside = std::abs(w.x) < 0.5 ? Direction(1, 0, 0) : Direction(0, 1, 0);
  const Direction u = glm::normalize(glm::cross(w, aside)), v = glm::cross(w, u);
  Direction result = std::cos(angle) * w + std::sin(angle) / angle * (offset.x * u + offset.y * v);
  result.z = std::max(0.0, result.z);
  return glm::normalize(result);
}

void checkError(double error, const char* what) {
  if (!(error >= 0) || !std::isfinite(error))
    throw Error(std::string(what) + ": found " + numberText(error) + ", expected a finite number, 0 or more");
}

}  // namespace

MeasuredValues measure(const Brdf& material, const SamplingPlan& plan, const MeasurementNoise& noise) {
  checkError(noise.relative, "the relative noise");
  checkError(noise.absolute, "the absolute noise");
  checkError(noise.misalignment, "the misalignment");
  std::mt19937_64 random(noise.seed);
  std::normal_distribution<double> gaussian;
  const auto pair = [&] {
    const double x = gaussian(random), y = gaussian(random);
    return glm::dvec2(x, y);
  };
  const bool isNoisy = noise.relative > 0 || noise.absolute > 0;
  MeasuredValues measured;
  for (const PlannedSample& sample : plan.samples) {
    const glm::dvec2 ofLight = pair(), ofViewer = pair();
    const Rgb value = glm::max(Rgb(0), material.evaluate(turned(sample.directions.wi, noise.misalignment * ofLight),
                                                         turned(sample.directions.wo, noise.misalignment * ofViewer)));
    Rgb reading, deviation;
    for (int channel = 0; channel < 3; ++channel) {
      deviation[channel] = std::hypot(noise.relative * value[channel], noise.absolute);
      reading[channel] = std::max(0.0, value[channel] + deviation[channel] * gaussian(random));
    }
    measured.rgb.push_back(reading);
    if (isNoisy) measured.noise.push_back(deviation);
  }
  return measured;
}

}  // namespace gonio::acquisition
