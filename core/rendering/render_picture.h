// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/metrics/image_metrics.h"
#include "core/rendering/path_tracer.h"

namespace gonio::rendering {

struct RenderOptions {
  int width = 256, height = 256;
  int samples = 64;  ///< per pixel
  std::uint64_t seed = 1;
  /// Density for importance sampling; empty: RenderMaterial chooses one. For comparisons use the same density and seed
  /// for all pictures, so that they share their noise.
  std::optional<SamplingDensity> density;
};

/// The render material for a BRDF with these options.
std::shared_ptr<const RenderMaterial> pictureMaterial(const Brdf& brdf, const RenderOptions& options);

/// Renders a scene in which all slots have the same material, with the effects of planEffects() and tangent frames:
/// linear RGB radiance, bitwise equal for any number of threads. `brdf` is only used during the call.
/// @throws Cancelled.
Image renderPicture(const Brdf& brdf, const Scene& scene, const RenderOptions& options,
                    const TaskControl& control = {});
/// The same with pictureMaterial(), for several pictures of one material.
Image renderPicture(const std::shared_ptr<const RenderMaterial>& material, const Scene& scene,
                    const RenderOptions& options, const TaskControl& control = {});

/// The paths of renderPicture() for materials with `options.density`, which must be given. Empty where pictures of
/// different materials have different paths: with interreflections, or with objects that have a material of their own.
/// 80 bytes per value, about 1.2 values per sample (comparisonScene()). @throws Cancelled.
std::optional<RecordedPaths> recordPaths(const Scene& scene, const RenderOptions& options,
                                         const TaskControl& control = {});

/// The scene of all rendered SNRs in Gonio: a sphere in the studio environment with the default camera.
Scene comparisonScene();
/// Its name in result files, and that of the same scene in lists (bundledSceneNames()). openScene() accepts both.
inline constexpr const char *comparisonSceneName = "sphere-studio", *bundledComparisonScene = "sphere";

/// The picture options of every rendered SNR, so that commands, studies, exports and the editor report equal numbers.
inline RenderOptions smallComparisonPicture() { return {.width = 128, .height = 128, .samples = 32, .density = {}}; }

/// A rendered picture of a comparison.
struct ComparisonPicture {
  Image image;                  ///< for display: the mean of both halves
  metrics::PicturePair halves;  ///< for measurements: half the samples each, with independent noise
};

/// Compares pictures of materials in comparisonScene() with that of a reference, which is rendered once. All pictures
/// use the reference's density and seeds and so share most of their noise; the ratios exclude the remaining noise
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

}  // namespace gonio::rendering
