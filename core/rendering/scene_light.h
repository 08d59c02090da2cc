// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/scene.h"

namespace gonio {

/// One source of light of a scene, by its place there.
struct SceneLight {
  enum class Kind { directional, point, rectangle, environment };
  Kind kind;
  std::size_t index = 0;  ///< among the scene's lights of the kind; of a rectangle the number of its object

  bool operator==(const SceneLight&) const = default;
};

/// All sources in a fixed order: directional, point, emitting rectangles, the environment. A source that sends nothing
/// (all channels 0) is none.
std::vector<SceneLight> lightsOf(const Scene& scene);

/// "the distant light", "point light 2", "lamp" (an object's name), "the environment 'sky'".
std::string lightName(const Scene& scene, const SceneLight& light);

/// Whether some point of the object's outer surface faces the source, were nothing else in the scene. False only where
/// that is certain.
bool canReach(const Scene& scene, const SceneLight& light, const SceneObject& receiver);

/// Whether `blocker` may stand between a point of `receiver` and the source. False only where a plane is known
/// that separates it from the convex hull of the receiver and all its ways to the source; shapes that touch count as
/// separated, for what touches shades no area. Cost: some support points of both shapes.
bool mayBlock(const Scene& scene, const SceneLight& light, const SceneObject& receiver, const SceneObject& blocker);

/// Whether a point of `receiver` may see a reflecting point of `other` (for the same object: itself).
bool maySee(const SceneObject& receiver, const SceneObject& other);

/// The largest fraction of the cosine-weighted hemisphere that `other` can fill at a point of `receiver`, in [0, 1]:
/// (r / d)^2 of its bounding sphere at the nearest distance d of the receiver from its centre.
double largestFormFactor(const SceneObject& receiver, const SceneObject& other);

}  // namespace gonio
