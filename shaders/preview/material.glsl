// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// What is looked at: a measured table with or without its edits, a model alone, or a blend. The definitions are told in
// preview/scene.frag.
// A file is put where it is first included: what several variants share comes before what only one has.
#include "half_difference.glsl"
#ifndef MODEL_ALONE
#include "preview/table.glsl"
#include "preview/data_transform.glsl"
#endif
#ifdef BLEND_TABLES
#include "preview/blend.glsl"
#endif
#ifdef EDIT_FACTORS
#include "preview/factors.glsl"
#endif

#ifdef EDIT_MODEL
uniform vec3 editedParameters[MODEL_PARAMETERS];
uniform vec3 fittedParameters[MODEL_PARAMETERS];
uniform float editStrength;
#endif
#ifdef EDIT_FACTORS
uniform float factorStrength;
#endif
#ifdef MODEL_ALONE
uniform vec3 modelParameters[MODEL_PARAMETERS];
#endif

vec3 evaluateBrdf(vec3 wi, vec3 wo) {
  if (wi.z <= 0.0 || wo.z <= 0.0) return vec3(0.0);
#ifdef BLEND_TABLES
  return evaluateBlend(wi, wo);
#elif defined(MODEL_ALONE)
  return EVALUATE_MODEL(wi, wo, modelParameters);
#else
  bool valid;
  vec3 value = evaluateTable(wi, wo, valid);
#ifdef EDIT_FACTORS
  if (valid) {
    vec3 places = factorPlaces(wi, wo);
    float cosines = wi.z * wo.z;
    vec3 edited = evaluateFactors(places, cosines, 0);
#ifdef KEEP_DETAIL
    vec3 from = evaluateFactors(places, cosines, 1);
#else
    vec3 from = value;
#endif
    value = max(vec3(0.0), value + factorStrength * (edited - from));
  }
#endif
#ifdef EDIT_MODEL
  if (valid) {
    vec3 change = EVALUATE_MODEL(wi, wo, editedParameters) - EVALUATE_MODEL(wi, wo, fittedParameters);
    value = max(vec3(0.0), value + editStrength * change);
  }
#endif
  return value;
#endif
}
