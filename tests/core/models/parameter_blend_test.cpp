// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/model.h"

#include <QTest>
#include <cmath>

#include "core/models/registry.h"
#include "core/support/error.h"
#include "tests/support/test_program.h"

namespace parameter_blend_test {
using namespace gonio;
using namespace gonio::models;

ParameterValues ggxValues(const Rgb& diffuse, double roughness) {
  ParameterValues values = defaultParameters(ggx().spec());
  values.values[*ggx().spec().find("diffuse")] = diffuse;
  values.values[*ggx().spec().find("roughness")] = Rgb(roughness);
  return values;
}

ParameterValues blend(const std::vector<ParameterValues>& ends, const std::vector<double>& weights) {
  return blended(ggx().spec(), ends, weights);
}

class ParameterBlendTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void linearAndGeometricMeans() {
    const ParameterValues half =
        blend({ggxValues(Rgb(0.2, 0.4, 0), 0.1), ggxValues(Rgb(0.6, 0, 0), 0.4)}, {0.25, 0.75});
    const Rgb diffuse = half.values[*ggx().spec().find("diffuse")];
    QVERIFY(glm::length(diffuse - Rgb(0.5, 0.1, 0)) < 1e-15);
    QVERIFY(std::abs(half.values[*ggx().spec().find("roughness")].x - 0.1 * std::pow(4, 0.75)) < 1e-15);
    const ParameterValues three =
        blend({ggxValues(Rgb(0.3), 0.1), ggxValues(Rgb(0.6), 0.2), ggxValues(Rgb(0.9), 0.8)}, {0.5, 0.25, 0.25});
    QVERIFY(std::abs(three.values[*ggx().spec().find("diffuse")].y - 0.525) < 1e-15);
    QVERIFY(std::abs(three.values[*ggx().spec().find("roughness")].x - std::sqrt(0.1 * std::sqrt(0.16))) < 1e-15);
  }

  /// To the last bit, which means and logarithms would not give back.
  void equalValuesAndWholeEndsStayAsTheyAre() {
    for (int i = 1; i < 50; ++i) {
      const ParameterValues a = ggxValues(Rgb(0.1, 0.7, 0.3) / double(i), 0.9 / i), b = ggxValues(Rgb(0.4), 0.3);
      QVERIFY(blend({a, a, a}, {0.1, 0.2, 0.7}) == a);
      QVERIFY(blend({a, b}, {1, 0}) == a);
      QVERIFY(blend({b, a}, {0, 1}) == a);
    }
  }

  /// A logarithmic parameter may be 0: no logarithm of it is taken.
  void hardCase38ZeroOnALogarithmicScale() {
    const ParameterValues half = blend({ggxValues(Rgb(0), 0), ggxValues(Rgb(0), 0.4)}, {0.5, 0.5});
    QVERIFY(std::abs(half.values[*ggx().spec().find("roughness")].x - 0.2) < 1e-15);
  }

  void hardCase31ChoicesThatDiffer() {
    for (const Model* model : allModels()) {
      const auto parameters = model->spec().parameters;
      for (std::size_t p = 0; p < parameters.size(); ++p) {
        if (parameters[p].choices.size() < 2) continue;
        ParameterValues a = defaultParameters(model->spec()), b = a;
        b.values[p] = Rgb(a.values[p].x == 0 ? 1 : 0);
        const std::vector<ParameterValues> ends{a, b};
        try {
          blended(model->spec(), ends, std::vector{0.5, 0.5});
          QFAIL("blended two conventions");
        } catch (const Error& error) {
          QVERIFY(QString(error.what()).contains(QString::fromStdString(std::string(parameters[p].id))));
        }
      }
    }
  }
};

GONIO_TEST(ParameterBlendTest)
}  // namespace parameter_blend_test

#include "parameter_blend_test.moc"
