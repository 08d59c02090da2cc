// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/preview_input.h"

#include <QTest>
#include <cmath>

#include "core/rendering/shape.h"
#include "tests/support/test_program.h"

namespace preview_navigation_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::widgets;

class PreviewNavigationTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The mirror direction at the sphere's point under the pointer is the light: its highlight is where the hand is.
  void highlightLiesUnderThePointer() {
    for (const double fieldOfView : {0.0, 0.55})
      for (const double x : {-0.4, 0.0, 0.3}) {
        const OrbitCamera camera{.yaw = 0.7, .pitch = -0.3, .fieldOfView = fieldOfView};
        const Direction light = lightTowards(camera, x, 0.2, 1.0);
        const CameraFrame frame = cameraFrame(camera);
        const Direction across = x * frame.halfExtent * frame.right + 0.2 * frame.halfExtent * frame.up;
        const Direction toEye = -(frame.orthographic ? frame.forward : glm::normalize(frame.forward + across));
        // The half vector is the normal; the point with this normal projects back to the pointer.
        const Direction normal = glm::normalize(light + toEye);
        const Direction fromEye = normal - frame.eye;
        const double depth = frame.orthographic ? 1 : glm::dot(fromEye, frame.forward);
        QVERIFY(std::abs(glm::dot(fromEye, frame.right) / depth - x * frame.halfExtent) < 1e-9);
        QVERIFY(std::abs(glm::dot(fromEye, frame.up) / depth - 0.2 * frame.halfExtent) < 1e-9);
      }
  }

  /// However narrow or wide the picture is, the whole sphere is in it.
  void sphereFitsIntoEveryPicture() {
    for (const double fieldOfView : {0.0, OrbitCamera{}.fieldOfView})
      for (const double aspect : {0.3, 1.0, 3.0}) {
        const CameraFrame frame = cameraFrame({.fieldOfView = fieldOfView});
        for (const auto& [x, y] : {std::pair(1.0, 0.0), {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}})
          QVERIFY(!nearestHit(Sphere{}, cameraRay(frame, x, y, aspect)));
        QVERIFY(nearestHit(Sphere{}, cameraRay(frame, 0, 0, aspect)));
      }
  }

  void pointerBesideTheSphereGivesAUnitDirection() {
    const Direction light = lightTowards(OrbitCamera{}, 1.0, 1.0, 2.0);
    QVERIFY(std::abs(glm::length(light) - 1) < 1e-12);
  }

  /// Orthographic, the sphere's radius 1 in a view of half height 1.15: sin theta is the distance from the middle.
  /// In perspective, the sine law in the triangle of eye, centre and point.
  void viewerAngleOfAPointOnTheSphere() {
    const OrbitCamera flat{.yaw = 1.1, .pitch = 0.4, .fieldOfView = 0};
    const double extent = cameraFrame(flat).halfExtent;
    for (const double radius : {0.0, 0.3, 0.9})
      QVERIFY(std::abs(*viewerPolarAngle(flat, radius / extent * 0.6, radius / extent * 0.8, 1) - std::asin(radius)) <
              1e-9);
    const OrbitCamera camera{.yaw = -0.5, .pitch = 0.2};
    for (const double x : {0.1, 0.5, 0.8}) {
      const double ray = std::atan(x * cameraFrame(camera).halfExtent);
      QVERIFY(std::abs(std::sin(*viewerPolarAngle(camera, x, 0, 1)) - camera.distance * std::sin(ray)) < 1e-9);
    }
    QVERIFY(!viewerPolarAngle(camera, 1, 1, 1));
  }

  void orbitStopsShortOfThePole() {
    OrbitCamera camera;
    for (int i = 0; i < 100; ++i) camera = orbited(camera, 3, 50);
    QVERIFY(camera.pitch < halfPi);
    QVERIFY(std::abs(camera.yaw) <= pi);
  }

  void zoomStaysOutsideTheSphere() {
    OrbitCamera camera;
    for (int i = 0; i < 100; ++i) camera = zoomed(camera, 1);
    QVERIFY(camera.distance > 1);
    const OrbitCamera back = zoomed(zoomed(OrbitCamera{}, 1), -1);
    QVERIFY(std::abs(back.distance - OrbitCamera{}.distance) < 1e-12);
  }

  /// A point at the target's depth follows the hand when it pans, and stays under the pointer when it zooms there.
  void whatIsGraspedStaysUnderTheHand() {
    const auto placeOf = [](const OrbitCamera& camera, const Direction& point) {
      const CameraFrame frame = cameraFrame(camera);
      const Direction away = point - frame.eye;
      const double depth = frame.orthographic ? 1 : glm::dot(away, frame.forward);
      return glm::dvec2(glm::dot(away, frame.right), glm::dot(away, frame.up)) / (depth * frame.halfExtent);
    };
    for (const double fieldOfView : {0.0, 0.55}) {
      const OrbitCamera camera{.yaw = 0.7, .pitch = -0.3, .fieldOfView = fieldOfView, .target = {0.1, -0.2, 0.3}};
      const CameraFrame frame = cameraFrame(camera);
      const Direction point = camera.target + 0.3 * frame.right - 0.2 * frame.up;
      const glm::dvec2 before = placeOf(camera, point);
      QVERIFY(glm::distance(placeOf(panned(camera, 0.4, -0.1), point), before + glm::dvec2(0.4, -0.1)) < 1e-12);
      for (const double steps : {-2.0, 3.0})
        QVERIFY(glm::distance(placeOf(zoomed(camera, steps, before.x, before.y), point), before) < 1e-12);
    }
    OrbitCamera far;
    for (int i = 0; i < 1000; ++i) far = panned(far, 1, 1);
    QVERIFY(glm::length(far.target) < 20);
  }
};

GONIO_TEST(PreviewNavigationTest)
}  // namespace preview_navigation_test

#include "preview_navigation_test.moc"
