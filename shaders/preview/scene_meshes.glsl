// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/geometry/mesh_intersector.h: rays against the triangles of all meshes of a scene, by the bounding volumes
// of core/geometry/mesh_intersector.h. widgets/preview/gl/mesh_texture.cpp has the layout.
uniform usampler2D meshTexels;
uniform int meshTriangles, meshNormals;  // the first texel of each part; the nodes begin at 0
uniform float meshRadii[MESHES];         // of the bounding spheres

const int meshRowBits = 11;      // a row has 2^11 texels
const int mostMeshNodes = 48;    // that wait on a ray's way
const uint emptyMeshChild = 7u;  // in the place of a leaf's count, which is 4 at most; 0 is a node

struct MeshPoint {
  int mesh, triangle;
  vec2 weights;  // of the second and third corner
};

uvec4 meshTexel(int i) { return texelFetch(meshTexels, ivec2(i & ((1 << meshRowBits) - 1), i >> meshRowBits), 0); }
vec3 meshVector(int i) { return uintBitsToFloat(meshTexel(i).xyz); }

// Where a ray enters a box; `never` where it passes by or comes after `farthest`.
float boxDistance(vec3 low, vec3 high, vec3 origin, vec3 inverse, float farthest) {
  vec3 a = (low - origin) * inverse, b = (high - origin) * inverse;
  vec3 enters = min(a, b), leaves = max(a, b);
  float from = max(max(enters.x, enters.y), max(enters.z, 0.0));
  float to = min(min(leaves.x, leaves.y), min(leaves.z, farthest));
  return from <= to * 1.000001 ? from : never;
}

// Shortens t to the distance of a triangle of one of `meshes` (bits) that is nearer. Möller and Trumbore 1997, with a
// margin that closes the gaps between neighbours.
bool meetTriangle(int triangle, vec3 origin, vec3 direction, int meshes, inout float t, inout MeshPoint point) {
  const float margin = 1e-6;
  uvec4 corner = meshTexel(meshTriangles + 3 * triangle);
  if (((meshes >> int(corner.w)) & 1) == 0) return false;
  vec3 ab = meshVector(meshTriangles + 3 * triangle + 1), ac = meshVector(meshTriangles + 3 * triangle + 2);
  vec3 p = cross(direction, ac), arm = origin - uintBitsToFloat(corner.xyz), q = cross(arm, ab);
  float scale = 1.0 / dot(ab, p);
  vec2 weights = vec2(dot(arm, p), dot(direction, q)) * scale;
  float distance = dot(ac, q) * scale;
  bool inside = weights.x >= -margin && weights.y >= -margin && weights.x + weights.y <= 1.0 + margin;
  if (!(inside && distance > 0.0 && distance < t)) return false;
  t = distance;
  point = MeshPoint(int(corner.w), triangle, weights);
  return true;
}

// Shortens t to the nearest triangle of `meshes` (bits) on a ray's way; with `any`, to one that is nearer than t.
bool meetMeshes(vec3 origin, vec3 direction, int meshes, bool any, inout float t, out MeshPoint point) {
  point = MeshPoint(-1, 0, vec2(0.0));
  vec3 safe = mix(direction, vec3(1e-12), lessThan(abs(direction), vec3(1e-12)));
  vec3 inverse = 1.0 / safe;
  uint links[mostMeshNodes];
  float entries[mostMeshNodes];
  int waiting = 1;
  links[0] = 0u;
  entries[0] = 0.0;
  bool found = false;
  while (waiting > 0) {
    --waiting;
    uint link = links[waiting];
    if (entries[waiting] > t) continue;
    int first = int(link >> 3u), count = int(link & 7u);
    if (count > 0) {
      for (int i = 0; i < count; ++i)
        found = meetTriangle(first + i, origin, direction, meshes, t, point) || found;
      if (any && found) return true;
      continue;
    }
    uvec4 low0 = meshTexel(4 * first), high0 = meshTexel(4 * first + 1);
    uvec4 low1 = meshTexel(4 * first + 2), high1 = meshTexel(4 * first + 3);
    float entry0 = boxDistance(uintBitsToFloat(low0.xyz), uintBitsToFloat(high0.xyz), origin, inverse, t);
    float entry1 = boxDistance(uintBitsToFloat(low1.xyz), uintBitsToFloat(high1.xyz), origin, inverse, t);
    if ((low1.w & 7u) == emptyMeshChild) entry1 = never;
    bool firstIsNearer = entry0 <= entry1;
    float near = firstIsNearer ? entry0 : entry1, far = firstIsNearer ? entry1 : entry0;
    if (far < never) {
      links[waiting] = firstIsNearer ? low1.w : low0.w;
      entries[waiting] = far;
      ++waiting;
    }
    if (near < never) {
      links[waiting] = firstIsNearer ? low0.w : low1.w;
      entries[waiting] = near;
      ++waiting;
    }
  }
  return found;
}

// Where a ray has met a triangle, with the normals of its plane and of its shading.
void meshPlace(MeshPoint point, out vec3 position, out vec3 geometricNormal, out vec3 shadingNormal) {
  int triangle = meshTriangles + 3 * point.triangle, normals = meshNormals + 3 * point.triangle;
  vec2 w = max(point.weights, vec2(0.0));
  w /= max(1.0, w.x + w.y);
  vec3 ab = meshVector(triangle + 1), ac = meshVector(triangle + 2);
  position = meshVector(triangle) + w.x * ab + w.y * ac;
  geometricNormal = normalize(cross(ab, ac));
  shadingNormal = (1.0 - w.x - w.y) * meshVector(normals) + w.x * meshVector(normals + 1) + w.y * meshVector(normals + 2);
  shadingNormal = dot(shadingNormal, geometricNormal) > 0.0 ? normalize(shadingNormal) : geometricNormal;
}
