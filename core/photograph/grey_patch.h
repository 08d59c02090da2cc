// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/photograph/photograph.h"

namespace gonio::photograph {

/// A diffuse grey surface of known reflectance in a photograph, which shows the exposure: a flat card or a sphere.
struct GreyPatch {
  double reflectance = 0.18;  ///< of all wavelengths
  // A card: a rectangle of pixels, and the direction that the card faces (world, unit).
  double x = 0, y = 0, width = 0, height = 0;
  Direction normal{0, 0, 1};
  std::optional<matching::Disc> sphere;  ///< the outline of a sphere, in pixels; empty: a card
  /// Where it is, relative to the middle of the surface of the material, in its unit. Small lights have the distance
  /// and direction that they have from there.
  Direction position{0};
};

/// The factor of the pixel values of each channel: the ratio of pixel values to the radiance that a Lambertian surface
/// has under the light of the photograph (least squares over the pixels of a sphere within 85 % of its radius). A card
/// and a sphere are lit by the whole light: nothing shadows them. Pixels that are clipped or not finite are not used.
/// @param warnings receives a sentence if a grey sphere does not look like a Lambertian one under this light.
/// @throws Error that names the photograph: no usable pixels, black pixels, or no light on the patch.
Rgb exposureOf(const Photograph& photograph, const GreyPatch& patch, std::vector<std::string>& warnings);

/// The irradiance of a surface with a normal (world, unit), where nothing shadows it. @param position of small lights
/// counts from there. O(texels of the environment).
Rgb irradianceOn(const Light& light, const Direction& normal, const Direction& position);

}  // namespace gonio::photograph
