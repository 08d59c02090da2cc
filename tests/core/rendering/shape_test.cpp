// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/shape.h"

#include <QTest>
#include <cmath>
#include <limits>

#include "tests/support/random_scenes.h"
#include "tests/support/simple_meshes.h"
#include "tests/support/test_program.h"

namespace shape_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::geometry;
using namespace gonio::test;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<Shape> someShapes() {
  return {Sphere{{0.3, -0.2, 0.1}, 0.8},
          Sphere{{1e3, 2e3, -1e3}, 700},
          Sphere{{1e-3, 0, 0}, 1e-5},
          Rectangle{{0, 0.5, 0}, {1, 0, 0.5}, {-0.3, 0.4, 0.6}},
          Rectangle{{0, -1, 0}, {0, 0, 1e4}, {1e4, 0, 0}},
          meshShape(TriangleMesh(cubeArrays())),
          meshShape(torusMesh()),
          meshShape(shaderBallMesh()),
          meshShape(transformed(bowlMesh(), placement(300, 0.4, {50, -20, 900})))};
}

/// From around the shape toward a place within its bounding sphere.
Ray randomRay(const Shape& shape, double distance, std::mt19937_64& random) {
  const Sphere bound = boundingSphere(shape);
  const Direction origin = bound.centre + distance * bound.radius * randomDirection(random);
  const Direction target = bound.centre + std::cbrt(uniform(random)) * bound.radius * randomDirection(random);
  return {origin, glm::normalize(target - origin)};
}

class ShapeTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The distance from the centre is the radius at both meetings, by the quadratic's other form; none where the
  /// centre is farther from the ray than the radius.
  void spheresAreMetWhereTheyLie() {
    std::mt19937_64 random(1);
    for (int n = 0; n < 20000; ++n) {
      const Sphere sphere{uniform(random) * randomDirection(random), 0.1 + uniform(random)};
      const Ray ray{3 * uniform(random) * randomDirection(random), randomDirection(random)};
      const Direction offset = ray.origin - sphere.centre;
      const double distance = glm::length(glm::cross(offset, ray.direction));
      if (std::abs(distance - sphere.radius) < 1e-9) continue;
      const double near = nearestDistance(sphere, ray, 0, infinity);
      QCOMPARE(blocks(sphere, ray, 0, infinity), std::isfinite(near));
      if (!std::isfinite(near)) {
        const bool away = glm::length(offset) > sphere.radius && glm::dot(offset, ray.direction) > 0;
        QVERIFY(distance > sphere.radius || away);
        continue;
      }
      QVERIFY(near > 0 && distance < sphere.radius);
      QVERIFY(std::abs(glm::length(offset + near * ray.direction) - sphere.radius) < 1e-12 * (3 + near));
      // From outside the nearer of both, from inside the only one ahead.
      const bool enters = glm::dot(offset + near * ray.direction, ray.direction) < 0;
      QCOMPARE(enters, glm::length(offset) > sphere.radius);
      QVERIFY(nearestDistance(sphere, ray, 0, near * (1 - 1e-9)) == infinity);
      const double far = nearestDistance(sphere, ray, near * (1 + 1e-9), infinity);
      QVERIFY(enters ? far > near && far < infinity : far == infinity);
    }
  }

  /// Two triangles, by Cramer's rule.
  void rectanglesAreMetWhereTheyLie() {
    std::mt19937_64 random(2);
    int met = 0;
    for (int n = 0; n < 20000; ++n) {
      const Rectangle rectangle = randomRectangle(random, 1);
      const Ray ray{2 * uniform(random) * randomDirection(random), randomDirection(random)};
      const glm::dmat3 axes(rectangle.halfU, rectangle.halfV, -ray.direction);
      const glm::dvec3 place = glm::inverse(axes) * (ray.origin - rectangle.centre);
      const double margin = 1 - std::max(std::abs(place.x), std::abs(place.y));
      if (std::abs(margin) < 1e-9 || std::abs(place.z) < 1e-9) continue;
      const double t = nearestDistance(rectangle, ray, 0, infinity);
      QCOMPARE(std::isfinite(t), margin > 0 && place.z > 0);
      QCOMPARE(blocks(rectangle, ray, 0, infinity), std::isfinite(t));
      if (!std::isfinite(t)) continue;
      ++met;
      QVERIFY(std::abs(t - place.z) < 1e-9 * (1 + place.z));
      const ShapeHit hit = shapeHit(rectangle, ray, t);
      QVERIFY(glm::length(hit.position - rectangle.at(place.x, place.y)) < 1e-9);
      QVERIFY(glm::length(hit.geometricNormal - rectangle.normal()) < 1e-15);
    }
    QVERIFY(met > 500);
  }

  /// What was found near is found again with its normals, however near, far or grazing; and from there on nothing
  /// nearer.
  void whatIsNearIsHit() {
    std::mt19937_64 random(3);
    for (const Shape& shape : someShapes()) {
      const Sphere bound = boundingSphere(shape);
      int hits = 0;
      for (int n = 0; n < 5000; ++n) {
        const double distance = std::pow(10.0, 4 * uniform(random) - 2);
        const Ray ray = randomRay(shape, distance, random);
        const double t = nearestDistance(shape, ray, 0, infinity);
        QCOMPARE(blocks(shape, ray, 0, infinity), std::isfinite(t));
        if (!std::isfinite(t)) continue;
        ++hits;
        const ShapeHit hit = shapeHit(shape, ray, t);
        QCOMPARE(hit.distance, t);
        // Meshes are met in single precision: past an edge by as much, the hit is held on the triangle.
        const double tolerance = std::holds_alternative<MeshShape>(shape) ? 1e-5 : 1e-9;
        QVERIFY(glm::length(hit.position - ray.origin - t * ray.direction) <
                tolerance * (bound.radius * (1 + distance) + glm::length(bound.centre)));
        QVERIFY(std::abs(glm::length(hit.geometricNormal) - 1) < 1e-12);
        QVERIFY(std::abs(glm::length(hit.shadingNormal) - 1) < 1e-12);
        QVERIFY(glm::dot(hit.geometricNormal, hit.shadingNormal) > 0);
      }
      QVERIFY(hits > 200);
    }
  }

  /// A ray that leaves a convex shape on its outside does not meet it again, at any size, place and slope.
  void leavingAConvexShapeIsForGood() {
    std::mt19937_64 random(4);
    for (const Shape& shape : someShapes()) {
      if (!isConvex(shape)) continue;
      for (int n = 0; n < 5000; ++n) {
        const Ray ray = randomRay(shape, 3, random);
        const double t = nearestDistance(shape, ray, 0, infinity);
        if (!std::isfinite(t)) continue;
        const ShapeHit hit = shapeHit(shape, ray, t);
        Direction away = randomDirection(random);
        // Every second one nearly along the surface.
        away -= (n % 2 ? 1 - 1e-6 * uniform(random) : 0.0) * glm::dot(away, hit.geometricNormal) * hit.geometricNormal;
        away = glm::normalize(glm::dot(away, hit.geometricNormal) < 0 ? -away : away);
        if (!(glm::dot(away, hit.geometricNormal) > 1e-9)) continue;
        QVERIFY2(!blocks(shape, {offsetRayOrigin(shape, hit), away}, 0, infinity),
                 qPrintable(QString("shape %1").arg(shape.index())));
      }
    }
  }

  /// Support functions against many points of the shape: none reaches farther, some nearly as far.
  void supportIsTheFarthestPoint() {
    std::mt19937_64 random(5);
    for (const Shape& shape : someShapes()) {
      const Sphere bound = boundingSphere(shape);
      const std::vector<Direction> points = surfacePoints(shape, 4000, random);
      QVERIFY(points.size() >= 1000);
      for (const Direction& point : points) QVERIFY(glm::length(point - bound.centre) <= bound.radius * (1 + 1e-6));
      for (int n = 0; n < 50; ++n) {
        const Direction d = randomDirection(random);
        double farthest = -infinity;
        for (const Direction& point : points) farthest = std::max(farthest, glm::dot(point, d));
        const double reach = support(shape, d), tolerance = 1e-6 * bound.radius + 1e-12 * glm::length(bound.centre);
        QVERIFY(std::abs(glm::dot(supportPoint(shape, d), d) - reach) < tolerance);
        QVERIFY(farthest <= reach + tolerance);
        QVERIFY(farthest > reach - 0.15 * bound.radius);
      }
    }
  }

  void whatEncloses() {
    const Shape cube = meshShape(TriangleMesh(cubeArrays())), sphere = Sphere{{1, 0, 0}, 2};
    QVERIFY(encloses(cube, {0.99, -0.99, 0.5}) && !encloses(cube, {1.01, 0, 0}) && !encloses(cube, {1, 0, 0}));
    QVERIFY(encloses(sphere, {-0.99, 0, 0}) && !encloses(sphere, {-1.01, 0, 0}));
    QVERIFY(!encloses(Rectangle{}, {0, 0, 0}));
    // Inside the tube, but faces of the ring are turned to that place.
    QVERIFY(!encloses(meshShape(torusMesh()), {0.7, 0, 0}));
    std::mt19937_64 random(6);
    for (int n = 0; n < 2000; ++n) {
      const Direction point = 1.5 * uniform(random) * randomDirection(random);
      const double reach = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
      QCOMPARE(encloses(cube, point), reach < 1);
    }
  }

  void whatIsConvex() {
    QVERIFY(isConvex(Sphere{}) && isConvex(Rectangle{}) && isConvex(meshShape(TriangleMesh(cubeArrays()))));
    QVERIFY(isConvex(meshShape(sphereMesh(1, 12, 16))));
    for (const char* name : {"torus", "bowl", "shader-ball"})
      QVERIFY(!isConvex(std::make_shared<const MeshIntersector>(bundledMesh(name))));
  }
};

GONIO_TEST(ShapeTest)
}  // namespace shape_test

#include "shape_test.moc"
