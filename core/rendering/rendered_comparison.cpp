// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/rendered_comparison.h"

namespace gonio {

namespace {

Image mean(const metrics::PicturePair& halves) {
  Image image = halves[0];
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = 0.5f * (image.pixels[i] + halves[1].pixels[i]);
    image.alpha[i] = 0.5f * (image.alpha[i] + halves[1].alpha[i]);
  }
  return image;
}

}  // namespace

RenderedComparison::RenderedComparison(const Brdf& reference, RenderOptions options, const TaskControl& control)
    : RenderedComparison(comparisonScene(), reference, std::move(options), control) {}

RenderedComparison::RenderedComparison(Scene scene, const Brdf& reference, RenderOptions options,
                                       const TaskControl& control)
    : scene_(std::move(scene)), options_(std::move(options)) {
  if (!options_.lobe) options_.lobe = estimateSamplingLobe(reference);
  options_.samples = (options_.samples + 1) / 2;
  reference_ = render(reference, control);
}

ComparisonPicture RenderedComparison::render(const Brdf& test, const TaskControl& control) const {
  constexpr std::uint64_t otherSeed = 0x9e3779b97f4a7c15;  // any other number
  RenderOptions other = options_;
  other.seed ^= otherSeed;
  ComparisonPicture picture;
  const auto material = pictureMaterial(test, options_);
  picture.halves = {renderPicture(material, scene_, options_, control.between(0, 0.5)),
                    renderPicture(material, scene_, other, control.between(0.5, 1))};
  picture.image = mean(picture.halves);
  return picture;
}

double RenderedComparison::signalToNoiseRatio(const ComparisonPicture& picture) const {
  return metrics::signalToNoiseRatio(reference_.halves, picture.halves);
}

double RenderedComparison::peakSignalToNoiseRatio(const ComparisonPicture& picture) const {
  return metrics::peakSignalToNoiseRatio(reference_.halves, picture.halves);
}

}  // namespace gonio
