// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// A sparse code decoded, first of three passes, of widgets/preview/code_decoder: for each group of coefficients
// that share their atoms of theta_d and theta_h, the sum over its atoms of phi_d. x is phi_d, y the group; a channel
// each in red, green, blue.
uniform samplerBuffer coefficients;
uniform samplerBuffer groupRanges;
uniform sampler2D phiDAtoms;  // x the node, y the atom; the channels' matrices on top of each other
uniform int groupCount;       // a channel

out vec4 fibre;

float sumOf(int channel, ivec2 place) {
  vec4 range = texelFetch(groupRanges, channel * groupCount + place.y);
  int atoms = channel * textureSize(phiDAtoms, 0).x;
  float sum = 0.0;
  for (int i = int(range.y); i < int(range.z); ++i) {
    vec2 coefficient = texelFetch(coefficients, i).xy;
    sum += coefficient.y * texelFetch(phiDAtoms, ivec2(place.x, atoms + int(coefficient.x)), 0).r;
  }
  return sum;
}

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  fibre = vec4(sumOf(0, place), sumOf(1, place), sumOf(2, place), 0.0);
}
