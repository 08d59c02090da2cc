// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Second pass of decoding: for each atom of theta_h the sum over its groups of fibre times atom of theta_d. x is phi_d,
// y theta_d of the first slab, then of the second, and so on.
uniform samplerBuffer slabRanges;
uniform samplerBuffer groupRanges;
uniform sampler2D fibres;
uniform sampler2D thetaDAtoms;  // x the node, y the atom; the channels' matrices on top of each other
uniform int groupCount;         // a channel
uniform int slabCount;          // a channel

out vec4 slab;

float sumOf(int channel, int phiD, int thetaD, int slabIndex) {
  vec4 range = texelFetch(slabRanges, channel * slabCount + slabIndex);
  int atoms = channel * textureSize(thetaDAtoms, 0).x;
  float sum = 0.0;
  for (int g = int(range.x); g < int(range.y); ++g) {
    int atom = int(texelFetch(groupRanges, channel * groupCount + g).x);
    sum += texelFetch(fibres, ivec2(phiD, g), 0)[channel] * texelFetch(thetaDAtoms, ivec2(thetaD, atoms + atom), 0).r;
  }
  return sum;
}

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  int size = textureSize(thetaDAtoms, 0).x;
  int thetaD = place.y % size, slabIndex = place.y / size;
  slab = vec4(sumOf(0, place.x, thetaD, slabIndex), sumOf(1, place.x, thetaD, slabIndex),
              sumOf(2, place.x, thetaD, slabIndex), 0.0);
}
