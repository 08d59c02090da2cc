// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/rgl_brdf.h"
#include "core/support/task_control.h"

namespace gonio::rgl {

/// A distribution D of microfacet normals, 1/sr, over the square of core/brdf/normal_square.h (rows azimuth, columns
/// polar angle), and sigma, the projected area of the microfacets, over directions on the same square. One slice each.
struct NormalDensity {
  SliceStack<float> ndf, sigma;
};

/// The parameterisation of a material without the polar angles of the incident direction.
struct RglLayout {
  std::vector<float> phis{0};  ///< azimuths of the incident direction, rad; for anisotropic materials from -pi to pi
  NormalDensity density;
  std::size_t vndfRows = 16;
  bool isotropic = true;
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
};

/// Samples a material at the nodes of a layout, with the viewer as incident direction (IncidentDirection::viewer). The
/// field `rgb` is f cos theta_i 4 sigma / D, theta_i the angle of the light, so its mean over the unit square is the
/// integral of f cos theta_i over the light if the whole square maps to directions above the horizon. size^2
/// evaluations per azimuth.
RglSlice sampleSlice(const Brdf& material, const RglLayout& layout, double theta, std::size_t size);

/// Assembles slices of ascending polar angles into the data of an RGL file, with the luminance of samplingLuminance().
RglData assemble(const RglLayout& layout, std::span<const RglSlice* const> slices);

/// Chooses polar angles of the incident direction, rad, from 0 to 89 degrees, densely where the material changes.
/// Starts with four angles and repeatedly halves the interval with the largest error of linear interpolation at its
/// middle: the error of the field `rgb`, weighted by the area of the part of a sphere's picture that is seen at angles
/// in this interval. Cost: two slices of 16 x 16 nodes per angle. @param count at least 4. @return the angles in the
/// order in which they were added, so that the first n >= 4 of them are the result for n. @throws Cancelled.
std::vector<double> placeAngles(const Brdf& material, const RglLayout& layout, std::size_t count,
                                const TaskControl& control = {});

}  // namespace gonio::rgl
