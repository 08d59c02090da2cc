// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/rendered_comparison.h"

namespace gonio {

namespace {

constexpr std::uint64_t otherSeed = 0x9e3779b97f4a7c15;  // any other number
/// Samples whose paths are recorded.
constexpr std::size_t maxRecorded = 1 << 20;

Image mean(const metrics::PicturePair& halves) {
  Image image = halves[0];
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = 0.5f * (image.pixels[i] + halves[1].pixels[i]);
    image.alpha[i] = 0.5f * (image.alpha[i] + halves[1].alpha[i]);
  }
  return image;
}

ComparisonPicture pictureOf(metrics::PicturePair halves) {
  Image both = mean(halves);
  return {std::move(both), std::move(halves)};
}

}  // namespace

RenderedComparison::RenderedComparison(const Brdf& reference, RenderOptions options, const TaskControl& control)
    : RenderedComparison(comparisonScene(), reference, std::move(options), control) {}

RenderedComparison::RenderedComparison(Scene scene, const Brdf& reference, RenderOptions options,
                                       const TaskControl& control)
    : scene_(std::move(scene)) {
  if (!options.lobe) options.lobe = estimateSamplingDensity(reference);
  options.samples = (options.samples + 1) / 2;
  options_ = {options, options};
  options_[1].seed ^= otherSeed;
  if (std::size_t(options.width) * std::size_t(options.height) * std::size_t(2 * options.samples) <= maxRecorded)
    for (std::size_t half = 0; half < 2; ++half)
      paths_[half] = recordPaths(scene_, options_[half], control.between(0.3 * double(half), 0.3 * double(half + 1)));
  reference_ = render(reference, control.between(0.6, 1));
}

ComparisonPicture RenderedComparison::render(const Brdf& test, const TaskControl& control) const {
  if (!paths_[0] || !paths_[1]) return trace(test, control);
  return pictureOf(
      {paths_[0]->picture(test, control.between(0, 0.5)), paths_[1]->picture(test, control.between(0.5, 1))});
}

ComparisonPicture RenderedComparison::trace(const Brdf& test, const TaskControl& control) const {
  const auto material = pictureMaterial(test, options_[0]);
  return pictureOf({renderPicture(material, scene_, options_[0], control.between(0, 0.5)),
                    renderPicture(material, scene_, options_[1], control.between(0.5, 1))});
}

double RenderedComparison::signalToNoiseRatio(const ComparisonPicture& picture) const {
  return metrics::signalToNoiseRatio(reference_.halves, picture.halves);
}

double RenderedComparison::peakSignalToNoiseRatio(const ComparisonPicture& picture) const {
  return metrics::peakSignalToNoiseRatio(reference_.halves, picture.halves);
}

}  // namespace gonio
