// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/scene_light.h"

#include <QTest>
#include <cmath>
#include <limits>

#include "tests/support/random_scenes.h"
#include "tests/support/test_program.h"

namespace scene_light_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::geometry;
using namespace gonio::test;

constexpr double infinity = std::numeric_limits<double>::infinity();
using Kind = SceneLight::Kind;

std::vector<Shape> meshes() {
  const auto cube = shared(TriangleMesh(cubeArrays()));
  return {meshShape(TriangleMesh(cubeArrays())), meshShape(torusMesh()),
          meshShape(transformed(*cube, placement(0.3, 0.7, {0.4, 0.2, 0}))),
          meshShape(transformed(bowlMesh(), placement(0.8, 0.1, {-0.6, 0.3, 0.5}))),
          meshShape(transformed(sphereMesh(1, 8, 10), placement(0.4, 0, {1, -0.5, 0.3})))};
}

Shape randomShape(const std::vector<Shape>& known, std::mt19937_64& random) {
  switch (random() % 3) {
    case 0:
      return Sphere{2.5 * uniform(random) * randomDirection(random), 0.05 + uniform(random)};
    case 1:
      return randomRectangle(random, 2.5);
    default:
      return known[random() % known.size()];
  }
}

/// Three objects, a lamp among them, a distant and a point light, and the furnace.
Scene randomScene(const std::vector<Shape>& known, std::mt19937_64& random) {
  Scene scene;
  for (int i = 0; i < 3; ++i) scene.objects.push_back({.name = "thing", .shape = randomShape(known, random)});
  scene.objects.push_back({.name = "lamp", .shape = randomRectangle(random, 3), .radiance = Rgb(1)});
  scene.directionalLights.push_back({randomDirection(random), Rgb(1)});
  scene.pointLights.push_back({3 * uniform(random) * randomDirection(random), Rgb(1)});
  scene.environment = furnaceEnvironment();
  return scene;
}

struct Counts {
  int reached = 0, blocked = 0, seen = 0, noes = 0, freePairs = 0;
};

/// What a hundred ways by chance show of a receiver, a light and a blocker, against what the analysis says.
void checkBlocking(const Scene& scene, const SceneLight& light, std::size_t receiver, std::size_t blocker,
                   std::mt19937_64& random, Counts& counts) {
  const SceneObject &from = scene.objects[receiver], &between = scene.objects[blocker];
  bool reached = false, blocked = false;
  for (int n = 0; n < 60; ++n) {
    const SurfacePoint start = randomSurfacePoint(from.shape, random);
    const Way way = randomWay(scene, light, start.position, random);
    if (!(way.length > 0) || !(glm::dot(way.direction, start.normal) > 1e-6)) continue;
    reached = true;
    blocked = blocked ||
              blocks(between.shape, {start.position + 1e-5 * start.normal, way.direction}, 0, way.length * (1 - 1e-5));
  }
  if (from.emits()) {
    QVERIFY(!canReach(scene, light, from));
    return;
  }
  counts.reached += reached;
  if (reached) QVERIFY(canReach(scene, light, from));
  if (light.kind == Kind::rectangle && light.index == blocker) {
    QVERIFY(!mayBlock(scene, light, from, between));
    return;
  }
  const bool mayBe = mayBlock(scene, light, from, between);
  counts.blocked += blocked;
  if (blocked)
    QVERIFY2(mayBe, qPrintable(QString("shape %1 before shape %2 in light %3")
                                   .arg(between.shape.index())
                                   .arg(from.shape.index())
                                   .arg(int(light.kind))));
  else if (reached && light.kind != Kind::environment && blocker != receiver)
    ++counts.freePairs, counts.noes += !mayBe;
}

void checkSeeing(const SceneObject& receiver, const SceneObject& other, std::mt19937_64& random, Counts& counts) {
  bool sees = false;
  for (int n = 0; n < 60; ++n) {
    const SurfacePoint a = randomSurfacePoint(receiver.shape, random), b = randomSurfacePoint(other.shape, random);
    const Direction way = b.position - a.position;
    // Between points of one shape only what is clear of its own surface counts.
    sees = sees || (glm::dot(way, a.normal) > 1e-3 && glm::dot(way, b.normal) < -1e-3);
  }
  if (receiver.emits() || other.emits()) sees = false;
  counts.seen += sees;
  if (sees) QVERIFY(maySee(receiver, other));
}

SceneObject object(const Shape& shape) { return {.name = "thing", .shape = shape}; }
Rectangle ground(double y = -1) { return {{0, y, 0}, {0, 0, 5}, {5, 0, 0}}; }

/// Objects under one light.
Scene under(std::vector<SceneObject> objects, const PointLight& light) {
  Scene scene;
  scene.objects = std::move(objects);
  scene.pointLights = {light};
  return scene;
}
Scene under(std::vector<SceneObject> objects, const Direction& toLight) {
  Scene scene;
  scene.objects = std::move(objects);
  scene.directionalLights = {{glm::normalize(toLight), Rgb(1)}};
  return scene;
}
bool blocked(const Scene& scene, std::size_t receiver, std::size_t blocker) {
  return mayBlock(scene, lightsOf(scene).front(), scene.objects[receiver], scene.objects[blocker]);
}
bool reached(const Scene& scene, std::size_t receiver) {
  return canReach(scene, lightsOf(scene).front(), scene.objects[receiver]);
}

class SceneLightTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The analysis may say "may be" too often, never "no" where one ray by chance says yes; and it does say "no".
  void neverNoWhereARaySaysYes() {
    std::mt19937_64 random(1);
    const std::vector<Shape> known = meshes();
    Counts counts;
    for (int n = 0; n < 150; ++n) {
      const Scene scene = randomScene(known, random);
      for (const SceneLight& light : lightsOf(scene))
        for (std::size_t receiver = 0; receiver < scene.objects.size(); ++receiver)
          for (std::size_t blocker = 0; blocker < scene.objects.size(); ++blocker)
            checkBlocking(scene, light, receiver, blocker, random, counts);
      for (const SceneObject& receiver : scene.objects)
        for (const SceneObject& other : scene.objects) checkSeeing(receiver, other, random, counts);
      if (QTest::currentTestFailed()) return;
    }
    QVERIFY(counts.reached > 3000 && counts.blocked > 1000 && counts.seen > 500);
    qInfo("%d of %d pairs without a blocked way are known to be free", counts.noes, counts.freePairs);
    QVERIFY(counts.noes > 0.7 * counts.freePairs);
  }

  /// Fraction of the cosine-weighted hemisphere that an object fills at points by chance: never above the bound.
  void formFactorsAreBounds() {
    std::mt19937_64 random(2);
    const std::vector<Shape> known = meshes();
    int close = 0;
    for (int n = 0; n < 100; ++n) {
      const SceneObject receiver = object(randomShape(known, random)), other = object(randomShape(known, random));
      const double bound = maxFormFactor(receiver, other);
      QVERIFY(bound > 0 && bound <= 1);
      for (int k = 0; k < 5; ++k) {
        const SurfacePoint point = randomSurfacePoint(receiver.shape, random);
        constexpr int rays = 400;
        int hits = 0;
        for (int i = 0; i < rays; ++i) {
          // Cosine-weighted: a point of the unit sphere on top of the normal.
          const Ray ray{point.position + 1e-6 * point.normal, glm::normalize(point.normal + randomDirection(random))};
          hits += blocks(other.shape, ray, 0, infinity);
        }
        const double fraction = double(hits) / rays, deviation = std::sqrt(bound * (1 - bound) / rays);
        QVERIFY(fraction <= bound + 5 * deviation + 1e-12);
        close += fraction > 0.3 * bound && bound < 0.9;
      }
    }
    QVERIFY(close > 20);
    const SceneObject a = object(Sphere{{0, 0, 0}, 1}), b = object(Sphere{{5, 0, 0}, 2});
    QCOMPARE(maxFormFactor(a, b), 0.25);
    QCOMPARE(maxFormFactor(a, a), 1.0);
  }

  void sourcesInTheirOrder() {
    Scene scene;
    QVERIFY(lightsOf(scene).empty());
    scene.directionalLights = {{{0, 1, 0}, Rgb(0)}, {{0, 1, 0}, Rgb(0, 1, 0)}};
    scene.pointLights = {{{0, 1, 0}, Rgb(0)}, {{0, 1, 0}, Rgb(1)}};
    scene.objects = {object(Sphere{}), {.name = "the lamp", .shape = Rectangle{}, .radiance = Rgb(1)}};
    scene.environment = std::make_shared<const EnvironmentMap>(Image(4, 2), "night");
    const std::vector<SceneLight> lights = lightsOf(scene);
    QVERIFY((lights == std::vector<SceneLight>{{Kind::directional, 1}, {Kind::point, 1}, {Kind::rectangle, 1}}));
    QCOMPARE(lightName(scene, lights[0]), std::string("distant light 2"));
    QCOMPARE(lightName(scene, lights[1]), std::string("point light 2"));
    QCOMPARE(lightName(scene, lights[2]), std::string("the lamp"));
    scene.environment = furnaceEnvironment();
    QCOMPARE(lightName(scene, lightsOf(scene).back()), std::string("the environment 'furnace'"));
    scene.directionalLights.pop_back();
    QCOMPARE(lightName(scene, {Kind::directional, 0}), std::string("the distant light"));
  }

  void aLoneSphereHasNoShadow() {
    const Scene scene = under({object(Sphere{})}, Direction(1, 1, 2));
    QVERIFY(reached(scene, 0) && !blocked(scene, 0, 0));
    QVERIFY(!maySee(scene.objects[0], scene.objects[0]));
    const Scene ring = under({object(meshShape(torusMesh()))}, Direction(1, 1, 2));
    QVERIFY(reached(ring, 0) && blocked(ring, 0, 0) && maySee(ring.objects[0], ring.objects[0]));
  }

  /// What rests on a plane is not shaded by it, at any size; it shades the plane.
  void aSphereOnTheGround() {
    for (const double size : {1.0, 1e-4, 1e4})
      for (const double radius : {1.0, 0.01}) {
        const Rectangle plane{{0, -size * radius, 0}, {0, 0, 5 * size}, {5 * size, 0, 0}};
        const std::vector<SceneObject> objects{object(Sphere{{0, 0, 0}, size * radius}), object(plane)};
        const PointLight lamp{Direction(-2, 3, 2.5) * size, Rgb(1)};
        for (const Scene& scene : {under(objects, Direction(0.3, 1, 0.2)), under(objects, lamp)}) {
          QVERIFY(!blocked(scene, 0, 1));
          QVERIFY(blocked(scene, 1, 0));
        }
        // Light from below is kept from the sphere, and does not reach the plane's front.
        const Scene below = under(objects, Direction(0.1, -1, 0));
        QVERIFY(blocked(below, 0, 1) && !reached(below, 1));
      }
    // A speck on a wide plane is no rounding.
    const Scene speck =
        under({object(Sphere{{0, 1e-4, 0}, 1e-4}), object(Rectangle{{0, 0, 0}, {0, 0, 1e6}, {1e6, 0, 0}})},
              Direction(0, 1, 0));
    QVERIFY(blocked(speck, 1, 0) && !blocked(speck, 0, 1));
  }

  void aLightBetweenTwoObjects() {
    const std::vector<SceneObject> objects{object(Sphere{{-2, 0, 0}, 1}), object(Sphere{{2, 0, 0}, 1})};
    const Scene scene = under(objects, PointLight{{0, 0, 0}, Rgb(1)});
    QVERIFY(!blocked(scene, 0, 1) && !blocked(scene, 1, 0));
    // Beyond both, one stands in the way of the other.
    const Scene beyond = under(objects, PointLight{{5, 0, 0}, Rgb(1)});
    QVERIFY(blocked(beyond, 0, 1) && !blocked(beyond, 1, 0));
  }

  void spheresSideBySide() {
    const auto scene = [](const Direction& second) {
      return under({object(Sphere{{0, 0, 0}, 1}), object(Sphere{second, 1})}, Direction(0, 1, 0));
    };
    QVERIFY(!blocked(scene({2.01, 0, 0}), 0, 1) && !blocked(scene({2.01, 0, 0}), 1, 0));
    QVERIFY(!blocked(scene({2, 0, 0}), 0, 1));
    QVERIFY(blocked(scene({1.9, 2.5, 0}), 0, 1) && !blocked(scene({1.9, 2.5, 0}), 1, 0));
    QVERIFY(!blocked(scene({1.5, -3, 1.5}), 0, 1));
    QVERIFY(!blocked(scene({1.5, 3, 1.5}), 0, 1));
    QVERIFY(blocked(scene({1.4, 3, 1.4}), 0, 1));
  }

  /// Lamps send from their front alone, and rectangles are lit on theirs.
  void frontsAndBacks() {
    const SceneObject lamp{.name = "lamp", .shape = Rectangle{{0, 2, 0}, {1, 0, 0}, {0, 0, 1}}, .radiance = Rgb(1)};
    QCOMPARE(std::get<Rectangle>(lamp.shape).normal().y, -1.0);
    const auto lit = [&](const Shape& shape) {
      Scene scene;
      scene.objects = {object(shape), lamp};
      return reached(scene, 0);
    };
    QVERIFY(lit(Sphere{}) && lit(Sphere{{0, 2.5, 0}, 0.6}) && !lit(Sphere{{0, 4, 0}, 1}));
    QVERIFY(lit(ground()) && !lit(ground(3)));
    QVERIFY(!lit(Rectangle{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}));
    // All of the lamp inside a sphere or a convex mesh lights its outside nowhere.
    QVERIFY(!lit(Sphere{{0, 2, 0}, 1.5}) && lit(Sphere{{0, 2, 0}, 1.4}));
    const auto cube = shared(TriangleMesh(cubeArrays()));
    QVERIFY(!lit(meshShape(transformed(*cube, placement(1.1, 0, {0, 2, 0})))));
    QVERIFY(lit(meshShape(transformed(*cube, placement(0.9, 0, {0, 2, 0})))));
    // It stands in the way of its own light nowhere, of other light it does, from both sides.
    Scene scene = under({object(Sphere{}), lamp}, Direction(0, 1, 0));
    QVERIFY(blocked(scene, 0, 1));
    scene.directionalLights.clear();
    QVERIFY(!blocked(scene, 0, 1));
  }

  void whatLiesBehindTheLight() {
    const Scene scene = under({object(Sphere{}), object(Sphere{{0, 6, 0}, 1})}, PointLight{{0, 3, 0}, Rgb(1)});
    QVERIFY(!blocked(scene, 0, 1) && !blocked(scene, 1, 0));
    QVERIFY(reached(scene, 0) && reached(scene, 1));
  }

  void lightInsideASphereReachesNoOutside() {
    const Scene scene = under({object(Sphere{}), object(Sphere{{4, 0, 0}, 1})}, PointLight{{0.3, 0, 0}, Rgb(1)});
    QVERIFY(!reached(scene, 0) && reached(scene, 1) && blocked(scene, 1, 0));
  }

  void environmentIsShadedByAllBeforeTheFront() {
    Scene scene;
    scene.environment = furnaceEnvironment();
    scene.objects = {object(ground()), object(Sphere{}), object(Sphere{{0, -3, 0}, 1}),
                     object(Rectangle{{0, 5, 0}, {0, 0, 1}, {1, 0, 0}})};
    QVERIFY(blocked(scene, 0, 1) && !blocked(scene, 0, 2) && blocked(scene, 0, 3));
    QVERIFY(blocked(scene, 1, 0) && blocked(scene, 1, 2));
    QVERIFY(maySee(scene.objects[0], scene.objects[1]) && !maySee(scene.objects[0], scene.objects[2]));
    QVERIFY(!maySee(scene.objects[0], scene.objects[3]));
  }
};

GONIO_TEST(SceneLightTest)
}  // namespace scene_light_test

#include "scene_light_test.moc"
