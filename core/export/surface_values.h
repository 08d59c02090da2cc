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

/// What shaders of the metallic-roughness kind are set by; each takes some of the values and gives them its own names,
/// and what a value means is defined by the shader's formula. Colours are linear sRGB.
struct SurfaceValues {
  Rgb baseColour{0.5};
  double metalness = 0;
  double roughness = 0.5;  ///< square root of alpha
  double anisotropy = 0;
  double rotation = 0;  ///< rad, of the grain from the tangent, counter-clockwise
  Rgb specularColour{1};
  double specular = 1;      ///< strength, or level where the shader's formula says so
  double specularTint = 0;  ///< how much of the base colour's hue the specular colour has
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

/// A value that a shader takes, with its limits.
struct SurfaceLimit {
  SurfaceField field;
  double lowest, highest;
};

/// A shader of the metallic-roughness kind.
struct SurfaceShader {
  std::span<const SurfaceLimit> limits;  ///< of what a fit may change; anisotropy and rotation of anisotropic materials
  SurfaceValues defaults;                ///< the shader's, for everything else
  /// The shader's own formula as a BRDF, 1/sr without the cosine, with the layers as it combines them.
  std::unique_ptr<const Brdf> (*brdf)(const SurfaceValues&);

  bool takes(SurfaceField field) const;
};

/// The values of least error of the shader's own formula in the cells of PictureCells, within its limits: from starts
/// of a metal and of a dielectric, each without and with a coat, with the widths and colours of the reciprocal
/// lobes of the material. Some seconds for an isotropic material. Deterministic. @throws Cancelled.
SurfaceValues fitSurface(const SurfaceShader& shader, const Brdf& material, const TaskControl& control = {});

}  // namespace gonio::exports
