// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "tests/core/models/model_test_support.h"
#include "tests/support/test_program.h"

namespace series_models_test {
using namespace gonio;
using namespace gonio::models;
using namespace gonio::models::test_support;

bool near(double value, double expected, double tolerance = 1e-13) {
  return std::abs(value - expected) <= tolerance * std::max(1.0, std::abs(expected));
}

Direction halfOf(const Direction& wi, const Direction& wo) { return glm::normalize(wi + wo); }

/// Spherical harmonics, rational functions and DSBRDF against their definitions written out.
class SeriesModelsTest : public QObject {
  Q_OBJECT
 private:
  /// 200 pairs, and the value of one channel of the model beside what `expected` gives.
  template <typename Expected>
  static void compare(const Model& model, const ParameterValues& values, Expected expected) {
    std::mt19937_64 random(2);
    const auto brdf = model.instantiate(values);
    for (int n = 0; n < 200; ++n) {
      const Direction wi = randomDirection(random), wo = randomDirection(random);
      QVERIFY(near(brdf->evaluate(wi, wo).x, expected(wi, wo), 1e-12));
    }
  }

 private Q_SLOTS:
  void harmonicsOfOneBandPair() {
    const Model& model = sphericalHarmonics();
    const auto only = [&](std::initializer_list<std::pair<std::string_view, double>> changes) {
      ParameterValues values = parametersOf(model, {{"c-0-0-0", 0}});
      for (const auto& [id, value] : changes) values.values[model.spec().find(id).value()] = Rgb(value);
      return values;
    };
    compare(model, only({{"c-0-0-0", 2}}), [](auto, auto) { return 2 / (4 * pi); });
    compare(model, only({{"c-1-1-0", 2}}), [](auto wi, auto wo) { return 2 * 3 / (4 * pi) * wi.z * wo.z; });
    compare(model, only({{"c-1-0-0", 2}}), [](auto wi, auto wo) { return std::sqrt(3.0) / (4 * pi) * (wi.z + wo.z); });
    // y_11 y_11 + y_1-1 y_1-1: the cosine between the horizontal parts, cut where it is negative.
    compare(model, only({{"c-1-1-1", 2}}),
            [](auto wi, auto wo) { return std::max(0.0, 2 * 3 / (4 * pi) * (wi.x * wo.x + wi.y * wo.y)); });
    compare(model, only({{"c-1-1-0", 2}, {"c-1-1-1", 2}}),
            [](auto wi, auto wo) { return std::max(0.0, 2 * 3 / (4 * pi) * glm::dot(wi, wo)); });
  }

  /// The sum over all orders of a band is a Legendre polynomial of the angle between the directions.
  void harmonicsAddUpToLegendre() {
    const Model& model = sphericalHarmonics();
    ParameterValues values = parametersOf(model, {{"c-0-0-0", 30}});
    for (int m = 0; m <= 4; ++m) {
      const std::string id = "c-4-4-" + std::to_string(m);
      values.values[model.spec().find(id).value()] = Rgb(1);
    }
    compare(model, values, [](auto wi, auto wo) {
      const double c2 = glm::dot(wi, wo) * glm::dot(wi, wo), p4 = (35 * c2 * c2 - 30 * c2 + 3) / 8;
      return 30 / (4 * pi) + 9 / (4 * pi) * p4;
    });
  }

  void theWindowFadesTheBands() {
    const Model& model = sphericalHarmonics();
    compare(model, parametersOf(model, {{"c-0-0-0", 0}, {"c-1-1-0", 1}, {"window", 1}}), [](auto wi, auto wo) {
      const double w = (1 + std::cos(pi / 5)) / 2;
      return w * w * 3 / (4 * pi) * wi.z * wo.z;
    });
  }

  void rationalFunctionWrittenOut() {
    const Model& model = rational();
    compare(model,
            parametersOf(model, {{"p-0", 2},
                                 {"p-x", 3},
                                 {"p-y", 5},
                                 {"p-xx", 7},
                                 {"p-xy", 11},
                                 {"p-yy", 13},
                                 {"q-x", 17},
                                 {"q-y", 0.19},
                                 {"q-xx", 23},
                                 {"q-xy", 29},
                                 {"q-yy", 0.31}}),
            [](auto wi, auto wo) {
              const Direction h = halfOf(wi, wo);
              const double x = 1 - h.z, y = 1 - glm::dot(h, wi);
              return (2 + 3 * x + 5 * y + 7 * x * x + 11 * x * y + 13 * y * y) /
                     (1 + 17 * x + 0.19 * y + 23 * x * x + 29 * x * y + 0.31 * y * y);
            });
  }

  /// With a strength of exp(kappa) - 1 and constant curves the lobe is the published one.
  void dsbrdfLobeAsPublished() {
    const Model& model = dsbrdf();
    compare(model,
            parametersOf(model, {{"diffuse", 0.3},
                                 {"strength-1", std::expm1(2.0)},
                                 {"kappa-1-0", 2},
                                 {"kappa-1-45", 2},
                                 {"kappa-1-90", 2},
                                 {"gamma-1-0", 40},
                                 {"gamma-1-90", 40},
                                 {"strength-2", 0}}),
            [](auto wi, auto wo) { return 0.3 / pi + std::expm1(2 * std::pow(halfOf(wi, wo).z, 40)); });
  }

  /// The curves meet the values at 0, 45 and 90 degrees.
  void dsbrdfCurvesMeetTheirKnots() {
    const Model& model = dsbrdf();
    const auto brdf = model.instantiate(parametersOf(model, {{"diffuse", 0},
                                                             {"strength-1", 1},
                                                             {"kappa-1-0", 0.5},
                                                             {"kappa-1-45", 2},
                                                             {"kappa-1-90", 1},
                                                             {"gamma-1-0", 10},
                                                             {"gamma-1-90", 1000},
                                                             {"strength-2", 0}}));
    const auto mirror = [&](double degrees) {
      return brdf->evaluate(direction(degrees, 0), direction(degrees, 180)).x * std::expm1(0.5);
    };
    QVERIFY(near(mirror(0), std::expm1(0.5)));
    QVERIFY(near(mirror(45), std::expm1(2.0)));
    QVERIFY(near(mirror(90 - 1e-9), std::expm1(1.0), 1e-8));
    // Off the peak at 45 degrees gamma is the geometric mean: 100.
    const Direction wi = glm::normalize(Direction(1, 0.2, 1)), h = glm::normalize(Direction(0.1, 0, 1));
    const Direction tangent = glm::normalize(glm::cross(h, wi)), across = glm::cross(tangent, h);
    const double s = std::sqrt(0.5);
    const double value = brdf->evaluate(s * (h + across), s * (h - across)).x * std::expm1(0.5);
    QVERIFY(near(value, std::expm1(2 * std::pow(h.z, 100))));
  }
};

GONIO_TEST(SeriesModelsTest)
}  // namespace series_models_test

#include "series_models_test.moc"
