// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/math/types.h: a direction as seen along a grain whose axis of x is (cos, sin) in the
// frame of the tangent.
vec3 inGrain(vec3 w, vec2 axis) { return vec3(axis.x * w.x + axis.y * w.y, axis.x * w.y - axis.y * w.x, w.z); }
