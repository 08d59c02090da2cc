// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/math/parallel.h"
#include "core/rendering/scene_file.h"
#include "tests/core/rendering/tracing.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace path_tracer_hard_cases_test {
/// Scenes at the edges: no light, no object, light where it cannot be, and brightness of all orders.
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::geometry;
using namespace gonio::test;

const Material grey = diffuseMaterial(Rgb(0.5));
const Material glossy = traced(ggx(Rgb(0.3, 0.2, 0.1), Rgb(0.8), 0.25, 0.4));

Scene with(const Shape& shape) {
  Scene scene;
  scene.objects.push_back({.name = "thing", .shape = shape});
  return scene;
}

bool isBlack(const Film& film) {
  return std::ranges::all_of(film.radiance, [](const Rgb& sum) { return sum == Rgb(0); });
}
bool isFinite(const Film& film) {
  return std::ranges::all_of(film.radiance, [](const Rgb& sum) { return std::isfinite(sum.x + sum.y + sum.z); });
}
double coverage(const Film& film) {
  double sum = 0;
  for (const double one : film.coverage) sum += one;
  return sum / double(film.coverage.size()) / film.samples;
}

/// 64 x 32 pixels of radiance 1, one of them far brighter, toward `bright`.
std::shared_ptr<const EnvironmentMap> hotEnvironment(const Direction& bright, float radiance) {
  Image image(64, 32);
  for (glm::vec3& pixel : image.pixels) pixel = glm::vec3(1);
  const glm::dvec2 place = EnvironmentMap::positionOf(bright);
  image.at(int(place.x * 64), int(place.y * 32)) = glm::vec3(radiance);
  return std::make_shared<const EnvironmentMap>(std::move(image), "hot");
}

class PathTracerHardCasesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void anEmptyScene() {
    Scene scene;
    const Film film = trace(scene, grey);
    QVERIFY(isBlack(film) && coverage(film) == 0);
    QVERIFY(film.image().alpha[7] == 0 && film.fireflies().brightest == 0);
    scene.environment = furnaceEnvironment();
    QVERIFY(isBlack(trace(scene, grey, {.overrides = everyEffect()})));
    scene.showEnvironment = true;
    const Image shown = trace(scene, grey).image();
    QVERIFY(std::ranges::all_of(shown.pixels, [](const glm::vec3& p) { return p == glm::vec3(1); }));
    QVERIFY(std::ranges::all_of(shown.alpha, [](float a) { return a == 1; }));
    QVERIFY(isBlack(Film(0, 0)) && Film(3, 2).image().pixels.size() == 6);
  }

  void blackMaterials() {
    for (const char* name : {"sphere", "bowl", "torus"}) {
      const Film film = trace(openScene(name), diffuseMaterial(Rgb(0)));
      QVERIFY(isBlack(film) && coverage(film) > 0.1);
      QCOMPARE(film.counters.shadow + film.counters.bounce, std::uint64_t(0));
      QVERIFY(isBlack(trace(openScene(name), diffuseMaterial(Rgb(0)), {.size = 8, .overrides = everyEffect()})));
    }
  }

  void anEnvironmentAllBlack() {
    for (const Shape& shape : {Shape(Sphere{}), Shape(meshShape(bowlMesh()))}) {
      Scene scene = with(shape);
      scene.environment = std::make_shared<const EnvironmentMap>(Image(8, 4), "night");
      const Film film = trace(scene, glossy);
      QVERIFY(isBlack(film) && coverage(film) > 0.1);
      QCOMPARE(film.counters.shadow + film.counters.bounce, std::uint64_t(0));
      QVERIFY(isBlack(trace(scene, glossy, {.overrides = everyEffect()})));
    }
  }

  void lightInsideAMesh() {
    for (const Shape& shape : {Shape(Sphere{}), Shape(meshShape(TriangleMesh(cubeArrays())))}) {
      Scene scene = with(shape);
      scene.pointLights = {{{0.3, 0.2, 0.1}, Rgb(100)}};
      const Film film = trace(scene, grey);
      QVERIFY(isBlack(film));
      QCOMPARE(film.counters.shadow, std::uint64_t(0));
      QVERIFY(isBlack(trace(scene, grey, {.overrides = everyEffect()})));
    }
    // Within the tube of the ring: faces across are turned to it, and its own wall stands between.
    Scene ring = with(meshShape(torusMesh()));
    ring.pointLights = {{{0, -0.7, 0.7}, Rgb(100)}};
    const Film film = trace(ring, grey);
    QVERIFY(isBlack(film) && film.counters.shadow > 0);
  }

  /// Along the plane no light falls on it; a sphere is lit on one half, and its terminator has no speck.
  void lightAtTheHorizon() {
    Scene plane = with(Rectangle{{0, -1, 0}, {0, 0, 5}, {5, 0, 0}});
    plane.camera = lookFrom({0, 2, 4}, {0, -1, 0});
    plane.directionalLights = {{{1, 0, 0}, Rgb(5)}};
    QVERIFY(isBlack(trace(plane, glossy)));
    Scene sphere = with(Sphere{});
    sphere.directionalLights = {{{1, 0, 0}, Rgb(5)}};
    const Film film = trace(sphere, glossy, {.size = 33});
    QVERIFY(isFinite(film));
    for (int y = 0; y < 33; ++y)
      for (int x = 0; x < 33; ++x) QVERIFY(x >= 16 || film.radiance[std::size_t(33 * y + x)] == Rgb(0));
    // A lamp in the plane that it should light, seen along its edge.
    Scene lamp = with(Rectangle{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}});
    lamp.objects.push_back({.name = "lamp", .shape = Rectangle{{3, 0, 0}, {0, 0, 1}, {1, 0, 0}}, .radiance = Rgb(9)});
    lamp.camera = lookFrom({0, 2, 4}, {0, 0, 0});
    QVERIFY(isFinite(trace(lamp, grey, {.overrides = everyEffect()})));
  }

  /// A place that does not see the hot pixel has the light of all others, although the pixel draws nearly all samples:
  /// the table of the draws has no room for the others beside it. Where it is seen it is all there is: its radiance
  /// over its bilinear solid angle.
  void dimLightBesideAHotPixel() {
    for (const float radiance : {1e4f, 1e12f, 1e30f})
      for (const bool isUpward : {true, false}) {
        const Direction u(1, 0, 0), v(0, 0, 1), up(0, isUpward ? 1 : -1, 0);
        Scene scene = with(isUpward ? Rectangle{{0, 0, 0}, v, u} : Rectangle{{0, 0, 0}, u, v});
        scene.camera = lookFrom(Direction(1, 0, 1) + 2.0 * up, {0, 0, 0});
        scene.environment = hotEnvironment(glm::normalize(Direction(0.1, 0, 0.2) - up), radiance);
        const double dim = traceOnePoint(scene, grey, {.size = 8, .samples = 64}).x;
        QVERIFY2(std::abs(dim - 0.5) < 0.01, qPrintable(QString("%1 beside %2").arg(dim).arg(double(radiance))));
        const double row = isUpward ? 8.5 : 23.5;
        const Direction bright = EnvironmentMap::directionAt(32.5 / 64, row / 32);
        scene.environment = hotEnvironment(bright, radiance);
        const double solidAngle = 2 * pi / 64 * pi / 32 * std::sin(pi * row / 32);
        const double expected = 0.5 / pi * (pi + double(radiance) * solidAngle * glm::dot(bright, up));
        const double lit = traceOnePoint(scene, grey, {.size = 8, .samples = 64}).x;
        QVERIFY2(std::abs(lit / expected - 1) < 0.02, qPrintable(QString::number(lit / expected)));
      }
  }

  /// A lamp that mirrors show as rare bright samples, where draws go to the material only; reported, the same for any
  /// number of threads and parts; none where all samples are alike.
  void firefliesAreTold() {
    Scene furnace = with(Sphere{});
    furnace.environment = furnaceEnvironment();
    const Fireflies none = trace(furnace, grey).fireflies();
    QVERIFY(none.brightest >= 1 && none.brightest < 4 && none.fraction == 0);
    Scene lamp = openScene("sphere-under-lamp");
    auto& rectangle = std::get<Rectangle>(lamp.objects[2].shape);
    rectangle.halfU *= 0.15;
    rectangle.halfV *= 0.15;
    lamp.objects[2].radiance *= 44;
    const Fireflies found = trace(lamp, grey, {.samples = 64, .strategy = PathTracer::Strategy::materials}).fireflies(),
                    sampled = trace(lamp, grey).fireflies();
    QVERIFY2(found.brightest > 300 && found.fraction > 0.9,
             qPrintable(QString("%1 %2").arg(found.brightest).arg(found.fraction)));
    QVERIFY(sampled.brightest < 60 && sampled.fraction == 0);
  }

  /// A spike of 1e6: finite, the two strategies that can find it agree.
  void mirrorSpikes() {
    const Material spike = traced(ggx(Rgb(0.05), Rgb(1), 0.003, 0.9));
    const Scene scene = openScene("sphere-under-lamp");
    const Film film = trace(scene, spike, {.samples = 64});
    QVERIFY(isFinite(film) && film.fireflies().brightest > 5);
    const QString text =
        disagreement(tracedTiles(scene, spike, {.samples = 64}, 1),
                     tracedTiles(scene, spike, {.samples = 64, .strategy = PathTracer::Strategy::materials}, 101));
    QVERIFY2(text.isEmpty(), qPrintable(text));
  }
};

GONIO_TEST(PathTracerHardCasesTest)
}  // namespace path_tracer_hard_cases_test

#include "path_tracer_hard_cases_test.moc"
