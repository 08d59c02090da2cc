// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/matching/ball_pictures.h"

namespace gonio::matching {

struct MatchOptions {
  /// Whether the exposure of the picture is unknown, as in a photograph: only the relations of its colours count.
  bool freeExposure = false;
};

/// Controls that reproduce a picture.
struct ControlMatch {
  models::ParameterValues controls;  ///< of editing::artistControls()
  double exposure = 0;               ///< stops by which the picture is brighter than the ball; 0 unless free
  /// 10 log10 of the energy of the picture, relative to that of its difference from the ball, dB: over the known cells
  /// of at most 64 x 64.
  double signalToNoiseRatio = 0;
};

/// The controls that are fitted: those that act on the model of the edit, except contrast and edge brightness, which
/// look too much like specular strength. Others have the values of the edit.
std::vector<editing::ArtistControl> matchedControls(const editing::DifferentialEdit& edit);

/// The controls of an edit with which a ball in the light of a scene looks like the sphere in a picture. Minimises the
/// squared differences of log(radiance + 1/20 of the mean), by Levenberg and Marquardt's method from several values of
/// roughness, first in few pixels. Of combinations of controls that look alike, it chooses the one in which the fewest
/// controls differ from their defaults. Within the ranges of the sliders, or farther if the edit is. Deterministic. 1
/// to 4 s on two cores.
/// @param material its edit is used as if it were enabled. @param scene light and camera.
/// @throws Error if the picture or the scene is unsuitable; Cancelled.
ControlMatch matchControls(const ReferencePicture& picture, MatchedMaterial material, const rendering::Scene& scene,
                           const MatchOptions& options = {}, const TaskControl& control = {});

}  // namespace gonio::matching
