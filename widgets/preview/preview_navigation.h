// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>

#include "core/rendering/camera.h"

namespace gonio::widgets {

/// What the hand does to the view, as plain functions: no state, no widget.

/// The camera after a drag by (dx, dy) pixels, y down: the sphere follows the hand.
OrbitCamera orbited(const OrbitCamera& camera, double dx, double dy);

/// The camera after it was shifted so that what lies at the target's depth moves by (x, y) in the picture (whose
/// smaller half side is 1, y up). The target stays within reach of the objects.
OrbitCamera panned(const OrbitCamera& camera, double x, double y);

/// The camera after `steps` notches of the wheel; positive moves nearer. What lies at the target's depth at (x, y) in
/// the picture (as in panned()) stays there.
OrbitCamera zoomed(const OrbitCamera& camera, double steps, double x = 0, double y = 0);

/// Turn of the environment for a drag by dx pixels, rad.
double environmentTurn(double dx);

/// Direction to a light whose mirror highlight lies at a picture position (x, y in [-1, 1], y up): it is reflected at
/// the sphere there; beside the sphere at its silhouette.
Direction lightTowards(const OrbitCamera& camera, double x, double y, double aspect);

/// Polar angle of the viewer (rad, [0, pi/2]) at the point of the sphere seen at a picture position (x, y in [-1, 1],
/// y up): the angle between the normal there and the direction to the eye. Nothing beside the sphere.
std::optional<double> viewerPolarAngle(const OrbitCamera& camera, double x, double y, double aspect);

}  // namespace gonio::widgets
