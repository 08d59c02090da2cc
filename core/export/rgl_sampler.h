// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/rgl_brdf.h"
#include "core/export/normal_density.h"

namespace gonio::exports {

/// The parameterisation of a material without the polar angles of the incident direction.
struct RglLayout {
  std::vector<float> phis{0};  ///< azimuths of the incident direction, rad; for anisotropic materials from -pi to pi
  NormalDensity density;
  std::size_t vndfRows = 32;
  bool isotropic = true;
  bool mirrorSymmetric = true;  ///< whether isotropic slices are the mean of both sides of the plane of incidence
};

/// The layout for a material: one azimuth if it is isotropic, else `azimuths` intervals over the whole circle, which
/// all loaders support (only Mitsuba supports half and quarter circles).
/// @param floor as in normalDensity().
RglLayout rglLayout(const Brdf& material, std::size_t azimuths, double floor);

/// The fields at one polar angle of the incident direction, for all its azimuths.
struct RglSlice {
  float theta = 0;
  SliceStack<float> vndf;
  SliceStack<glm::vec3> rgb;
  std::vector<DirectionPair> pairs;  ///< at the nodes of rgb, with the viewer at theta; if the light is below the
                                     ///< horizon, it is replaced by the viewer
  std::vector<double> scale;  ///< rgb over the BRDF value per node: cos theta_i 4 sigma / D; 0 if the light is below
                              ///< the horizon
  std::size_t clipped = 0;    ///< number of negative channel values that were set to 0
};

/// Samples a material at the nodes of a layout, with the viewer as incident direction (IncidentDirection::viewer). The
/// field `rgb` is f cos theta_i 4 sigma / D, theta_i the angle of the light, so its mean over the unit square is the
/// integral of f cos theta_i over the light if the whole square maps to directions above the horizon. size^2
/// evaluations per azimuth.
RglSlice sampleSlice(const Brdf& material, const RglLayout& layout, double theta, std::size_t size);

/// Assembles slices of ascending polar angles into the data of an RGL file, with the luminance of samplingLuminance().
RglData assemble(const RglLayout& layout, std::span<const RglSlice* const> slices);

}  // namespace gonio::exports
