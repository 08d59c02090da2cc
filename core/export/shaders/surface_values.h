// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/support/task_control.h"

namespace gonio::exports {

/// Parameters of metallic-roughness shaders. Each shader uses some of them, under its own names; its formula defines
/// what a value means. Colours are linear sRGB.
struct SurfaceValues {
  Rgb baseColour{0.5};
  double metalness = 0;
  double roughness = 0.5;  ///< square root of the GGX alpha
  double anisotropy = 0;
  double rotation = 0;  ///< angle of the grain from the tangent, rad, counter-clockwise
  Rgb specularColour{1};
  double specular = 1;      ///< strength or level, as the shader's formula defines
  double specularTint = 0;  ///< [0, 1]: colour of the highlight, from white (0) to the base colour normalised to
                            ///< luminance 1 (1)
  double ior = 1.5;
  double coat = 0;
  double coatRoughness = 0.1;
  Rgb sheenColour{0};
  double sheenRoughness = 0.5;

  bool operator==(const SurfaceValues&) const = default;
};

enum class SurfaceField {
  baseColour,
  metalness,
  roughness,
  anisotropy,
  rotation,
  specularColour,
  specular,
  specularTint,
  ior,
  coat,
  coatRoughness,
  sheenColour,
  sheenRoughness
};

/// A parameter of a shader, with its limits.
struct SurfaceLimit {
  SurfaceField field;
  double minimum, maximum;
};

/// A metallic-roughness shader.
struct SurfaceShader {
  std::span<const SurfaceLimit> limits;  ///< of the parameters that a fit changes; anisotropy and rotation only for
                                         ///< anisotropic materials
  SurfaceValues defaults;                ///< values of all other parameters
  /// The shader's own formula as a BRDF, 1/sr, without the cosine, including its layering.
  std::unique_ptr<const Brdf> (*brdf)(const SurfaceValues&);

  /// Whether a fit of this shader changes the parameter.
  bool isFitted(SurfaceField field) const;
};

/// Fits the shader's own formula to a material within its limits: least squared residuals of PictureCells. Starts from
/// a metal and a dielectric, each without and with a coat, with the widths and colours of fitReciprocalLobes(). Takes
/// a few seconds for an isotropic material. Deterministic. @throws Cancelled.
SurfaceValues fitSurface(const SurfaceShader& shader, const Brdf& material, const TaskControl& control = {});

}  // namespace gonio::exports
