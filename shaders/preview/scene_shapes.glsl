// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/rendering/shape.h for spheres and rectangles: objects are numbered spheres first. SPHERES and RECTANGLES
// are their counts. All are convex: a ray never meets the object that it leaves.
const int OBJECTS = SPHERES + RECTANGLES;
#if SPHERES > 0
uniform vec4 spheres[SPHERES];  // centre, radius
#endif
#if RECTANGLES > 0
uniform vec3 rectangleCentres[RECTANGLES];
uniform vec3 rectangleSides[2 * RECTANGLES];  // half sides u, v
#endif
// Reflectance of a Lambertian object, or radiance of one that emits; in w what it is.
uniform vec4 objectColours[OBJECTS];
const float materialSlot = 0.0, diffuse = 1.0, emitting = 2.0;

const float never = 3.0e38;
const float nearest = 1e-4;  // nothing counts that lies closer to a ray's start

float sphereDistance(vec4 sphere, vec3 origin, vec3 direction) {
  vec3 toOrigin = origin - sphere.xyz;
  float middle = -dot(toOrigin, direction);
  // The squared distance of the ray from the centre: no cancellation however far the eye is.
  vec3 closest = toOrigin + middle * direction;
  float discriminant = sphere.w * sphere.w - dot(closest, closest);
  if (discriminant < 0.0) return never;
  float t = middle - sqrt(discriminant);
  return t > nearest ? t : never;
}

#if RECTANGLES > 0
float rectangleDistance(int i, vec3 origin, vec3 direction) {
  vec3 u = rectangleSides[2 * i], v = rectangleSides[2 * i + 1];
  vec3 normal = cross(u, v);
  float slope = dot(normal, direction);
  if (slope == 0.0) return never;
  float t = dot(normal, rectangleCentres[i] - origin) / slope;
  vec3 offset = origin + t * direction - rectangleCentres[i];
  bool inside = abs(dot(offset, u)) <= dot(u, u) && abs(dot(offset, v)) <= dot(v, v);
  return t > nearest && inside ? t : never;
}
#endif

float objectDistance(int object, vec3 origin, vec3 direction) {
#if SPHERES > 0
  if (object < SPHERES) return sphereDistance(spheres[object], origin, direction);
#endif
#if RECTANGLES > 0
  return rectangleDistance(object - SPHERES, origin, direction);
#else
  return never;
#endif
}

// The first object along a ray that does not leave `self`; -1 where there is none.
int firstObject(int self, vec3 origin, vec3 direction, out float t) {
  int found = -1;
  t = never;
  for (int i = 0; i < OBJECTS; ++i) {
    if (i == self) continue;
    float distance = objectDistance(i, origin, direction);
    if (distance < t) {
      t = distance;
      found = i;
    }
  }
  return found;
}

vec3 objectNormal(int object, vec3 position) {
#if SPHERES > 0
  if (object < SPHERES) return normalize(position - spheres[object].xyz);
#endif
#if RECTANGLES > 0
  return normalize(cross(rectangleSides[2 * (object - SPHERES)], rectangleSides[2 * (object - SPHERES) + 1]));
#else
  return vec3(0.0, 0.0, 1.0);
#endif
}

// Columns: tangent, bitangent, normal; on a sphere the tangent runs along growing azimuth about +y.
mat3 objectFrame(int object, vec3 n) {
#if RECTANGLES > 0
  if (object >= SPHERES) {
    vec3 u = normalize(rectangleSides[2 * (object - SPHERES)]);
    return mat3(u, cross(n, u), n);
  }
#endif
  vec3 tangent = vec3(n.z, 0.0, -n.x);
  float squaredLength = dot(tangent, tangent);
  tangent = squaredLength > 1e-12 ? tangent * inversesqrt(squaredLength) : vec3(1.0, 0.0, 0.0);
  return mat3(tangent, cross(n, tangent), n);
}

#ifdef SHADOWS
uniform int blockers[OBJECTS];  // bit i: object i may stand between this one and a light

bool isBlocked(int object, vec3 origin, vec3 direction, float farthest) {
  for (int i = 0; i < OBJECTS; ++i)
    if ((blockers[object] & (1 << i)) != 0 && objectDistance(i, origin, direction) < farthest) return true;
  return false;
}
#else
bool isBlocked(int object, vec3 origin, vec3 direction, float farthest) { return false; }
#endif
