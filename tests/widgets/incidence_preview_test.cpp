// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>
#include <random>

#include "core/brdf/incidence_table_brdf.h"
#include "core/models/registry.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_spheres.h"
#include "tests/widgets/shader_values.h"

namespace incidence_preview_test {
using namespace gonio;
using Axis = IncidenceTable::Axis;

std::vector<double> uneven(double first, double last, int count) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) {
    const double fraction = i / (count - 1.0);
    angles.push_back(first + (last - first) * (0.4 * fraction + 0.6 * fraction * fraction));
  }
  return angles;
}

/// A highlight about the mirror direction with a random texture, another one for each azimuth of the light.
std::shared_ptr<const IncidenceTableBrdf> material(Axis axis, bool symmetric, const std::vector<double>& rotations) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0.5f, 1);
  IncidenceTable table{.axis = axis, .symmetric = symmetric};
  table.incident = uneven(radians(5), radians(70), 5);
  table.azimuths = symmetric ? uneven(0, pi, 9) : uneven(radians(10), radians(350), 14);
  table.polars = uneven(0, axis == Axis::mirror ? radians(150) : halfPi, 25);
  table.rotations = rotations;
  for (const double rotation : rotations)
    for (const double i : table.incident)
      for (const double a : table.azimuths)
        for (const double p : table.polars) {
          const double off = axis == Axis::mirror ? p : std::acos(glm::dot(fromSpherical(p, a), fromSpherical(i, pi)));
          const double lobe = 0.1 + (1 + std::cos(2 * rotation)) * std::exp(-off * off / 0.1);
          table.values.emplace_back(lobe * uniform(random), lobe * uniform(random), 0.3f * uniform(random));
        }
  return std::make_shared<const IncidenceTableBrdf>(std::move(table));
}

std::vector<DirectionPair> randomPairs() {
  std::mt19937_64 random(7);
  std::vector<DirectionPair> pairs{{{0, 0, 1}, {0, 0, 1}}, {fromSpherical(1, 2), fromSpherical(1, 2 - pi)}};
  while (pairs.size() < test::ShaderValues::count)
    pairs.push_back({test::randomUpper(random), test::randomUpper(random)});
  for (DirectionPair& pair : pairs) pair = {test::rounded(pair.wi), test::rounded(pair.wo)};
  return pairs;
}

/// Whether the value jumps there: an angle of incidence counts as long as its viewer is above the horizon.
bool jumps(const Brdf& brdf, const DirectionPair& pair, double tolerance) {
  std::mt19937_64 random(1);
  const Rgb value = brdf.evaluate(pair.wi, pair.wo);
  for (int i = 0; i < 16; ++i) {
    const Direction wi = glm::normalize(pair.wi + 1e-5 * (test::randomUpper(random) - Direction(0, 0, 0.5)));
    const Direction wo = glm::normalize(pair.wo + 1e-5 * (test::randomUpper(random) - Direction(0, 0, 0.5)));
    if (maxChannel(glm::abs(brdf.evaluate(wi, wo) - value)) > tolerance) return true;
  }
  return false;
}

/// The shader's tables of angles of incidence are those of core/brdf/incidence_table_brdf.h.
class IncidencePreviewTest : public test::SphereTest {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { openSpheres(); }

  void forms_data() {
    QTest::addColumn<bool>("aboutMirror");
    QTest::addColumn<bool>("symmetric");
    QTest::addColumn<std::vector<double>>("rotations");
    for (const bool mirror : {true, false})
      for (const bool symmetric : {true, false})
        for (const auto& rotations : {std::vector<double>{0}, uneven(radians(20), radians(280), 5)})
          QTest::addRow("about the %s, %s, %d azimuths of the light", mirror ? "mirror direction" : "normal",
                        symmetric ? "symmetric" : "whole circle", int(rotations.size()))
              << mirror << symmetric << rotations;
  }
  void forms() {
    QFETCH(bool, aboutMirror);
    QFETCH(bool, symmetric);
    QFETCH(std::vector<double>, rotations);
    const auto brdf = material(aboutMirror ? Axis::mirror : Axis::normal, symmetric, rotations);
    QVERIFY(widgets::isShownNatively(*brdf) && brdf->isIsotropic() == (rotations.size() == 1));
    comparePairs(*brdf, brdf);
    verify({widgets::EditedMaterial{brdf}});
    verify(
        {widgets::EditedMaterial{brdf, {test::rougherEdit("ggx", "roughness", 0.5, editing::Composition::logPlus)}}});
  }

 private:
  void comparePairs(const Brdf& brdf, const std::shared_ptr<const Brdf>& base) {
    constexpr double tolerance = 5e-6;
    test::ShaderValues shader(randomPairs());
    const std::vector<Rgb> found = shader.evaluate({base});
    double worst = 0;
    int left = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const DirectionPair& pair = shader.pairs()[i];
      const double error = maxChannel(glm::abs(found[i] - brdf.evaluate(pair.wi, pair.wo)));
      if (error > tolerance && jumps(brdf, pair, 1e-3)) {
        ++left;
        continue;
      }
      worst = std::max(worst, error);
    }
    qInfo("%.1e; %d pairs at jumps", worst, left);
    QVERIFY(worst < tolerance && left < 10);
  }
};

GONIO_TEST(IncidencePreviewTest)
}  // namespace incidence_preview_test

#include "incidence_preview_test.moc"
