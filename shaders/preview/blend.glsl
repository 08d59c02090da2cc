// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Materials mixed while a point is dragged between them; only the weights change (and the target that all move to).
// Twin of editing::TransformedMixture and of the blends of core/interpolation that it stands for.
//   BLEND_TABLES     how many
//   BLEND_IN_TRANSFORMED_DOMAIN  their values are transformed, by the DataTransform BLEND_TRANSFORM
//   BLEND_MOVES      each is moved by a model first, with EVALUATE_MODEL and MODEL_PARAMETERS: by model(target) -
//                    model(its own parameters)
//   BLEND_OWN        one of them has a part of its weight in its own form, as ownForm() evaluates it
#include "preview/data_transform.glsl"
#include "preview/table.glsl"

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

#ifdef BLEND_IN_TRANSFORMED_DOMAIN
// Product of the cosines of both directions at a node of the grid.
float nodeCosines(ivec3 node, vec3 size) {
  float thetaH = float(node.z * node.z) / (size.z * size.z) * (0.5 * pi);
  float thetaD = float(node.y) / size.y * (0.5 * pi);
  float middle = cos(thetaH) * cos(thetaD);
  float side = sin(thetaH) * sin(thetaD) * cos(float(node.x) / size.x * blendPhiPeriods[0]);
  return middle * middle - side * side;
}

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
