// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>

#include "core/rendering/camera.h"

namespace gonio::widgets {

/// Navigation of the view, as plain functions without state or widget.

/// The camera after a drag by (dx, dy) pixels, y down: the sphere follows the pointer.
OrbitCamera orbited(const OrbitCamera& camera, double dx, double dy);

/// The camera shifted so that points at the target's depth move by (x, y) in the picture (in units of half its smaller
/// side, y up). The target stays near the objects.
OrbitCamera panned(const OrbitCamera& camera, double x, double y);

/// The camera after `steps` notches of the wheel; positive moves nearer. The point at the target's depth at (x, y) in
/// the picture (units as in panned()) stays in place.
OrbitCamera zoomed(const OrbitCamera& camera, double steps, double x = 0, double y = 0);

/// Rotation of the environment for a drag by dx pixels, rad.
double environmentTurn(double dx);

/// Direction to a light with its mirror highlight on the sphere at a picture position (x, y in [-1, 1], y up); beside
/// the sphere, at its silhouette.
Direction lightTowards(const OrbitCamera& camera, double x, double y, double aspect);

/// Polar angle of the viewer (rad, [0, pi/2]) at the point of the sphere seen at a picture position (x, y in [-1, 1],
/// y up): the angle between the normal there and the direction to the eye. Nullopt beside the sphere.
std::optional<double> viewerPolarAngle(const OrbitCamera& camera, double x, double y, double aspect);

}  // namespace gonio::widgets
