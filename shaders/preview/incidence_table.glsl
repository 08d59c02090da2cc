// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/brdf/incidence_table_brdf.h: values for some angles of incidence, each over the directions about an axis.
//   INCIDENCE_TABLE_MIRROR     the axis is the mirror direction of the light; else the normal
//   INCIDENCE_TABLE_SYMMETRIC  the azimuths are in [0, pi]
//   INCIDENCE_TABLE_ROTATIONS  the light has several azimuths
// By hand: the nodes are uneven, and drivers filter with weights of a few bits.
uniform sampler3D incidenceValues;  // (rgb, 1) above the horizon, else 0: x polar angle, y azimuth, z angle of incidence, for each azimuth of the light
uniform sampler2D incidenceNodes;   // a row for each of these four
uniform ivec4 incidenceCounts;

// Two nodes with the fraction of the second.
struct IncidenceBracket {
  ivec2 nodes;
  float fraction;
};

float incidenceNode(int row, int index) { return texelFetch(incidenceNodes, ivec2(index, row), 0).x; }

// Held at the ends.
IncidenceBracket incidenceBracket(int row, float at) {
  int count = incidenceCounts[row], next = 0, end = count;
  while (next < end) {
    int middle = (next + end) / 2;
    if (incidenceNode(row, middle) <= at) next = middle + 1;
    else end = middle;
  }
  ivec2 nodes = ivec2(max(next - 1, 0), min(next, count - 1));
  float first = incidenceNode(row, nodes.x);
  return IncidenceBracket(nodes, nodes.x < nodes.y ? (at - first) / (incidenceNode(row, nodes.y) - first) : 0.0);
}

// 0 to pi.
float unsignedAzimuth(vec2 w) {
  float acute = acuteAngle(abs(w.y), abs(w.x));
  return w.x < 0.0 ? pi - acute : acute;
}

// Of azimuths on the whole circle: the last node is followed by the first, a turn on.
IncidenceBracket circleBracket(int row, vec2 w) {
  float at = w.y < 0.0 ? 2.0 * pi - unsignedAzimuth(w) : unsignedAzimuth(w);
  int last = incidenceCounts[row] - 1;
  float first = incidenceNode(row, 0), end = incidenceNode(row, last);
  if (at >= first && at <= end) return incidenceBracket(row, at);
  float gap = first + 2.0 * pi - end;
  return IncidenceBracket(ivec2(last, 0), gap > 0.0 ? ((at < first ? at + 2.0 * pi : at) - end) / gap : 0.0);
}

IncidenceBracket azimuthBracket(vec2 w) {
#ifdef INCIDENCE_TABLE_SYMMETRIC
  return incidenceBracket(1, unsignedAzimuth(w));
#else
  return circleBracket(1, w);
#endif
}

#ifdef INCIDENCE_TABLE_ROTATIONS
IncidenceBracket incidenceRotations;  // of the light that is evaluated
#endif

// The horizon is the same for every azimuth of the light.
vec4 incidenceTexel(int polar, int azimuth, int incident) {
#ifdef INCIDENCE_TABLE_ROTATIONS
  ivec2 layers = incidenceRotations.nodes * incidenceCounts.z + incident;
  return mix(texelFetch(incidenceValues, ivec3(polar, azimuth, layers.x), 0),
             texelFetch(incidenceValues, ivec3(polar, azimuth, layers.y), 0), incidenceRotations.fraction);
#else
  return texelFetch(incidenceValues, ivec3(polar, azimuth, incident), 0);
#endif
}

float anglePolar(float sine, float cosine) { return cosine < 0.0 ? pi - acuteAngle(sine, -cosine) : acuteAngle(sine, cosine); }

// Nodes below the horizon are dropped by their alpha of 0.
vec4 incidenceLookup(int incident, IncidenceBracket p, IncidenceBracket a) {
  vec4 low = mix(incidenceTexel(p.nodes.x, a.nodes.x, incident), incidenceTexel(p.nodes.y, a.nodes.x, incident), p.fraction);
  vec4 high = mix(incidenceTexel(p.nodes.x, a.nodes.y, incident), incidenceTexel(p.nodes.y, a.nodes.y, incident), p.fraction);
  vec4 found = mix(low, high, a.fraction);
  // All four may be below the horizon: then those nearest to the axis that are not.
  for (int step = p.nodes.x - 1; found.a <= 0.0 && step >= 0; --step)
    found = mix(incidenceTexel(step, a.nodes.x, incident), incidenceTexel(step, a.nodes.y, incident), a.fraction);
  return found;
}

// Linear RGB in 1/sr; `valid` is false where the value is 0 because nothing was measured there.
vec3 evaluateIncidenceTable(vec3 wi, vec3 wo, out bool valid) {
  const float tolerance = 1e-6;
  float sinI = length(wi.xy), thetaI = acuteAngle(sinI, wi.z);
  vec2 i = sinI > 0.0 ? wi.xy / sinI : vec2(1.0, 0.0);
#ifdef INCIDENCE_TABLE_ROTATIONS
  incidenceRotations = circleBracket(3, i);
#endif
  vec2 turned = vec2(dot(i, wo.xy), i.x * wo.y - i.y * wo.x);
  // About the mirror direction: azimuth 0, a quarter turn, the axis.
  vec3 at = vec3(wi.z * turned.x + sinI * wo.z, turned.y, wi.z * wo.z - sinI * turned.x);
#ifdef INCIDENCE_TABLE_MIRROR
  float polar = anglePolar(length(at.xy), at.z);
  IncidenceBracket polars = incidenceBracket(0, polar), azimuths = azimuthBracket(at.xy);
#else
  float polar = acuteAngle(length(wo.xy), wo.z);
#endif
  IncidenceBracket incident = incidenceBracket(2, thetaI);
  vec4 sum = vec4(0.0);
  for (int k = 0; k < 2; ++k) {
    float fraction = k == 0 ? 1.0 - incident.fraction : incident.fraction;
    if (fraction <= 0.0) continue;
    // The viewer that sees the same of the highlight under this angle of incidence.
    float theta = incidenceNode(2, incident.nodes[k]), s = sin(theta), c = cos(theta);
    vec3 seen = vec3(c * at.x - s * at.z, at.y, s * at.x + c * at.z);
    bool isBelow = seen.z < -tolerance;
    // Between two angles of incidence one of them has the direction above its horizon; beyond them it is moved there.
    if (isBelow && incident.nodes.x != incident.nodes.y) continue;
    vec2 turn = at.xy / max(length(at.xy), 1e-30);
#ifdef INCIDENCE_TABLE_MIRROR
    IncidenceBracket shown = polars;
    if (isBelow) shown = incidenceBracket(0, anglePolar(c, -s * turn.x));
    vec4 found = incidenceLookup(incident.nodes[k], shown, azimuths);
#else
    if (isBelow) {
      vec2 horizon = normalize(vec2(c, -s * turn.x));  // sine and cosine of the angle from the mirror direction
      seen = vec3(c * horizon.x * turn.x - s * horizon.y, horizon.x * turn.y, 0.0);
    }
    IncidenceBracket polars = incidenceBracket(0, anglePolar(length(seen.xy), seen.z));
    vec4 found = incidenceLookup(incident.nodes[k], polars, azimuthBracket(seen.xy));
#endif
    if (found.a > 0.0) sum += fraction * vec4(found.rgb / found.a, 1.0);
  }
  vec3 value = sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0);
  vec2 ends = vec2(incidenceNode(0, 0), incidenceNode(0, incidenceCounts.x - 1));
  vec2 lights = vec2(incidenceNode(2, 0), incidenceNode(2, incidenceCounts.z - 1));
  valid = value != vec3(0.0) || (polar >= ends.x - tolerance && polar <= ends.y + tolerance &&
                                 thetaI >= lights.x - tolerance && thetaI <= lights.y + tolerance);
  return value;
}
