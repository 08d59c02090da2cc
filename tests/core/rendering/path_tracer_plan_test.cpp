// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/rendering/render_picture.h"
#include "core/rendering/scene_file.h"
#include "tests/core/rendering/tracing.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace path_tracer_plan_test {
/// The path tracer does what its plan says, and a plan leaves out nothing that shows.
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::geometry;
using namespace gonio::test;

const Material glossy = traced(ggx(Rgb(0.3, 0.2, 0.1), Rgb(0.8), 0.25, 0.4));

EffectOverrides forced(Effect effect, bool on) {
  EffectOverrides overrides;
  overrides[std::size_t(effect)] = on;
  return overrides;
}

float brightest(const Image& image) {
  float result = 0;
  for (const glm::vec3& pixel : image.pixels) result = std::max({result, pixel.x, pixel.y, pixel.z});
  return result;
}

class PathTracerPlanTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Counted: one ray from the eye for each sample, none else.
  void aLoneConvexShapeTracesNoOtherRay() {
    for (const Shape& shape : {Shape(Sphere{}), Shape(meshShape(TriangleMesh(cubeArrays())))})
      for (const bool environment : {true, false}) {
        Scene scene = sphereScene(environment ? studioEnvironment() : nullptr);
        scene.objects[0].shape = shape;
        const Film film = trace(scene, glossy, {.size = 20, .samples = 8});
        QCOMPARE(film.counters.camera, std::uint64_t(20 * 20 * 8));
        QCOMPARE(film.counters.shadow, std::uint64_t(0));
        QCOMPARE(film.counters.bounce, std::uint64_t(0));
        // But for the frames, which turn the draws: the rays meet nothing, so not a bit changes.
        EffectOverrides overrides = everyEffect();
        overrides[std::size_t(Effect::anisotropicFrames)] = false;
        const Film all = trace(scene, glossy, {.size = 20, .samples = 8, .overrides = overrides});
        QVERIFY(all.counters.shadow > 0 && all.counters.bounce > 0);
        QVERIFY(all.radiance == film.radiance);
      }
  }

  /// Everything on: the same picture within the noise and what the plan says that it leaves out, with more rays where
  /// the plan leaves out rays (between two spheres it shortens only what each ray is tested against, and the longest
  /// paths).
  void everythingOnIsTheSamePicture_data() {
    QTest::addColumn<QString>("name");
    for (const std::string& name : bundledSceneNames()) QTest::newRow(name.c_str()) << QString::fromStdString(name);
  }
  void everythingOnIsTheSamePicture() {
    QFETCH(QString, name);
    const Scene scene = openScene(name.toStdString());
    const TraceOptions planned{.size = 20, .samples = 32};
    TraceOptions all = planned;
    all.overrides = everyEffect();
    const Film a = trace(scene, glossy, planned), b = trace(scene, glossy, all);
    const auto rays = [](const Film& film) { return double(film.counters.shadow + film.counters.bounce); };
    const EffectPlan plan = tracerOf(scene, glossy).plan();
    const bool sparesRays = std::ranges::any_of(plan.blockers, [](const auto& lights) {
      return std::ranges::any_of(lights, [](const auto& blockers) { return blockers.empty(); });
    });
    QVERIFY(rays(b) > (sparesRays ? 1.01 : 0.99) * rays(a));
    const double leftOut = plan.remainder * brightest(a.image());
    const QString text =
        disagreement(tracedTiles(scene, glossy, planned, 1), tracedTiles(scene, glossy, all, 101), leftOut);
    QVERIFY2(text.isEmpty(), qPrintable(text));
  }

  /// Each effect that a scene calls for shows: without it the picture is another.
  void whatIsCalledForShows() {
    const std::vector<std::pair<const char*, Effect>> cases{{"sphere-distant-light", Effect::directLight},
                                                            {"sphere", Effect::environmentLight},
                                                            {"two-spheres", Effect::emittedLight},
                                                            {"sphere-on-plane", Effect::castShadows},
                                                            {"sphere-under-lamp", Effect::castShadows},
                                                            {"bowl", Effect::selfShadowing},
                                                            {"torus", Effect::selfShadowing},
                                                            {"bowl", Effect::interreflection},
                                                            {"two-spheres", Effect::interreflection}};
    for (const auto& [name, effect] : cases) {
      const Scene scene = openScene(name);
      QVERIFY(tracerOf(scene, glossy).plan().simulates(effect));
      const Tiles with = tracedTiles(scene, glossy, {.size = 20, .samples = 32}, 1),
                  without =
                      tracedTiles(scene, glossy, {.size = 20, .samples = 32, .overrides = forced(effect, false)}, 1);
      QVERIFY2(!disagreement(with, without).isEmpty(), (std::string(name) + ", " + effectId(effect)).c_str());
    }
  }

  /// Lights' and materials' draws alone find the same light as both together.
  void strategiesAgreeInTheMean() {
    for (const char* name : {"sphere-under-lamp", "sphere-on-plane"}) {
      const Scene scene = openScene(name);
      const auto tiles = [&](PathTracer::Strategy strategy, std::uint64_t seed) {
        return tracedTiles(scene, glossy, {.samples = 64, .strategy = strategy}, seed);
      };
      const Tiles both = tiles(PathTracer::Strategy::both, 1);
      for (const auto& one : {tiles(PathTracer::Strategy::lights, 101), tiles(PathTracer::Strategy::materials, 201)}) {
        const QString text = disagreement(both, one);
        QVERIFY2(text.isEmpty(), qPrintable(text));
      }
    }
  }

  void lampsAreFoundWithoutRaysToThem() {
    const Scene scene = openScene("sphere-under-lamp");
    const TraceOptions off{.samples = 64, .overrides = forced(Effect::areaLightSampling, false)};
    const Film film = trace(scene, glossy, off);
    QCOMPARE(film.counters.shadow, std::uint64_t(0));
    const QString text =
        disagreement(tracedTiles(scene, glossy, {.samples = 64}, 1), tracedTiles(scene, glossy, off, 101));
    QVERIFY2(text.isEmpty(), qPrintable(text));
  }

  /// A shorter plan leaves out no more than it says.
  void remaindersAreBounds() {
    const Scene scene = openScene("bowl");
    const Material grey = diffuseMaterial(Rgb(0.7));
    const auto bound = bindMaterials(scene, std::vector<Material>{grey});
    const auto tiles = [&](double remainder, std::uint64_t seed) {
      return tilesOf(
          6,
          [&](std::uint64_t one) {
            Film film(20, 20);
            PathTracer(scene, bound, planEffects(scene, bound, {}, {.remainder = remainder}), one).accumulate(film, 16);
            return film.image();
          },
          seed);
    };
    const Tiles whole = tiles(1e-6, 1);
    int last = 100;
    for (const double fraction : {0.01, 0.1, 0.5}) {
      const EffectPlan plan = planEffects(scene, bound, {}, {.remainder = fraction});
      QVERIFY(plan.reflections < last && plan.remainder <= fraction);
      last = plan.reflections;
      const QString text =
          disagreement(whole, tiles(fraction, 101), plan.remainder * brightest(trace(scene, grey).image()));
      QVERIFY2(text.isEmpty(), qPrintable(text));
    }
  }
};

GONIO_TEST(PathTracerPlanTest)
}  // namespace path_tracer_plan_test

#include "path_tracer_plan_test.moc"
