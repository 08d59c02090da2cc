// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/rgl_brdf.h"
#include "core/export/normal_density.h"

namespace gonio::exports {

/// What the parameterisation of a material is made of, apart from the polar angles of the incident direction.
struct RglLayout {
  std::vector<float> phis{0};  ///< azimuths of the incident direction, rad; of an anisotropic one from -pi to pi
  NormalDensity density;
  std::size_t vndfRows = 32;
  bool isotropic = true;
  bool mirrorSymmetric = true;  ///< isotropic slices are the mean of both sides of the plane of incidence
};

/// The layout for a material: one azimuth for an isotropic one, else `azimuths` intervals over the whole circle, which
/// all loaders know (half and quarter circles Mitsuba alone).
/// @param floor of normalDensity()
RglLayout rglLayout(const Brdf& material, std::size_t azimuths, double floor);

/// The fields at one polar angle of the incident direction, for all its azimuths.
struct RglSlice {
  float theta = 0;
  SliceStack<float> vndf;
  SliceStack<glm::vec3> rgb;
  std::vector<DirectionPair> pairs;  ///< of the nodes of rgb, the viewer at theta; light below the horizon: none
  std::vector<double> scale;         ///< a node's rgb over its BRDF value: cos theta_o 4 sigma / D; 0 where none
  std::size_t clipped = 0;           ///< negative channels that were set to 0
};

/// Samples a material at the nodes of a layout; the viewer takes the slot of the incident direction. The field
/// `rgb` is f cos theta_o 4 sigma / D: the integral of f cos theta_o over the light is its mean over the unit square,
/// where all of the square is seen. size^2 evaluations an azimuth.
RglSlice sampleSlice(const Brdf& material, const RglLayout& layout, double theta, std::size_t size);

/// Slices of ascending polar angles as what an RGL file holds, the luminance with a floor of 1/1000 of its largest
/// value in a slice, and even where a slice is black: the loaders divide by its integral.
RglData assemble(const RglLayout& layout, std::span<const RglSlice* const> slices);

}  // namespace gonio::exports
