// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/models/registry.h"
#include "tests/support/test_program.h"

namespace layered_test {
using namespace gonio;
using models::ParameterValues;

const models::Model& model() { return models::layered(); }
std::size_t index(const char* id) { return *model().spec().find(id); }

/// All strengths 0, all lobes on.
ParameterValues black() {
  ParameterValues values = models::defaultParameters(model().spec());
  for (std::size_t i = 0; i < values.values.size(); ++i) {
    if (model().spec().parameters[i].linear) values.values[i] = Rgb(0);
    if (!model().spec().parameters[i].choices.empty()) values.values[i] = Rgb(1);
  }
  return values;
}
double at(const ParameterValues& p, const Direction& wi, const Direction& wo) {
  return model().instantiate(p)->evaluate(wi, wo).y;
}

class LayeredTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Estévez and Kulla 2017, eq. 2, over 4 (cos + cos - cos cos).
  void sheenHasItsClosedForm() {
    ParameterValues p = black();
    p.values[index("sheen")] = Rgb(0.7);
    p.values[index("sheen-roughness")] = Rgb(0.25);
    for (const double theta : {0.1, 0.6, 1.2, 1.5}) {
      const Direction w = fromSpherical(theta, 0.3);
      const double c = std::cos(theta), d = (2 + 4) * std::pow(std::sin(theta), 4) / (2 * pi);
      QVERIFY(std::abs(at(p, w, w) - 0.7 * d / (4 * (2 * c - c * c))) < 1e-12);
    }
  }

  /// The retroreflective lobe about the viewer is a microfacet lobe about the mirror direction with the viewer turned.
  void retroreflectionMirrorsALobe() {
    ParameterValues back = black(), forth = black();
    back.values[index("retro")] = forth.values[index("base")] = forth.values[index("base-edge")] = Rgb(0.3);
    back.values[index("retro-roughness")] = forth.values[index("base-roughness")] = Rgb(0.2);
    for (const double theta : {0.2, 0.9, 1.4})
      for (const double phi : {0.0, 0.7, 3.0}) {
        const Direction wi = fromSpherical(0.8, 0.4), wo = fromSpherical(theta, phi);
        const double expected = at(forth, wi, {-wo.x, -wo.y, wo.z});
        QVERIFY(std::abs(at(back, wi, wo) - expected) <= 1e-12 * expected);
        QVERIFY(std::abs(at(back, wi, wo) - at(back, wo, wi)) <= 1e-12 * expected);
      }
  }

  void aLobeThatIsOffIsBlack() {
    for (const auto& [strength, lobe] : {std::pair{"flakes", "flakes-lobe"},
                                         {"coat", "coat-lobe"},
                                         {"sheen", "sheen-lobe"},
                                         {"retro", "retro-lobe"}}) {
      ParameterValues p = black();
      p.values[index(strength)] = Rgb(1);
      const Direction w = fromSpherical(0.5, 1);
      QVERIFY(at(p, w, w) > 0);
      p.values[index(lobe)] = Rgb(0);
      QCOMPARE(at(p, w, w), 0.0);
      // The parts know it: an edit that switches a lobe changes it.
      ParameterValues on = p;
      on.values[index(lobe)] = Rgb(1);
      const auto off = model().lobes(p), lit = model().lobes(on);
      int different = 0;
      for (std::size_t k = 0; k < off.size(); ++k) different += off[k].colours != lit[k].colours;
      QCOMPARE(different, 1);
    }
  }

  /// From wide to sharp among those that are on; a lobe that is off keeps its place.
  void canonicalOrder() {
    ParameterValues p = black();
    p.values[index("flakes-lobe")] = Rgb(0);
    p.values[index("base-roughness")] = Rgb(0.1);
    p.values[index("flakes-roughness")] = Rgb(0.7);
    p.values[index("coat-roughness")] = Rgb(0.4);
    p.values[index("base")] = Rgb(0.5);
    const ParameterValues sorted = model().canonical(p);
    QCOMPARE(sorted.values[index("base-roughness")].x, 0.4);
    QCOMPARE(sorted.values[index("coat-roughness")].x, 0.1);
    QCOMPARE(sorted.values[index("coat")].x, 0.5);
    QCOMPARE(sorted.values[index("flakes-roughness")].x, 0.7);
  }
};

GONIO_TEST(LayeredTest)
}  // namespace layered_test

#include "layered_test.moc"
