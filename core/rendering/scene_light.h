// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/scene.h"

namespace gonio::rendering {

/// Identifies a light source of a scene.
struct SceneLight {
  enum class Kind { directional, point, rectangle, environment };
  Kind kind;
  std::size_t index = 0;  ///< among the scene's lights of that kind; for a rectangle the index of its object

  bool operator==(const SceneLight&) const = default;
};

/// All sources in a fixed order: directional, point, emitting rectangles, environment. Sources with all channels 0 are
/// omitted.
std::vector<SceneLight> lightsOf(const Scene& scene);

/// The name for display: "the distant light", "point light 2", "lamp" (an object's name), "the environment 'sky'".
std::string lightName(const Scene& scene, const SceneLight& light);

/// Whether some point of the object's outer surface may face the source, without regard to other objects. Conservative:
/// false only if that is certain.
bool canReach(const Scene& scene, const SceneLight& light, const SceneObject& receiver);

/// Whether `blocker` may occlude the source from a point of `receiver`. Conservative: false only if a plane separates
/// it from the convex hull of the receiver and all paths to the source. Shapes that touch count as separated, since
/// contact shades no area. Cost: some support points of both shapes.
bool mayBlock(const Scene& scene, const SceneLight& light, const SceneObject& receiver, const SceneObject& blocker);

/// Whether a reflecting point of `other` may be visible from a point of `receiver`; for the same object, whether it may
/// see itself.
bool maySee(const SceneObject& receiver, const SceneObject& other);

/// Upper bound of the fraction of the cosine-weighted hemisphere that `other` covers at a point of `receiver`, in [0,
/// 1]: (r / d)^2, with r the radius of its bounding sphere and d the smallest distance of the receiver from its centre.
double maxFormFactor(const SceneObject& receiver, const SceneObject& other);

}  // namespace gonio::rendering
