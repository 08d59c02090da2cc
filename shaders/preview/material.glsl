// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// What is looked at: a measured table or RGL file with or without edits, a model alone, or a blend. The definitions are listed in
// preview/scene.frag.
// A file is put where it is first included: what several variants share comes before what only one has.
#include "half_difference.glsl"
#include "preview/marginal_warp.glsl"
#include "preview/normal_square.glsl"
#ifdef RGL_THETAS
#include "preview/rgl.glsl"
#elif !defined(MODEL_ALONE)
#include "preview/table.glsl"
#endif
#ifndef MODEL_ALONE
#include "preview/data_transform.glsl"
#endif
#ifdef BLEND_TABLES
#include "preview/blend.glsl"
#endif
#ifdef FACTOR_EDITS
#include "preview/factors.glsl"
#endif
#ifdef MODEL_ALONE
uniform vec3 modelParameters[MODEL_PARAMETERS];
#endif

// The steps that widgets/preview/gl/edit_chain puts together, each with the clamp of editing::applyEdits().
#ifdef EDIT_STEPS
EDIT_UNIFORMS
#define MODEL_STEP(model, edited, fitted, strength) value = max(vec3(0.0), value + strength * (model(wi, wo, edited) - model(wi, wo, fitted)));
#define FACTOR_STEP(edit, terms, axes, keepDetail, strength) value = editedByFactors(value, wi, wo, edit, terms, axes, keepDetail, strength);
#endif

vec3 evaluateBrdf(vec3 wi, vec3 wo) {
  if (wi.z <= 0.0 || wo.z <= 0.0) return vec3(0.0);
#ifdef BLEND_TABLES
  return evaluateBlend(wi, wo);
#elif defined(MODEL_ALONE)
  return EVALUATE_MODEL(wi, wo, modelParameters);
#else
#ifdef RGL_THETAS
  const bool valid = true;
  vec3 value = evaluateRgl(wi, wo);
#else
  bool valid;
  vec3 value = evaluateTable(wi, wo, valid);
#endif
#ifdef EDIT_STEPS
  if (valid) {
    EDIT_STEPS
  }
#endif
  return value;
#endif
}
