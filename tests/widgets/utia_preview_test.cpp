// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>
#include <random>

#include "core/brdf/utia_brdf.h"
#include "core/models/registry.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_spheres.h"
#include "tests/widgets/shader_values.h"

namespace utia_preview_test {
using namespace gonio;
using namespace gonio::rendering;

/// Values of four orders of magnitude, without a pattern: neighbours differ as much as they can.
constexpr double smallest = 1e-3, largest = 10;

std::shared_ptr<const UtiaBrdf> randomMaterial() {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> exponent(std::log(smallest), std::log(largest));
  std::vector<glm::vec3> values(UtiaBrdf::directionCount * UtiaBrdf::directionCount);
  for (glm::vec3& value : values)
    for (int channel = 0; channel < 3; ++channel) value[channel] = float(std::exp(exponent(random)));
  return std::make_shared<const UtiaBrdf>(std::move(values));
}

/// A brushed metal of two anisotropic lobes, another one for each order of the directions.
std::shared_ptr<const UtiaBrdf> brushedMaterial() {
  std::vector<Direction> directions;
  for (std::size_t i = 0; i < UtiaBrdf::directionCount; ++i)
    directions.push_back(fromSpherical(double(i / UtiaBrdf::azimuthCount) * UtiaBrdf::polarStep,
                                       double(i % UtiaBrdf::azimuthCount) * UtiaBrdf::azimuthStep));
  std::vector<glm::vec3> values;
  for (const Direction& incident : directions)
    for (const Direction& viewing : directions) {
      const Direction half = glm::normalize(incident + viewing);
      const double along = half.x / half.z, across = half.y / half.z;
      const double lobe = std::exp(-along * along / 0.5 - across * across / 0.05);
      values.emplace_back(0.1 + 0.6 * lobe, 0.1 + 0.4 * lobe * viewing.z, 0.05 + 0.2 * incident.z);
    }
  return std::make_shared<const UtiaBrdf>(std::move(values));
}

/// Random pairs, among them nodes, the pole, the seam of the azimuths and directions beyond the last polar angle.
std::vector<DirectionPair> testPairs() {
  std::mt19937_64 random(7);
  std::vector<Direction> special{{0, 0, 1}, {1e-6, 0, 1}, fromSpherical(1.4, 2), fromSpherical(halfPi - 1e-6, 1)};
  for (const double theta : {radians(15), radians(75)})
    for (const double phi : {0.0, pi, -pi + 1e-7, radians(7.5), radians(-97.5)})
      special.push_back(fromSpherical(theta, phi));
  std::vector<DirectionPair> pairs;
  for (const Direction& wi : special)
    for (const Direction& wo : special) pairs.push_back({wi, wo});
  while (pairs.size() < test::ShaderValues::count)
    pairs.push_back({test::randomUpper(random), test::randomUpper(random)});
  for (DirectionPair& pair : pairs) pair = {test::rounded(pair.wi), test::rounded(pair.wo)};
  return pairs;
}

/// The shader's UTIA materials are those of core/brdf/utia_brdf.h.
class UtiaPreviewTest : public test::SphereTest {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { openSpheres(); }

  /// The texture is float32 and the arithmetic float: half precision would be off by 5e-4 of a value.
  void pairsOfDirections() {
    test::ShaderValues shader(testPairs());
    const auto brdf = randomMaterial();
    for (const IncidentDirection incident : allIncidentDirections) {
      const auto ordered = brdf->withIncident(incident);
      const double error = worst(shader, {ordered});
      qInfo("%s: %.1e of the largest value", incidentDirectionId(incident), error / largest);
      QVERIFY(error < 1e-5 * largest);
    }
  }

  void picturesOfEveryOrder() {
    for (const IncidentDirection incident : allIncidentDirections)
      verify(brushedMaterial()->withIncident(incident), {}, sphereScene());
    verify(brushedMaterial(), {}, sphereScene(studioEnvironment(), {.yaw = 0.4, .pitch = 0.2}), 30);
  }

  void picturesOfEdits() {
    for (const auto composition :
         {editing::Composition::additive, editing::Composition::logPlus, editing::Composition::lobes})
      verify(brushedMaterial(), {test::rougherEdit("ggx", "roughness", 0.5, composition)}, sphereScene());
  }

 private:
  static double worst(test::ShaderValues& shader, const widgets::EditedMaterial& material) {
    const std::vector<Rgb> found = shader.evaluate(material);
    const auto brdf = editing::applyEdits(material.base, material.edits);
    std::vector<Rgb> expected(found.size());
    brdf->evaluate(shader.pairs(), expected);
    double error = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
      error = std::max(error, maxChannel(glm::abs(found[i] - expected[i])));
    return error;
  }

  void verify(const std::shared_ptr<const Brdf>& base, const editing::EditList& edits, const Scene& scene,
              double least = 50) {
    widgets::PreviewSubject subject{widgets::EditedMaterial{base, edits}};
    subject.density = std::make_shared<const TabulatedDensity>(*widgets::subjectBrdf(subject));
    SphereTest::verify(subject, scene, least);
  }
};

GONIO_TEST(UtiaPreviewTest)
}  // namespace utia_preview_test

#include "utia_preview_test.moc"
