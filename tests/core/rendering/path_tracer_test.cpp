// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/path_tracer.h"

#include <QTest>
#include <cmath>

#include "core/math/parallel.h"
#include "core/rendering/scene_file.h"
#include "tests/core/rendering/tracing.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace path_tracer_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::test;

const Material grey = diffuseMaterial(Rgb(0.5));
const Material glossy = traced(ggx(Rgb(0.3, 0.2, 0.1), Rgb(0.8), 0.25, 0.4));

Rectangle plane() { return {{0, 0, 0}, {0, 0, 4}, {4, 0, 0}}; }

/// A plane of albedo 0.5 from above, seen at `at`.
Scene planeScene(const Direction& at) {
  Scene scene;
  scene.objects.push_back({.name = "plane", .shape = plane()});
  scene.camera = lookFrom(at + Direction(1, 2, 1.5), at);
  return scene;
}

/// Irradiance at a point from a polygon of radiance 1 above its horizon: Lambert's formula (Arvo 1995, eq. 3.5).
double polygonIrradiance(const std::vector<Direction>& corners, const Direction& at, const Direction& normal) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Direction a = glm::normalize(corners[i] - at), b = glm::normalize(corners[(i + 1) % corners.size()] - at);
    sum += std::acos(glm::dot(a, b)) * glm::dot(glm::normalize(glm::cross(a, b)), normal);
  }
  return std::abs(sum) / 2;
}

bool isNear(const Rgb& a, const Rgb& b, double relative) {
  return maxChannel(glm::abs(a - b)) <= relative * maxChannel(glm::abs(b));
}

class PathTracerTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void inverseSquareAndCosine() {
    for (const Direction& at : {Direction(0, 0, 0), Direction(1.5, 0, -1), Direction(-3, 0, 3)}) {
      Scene scene = planeScene(at);
      scene.pointLights = {{{0.5, 1.5, 0.2}, Rgb(3, 5, 7)}};
      const Direction way = scene.pointLights[0].position - at;
      const double expected = 0.5 / pi * way.y / std::pow(glm::length(way), 3);
      QVERIFY(isNear(traceOnePoint(scene, grey), expected * Rgb(3, 5, 7), 1e-5));
    }
  }

  void distantLightByItsCosine() {
    for (const double height : {0.0, 0.001, 0.5, 1.0}) {
      Scene scene = planeScene({1, 0, 1});
      scene.directionalLights = {{{std::sqrt(1 - height * height), height, 0}, Rgb(2, 3, 4)}};
      QVERIFY(isNear(traceOnePoint(scene, grey), Rgb(2, 3, 4) * (0.5 / pi * height), 1e-9));
    }
  }

  /// Every strategy, with and without rays to places on the lamp.
  void rectangularLampsHaveTheirClosedForm() {
    const Rectangle lamp{{0.4, 1.2, -0.3}, {0.8, 0.1, 0}, {0.05, -0.4, 0.6}};
    QVERIFY(lamp.normal().y < 0);
    for (const Direction& at : {Direction(0, 0, 0), Direction(-1.2, 0, 0.7)}) {
      Scene scene = planeScene(at);
      scene.objects.push_back({.name = "lamp", .shape = lamp, .radiance = Rgb(2, 1, 4)});
      const double irradiance =
          polygonIrradiance({lamp.at(-1, -1), lamp.at(1, -1), lamp.at(1, 1), lamp.at(-1, 1)}, at, {0, 1, 0});
      const Rgb expected = Rgb(2, 1, 4) * (0.5 / pi * irradiance);
      using enum PathTracer::Strategy;
      for (const auto strategy : {both, lights, materials})
        for (const bool sampled : {true, false}) {
          if (strategy == lights && !sampled) continue;
          TraceOptions options{.size = 8, .samples = 256, .strategy = strategy};
          options.overrides[std::size_t(Effect::areaLightSampling)] = sampled;
          // Directions of the material find the lamp by chance: a binomial fraction of them.
          const bool byChance = strategy == materials || !sampled;
          const double finds = irradiance / pi * options.samples * options.size * options.size;
          const double tolerance = byChance ? 5 / std::sqrt(finds) : 5e-3;
          const Rgb found = traceOnePoint(scene, grey, options);
          QVERIFY2(isNear(found, expected, tolerance),
                   qPrintable(QString("%1: %2, expected %3").arg(int(strategy)).arg(found.x).arg(expected.x)));
        }
    }
  }

  /// Places of the ground where the sphere hides the lamp are exactly black, others as if it were not there.
  void hardShadowsAreExact() {
    std::mt19937_64 random(1);
    const Direction light(-1, 2.5, 0.7), centre(0, 0.6, 0);
    int dark = 0;
    for (int n = 0; n < 200; ++n) {
      const Direction at(3 * uniform(random) - 1, 0, 3 * uniform(random) - 2);
      Scene scene = planeScene(at);
      const Direction toEye(2.5, 0.2, 1.5);
      scene.camera = lookFrom(at + toEye, at);
      scene.objects.push_back({.name = "sphere", .shape = Sphere{centre, 0.5}, .material = Diffuse{Rgb(0)}});
      scene.pointLights = {{light, Rgb(4)}};
      const Direction way = light - at, ray = glm::normalize(way);
      const double passes = glm::length(glm::cross(centre - at, ray));
      const bool isHidden = blocks(scene.objects[1].shape, {at, glm::normalize(toEye)}, 0, 10);
      if (std::abs(passes - 0.5) < 1e-4 || isHidden) continue;
      const Rgb found = traceOnePoint(scene, grey, {.size = 2, .samples = 4});
      dark += passes < 0.5;
      if (passes < 0.5)
        QCOMPARE(found, Rgb(0));
      else
        QVERIFY(isNear(found, Rgb(4 * 0.5 / pi * way.y / std::pow(glm::length(way), 3)), 1e-4));
    }
    QVERIFY(dark > 15);
  }

  /// Points of the sphere under the studio against all directions of the picture.
  void agreesWithQuadrature() {
    for (const double theta : {0.0, 0.8, 1.3}) {
      Scene scene = openScene("sphere");
      const Direction normal{std::sin(theta), 0, std::cos(theta)};
      scene.camera = lookFrom(normal + Direction(0, 0, 4), normal);
      const Rgb expected = quadrature(glossy->brdf(), scene, cameraRay(cameraFrame(scene.camera), 0, 0, 1), 1024);
      QVERIFY(isNear(traceOnePoint(scene, glossy, {.size = 8, .samples = 512}), expected, 5e-3));
    }
  }

  /// Independent samples err by 1 / sqrt(samples); stratified ones by no more.
  void theErrorFallsAsTheRootOfTheSamples() {
    const Scene scene = openScene("sphere-under-lamp");
    const Image reference = trace(scene, glossy, {.size = 16, .samples = 4096, .seed = 99}).image();
    const auto error = [&](int samples) {
      double sum = 0;
      for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Image image = trace(scene, glossy, {.size = 16, .samples = samples, .seed = seed}).image();
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
          sum += std::pow(glm::distance(image.pixels[i], reference.pixels[i]), 2);
      }
      return std::sqrt(sum);
    };
    const double ratio = error(8) / error(128);
    QVERIFY2(ratio > 3.2 && ratio < 16, qPrintable(QString::number(ratio)));
  }

  void sameBitsForThreadsAndParts() {
    for (const char* name : {"sphere-under-lamp", "bowl"}) {
      const Scene scene = openScene(name);
      const auto render = [&](int threads, const std::vector<int>& parts) {
        const ThreadLimit limit(threads);
        const PathTracer tracer = tracerOf(scene, glossy);
        Film film(20, 16);
        for (const int samples : parts) tracer.accumulate(film, samples);
        return film;
      };
      const Film whole = render(2, {32}), parts = render(2, {16, 16}), alone = render(1, {1, 31});
      for (const Film* film : {&parts, &alone}) {
        QCOMPARE(film->samples, 32);
        QVERIFY(film->radiance == whole.radiance && film->coverage == whole.coverage);
        QCOMPARE(film->counters.shadow, whole.counters.shadow);
        QCOMPARE(film->counters.bounce, whole.counters.bounce);
        QCOMPARE(film->fireflies().brightest, whole.fireflies().brightest);
        QCOMPARE(film->fireflies().fraction, whole.fireflies().fraction);
      }
      const Image image = whole.image(),
                  other = trace(scene, glossy, {.size = 20, .seed = std::uint64_t(1) << 40}).image();
      QVERIFY(image.pixels != other.pixels);
    }
  }

  void cancelLeavesTheFilmAsItWas() {
    const PathTracer tracer = tracerOf(openScene("bowl"), glossy);
    Film film(24, 24);
    tracer.accumulate(film, 2);
    const Film before = film;
    std::stop_source source;
    TaskControl control{source.get_token(), [&](double fraction) {
                          if (fraction > 0.3) source.request_stop();
                        }};
    QVERIFY_THROWS_EXCEPTION(Cancelled, tracer.accumulate(film, 64, control));
    QVERIFY(film.radiance == before.radiance && film.samples == 2 && film.counters.camera == before.counters.camera);
    tracer.accumulate(film, 2);
    QVERIFY(film.radiance == [&] {
      Film whole(24, 24);
      tracer.accumulate(whole, 4);
      return whole.radiance;
    }());
  }

  /// A fine mesh of a sphere has the sphere's picture; the rim differs by the polygon.
  void aMeshOfASphereIsASphere() {
    Scene analytic = openScene("sphere-point-light"), meshed = analytic;
    meshed.objects[0].shape = meshShape(sphereMesh(1, 96, 192));
    for (Scene* scene : {&analytic, &meshed}) scene->environment = studioEnvironment();
    const Tiles a = tracedTiles(analytic, glossy, {.samples = 32}, 1),
                b = tracedTiles(meshed, glossy, {.samples = 32}, 50);
    const QString text = disagreement(a, b, 3e-3);
    QVERIFY2(text.isEmpty(), qPrintable(text));
  }
};

GONIO_TEST(PathTracerTest)
}  // namespace path_tracer_test

#include "path_tracer_test.moc"
