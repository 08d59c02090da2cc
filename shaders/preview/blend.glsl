// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Materials mixed while a point is dragged between them; only the weights change (and the target that all move to).
// Twin of editing::TransformedMixture and of the blends of core/interpolation that it stands for.
//   BLEND_TABLES     how many
//   BLEND_IN_TRANSFORMED_DOMAIN  their values are transformed, by the DataTransform BLEND_TRANSFORM
//   BLEND_MOVES      each is moved by a model first, with EVALUATE_MODEL and MODEL_PARAMETERS: by model(target) -
//                    model(its own parameters)
//   BLEND_OWN        one of them has a part of its weight in its own form, as ownForm() evaluates it
//   BLEND_DETAIL     measured detail is preserved (core/interpolation/measured_detail.h): the values are mixed, and the
//                    change of the space is added, which is that of models (BLEND_MOVES), of factor curves
//                    (BLEND_FACTORS, BLEND_FACTOR_PARTS) or of codes: BLEND_TRANSFORM, whose transformed values are in
//                    the upper half of the textures along theta_h
//   BLEND_BOTH_ORDERS  the change is the mean of both orders of the directions
#include "preview/data_transform.glsl"
#include "preview/table.glsl"
#ifdef FACTOR_EDITS
#include "preview/factors.glsl"
#endif

uniform sampler3D blendTables[BLEND_TABLES];
uniform float blendPhiPeriods[BLEND_TABLES];
uniform float blendWeights[BLEND_TABLES];
#ifdef BLEND_MOVES
uniform vec4 targetParameters[MODEL_PARAMETERS];
uniform vec4 ownParameters[BLEND_TABLES * MODEL_PARAMETERS];

vec3 ownModel(vec3 wi, vec3 wo, int material) {
  vec4 parameters[MODEL_PARAMETERS];
  for (int i = 0; i < MODEL_PARAMETERS; ++i) parameters[i] = ownParameters[material * MODEL_PARAMETERS + i];
  return EVALUATE_MODEL(wi, wo, parameters);
}
#endif

#ifdef BLEND_OWN
uniform float blendOwnFraction;  // of the sum; blendWeights are without it
uniform int blendOwnIndex;
vec3 ownForm(vec3 wi, vec3 wo);
#endif

#ifdef BLEND_TRANSFORM
// Product of the cosines of both directions at a node of the grid.
float nodeCosines(ivec3 node, vec3 size) {
  float thetaH = float(node.z * node.z) / (size.z * size.z) * (0.5 * pi);
  float thetaD = float(node.y) / size.y * (0.5 * pi);
  float middle = cos(thetaH) * cos(thetaD);
  float side = sin(thetaH) * sin(thetaD) * cos(float(node.x) / size.x * blendPhiPeriods[0]);
  return middle * middle - side * side;
}
#endif

#ifdef BLEND_DETAIL
uniform float blendBounds[BLEND_TABLES];  // the fraction of the bound of each material

#if defined(BLEND_TRANSFORM)
// What the space changes at a node: of the mixture transformed back, less the mixture of those transformed back.
vec3 changeAtNode(ivec3 node, vec3 size) {
  float cosines = nodeCosines(node, size);
  vec3 sum = vec3(0.0), parts = vec3(0.0);
  for (int i = 0; i < BLEND_TABLES; ++i) {
    if (blendWeights[i] == 0.0) continue;
    vec3 value = texelFetch(blendTables[i], node + ivec3(0, 0, int(size.z)), 0).rgb;
    sum += blendWeights[i] * value;
    parts += blendWeights[i] * inverseTransformed(BLEND_TRANSFORM, max(value, vec3(0.0)), cosines);
  }
  return inverseTransformed(BLEND_TRANSFORM, max(sum, vec3(0.0)), cosines) - parts;
}

// Interpolated over the corners above the horizon, where the transformed values are known.
vec3 changeOfSpace(vec3 wi, vec3 wo, vec3 at) {
  ivec3 count = textureSize(blendTables[0], 0);
  count.z /= 2;
  vec3 place = tablePlace(vec3(count), blendPhiPeriods[0], at);
  ivec3 low = ivec3(place);
  vec3 fraction = place - vec3(low);
  vec4 sum = vec4(0.0);
  for (int corner = 0; corner < 8; ++corner) {
    ivec3 step = ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
    ivec3 node = ivec3((low.x + step.x) % count.x, min(low.yz + step.yz, count.yz - 1));
    if (texelFetch(blendTables[0], node + ivec3(0, 0, count.z), 0).a == 0.0) continue;
    vec3 weights = mix(1.0 - fraction, fraction, vec3(step));
    sum += weights.x * weights.y * weights.z * vec4(changeAtNode(node, vec3(count)), 1.0);
  }
  return sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0);
}

// The lower half of the texture: the filter must not reach the upper one.
vec4 valueAt(sampler3D values, float period, vec3 at) {
  vec3 size = vec3(textureSize(values, 0));
  vec3 place = tablePlace(vec3(size.xy, 0.5 * size.z), period, at);
  place.z = min(place.z, 0.5 * size.z - 1.0);
  return texture(values, (place + 0.5) / size);
}
#else
vec4 valueAt(sampler3D values, float period, vec3 at) { return tableAt(values, period, at); }
#endif

#if defined(BLEND_FACTORS)
#define BLEND_CURVES(edit, set, terms, axes) evaluateFactors(factorPlaces(wi, wo, edit, axes), cosines, edit, set, terms, axes)
vec3 changeOfSpace(vec3 wi, vec3 wo, vec3 at) {
  float cosines = wi.z * wo.z;
  return BLEND_FACTORS - (BLEND_FACTOR_PARTS);
}
#elif defined(BLEND_MOVES)
vec3 changeOfSpace(vec3 wi, vec3 wo, vec3 at) {
  vec3 change = EVALUATE_MODEL(wi, wo, targetParameters);
  for (int i = 0; i < BLEND_TABLES; ++i)
    if (blendWeights[i] != 0.0) change -= blendWeights[i] * ownModel(wi, wo, i);
  return change;
}
#endif

// Linear RGB in 1/sr; not below the lowest of the materials, which may be negative in its own form.
vec3 evaluateBlend(vec3 wi, vec3 wo) {
  vec3 at;
  if (!toHalfDifference(wi, wo, at)) return vec3(0.0);
  vec3 values[BLEND_TABLES];
  vec3 sum = vec3(0.0);
  for (int i = 0; i < BLEND_TABLES; ++i) {
    values[i] = vec3(0.0);
    if (blendWeights[i] == 0.0) continue;
    vec4 texel = valueAt(blendTables[i], blendPhiPeriods[i], at);
    if (texel.a > 0.0) values[i] = texel.rgb / texel.a;
#ifdef BLEND_OWN
    if (i == blendOwnIndex) values[i] = mix(values[i], ownForm(wi, wo), blendOwnFraction / blendWeights[i]);
#endif
    sum += blendWeights[i] * values[i];
  }
  vec3 lowest = vec3(3.4e38);
  for (int i = 0; i < BLEND_TABLES; ++i)
    if (blendWeights[i] != 0.0) lowest = min(lowest, mix(sum, values[i], blendBounds[i]));
  vec3 change = changeOfSpace(wi, wo, at);
#ifdef BLEND_BOTH_ORDERS
  change = 0.5 * (change + changeOfSpace(wo, wi, at));
#endif
  return max(lowest, sum + change);
}
#elif defined(BLEND_TRANSFORM)
// The mixture at a node, transformed back; alpha is 0 where no material has data.
vec4 blendAtNode(ivec3 node, vec3 size) {
  vec4 sum = vec4(0.0);
  for (int i = 0; i < BLEND_TABLES; ++i) {
    vec4 texel = texelFetch(blendTables[i], node, 0);
    sum += blendWeights[i] * texel;
  }
  if (sum.a <= 0.0) return vec4(0.0);
  return vec4(inverseTransformed(BLEND_TRANSFORM, max(sum.rgb, vec3(0.0)), nodeCosines(node, size)), 1.0);
}

// Linear RGB in 1/sr; 0 where no material has data. Values are interpolated, as those of a table of the mixture are: in
// the transformed domain they would be lower between the nodes, by far so in a sharp highlight.
vec3 evaluateBlend(vec3 wi, vec3 wo) {
  vec3 at;
  if (!toHalfDifference(wi, wo, at)) return vec3(0.0);
  ivec3 count = textureSize(blendTables[0], 0);
  vec3 place = tablePlace(vec3(count), blendPhiPeriods[0], at);
  ivec3 low = ivec3(place);
  vec3 fraction = place - vec3(low);
  vec4 sum = vec4(0.0);
  for (int corner = 0; corner < 8; ++corner) {
    ivec3 step = ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
    ivec3 node = ivec3((low.x + step.x) % count.x, min(low.yz + step.yz, count.yz - 1));
    vec3 weights = mix(1.0 - fraction, fraction, vec3(step));
    sum += weights.x * weights.y * weights.z * blendAtNode(node, vec3(count));
  }
  return sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0);
}
#else
// Linear RGB in 1/sr; 0 where no material has data.
vec3 evaluateBlend(vec3 wi, vec3 wo) {
  vec3 at;
  if (!toHalfDifference(wi, wo, at)) return vec3(0.0);
#ifdef BLEND_MOVES
  vec3 target = EVALUATE_MODEL(wi, wo, targetParameters);
#endif
  vec3 sum = vec3(0.0);
  for (int i = 0; i < BLEND_TABLES; ++i) {
    if (blendWeights[i] == 0.0) continue;
    vec4 texel = tableAt(blendTables[i], blendPhiPeriods[i], at);
    if (texel.a <= 0.0) continue;
    vec3 value = texel.rgb / texel.a;
#ifdef BLEND_MOVES
    value = max(vec3(0.0), value + (target - ownModel(wi, wo, i)));
#endif
    sum += blendWeights[i] * value;
  }
#ifdef BLEND_OWN
  vec3 own = ownForm(wi, wo);
#ifdef BLEND_MOVES
  own = max(min(own, vec3(0.0)), own + (target - ownModel(wi, wo, blendOwnIndex)));
#endif
  sum += blendOwnFraction * own;
#endif
  return max(sum, vec3(0.0));
}
#endif
