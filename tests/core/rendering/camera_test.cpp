// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/scene.h"

#include <QTest>
#include <cmath>

#include "core/rendering/path_batch.h"
#include "core/rendering/shape.h"
#include "tests/support/test_program.h"

namespace camera_test {
using namespace gonio;
using namespace gonio::rendering;

/// Where a ray meets the unit sphere.
std::optional<Direction> sphereHit(const Ray& ray) {
  const auto hit = nearestHit(Sphere{}, ray);
  return hit ? std::optional(hit->position) : std::nullopt;
}
bool near(const Direction& a, const Direction& b, double tolerance = 1e-12) { return glm::length(a - b) < tolerance; }
class CameraTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theCentreOfThePictureSeesThePointTowardTheEye() {
    for (const double fieldOfView : {0.0, 0.55})
      for (const double yaw : {0.0, 1.0, -2.5})
        for (const double pitch : {0.0, 0.7, -1.2}) {
          const CameraFrame frame = cameraFrame({yaw, pitch, 4, fieldOfView});
          const auto hit = sphereHit(cameraRay(frame, 0, 0, 1.5));
          QVERIFY(hit && near(*hit, glm::normalize(frame.eye)));
        }
    QVERIFY(near(*sphereHit(cameraRay(cameraFrame({halfPi, 0, 4, 0.5}), 0, 0, 1)), {1, 0, 0}));
    QVERIFY(sphereHit(cameraRay(cameraFrame({0, 0.5, 4, 0.5}), 0, 0, 1))->y > 0);
  }

  void picturesAreUprightAndNotMirrored() {
    for (const double fieldOfView : {0.0, 0.55}) {
      const CameraFrame frame = cameraFrame({0, 0, 4, fieldOfView});
      QVERIFY(sphereHit(cameraRay(frame, 0.3, 0, 1))->x > 0.1);
      QVERIFY(sphereHit(cameraRay(frame, 0, 0.3, 1))->y > 0.1);
    }
  }

  /// Hits lie on the sphere and on the ray, in front; the tangent cone of a perspective camera bounds them.
  void silhouettes() {
    const CameraFrame orthographic = cameraFrame({0.3, 0.2, 4, 0});
    QVERIFY(sphereHit(cameraRay(orthographic, (1 - 1e-9) / 1.15, 0, 1)));
    QVERIFY(!sphereHit(cameraRay(orthographic, (1 + 1e-9) / 1.15, 0, 1)));
    const CameraFrame perspective = cameraFrame({0.3, 0.2, 4, 0.55});
    const double edge = std::tan(std::asin(0.25)) / perspective.halfExtent;
    QVERIFY(!sphereHit(cameraRay(perspective, edge * (1 + 1e-9), 0, 1)));
    for (const double x : {0.0, 0.5, 0.9, 1 - 1e-9}) {
      const Ray ray = cameraRay(perspective, x * edge, 0, 1);
      const auto hit = sphereHit(ray);
      QVERIFY(hit && std::abs(glm::length(*hit) - 1) < 1e-15);
      QVERIFY(near(glm::normalize(*hit - ray.origin), ray.direction, 1e-7));
      QVERIFY(glm::dot(*hit, ray.direction) < 0);
    }
  }

  void framesAreRightHandedAndFollowTheirDefinition() {
    QVERIFY(near(shadingFrame({0, 0, 1}).tangent, {1, 0, 0}) && near(shadingFrame({0, 0, 1}).bitangent, {0, 1, 0}));
    QVERIFY(near(shadingFrame({1, 0, 0}).tangent, {0, 0, -1}) && near(shadingFrame({1, 0, 0}).bitangent, {0, 1, 0}));
    QVERIFY(near(shadingFrame({0, 1, 0}).tangent, {1, 0, 0}) && near(shadingFrame({0, -1, 0}).tangent, {1, 0, 0}));
    for (const double theta : {0.0, 1e-9, 0.4, 1.5, pi})
      for (const double phi : {0.0, 1.0, -2.0}) {
        const Direction n{std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
        for (const ShadingFrame& frame : {shadingFrame(n), anyFrame(n)}) {
          QVERIFY(near(glm::cross(frame.tangent, frame.bitangent), frame.normal));
          QVERIFY(std::abs(glm::dot(frame.tangent, frame.normal)) < 1e-12 &&
                  std::abs(glm::length(frame.tangent) - 1) < 1e-12);
          const Direction w = glm::normalize(Direction(0.3, -0.5, 0.7));
          QVERIFY(near(frame.toWorld(frame.toLocal(w)), w));
          QVERIFY(near(frame.toLocal(n), {0, 0, 1}));
        }
      }
  }
};

GONIO_TEST(CameraTest)
}  // namespace camera_test

#include "camera_test.moc"
