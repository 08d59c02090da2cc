// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Last pass of decoding: slab times atom of theta_h, bounded and transformed back, into the texture of
// preview/table.glsl. Twin of dictionary::decode(). x is phi_d, y theta_d; eight nodes of theta_h at once, so that a
// slab's texel is fetched once for 24 products. TRANSFORM is the DataTransform.
#include "preview/data_transform.glsl"

uniform sampler2D slabs;
uniform sampler2D thetaHAtoms;  // x the slab; two rows are eight nodes of a channel
uniform sampler3D weights;      // of the cosines; 0 in invalid cells
uniform vec3 highest, lowest;   // bounds of the transformed values
uniform vec3 largestValue;      // bounds of the absolute values, 1/sr
uniform int block;              // of eight nodes

layout(location = 0) out vec4 layers[8];

vec4 texelOf(vec3 y, ivec3 cell) {
  float weight = texelFetch(weights, cell, 0).r;
  if (weight <= 0.0) return vec4(0.0);
  vec3 bounded = max(min(y, highest), lowest);
  return vec4(sign(bounded) * min(inverseTransformed(TRANSFORM, abs(bounded), weight), largestValue), 1.0);
}

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  ivec3 size = textureSize(weights, 0);
  ivec2 atomsSize = textureSize(thetaHAtoms, 0);
  int green = atomsSize.y / 3, blue = 2 * green;
  vec4 red0 = vec4(0.0), red1 = vec4(0.0), green0 = vec4(0.0), green1 = vec4(0.0), blue0 = vec4(0.0),
       blue1 = vec4(0.0);
  for (int l = 0; l < atomsSize.x; ++l) {
    vec3 slab = texelFetch(slabs, ivec2(place.x, place.y + l * size.y), 0).rgb;
    ivec2 atom = ivec2(l, 2 * block);
    red0 += slab.r * texelFetch(thetaHAtoms, atom, 0);
    red1 += slab.r * texelFetch(thetaHAtoms, atom + ivec2(0, 1), 0);
    green0 += slab.g * texelFetch(thetaHAtoms, atom + ivec2(0, green), 0);
    green1 += slab.g * texelFetch(thetaHAtoms, atom + ivec2(0, green + 1), 0);
    blue0 += slab.b * texelFetch(thetaHAtoms, atom + ivec2(0, blue), 0);
    blue1 += slab.b * texelFetch(thetaHAtoms, atom + ivec2(0, blue + 1), 0);
  }
  for (int i = 0; i < 4; ++i) {
    ivec3 cell = ivec3(place, min(8 * block + i, size.z - 1));
    layers[i] = texelOf(vec3(red0[i], green0[i], blue0[i]), cell);
    cell.z = min(cell.z + 4, size.z - 1);
    layers[i + 4] = texelOf(vec3(red1[i], green1[i], blue1[i]), cell);
  }
}
