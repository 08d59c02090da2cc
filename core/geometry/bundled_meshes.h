// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <string>

#include "core/geometry/triangle_mesh.h"

/// Closed meshes that the project makes itself. The named ones lie in the cube [-1, 1]^3 and stand on y = -1, as a unit
/// sphere about the origin does.
namespace gonio {

/// A surface of revolution about +y, closed and wound outward. The profile runs through points (distance from the axis,
/// height): from axis to axis (its first and last distance are 0), or around (its last point is its first). Creases of
/// the profile stay sharp beyond creaseAngle.
/// @throws Error where the profile is too short, open, crosses the axis or is not finite; where there are fewer than 3
/// segments.
MeshArrays revolvedArrays(std::span<const glm::dvec2> profile, int segments);
TriangleMesh revolvedMesh(std::span<const glm::dvec2> profile, int segments);

/// A ring of 128 x 64 quadrangles about +y; radius of its middle line 0.7, of its tube 0.3.
TriangleMesh torusMesh();
/// A thick-walled bowl with a foot, open to the top.
TriangleMesh bowlMesh();
/// The preview object: a ball with a recessed band and an opening towards the viewer (+z), through which a core shows,
/// on a waisted stand. It has parts of every curvature, shadows itself and sees itself.
TriangleMesh shaderBallMesh();

/// A solid cylinder about +y with rounded rims.
TriangleMesh cylinderMesh();
/// A thin cloth that hangs in folds over a ball: sheen, silhouettes and soft creases.
TriangleMesh clothMesh();

/// Made once: "shader-ball", "torus", "bowl", "cylinder", "cloth".
/// @throws Error that lists the names.
std::shared_ptr<const TriangleMesh> bundledMesh(const std::string& name);

}  // namespace gonio
