// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/sphere_scene.h"

namespace gonio::widgets {

/// What the hand does to the view, as plain functions: no state, no widget.

/// The camera after a drag by (dx, dy) pixels, y down: the sphere follows the hand.
OrbitCamera orbited(const OrbitCamera& camera, double dx, double dy);

/// The camera after `steps` notches of the wheel; positive moves nearer.
OrbitCamera zoomed(const OrbitCamera& camera, double steps);

/// Turn of the environment for a drag by dx pixels, rad.
double environmentTurn(double dx);

/// Direction to a light whose mirror highlight lies at a picture position (x, y in [-1, 1], y up): it is reflected at
/// the sphere there; beside the sphere at its silhouette.
Direction lightTowards(const OrbitCamera& camera, double x, double y, double aspect);

}  // namespace gonio::widgets
