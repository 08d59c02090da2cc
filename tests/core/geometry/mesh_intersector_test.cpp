// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/geometry/mesh_intersector.h"

#include <QTest>
#include <limits>

#include "core/math/parallel.h"
#include "core/support/error.h"
#include "tests/support/simple_meshes.h"
#include "tests/support/test_program.h"

namespace mesh_intersector_test {
using namespace gonio;
using namespace gonio::geometry;
using namespace gonio::test;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// By Möller and Trumbore 1997 over all triangles, in double: the least t > 0, infinite where there is none. `margin`
/// is the least fraction of an edge by which the ray passes any edge of a triangle that it comes near.
struct PlainHit {
  double t = infinity, margin = infinity;
  std::size_t triangle = 0;
};
PlainHit plainClosest(const TriangleMesh& mesh, const glm::dvec3& origin, const glm::dvec3& direction) {
  PlainHit best;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    const TriangleIndices& triangle = mesh.triangles()[i];
    const glm::dvec3 a(mesh.positions()[triangle[0]]),
        ab = glm::dvec3(mesh.positions()[triangle[1]]) - a, ac = glm::dvec3(mesh.positions()[triangle[2]]) - a,
        p = glm::cross(direction, ac), arm = origin - a, q = glm::cross(arm, ab);
    const double determinant = glm::dot(ab, p), u = glm::dot(arm, p) / determinant,
                 v = glm::dot(direction, q) / determinant, t = glm::dot(ac, q) / determinant;
    const double inside = std::min({u, v, 1 - u - v});
    if (!(t > 0)) continue;
    best.margin = std::min(best.margin, std::abs(inside));
    if (inside >= 0 && t < best.t) best.t = t, best.triangle = i;
  }
  return best;
}

/// Rays from a sphere of `distance` radii that pass through the bounding sphere.
struct Ray {
  glm::dvec3 origin, direction;
};
Ray randomRay(const TriangleMesh& mesh, double distance, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0.2, 5);
  const auto& [centre, radius] = mesh.boundingSphere();
  const glm::dvec3 origin = centre + distance * radius * randomDirection(random);
  const glm::dvec3 target = centre + radius * std::cbrt(uniform(random) / 5) * randomDirection(random);
  return {origin, uniform(random) * glm::normalize(target - origin)};
}

void checkAgainstPlain(const TriangleMesh& mesh, double distance, int rays) {
  const MeshIntersector intersector(shared(mesh));
  std::mt19937_64 random(7);
  int hits = 0, unclear = 0;
  for (int n = 0; n < rays; ++n) {
    const Ray ray = randomRay(mesh, distance, random);
    const PlainHit plain = plainClosest(mesh, ray.origin, ray.direction);
    // Through an edge or past a silhouette by less than single precision distinguishes: either answer is right.
    if (plain.margin < 1e-4) {
      ++unclear;
      continue;
    }
    const auto hit = intersector.closest(ray.origin, ray.direction, 0, infinity);
    QCOMPARE(hit.has_value(), plain.t < infinity);
    QCOMPARE(intersector.occluded(ray.origin, ray.direction, 0, infinity), hit.has_value());
    if (!hit) continue;
    ++hits;
    QCOMPARE(std::size_t(hit->triangle), plain.triangle);
    const double size = mesh.boundingSphere().radius * distance;
    QVERIFY(std::abs(hit->t - plain.t) * glm::length(ray.direction) < 1e-9 * size);
    QVERIFY(glm::length(ray.origin + hit->t * ray.direction - hit->position) < 1e-9 * size);
    QVERIFY(hit->u >= 0 && hit->v >= 0 && hit->u + hit->v <= 1 + 1e-15);
    QVERIFY(glm::length(hit->geometricNormal - mesh.geometricNormal(hit->triangle)) < 1e-15);
    QVERIFY(std::abs(glm::length(hit->shadingNormal) - 1) < 1e-12);
    QVERIFY(glm::dot(hit->shadingNormal, hit->geometricNormal) > 0);
  }
  QVERIFY(hits > rays / 4);
  QVERIFY(unclear < rays / 2);
}

class MeshIntersectorTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void hitsAreThoseOfAllTriangles() {
    const TriangleMesh sphere = sphereMesh(1, 12, 24);
    checkAgainstPlain(sphere, 2, 4000);
    checkAgainstPlain(sphere, 0.3, 2000);
    checkAgainstPlain(TriangleMesh(cubeArrays()), 3, 4000);
    checkAgainstPlain(torusMesh(), 2, 300);
  }

  /// Neither the size of a mesh, nor its place, nor a far eye costs accuracy.
  void sizePlaceAndDistanceDoNotMatter() {
    const TriangleMesh sphere = sphereMesh(1, 12, 24);
    checkAgainstPlain(transformed(sphere, placement(1e-20, 0.2, {0, 0, 0})), 2, 1000);
    checkAgainstPlain(transformed(sphere, placement(1e20, 0.2, {0, 0, 0})), 2, 1000);
    checkAgainstPlain(transformed(sphere, placement(1, 0.2, {1000, -2000, 500})), 2, 1000);
    checkAgainstPlain(sphere, 1e6, 1000);
  }

  void theShadingNormalIsInterpolated() {
    const TriangleMesh mesh = sphereMesh(1, 40, 80);
    const MeshIntersector intersector(shared(mesh));
    std::mt19937_64 random(3);
    for (int n = 0; n < 2000; ++n) {
      const Direction d = randomDirection(random);
      const auto hit = intersector.closest({0, 0, 0}, d, 0, infinity);
      QVERIFY(hit && glm::length(hit->shadingNormal - d) < 5e-3);
      QVERIFY(glm::length(hit->position - hit->t * d) < 1e-14);
    }
  }

  void aShadingNormalPointsOutward() {
    MeshArrays arrays{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}};
    arrays.normals = {{0, 0, 1}, {0, 0.9f, -0.1f}, {0, 0, 1}};
    const MeshIntersector intersector(shared(TriangleMesh(arrays)));
    const auto hit = intersector.closest({0.98, 0.01, 1}, {0, 0, -1}, 0, infinity);
    QVERIFY(hit);
    QCOMPARE(hit->shadingNormal, Direction(0, 0, 1));
    const auto behind = intersector.closest({0.3, 0.3, -1}, {0, 0, 1}, 0, infinity);
    QVERIFY(behind);
    QCOMPARE(behind->geometricNormal, Direction(0, 0, 1));
  }

  /// From inside a closed mesh every ray meets it, also when it is aimed at an edge. Where it is aimed at a vertex,
  /// single precision may take it past each of the triangles about it, once in some ten thousand times.
  void closedMeshesDoNotLeak() {
    for (const TriangleMesh& mesh : {TriangleMesh(cubeArrays()), sphereMesh(1, 16, 32),
                                     transformed(sphereMesh(1, 16, 32), placement(3e4, 0.7, {2e4, 1e4, -3e4}))}) {
      const MeshIntersector intersector(shared(mesh));
      std::mt19937_64 random(5);
      std::uniform_real_distribution<double> uniform(0, 1);
      const auto& [centre, radius] = mesh.boundingSphere();
      int leaks = 0;
      for (int n = 0; n < 50000; ++n) {
        const glm::dvec3 origin = centre + 0.5 * radius * uniform(random) * randomDirection(random);
        const TriangleIndices& triangle = mesh.triangles()[random() % mesh.triangles().size()];
        const glm::dvec3 a(mesh.positions()[triangle[0]]), b(mesh.positions()[triangle[1]]);
        for (const glm::dvec3& d : {randomDirection(random), glm::mix(a, b, uniform(random)) - origin}) {
          QVERIFY(intersector.closest(origin, d, 0, infinity));
          QVERIFY(intersector.occluded(origin, d, 0, infinity));
        }
        leaks += !intersector.closest(origin, a - origin, 0, infinity);
      }
      QVERIFY(leaks <= 10);
    }
  }

  /// What leaves a convex mesh to the outside never meets it, up to grazing directions.
  void convexMeshesDoNotShadowThemselves() {
    for (const TriangleMesh& mesh : {TriangleMesh(cubeArrays()), sphereMesh(1, 60, 120),
                                     transformed(sphereMesh(1, 60, 120), placement(1e-6, 0.1, {0, 0, 0})),
                                     transformed(sphereMesh(1, 60, 120), placement(1e5, 0.1, {2e5, 1e5, 0}))}) {
      QVERIFY(mesh.isConvex());
      const MeshIntersector intersector(shared(mesh));
      std::mt19937_64 random(6);
      for (int n = 0; n < 100000; ++n) {
        const Ray ray = randomRay(mesh, 3, random);
        const auto hit = intersector.closest(ray.origin, ray.direction, 0, infinity);
        if (!hit) continue;
        Direction outward = randomDirection(random);
        const double up = glm::dot(outward, hit->geometricNormal);
        // Every other direction is within 1e-3 of grazing.
        outward += ((n % 2 ? 1e-3 : 1.0) * std::abs(up) - up) * hit->geometricNormal;
        const glm::dvec3 start = offsetOrigin(hit->position, hit->geometricNormal, mesh.boundingSphere().radius);
        QVERIFY(!intersector.occluded(start, outward, 0, infinity));
      }
    }
  }

  void limitsCount() {
    const MeshIntersector intersector(shared(TriangleMesh(cubeArrays())));
    const glm::dvec3 origin(0.3, 0.2, 5), direction(0, 0, -2);
    QCOMPARE(intersector.closest(origin, direction, 0, infinity)->t, 2.0);
    QCOMPARE(intersector.closest(origin, direction, 2.1, infinity)->t, 3.0);
    QVERIFY(!intersector.closest(origin, direction, 0, 1.9));
    QVERIFY(!intersector.closest(origin, direction, 3.1, infinity));
    QVERIFY(!intersector.closest(origin, direction, 2.1, 2.9));
    QVERIFY(!intersector.occluded(origin, direction, 0, 1.9) && !intersector.occluded(origin, direction, 2.1, 2.9));
    QVERIFY(intersector.occluded(origin, direction, 0, 2.1));
    QVERIFY(!intersector.closest(origin, -direction, 0, infinity));
    QVERIFY(!intersector.closest(origin, {1, 0, 0}, 0, infinity));
    QVERIFY(!intersector.closest({std::nan(""), 0, 0}, direction, 0, infinity));
  }

  void degenerateTrianglesAreNotMet() {
    MeshArrays arrays = cubeArrays();
    arrays.positions.emplace_back(0, 0, 3);
    arrays.positions.emplace_back(0, 2, 3);
    arrays.triangles.insert(arrays.triangles.begin(), {8, 9, 9});
    const MeshIntersector intersector(shared(TriangleMesh(arrays)));
    const auto hit = intersector.closest({0, 1e-9, 5}, {0, 0, -1}, 0, infinity);
    QVERIFY(hit && hit->triangle < 12);
    QVERIFY(std::abs(hit->t - 4) < 1e-12);
  }

  /// Through edges too, where two triangles are met at once: the same bits from two builds, for any number of threads.
  void theSameBitsEveryTime() {
    const auto mesh = bundledMesh("shader-ball");
    const auto trace = [&](int threads) {
      const ThreadLimit limit(threads);
      const MeshIntersector intersector(mesh);
      constexpr std::size_t rays = 40000;
      std::vector<MeshHit> hits(rays);
      parallelForBlocks(rays, 500, [&](std::size_t begin, std::size_t end) {
        std::mt19937_64 random(begin);
        for (std::size_t n = begin; n < end; ++n) {
          const Ray ray = randomRay(*mesh, 2, random);
          const TriangleIndices& triangle = mesh->triangles()[random() % mesh->triangles().size()];
          const glm::dvec3 middle =
              0.5 * (glm::dvec3(mesh->positions()[triangle[0]]) + glm::dvec3(mesh->positions()[triangle[1]]));
          const auto hit = intersector.closest(ray.origin, n % 2 ? ray.direction : middle - ray.origin, 0, infinity);
          if (hit) hits[n] = *hit;
        }
      });
      return hits;
    };
    const std::vector<MeshHit> one = trace(1), again = trace(1), four = trace(4);
    for (std::size_t n = 0; n < one.size(); ++n)
      for (const auto& other : {again[n], four[n]}) {
        QCOMPARE(other.triangle, one[n].triangle);
        QVERIFY(other.t == one[n].t && other.position == one[n].position &&
                other.shadingNormal == one[n].shadingNormal);
      }
  }
};

GONIO_TEST(MeshIntersectorTest)
}  // namespace mesh_intersector_test

#include "mesh_intersector_test.moc"
