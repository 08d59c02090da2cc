// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/rendering/shape.h. Objects are numbered spheres, meshes, rectangles; SPHERES, MESHES and RECTANGLES are
// their counts. Spheres and rectangles are convex: a ray never meets the one that it leaves.
const int firstRectangle = SPHERES + MESHES;
const int OBJECTS = firstRectangle + RECTANGLES;
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
const float nearest = 1e-4;  // no sphere or rectangle counts that lies closer to a ray's start

#if MESHES > 0
#include "preview/scene_meshes.glsl"
#endif

struct Hit {
  int object;  // -1: none
  float t;
#if MESHES > 0
  MeshPoint point;
#endif
};

bool isMesh(int object) { return object >= SPHERES && object < firstRectangle; }

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
  if (object >= firstRectangle) return rectangleDistance(object - firstRectangle, origin, direction);
  return never;
#else
  return never;
#endif
}

// The first object along a ray that does not leave the sphere or rectangle `self`.
Hit firstObject(int self, vec3 origin, vec3 direction) {
  Hit hit;
  hit.object = -1;
  hit.t = never;
  for (int i = 0; i < OBJECTS; ++i) {
    if (i == self || isMesh(i)) continue;
    float distance = objectDistance(i, origin, direction);
    if (distance < hit.t) {
      hit.t = distance;
      hit.object = i;
    }
  }
#if MESHES > 0
  if (meetMeshes(origin, direction, ~0, false, hit.t, hit.point)) hit.object = SPHERES + hit.point.mesh;
#endif
  return hit;
}

vec3 objectNormal(int object, vec3 position) {
#if SPHERES > 0
  if (object < SPHERES) return normalize(position - spheres[object].xyz);
#endif
#if RECTANGLES > 0
  int i = object - firstRectangle;
  return normalize(cross(rectangleSides[2 * i], rectangleSides[2 * i + 1]));
#else
  return vec3(0.0, 0.0, 1.0);
#endif
}

// Columns: tangent, bitangent, normal; on a sphere and a mesh the tangent runs along growing azimuth about +y.
mat3 objectFrame(int object, vec3 n) {
#if RECTANGLES > 0
  if (object >= firstRectangle) {
    vec3 u = normalize(rectangleSides[2 * (object - firstRectangle)]);
    return mat3(u, cross(n, u), n);
  }
#endif
  vec3 tangent = vec3(n.z, 0.0, -n.x);
  float squaredLength = dot(tangent, tangent);
  tangent = squaredLength > 1e-12 ? tangent * inversesqrt(squaredLength) : vec3(1.0, 0.0, 0.0);
  return mat3(tangent, cross(n, tangent), n);
}

// A point of an object, seen.
struct Surface {
  int object;
  vec3 position;  // where rays leave
  mat3 frame;
  vec3 wo;  // local; below the horizon where the inside is seen
#if MESHES > 0
  vec3 geometricNormal;
#endif
};

#if MESHES > 0
// As the reference renderer has it: no black rims where a shading normal turns away from the eye and the surface does
// not; rays start off the surface.
Surface meshSurface(Hit hit, vec3 direction) {
  vec3 position, geometricNormal, normal;
  meshPlace(hit.point, position, geometricNormal, normal);
  bool backFaced = dot(geometricNormal, direction) > 0.0;
  if (!backFaced && dot(normal, direction) >= 0.0) normal = geometricNormal;
  mat3 frame = objectFrame(hit.object, normal);
  vec3 origin = position + geometricNormal * (meshRadii[hit.point.mesh] * 1e-5);
  return Surface(hit.object, origin, frame, backFaced ? vec3(0.0, 0.0, -1.0) : -direction * frame, geometricNormal);
}
#endif

Surface surfaceAt(Hit hit, vec3 origin, vec3 direction) {
#if MESHES > 0
  if (isMesh(hit.object)) return meshSurface(hit, direction);
#endif
  vec3 place = origin + hit.t * direction;
  vec3 normal = objectNormal(hit.object, place);
  mat3 frame = objectFrame(hit.object, normal);
#if MESHES > 0
  return Surface(hit.object, place, frame, -direction * frame, normal);
#else
  return Surface(hit.object, place, frame, -direction * frame);
#endif
}

// Whether a direction (world, and local) leaves the surface to the outside.
bool leaves(Surface surface, vec3 direction, vec3 local) {
#if MESHES > 0
  return local.z > 0.0 && dot(surface.geometricNormal, direction) > 0.0;
#else
  return local.z > 0.0;
#endif
}

#ifdef SHADOWS
uniform int blockers[OBJECTS];  // bit i: object i may stand between this one and a light

bool isBlocked(Surface surface, vec3 direction, float farthest) {
  int bits = blockers[surface.object];
  for (int i = 0; i < OBJECTS; ++i)
    if (!isMesh(i) && (bits & (1 << i)) != 0 && objectDistance(i, surface.position, direction) < farthest) return true;
#if MESHES > 0
  int meshes = (bits >> SPHERES) & ((1 << MESHES) - 1);
  MeshPoint point;
  return meshes != 0 && meetMeshes(surface.position, direction, meshes, true, farthest, point);
#else
  return false;
#endif
}
#else
bool isBlocked(Surface surface, vec3 direction, float farthest) { return false; }
#endif
