// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/math/marginal_warp.h: densities on the unit square, one a slice, blended linearly between slices by the
// hardware's filter along z.
//   cells: x the density in cells, y its integral along the row up to the node
//   rows:  at (row, slice): x the integral of the row, y that of the rows before it

// Between two runs of slices (those of two azimuths), each at its texture coordinate along z.
struct Slices {
  float low, high, fraction;
};

vec2 warpNode(sampler3D cells, vec2 node, Slices at) {
  vec2 size = vec2(textureSize(cells, 0).xy);
  vec2 place = (node + 0.5) / size;
  vec2 value = texture(cells, vec3(place, at.low)).xy;
  if (at.fraction > 0.0) value = mix(value, texture(cells, vec3(place, at.high)).xy, at.fraction);
  return value;
}

vec2 warpRow(sampler2D rows, float row, Slices at) {
  float place = (row + 0.5) / float(textureSize(rows, 0).x);
  vec2 value = texture(rows, vec2(place, at.low)).xy;
  if (at.fraction > 0.0) value = mix(value, texture(rows, vec2(place, at.high)).xy, at.fraction);
  return value;
}

// Where the map takes a point.
vec2 warpInverse(sampler3D cells, sampler2D rows, vec2 point, Slices at, out float density) {
  vec2 size = vec2(textureSize(cells, 0).xy);
  vec2 place = clamp(point, 0.0, 1.0) * (size - 1.0);
  vec2 node = min(floor(place), size - 2.0);
  vec2 f = place - node;
  vec2 left = mix(warpNode(cells, node, at), warpNode(cells, node + vec2(0.0, 1.0), at), f.y);
  float right = mix(warpNode(cells, node + vec2(1.0, 0.0), at).x, warpNode(cells, node + vec2(1.0, 1.0), at).x, f.y);
  vec2 low = warpRow(rows, node.y, at);
  float high = warpRow(rows, node.y + 1.0, at).x;
  float total = mix(low.x, high, f.y);
  float across = left.y + f.x * (left.x + 0.5 * f.x * (right - left.x));
  float along = low.y + f.y * (low.x + 0.5 * f.y * (high - low.x));
  density = mix(left.x, right, f.x) * (size.x - 1.0) * (size.y - 1.0);
  return clamp(vec2(total > 0.0 ? across / total : point.x, along), 0.0, 1.0);
}

// How far along a cell the integral of what runs straight from `low` to `high` is `area`.
float inverseOfRamp(float low, float high, float area) {
  float sum = low + sqrt(max(0.0, low * low + 2.0 * area * (high - low)));
  return sum > 0.0 ? clamp(2.0 * area / sum, 0.0, 1.0) : 0.0;
}
