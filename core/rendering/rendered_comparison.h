// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/metrics/image_metrics.h"
#include "core/rendering/render_picture.h"

namespace gonio {

/// The common picture options of rankings, studies and the editor's comparisons, so that they report equal numbers: a
/// quarter of the pixels of `goniotool compare` and half its samples; the SNR differs by 0.1 dB.
inline RenderOptions smallComparisonPicture() { return {.width = 128, .height = 128, .samples = 32, .lobe = {}}; }

/// A rendered picture of a comparison.
struct ComparisonPicture {
  Image image;                  ///< for display: the mean of both halves
  metrics::PicturePair halves;  ///< for measurements: half the samples each, with independent noise
};

/// Compares pictures of materials in comparisonScene() with that of a reference, which is rendered once. All pictures
/// use the reference's lobe and seeds and so share most of their noise; the ratios exclude the remaining noise
/// (metrics::PicturePair). Pictures of up to a million samples share their paths too (recordPaths(), up to 100 MB).
class RenderedComparison {
 public:
  /// Renders the reference. @throws Cancelled.
  /// @param options an odd number of samples is rounded up.
  explicit RenderedComparison(const Brdf& reference, RenderOptions options = {}, const TaskControl& control = {});
  /// The same in another scene, where all slots have the same material. Its ratios are not comparable with those of
  /// comparisonScene().
  RenderedComparison(Scene scene, const Brdf& reference, RenderOptions options = {}, const TaskControl& control = {});

  const Image& reference() const { return reference_.image; }
  /// @throws Cancelled.
  ComparisonPicture render(const Brdf& test, const TaskControl& control = {}) const;
  /// The same picture without recorded paths, to measure the time that a renderer needs. @throws Cancelled.
  ComparisonPicture trace(const Brdf& test, const TaskControl& control = {}) const;
  /// Rendered SNR of a picture from render(), dB; special cases as metrics::signalToNoiseRatio().
  double signalToNoiseRatio(const ComparisonPicture& picture) const;
  double peakSignalToNoiseRatio(const ComparisonPicture& picture) const;

 private:
  Scene scene_;
  std::array<RenderOptions, 2> options_;  ///< of each half
  std::array<std::optional<RecordedPaths>, 2> paths_;
  ComparisonPicture reference_;
};

}  // namespace gonio
