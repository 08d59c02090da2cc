// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/brdf/brdf.h: a measurement that can be read in any order of its directions.
//   INCIDENT_VIEWER, INCIDENT_LIGHT  which directions take the place of the incident one (both: the mean)
#if defined(INCIDENT_VIEWER) || defined(INCIDENT_LIGHT)

// Linear RGB in 1/sr at the file's own directions.
vec3 storedBrdf(vec3 incident, vec3 outgoing);

vec3 storedInOrder(vec3 wi, vec3 wo) {
#if defined(INCIDENT_VIEWER) && defined(INCIDENT_LIGHT)
  return 0.5 * (storedBrdf(wo, wi) + storedBrdf(wi, wo));
#elif defined(INCIDENT_LIGHT)
  return storedBrdf(wi, wo);
#else
  return storedBrdf(wo, wi);
#endif
}
#endif
