// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// What is looked at: a measurement in its own form with or without edits, a model alone, or a blend. The definitions are listed in
// preview/scene.frag.
// A file is put where it is first included: what several variants share comes before what only one has.
#include "grain.glsl"
#include "half_difference.glsl"
#include "preview/incident_direction.glsl"
#include "preview/marginal_warp.glsl"
#include "preview/normal_square.glsl"
#if defined(RGL_THETAS) || defined(UTIA) || defined(INCIDENCE_TABLE) || defined(MODEL_ALONE) || defined(FACTOR_BASE_TERMS)
#define OTHER_FORM
#endif
#if defined(BLEND_TABLES) || !defined(OTHER_FORM)
#include "preview/table.glsl"
#endif
#ifdef RGL_THETAS
#include "preview/rgl.glsl"
#elif defined(UTIA)
#include "preview/utia.glsl"
#elif defined(INCIDENCE_TABLE)
#include "preview/incidence_table.glsl"
#endif
#include "preview/data_transform.glsl"
#ifdef FACTOR_EDITS
#include "preview/factors.glsl"
#endif
#ifdef BLEND_TABLES
#include "preview/blend.glsl"
#endif
#ifdef BLEND_OWN
vec3 ownForm(vec3 wi, vec3 wo) {
#ifdef UTIA
  bool valid;
  return evaluateUtia(wi, wo, valid);
#else
  return storedInOrder(wi, wo);
#endif
}
#endif
#ifdef MODEL_ALONE
MODEL_UNIFORM
#endif

// What is looked at without edits. `valid`: whether the value is known.
vec3 measuredBrdf(vec3 wi, vec3 wo, out bool valid) {
  valid = true;
  if (wi.z <= 0.0 || wo.z <= 0.0) return vec3(0.0);
#ifdef BLEND_TABLES
  return evaluateBlend(wi, wo);
#elif defined(MODEL_ALONE)
  return EVALUATE_MODEL(wi, wo, modelParameters);
#elif defined(RGL_THETAS)
  return storedInOrder(wi, wo);
#elif defined(UTIA)
  return evaluateUtia(wi, wo, valid);
#elif defined(INCIDENCE_TABLE)
  return evaluateIncidenceTable(wi, wo, valid);
#elif defined(FACTOR_BASE_TERMS)
  return evaluateFactors(factorPlaces(wi, wo, 0, FACTOR_BASE_AXES), wi.z * wo.z, 0, 0, FACTOR_BASE_TERMS, FACTOR_BASE_AXES);
#else
  return evaluateTable(wi, wo, valid);
#endif
}

// The same at directions that came from `wi` and `wo` by a turn in the plane of the normal and the half vector.
vec3 measuredInPlane(vec3 wi, vec3 wo, vec3 movedIn, vec3 movedOut, out bool valid) {
#if defined(OTHER_FORM) || defined(BLEND_TABLES)
  return measuredBrdf(movedIn, movedOut, valid);
#else
  return evaluateTableInPlane(wi, wo, movedIn + movedOut, valid);
#endif
}

// The stages that widgets/preview/gl/edit_chain puts together, functions that each call the one before: either steps that
// look at one pair of directions, with the clamp of editing::applyEdits(), or one edit that is composed by lobes.
#ifdef EDIT_STAGES
#ifdef LOBE_EDITS
#include "preview/lobe_warp.glsl"
#endif
vec3 withChange(vec3 value, vec3 change) { return max(min(value, vec3(0.0)), value + change); }
// Twin of core/editing/differential_edit.h.
vec3 logPlusChange(vec3 value, vec3 edited, vec3 fitted) { return (1.0 + max(value, vec3(0.0))) * ((edited - fitted) / (1.0 + fitted)); }
EDIT_UNIFORMS
#define FACTOR_STEP(edit, terms, axes, keepDetail, strength) value = editedByFactors(value, wi, wo, edit, terms, axes, keepDetail, strength);
#define ADDITIVE_STEP(model, edited, fitted, strength) value = withChange(value, strength * (model(wi, wo, edited) - model(wi, wo, fitted)));
#define LOG_PLUS_STEP(model, edited, fitted, strength) value = withChange(value, strength * logPlusChange(value, model(wi, wo, edited), model(wi, wo, fitted)));
#define COLOUR_STEP(colours, strength) value = withChange(value, strength * (colours * value - value));
#define STEPS(name, previous, steps) vec3 name(vec3 wi, vec3 wo, out bool valid) { vec3 value = previous(wi, wo, valid); if (valid) { steps } return value; }
EDIT_STAGES
#else
#define LAST_STAGE measuredBrdf
#endif

vec3 evaluateBrdf(vec3 wi, vec3 wo) {
  bool valid;
  return LAST_STAGE(wi, wo, valid);
}
