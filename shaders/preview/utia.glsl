// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/brdf/utia_brdf.h: 288 incident by 288 viewing directions, linear in the four angles. By hand: drivers
// filter with weights of a few bits, and the nodes lie 15 degrees apart.
#include "preview/incident_direction.glsl"

uniform sampler2D utiaValues;  // a row an incident, a column a viewing direction

// The four nodes about a direction with their weights, which sum to 1.
struct UtiaNodes {
  ivec4 index;
  vec4 weight;
};

UtiaNodes utiaNodes(vec3 w) {
  const int azimuths = 48;
  float theta = min(acuteAngle(length(w.xy), w.z) * (12.0 / pi), 5.0);
  float acute = acuteAngle(abs(w.y), abs(w.x));
  float phi = w.x < 0.0 ? pi - acute : acute;
  float turn = (w.y < 0.0 ? -phi : phi) * (float(azimuths / 2) / pi);
  float below = min(floor(theta), 4.0);
  int left = (int(floor(turn)) + azimuths) % azimuths;
  int row = int(below) * azimuths;
  ivec2 pair = row + ivec2(left, (left + 1) % azimuths);
  vec2 up = vec2(1.0 - (theta - below), theta - below), aside = vec2(1.0 - fract(turn), fract(turn));
  return UtiaNodes(ivec4(pair, pair + azimuths), vec4(up.x * aside, up.y * aside));
}

vec3 storedBrdf(vec3 incident, vec3 outgoing) {
  UtiaNodes rows = utiaNodes(incident), columns = utiaNodes(outgoing);
  vec3 value = vec3(0.0);
  for (int i = 0; i < 4; ++i)
    for (int v = 0; v < 4; ++v)
      value += rows.weight[i] * columns.weight[v] * texelFetch(utiaValues, ivec2(columns.index[v], rows.index[i]), 0).rgb;
  return value;
}

// Linear RGB in 1/sr; `valid` is false where the value is 0 because nothing was measured there.
vec3 evaluateUtia(vec3 wi, vec3 wo, out bool valid) {
  const float lowestMeasured = 0.258819;  // the cosine of 75 degrees
  vec3 value = storedInOrder(wi, wo);
  valid = value != vec3(0.0) || min(wi.z, wo.z) >= lowestMeasured;
  return value;
}
