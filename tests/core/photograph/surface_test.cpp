// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/photograph/surface.h"

#include <QTest>

#include "core/photograph/photograph.h"
#include "tests/support/test_program.h"

namespace surface_test {
using namespace gonio;
using namespace gonio::photograph;

constexpr int width = 96, height = 64;

/// An oblique view. Of surfaces other than spheres, the axis of the camera is beside the middle.
Photograph viewOf(const Surface& surface) {
  Photograph photograph{.name = "test", .image = {}, .disc = {}, .camera = {}, .light = {}};
  photograph.surface = surface;
  photograph.size = {width, height};
  photograph.camera = {.yaw = 0.4, .pitch = 0.3, .distance = 4.5, .fieldOfView = radians(30)};
  if (!isSphere(surface)) photograph.camera.target = {0.2, -0.1, 0.1};
  photograph.disc = discOf(photograph.camera, width, height);
  return photograph;
}

class SurfaceTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The points are those where the ray tracer hits the scene of the photograph, in which cylinders and round samples
  /// are meshes. Of a cylinder only the side is shown.
  void isWhereTheRayTracerHits() {
    const Direction oblique = glm::normalize(Direction(0.4, 1, -0.3)), facing = glm::normalize(Direction(-0.2, 0.9, 1));
    for (const Surface& surface :
         {Surface(UnitSphere{}), Surface(Cylinder{{0, 1, 0}, 1.2}), Surface(Cylinder{oblique, 5}),
          Surface(FlatSample{facing, 1.8, 1.2}), Surface(FlatSample{facing, 1.8, 1.2, true})}) {
      const Photograph photograph = viewOf(surface);
      const SurfaceView view(photograph);
      const auto* cylinder = std::get_if<Cylinder>(&surface);
      const rendering::Scene scene = sceneOf(photograph, width, height);
      const rendering::CameraFrame frame = rendering::cameraFrame(scene.camera);
      int shown = 0, differing = 0, inner = 0;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          const glm::dvec2 pixel(x + 0.5, y + 0.5);
          const Ray ray =
              rendering::cameraRay(frame, 2 * pixel.x / width - 1, 1 - 2 * pixel.y / height, double(width) / height);
          auto hit = rendering::nearestHit(scene.objects[0].shape, ray);
          if (hit && cylinder && std::abs(glm::dot(hit->geometricNormal, cylinder->axis)) > 0.5) hit.reset();
          if (view.shows(pixel) != hit.has_value()) ++differing;
          if (!hit || !view.shows(pixel, 0.985)) continue;
          ++shown;
          const SeenPoint point = view.at(pixel);
          constexpr double segment = 1e-3;  // the shading normals of neighbouring segments differ by 0.01
          QVERIFY2(glm::length(point.position - hit->position) < segment, surfaceName(surface).data());
          QVERIFY(glm::length(point.normal - hit->shadingNormal) < segment);
          QVERIFY(glm::length(point.toViewer + ray.direction) < 1e-9);
          const bool isInner = view.shows(pixel, 0.5);
          inner += isInner;
          if (cylinder && isInner)
            QVERIFY(std::abs(glm::dot(hit->position, cylinder->axis)) < cylinder->length / 4 + segment);
          if (const auto* flat = std::get_if<FlatSample>(&surface); flat && isInner)
            QVERIFY(std::abs(rendering::shadingFrame(flat->normal).toLocal(hit->position).x) <
                    flat->width / 4 + segment);
        }
      const QByteArray counts = QByteArray(surfaceName(surface).data()) + ": " + QByteArray::number(shown) +
                                " shown, " + QByteArray::number(inner) + " inner, " + QByteArray::number(differing) +
                                " differing";
      QVERIFY2(shown > 600 && inner > 100 && inner < shown / 2, counts);
      QVERIFY2(differing <= 3, counts);
    }
  }

  /// The width is horizontal, and width, height and normal are a right-handed frame: a small light beside the middle
  /// is in the sample if it is within half the width along the first and half the height along the second.
  void flatSamplesHaveAFrame() {
    for (const Direction& normal :
         {Direction(0, 0, 1), Direction(0, 1, 0), glm::normalize(Direction(1, -2, -3)), Direction(0, -1, 0)}) {
      const auto [right, up, front] = rendering::shadingFrame(normal);
      QVERIFY(std::abs(right.y) < 1e-12);
      QVERIFY(std::abs(glm::dot(right, normal)) < 1e-12);
      QVERIFY(glm::length(glm::cross(right, up) - normal) < 1e-12);
      const FlatSample flat{.normal = normal, .width = 4, .height = 1};
      QVERIFY(occupies(flat, 1.9 * right + 0.4 * up) && !occupies(flat, 0.4 * right + 1.9 * up));
      QVERIFY(!occupies(flat, 2.1 * right) && !occupies(flat, 0.6 * up));
    }
    QVERIFY(glm::length(rendering::shadingFrame(FlatSample{}.normal).tangent - Direction(1, 0, 0)) < 1e-12);
  }

  void outsideAndInside() {
    const Surface cylinder = Cylinder{{0, 1, 0}, 2}, flat = FlatSample{{0, 0, 1}, 2, 1};
    QVERIFY(isOutside(cylinder, {0, 5, 1.1}) && !isOutside(cylinder, {0, 5, 0.9}));
    QVERIFY(isOutside(flat, {9, 0, 0.1}) && !isOutside(flat, {0, 0, -0.1}));
    QVERIFY(occupies(cylinder, {0.9, 0.9, 0}) && !occupies(cylinder, {0.9, 1.1, 0}) &&
            !occupies(cylinder, {0.9, 0, 0.9}));
    QVERIFY(occupies(flat, {0.9, 0.4, 0}) && !occupies(flat, {0.9, 0.6, 0}) && !occupies(flat, {0, 0, 0.1}));
    QVERIFY(occupies(UnitSphere{}, {0, 1, 0}) && isOutside(UnitSphere{}, {0, 1.01, 0}));
  }
};

GONIO_TEST(SurfaceTest)

}  // namespace surface_test

#include "surface_test.moc"
