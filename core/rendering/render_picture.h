// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/path_tracer.h"

namespace gonio {

struct RenderOptions {
  int width = 256, height = 256;
  int samples = 64;  ///< of each pixel
  std::uint64_t seed = 1;
  /// Density for samples of the BRDF; its own, or estimated from it, when absent. Give the same lobe to pictures that
  /// are compared: with equal seeds they then share their noise.
  std::optional<SamplingLobe> lobe;
};

/// The material of a picture with these options.
std::shared_ptr<const RenderMaterial> pictureMaterial(const Brdf& brdf, const RenderOptions& options);

/// A picture of a scene whose objects all have the one material, by the effects that the scene calls for and frames
/// along the surfaces: linear RGB radiance, the same bits for any number of threads. `brdf` is not kept.
/// @throws Cancelled.
Image renderPicture(const Brdf& brdf, const Scene& scene, const RenderOptions& options,
                    const TaskControl& control = {});
/// The same of pictureMaterial(), for several pictures of one material.
Image renderPicture(const std::shared_ptr<const RenderMaterial>& material, const Scene& scene,
                    const RenderOptions& options, const TaskControl& control = {});

/// The scene of every rendered SNR in Gonio, named "sphere-studio": the sphere with the default camera in the studio.
Scene comparisonScene();
inline constexpr const char* comparisonSceneName = "sphere-studio";

}  // namespace gonio
