// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/picture_refinement.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/support/error.h"

namespace gonio::rendering {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int maxPass = 16;
constexpr int trialPixels = 4096, fewSamples = 4, trialSamples = 16;
constexpr double maxOrder = 0.75;  ///< that of jittered samples across an edge (Mitchell 1996)

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// As many samples as the pictures so far have, while they fit into the time that is left; at least one.
int nextPass(const Film& film, const RefinementLimits& limits, double spent) {
  int pass = std::min({std::max(1, film.samples), maxPass, limits.samples - film.samples});
  if (film.samples > 0) {
    const double fitting = (limits.seconds - spent) / (spent / film.samples);
    if (fitting < pass) pass = std::max(1, int(fitting));
  }
  return pass;
}

/// RMS difference of two pictures of the same expectation, over root 2 and their mean.
double relativeNoise(const Image& a, const Image& b) {
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const double one = luminance(Rgb(a.pixels[i])), other = luminance(Rgb(b.pixels[i]));
    sum += (one + other) / 2;
    squares += (one - other) * (one - other) / 2;
  }
  const double count = double(a.pixels.size());
  return sum > 0 ? std::sqrt(squares / count) / (sum / count) : 0;
}

}  // namespace

void refinePicture(const PathTracer& tracer, Film& film, const RefinementLimits& limits, const TaskControl& control,
                   const Pause* pause) {
  double spent = 0, fraction = 0;
  do {
    if (pause) pause->wait(control.stop);
    control.throwIfStopped();
    const int pass = nextPass(film, limits, spent);
    const double bySamples = double(film.samples + pass) / limits.samples;
    const double byTime = film.samples ? spent * (film.samples + pass) / film.samples / limits.seconds : 0;
    const double next = std::clamp(std::max(bySamples, byTime), fraction, 1.0);
    const Clock::time_point start = Clock::now();
    tracer.accumulate(film, pass, control.between(fraction, next));
    spent += secondsSince(start);
    fraction = next;
  } while (film.samples < limits.samples && spent * (film.samples + 1) / film.samples <= limits.seconds);
}

double PictureEstimate::noise(int samples) const { return noisePerSample * std::pow(double(samples), -order); }

PictureEstimate estimatePicture(const Scene& scene, const std::vector<std::shared_ptr<const RenderMaterial>>& materials,
                                const EffectPlan& plan, int width, int height, const TaskControl& control) {
  const double scale = std::min(1.0, std::sqrt(trialPixels / (double(width) * height)));
  const int trialWidth = std::max(1, int(std::lround(width * scale))),
            trialHeight = std::max(1, int(std::lround(height * scale)));
  Image few[2], many[2];
  const Clock::time_point start = Clock::now();
  for (std::uint64_t i = 0; i < 2; ++i) {
    const PathTracer tracer(scene, materials, plan, i + 1);
    Film film(trialWidth, trialHeight);
    tracer.accumulate(film, fewSamples, control);
    few[i] = film.image();
    tracer.accumulate(film, trialSamples - fewSamples, control);
    many[i] = film.image();
  }
  const double pixelRatio = double(width) * height / (double(trialWidth) * trialHeight);
  PictureEstimate estimate{.secondsPerSample = secondsSince(start) / (2 * trialSamples) * pixelRatio};
  const double noise = relativeNoise(many[0], many[1]);
  if (!(noise > 0)) return estimate;
  const double fall = std::log(relativeNoise(few[0], few[1]) / noise) / std::log(double(trialSamples) / fewSamples);
  estimate.order = std::clamp(fall, 0.5, maxOrder);
  estimate.noisePerSample = noise * std::pow(trialSamples, estimate.order);
  return estimate;
}

}  // namespace gonio::rendering
