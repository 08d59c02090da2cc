// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Materials mixed while a point is dragged between them; only the weights change (and the target that all move to).
// Twin of editing::TransformedMixture and of the blends of core/interpolation that it stands for.
//   BLEND_TABLES     how many
//   BLEND_TRANSFORM  the DataTransform of their values; the mean is transformed back
//   BLEND_MOVES      each is moved by a model first, with EVALUATE_MODEL and MODEL_PARAMETERS: by model(target) -
//                    model(its own parameters)
//   BLEND_OWN        one of them has a part of its weight in its own form, as ownForm() evaluates it
#include "preview/data_transform.glsl"
#include "preview/table.glsl"

uniform sampler3D blendTables[BLEND_TABLES];
uniform float blendPhiPeriods[BLEND_TABLES];
uniform float blendWeights[BLEND_TABLES];
#ifdef BLEND_MOVES
uniform vec3 targetParameters[MODEL_PARAMETERS];
uniform vec3 ownParameters[BLEND_TABLES * MODEL_PARAMETERS];

vec3 ownModel(vec3 wi, vec3 wo, int material) {
  vec3 parameters[MODEL_PARAMETERS];
  for (int i = 0; i < MODEL_PARAMETERS; ++i) parameters[i] = ownParameters[material * MODEL_PARAMETERS + i];
  return EVALUATE_MODEL(wi, wo, parameters);
}
#endif

#ifdef BLEND_OWN
uniform float blendOwnShare;  // of the sum; blendWeights are without it
uniform int blendOwnIndex;
vec3 ownForm(vec3 wi, vec3 wo);
#endif

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
  sum += blendOwnShare * own;
#endif
  return inverseTransformed(BLEND_TRANSFORM, max(sum, vec3(0.0)), wi.z * wo.z);
}
