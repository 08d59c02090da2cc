// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/metrics/image_metrics.h"
#include "core/rendering/render_picture.h"

namespace gonio {

/// The picture of rankings, studies and the editor's comparisons, so that all of them report one number: a quarter of
/// the pixels of `goniotool compare` and half its samples; the SNR differs by 0.1 dB from it.
inline RenderOptions smallComparisonPicture() { return {.width = 128, .height = 128, .samples = 32, .lobe = {}}; }

/// A material in comparisonScene().
struct ComparisonPicture {
  Image image;                  ///< to look at: the mean of both halves
  metrics::PicturePair halves;  ///< of half the samples each, with noise of their own: to measure with
};

/// Pictures of materials in comparisonScene() against that of one reference, which is rendered once. All use its lobe
/// and seeds: they share most of their noise. What they do not share does not count: the ratios are those of pictures
/// of infinitely many samples, as far as these can show (metrics::PicturePair).
class RenderedComparison {
 public:
  /// Renders the reference. @throws Cancelled.
  /// @param options an odd number of samples counts as the next even one.
  explicit RenderedComparison(const Brdf& reference, RenderOptions options = {}, const TaskControl& control = {});
  /// The same in another scene, whose objects all have the one material: its ratios are those of this scene alone.
  RenderedComparison(Scene scene, const Brdf& reference, RenderOptions options = {}, const TaskControl& control = {});

  const Image& reference() const { return reference_.image; }
  /// @throws Cancelled.
  ComparisonPicture render(const Brdf& test, const TaskControl& control = {}) const;
  /// Of a picture by render(), dB; contract for 0 as metrics::signalToNoiseRatio.
  double signalToNoiseRatio(const ComparisonPicture& picture) const;
  double peakSignalToNoiseRatio(const ComparisonPicture& picture) const;

 private:
  Scene scene_;
  RenderOptions options_;  ///< of each half
  ComparisonPicture reference_;
};

}  // namespace gonio
