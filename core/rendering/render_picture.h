// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/path_tracer.h"

namespace gonio {

struct RenderOptions {
  int width = 256, height = 256;
  int samples = 64;  ///< per pixel
  std::uint64_t seed = 1;
  /// Density for importance sampling; empty: RenderMaterial chooses one. For comparisons use the same lobe and seed for
  /// all pictures, so that they share their noise.
  std::optional<SamplingDensity> lobe;
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

/// The paths of renderPicture() for materials with `options.lobe`, which must be given. Empty where pictures of
/// different materials have different paths: with interreflections, or with objects that have a material of their own.
/// 80 bytes per value, about 1.2 values per sample (comparisonScene()). @throws Cancelled.
std::optional<RecordedPaths> recordPaths(const Scene& scene, const RenderOptions& options,
                                         const TaskControl& control = {});

/// The scene of all rendered SNRs in Gonio: a sphere in the studio environment with the default camera.
Scene comparisonScene();
/// Its name in result files, and that of the same scene in lists (bundledSceneNames()). openScene() accepts both.
inline constexpr const char *comparisonSceneName = "sphere-studio", *bundledComparisonScene = "sphere";

}  // namespace gonio
