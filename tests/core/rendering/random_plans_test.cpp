// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/support/random_plans.h"

#include <QTest>

#include "core/rendering/scene_file.h"
#include "tests/core/rendering/tracing.h"
#include "tests/support/test_program.h"

namespace random_plans_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::test;

/// A sphere before a wall behind the camera, lit from the camera's side: what the sphere sends back is seen by the wall
/// and the sphere alone.
Scene sphereAndWall() {
  Scene scene;
  scene.camera.distance = 5;
  scene.objects = {
      {.name = "sphere", .shape = Sphere{}, .material = MaterialSlot{0}},
      {.name = "wall", .shape = Rectangle{{0, 0, 30}, {0, 30, 0}, {30, 0, 0}}, .material = Diffuse{Rgb(0.9)}}};
  scene.directionalLights = {{{0, 0, -1}, Rgb(30)}};
  return scene;
}

QString plannedAgainstAll(const Scene& scene, const Material& material) {
  const RandomPlan both{scene, bindMaterials(scene, RenderMaterials{material})};
  const PlanComparison result = comparePlan(both, 32, 256, 1, checkedPlan(scene, both.materials));
  if (result.agrees() && result.mean > 0) return {};
  return QString("mean %1, a block differs by %2, stated %3, standard error %4")
      .arg(result.mean)
      .arg(result.difference)
      .arg(result.stated)
      .arg(result.standardError);
}

class RandomPlansTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Materials that reflect in a narrow band of directions only: by the plan the picture has their light.
  void narrowBandsAreSimulated() {
    const HalfDifferenceGrid grid;
    const Material ring = traced(raisedTable(grid, {radians(35.5), radians(39.5)}, {0, radians(2)}, 300));
    const Material factors = traced(factorization::makePdvBrdf(*raisedFactors(radians(34.4), radians(39.6), 2)));
    for (const Material& material : {ring, factors}) {
      const Scene scene = sphereAndWall();
      const EffectPlan plan = planEffects(scene, bindMaterials(scene, RenderMaterials{material}));
      QVERIFY2(plan.simulates(Effect::interreflection), plan[Effect::interreflection].reason.c_str());
      const QString text = plannedAgainstAll(scene, material);
      QVERIFY2(text.isEmpty(), qPrintable(text));
    }
  }

  /// Edits by lobes: the plan ends the paths by a bound, and the picture is that with all effects.
  void plansOfEditsByLobesEnd() {
    const models::Model& model = models::ggx();
    const models::ParameterValues fitted = models::defaultParameters(model.spec());
    editing::DifferentialEdit edit = editing::unchangedEdit(model, fitted);
    edit.edited.values[*model.spec().find("roughness")] *= 2;
    const Material material = traced(
        editing::applyEdits(bakeTable(*model.instantiate(fitted)), std::vector<editing::Edit>{{.content = edit}}));
    const Scene scene = openScene("sphere-on-plane");
    const EffectPlan plan = planEffects(scene, bindMaterials(scene, RenderMaterials{material}));
    QVERIFY2(plan.reflections < EffectThresholds().maxReflections && plan.remainder <= EffectThresholds().remainder,
             plan[Effect::interreflection].reason.c_str());
    const QString text = plannedAgainstAll(scene, material);
    QVERIFY2(text.isEmpty(), qPrintable(text));
  }

  /// What is seen only in a mirror, what emits behind something else, gaps of 1e-10, and light along the horizon.
  void hiddenThingsAreSimulated() {
    const Material mirror = traced(ggx(Rgb(0), Rgb(1), 0.003, 1)), grey = diffuseMaterial(Rgb(0.6));
    const auto wall = [](const char* name, const Direction& centre, const Direction& u, const Direction& v, int slot) {
      return SceneObject{.name = name, .shape = Rectangle{centre, u, v}, .material = MaterialSlot{slot}};
    };
    const SceneObject glass = wall("mirror", {0, 0, -3}, {1, 0, 0}, {0, 1, 0}, 0);
    Scene behindTheCamera;
    behindTheCamera.objects = {
        glass, {.name = "ring", .shape = meshShape(geometry::torusMesh()), .material = MaterialSlot{1}}};
    behindTheCamera.camera = lookFrom({0.2, 0.3, -1.5}, {0, 0, -3});
    behindTheCamera.directionalLights = {{glm::normalize(Direction(0.2, 1, 0.3)), Rgb(2)}};
    Scene hiddenLamp;
    hiddenLamp.objects = {
        wall("ground", {0, -1, 0}, {0, 0, 3}, {3, 0, 0}, 1),
        wall("screen", {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 1),
        {.name = "lamp", .shape = Rectangle{{0, 0, -1.2}, {0.5, 0, 0}, {0, 0.5, 0}}, .radiance = Rgb(9)}};
    hiddenLamp.camera = lookFrom({0, 0.6, 5}, {0, 0, 0});
    Scene gap;
    gap.objects = {wall("under", {0, 0, 0}, {0, 0, 2}, {2, 0, 0}, 1),
                   wall("over", {0.5, 1e-10, 0}, {0, 0, 0.7}, {0.7, 0, 0}, 0),
                   {.name = "ball", .shape = Sphere{{-0.6, 0.4 + 1e-10, 0}, 0.4}, .material = MaterialSlot{1}}};
    gap.camera = lookFrom({0, 3, 4}, {0, 0, 0});
    gap.environment = studioEnvironment();
    Scene horizon = gap;
    horizon.environment = nullptr;
    horizon.directionalLights = {{glm::normalize(Direction(1, 1e-4, 0)), Rgb(20)}, {Direction(1, 0, 0), Rgb(5)}};
    for (const auto& [name, scene] : {std::pair("behind the camera", behindTheCamera),
                                      {"hidden lamp", hiddenLamp},
                                      {"gap", gap},
                                      {"horizon", horizon}}) {
      const RandomPlan random{scene, bindMaterials(scene, RenderMaterials{mirror, grey})};
      const PlanComparison result = comparePlan(random, 24, 256, 3, planEffects(scene, random.materials));
      QVERIFY2(result.mean > 0 && result.agrees(), qPrintable(QString("%1: mean %2, difference %3, stated %4, error %5")
                                                                  .arg(name)
                                                                  .arg(result.mean)
                                                                  .arg(result.difference)
                                                                  .arg(result.stated)
                                                                  .arg(result.standardError)));
    }
  }

  /// Scenes by chance: no block of 8 x 8 pixels differs from all effects by more than is stated and the noise. A block
  /// that seems to is rendered again with more samples.
  void plansAgreeWithAllEffects() {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      const RandomPlan random = randomPlan(seed);
      const EffectPlan plan = checkedPlan(random.scene, random.materials);
      PlanComparison result = comparePlan(random, 16, 16, 1, plan);
      if (!result.agrees()) result = comparePlan(random, 16, 512, 2, plan);
      QVERIFY2(result.agrees(), qPrintable(QString("scene %1: %2, stated %3, standard error %4")
                                               .arg(seed)
                                               .arg(result.difference)
                                               .arg(result.stated)
                                               .arg(result.standardError)));
    }
  }

  /// Fewer rays, the same expectation: the bowl by a plan that ends paths early and by one that does not.
  void endingPathsEarlyChangesNoMean() {
    for (const char* name : {"bowl", "torus"}) {
      const Scene scene = openScene(name);
      const Material material = traced(ggx(Rgb(0.4, 0.3, 0.2), Rgb(1), 0.2, 0.3));
      const auto bound = bindMaterials(scene, materialsInSlots(scene, material));
      EffectPlan early = planEffects(scene, bound), late = early;
      late.endsPathsEarly = false;
      std::array<std::uint64_t, 2> rays{};
      const auto tiles = [&](const EffectPlan& plan, std::uint64_t seed, std::uint64_t& count) {
        return tilesOf(
            12,
            [&](std::uint64_t one) {
              Film film(24, 24);
              PathTracer(scene, bound, plan, one).accumulate(film, 16);
              count += film.counters.bounce;
              return film.image();
            },
            seed);
      };
      const Tiles a = tiles(early, 1, rays[0]), b = tiles(late, 101, rays[1]);
      const QString text = disagreement(a, b);
      QVERIFY2(text.isEmpty(), qPrintable(text));
      QVERIFY(rays[0] < rays[1]);
    }
  }

  /// A plan that is made to leave out what shows is extended, and says why.
  void theCheckFindsWhatIsMissing() {
    const Scene scene = openScene("bowl");
    const auto bound = bindMaterials(scene, materialsInSlots(scene, diffuseMaterial(Rgb(0.8))));
    const EffectThresholds loose{.remainder = 1.0 / 512};
    EffectPlan plan = planEffects(scene, bound);
    QVERIFY(!checkPlan(scene, bound, plan).findsMore(loose.remainder));
    plan.reflections = 1;
    const PlanCheck check = checkPlan(scene, bound, plan);
    QVERIFY(check.findsMore(loose.remainder));
    QVERIFY(check.omitted > 0.05 && check.standardError < 0.2 * check.omitted);
  }

  /// The sum of path terms: after n reflections no more light than after n + 1.
  void pathTermsAddUp() {
    const Scene scene = openScene("bowl");
    const auto bound = bindMaterials(scene, materialsInSlots(scene, diffuseMaterial(Rgb(0.8))));
    double last = 0;
    for (const int reflections : {1, 2, 3, 8}) {
      const EffectPlan plan = planEffects(scene, bound, {}, {.remainder = 1e-6, .maxReflections = reflections});
      QCOMPARE(plan.reflections, reflections);
      Film film(20, 20);
      PathTracer(scene, bound, plan).accumulate(film, 64);
      double mean = 0;
      for (const Rgb& sum : film.radiance) mean += sum.y;
      QVERIFY(mean > 1.01 * last);
      last = mean;
    }
  }
};

GONIO_TEST(RandomPlansTest)
}  // namespace random_plans_test

#include "random_plans_test.moc"
