// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/geometry/bundled_meshes.h"

#include <QTest>

#include "core/geometry/mesh_intersector.h"
#include "core/support/error.h"
#include "tests/support/simple_meshes.h"
#include "tests/support/test_program.h"

namespace bundled_meshes_test {
using namespace gonio;
using namespace gonio::geometry;

class BundledMeshesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void meshesKeepTheirPromises() {
    for (const std::string& name : bundledMeshNames()) {
      const auto mesh = bundledMesh(name);
      QVERIFY(mesh == bundledMesh(name));
      QCOMPARE(mesh->droppedTriangles(), std::size_t(0));
      QVERIFY(mesh->isClosed() && mesh->volume() > 0);
      QVERIFY(std::abs(mesh->bounds().min.y + 1) < 1e-6);
      for (int axis = 0; axis < 3; ++axis)
        QVERIFY(mesh->bounds().min[axis] > -1 - 1e-6 && mesh->bounds().max[axis] < 1 + 1e-6);
      QVERIFY(mesh->triangles().size() >= 6000 && mesh->triangles().size() <= 60000);
    }
    QVERIFY_THROWS_EXCEPTION(Error, bundledMesh("teapot"));
  }

  /// Each of their parts, too, is wound outward: what is seen from outside is an outside.
  void whatIsSeenIsOutside() {
    std::mt19937_64 random(1);
    for (const std::string& name : bundledMeshNames()) {
      const MeshIntersector intersector(bundledMesh(name));
      for (int n = 0; n < 20000; ++n) {
        const glm::dvec3 origin = 3.0 * test::randomDirection(random);
        const Direction direction = test::randomDirection(random) - origin;
        if (const auto hit = intersector.closest(origin, direction, 0, 10))
          QVERIFY(glm::dot(hit->geometricNormal, direction) < 0);
      }
    }
  }

  /// Pappus: the volume and, through it, the winding of a torus. Inscribed, so a little smaller.
  void aTorusHasItsVolume() {
    const double ratio = torusMesh().volume() / (2 * pi * pi * 0.7 * 0.3 * 0.3);
    QVERIFY(ratio < 1 && ratio > 0.997);
    const TriangleMesh torus = torusMesh();
    for (std::size_t i = 0; i < torus.triangles().size(); ++i)
      for (int corner = 0; corner < 3; ++corner) {
        const Direction p(torus.positions()[torus.triangles()[i][corner]]);
        const Direction middle = 0.7 * glm::normalize(Direction(p.x, 0, p.z)) + Direction(0, -0.7, 0);
        const Direction normal(torus.cornerNormals()[3 * i + std::size_t(corner)]);
        QVERIFY(glm::length(normal - glm::normalize(p - middle)) < 2e-3);
      }
  }

  void profilesTurnEitherWay() {
    const std::vector<glm::dvec2> up = {{0, -1}, {1, 0}, {0, 1}}, down(up.rbegin(), up.rend());
    // Two pyramids of 4 sides: base 2, height 1 each.
    QVERIFY(std::abs(revolvedMesh(up, 4).volume() - 4.0 / 3) < 1e-6);
    QVERIFY(std::abs(revolvedMesh(down, 4).volume() - 4.0 / 3) < 1e-6);
    QVERIFY(revolvedMesh(up, 3).isConvex());
  }

  void badProfilesAreRefused() {
    using Profile = std::vector<glm::dvec2>;
    QVERIFY_THROWS_EXCEPTION(Error, revolvedMesh(Profile{{0, 0}, {0, 1}}, 8));
    QVERIFY_THROWS_EXCEPTION(Error, revolvedMesh(Profile{{0, 0}, {1, 1}, {0.5, 2}}, 8));
    QVERIFY_THROWS_EXCEPTION(Error, revolvedMesh(Profile{{0, 0}, {-1, 1}, {0, 2}}, 8));
    QVERIFY_THROWS_EXCEPTION(Error, revolvedMesh(Profile{{0, 0}, {1, std::nan("")}, {0, 2}}, 8));
    QVERIFY_THROWS_EXCEPTION(Error, revolvedMesh(Profile{{0, 0}, {1, 1}, {0, 2}}, 2));
    QVERIFY_THROWS_EXCEPTION(Error, revolvedMesh(Profile{{0, 0}, {0, 1}, {0, 2}}, 8));
  }
};

GONIO_TEST(BundledMeshesTest)
}  // namespace bundled_meshes_test

#include "bundled_meshes_test.moc"
