// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/picture_refinement.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/support/error.h"

namespace gonio {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int largestPass = 16;
constexpr int trialPixels = 9216, trialSamples = 4;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// As many samples as the pictures so far have, while they fit into the time that is left; at least one.
int nextPass(const Film& film, const RefinementLimits& limits, double spent) {
  int pass = std::min({std::max(1, film.samples), largestPass, limits.samples - film.samples});
  if (film.samples > 0) {
    const double fitting = (limits.seconds - spent) / (spent / film.samples);
    if (fitting < pass) pass = std::max(1, int(fitting));
  }
  return pass;
}

}  // namespace

void refinePicture(const PathTracer& tracer, Film& film, const RefinementLimits& limits, const TaskControl& control,
                   const Pause* pause) {
  double spent = 0, share = 0;
  do {
    if (pause) pause->wait(control.stop);
    control.throwIfStopped();
    const int pass = nextPass(film, limits, spent);
    const double bySamples = double(film.samples + pass) / limits.samples;
    const double byTime = film.samples ? spent * (film.samples + pass) / film.samples / limits.seconds : 0;
    const double next = std::clamp(std::max(bySamples, byTime), share, 1.0);
    const Clock::time_point start = Clock::now();
    tracer.accumulate(film, pass, control.between(share, next));
    spent += secondsSince(start);
    share = next;
  } while (film.samples < limits.samples && spent * (film.samples + 1) / film.samples <= limits.seconds);
}

double PictureEstimate::noise(int samples) const { return noiseOfSample / std::sqrt(double(samples)); }

PictureEstimate estimatePicture(const Scene& scene, const std::vector<std::shared_ptr<const RenderMaterial>>& materials,
                                const EffectPlan& plan, int width, int height, const TaskControl& control) {
  const double scale = std::min(1.0, std::sqrt(trialPixels / (double(width) * height)));
  const int trialWidth = std::max(1, int(std::lround(width * scale))),
            trialHeight = std::max(1, int(std::lround(height * scale)));
  const Clock::time_point start = Clock::now();
  Image pictures[2];
  for (std::uint64_t i = 0; i < 2; ++i) {
    Film film(trialWidth, trialHeight);
    PathTracer(scene, materials, plan, i + 1).accumulate(film, trialSamples, control.between(0.5 * double(i), 1));
    pictures[i] = film.image();
  }
  const double pixelRatio = double(width) * height / (double(trialWidth) * trialHeight);
  PictureEstimate estimate{.secondsOfSample = secondsSince(start) / (2 * trialSamples) * pixelRatio};
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < pictures[0].pixels.size(); ++i) {
    const double a = luminance(Rgb(pictures[0].pixels[i])), b = luminance(Rgb(pictures[1].pixels[i]));
    sum += (a + b) / 2;
    squares += (a - b) * (a - b) / 2;
  }
  const double count = double(pictures[0].pixels.size());
  if (sum > 0) estimate.noiseOfSample = std::sqrt(squares / count * trialSamples) / (sum / count);
  return estimate;
}

}  // namespace gonio
