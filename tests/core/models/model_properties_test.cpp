// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "tests/core/models/model_test_support.h"
#include "tests/support/test_program.h"

namespace model_properties_test {
using namespace gonio;
using namespace gonio::models;
using namespace gonio::models::test_support;

bool finiteAndNotNegative(const Rgb& value) {
  for (int c = 0; c < 3; ++c)
    if (!std::isfinite(value[c]) || !(value[c] >= 0)) return false;
  return true;
}

/// Equal to `tolerance`, relative where the values are large.
bool near(const Rgb& a, const Rgb& b, double tolerance) {
  for (int c = 0; c < 3; ++c)
    if (!(std::abs(a[c] - b[c]) <= tolerance * std::max({1.0, std::abs(a[c]), std::abs(b[c])}))) return false;
  return true;
}

Direction rotated(const Direction& w, double phi) {
  return {std::cos(phi) * w.x - std::sin(phi) * w.y, std::sin(phi) * w.x + std::cos(phi) * w.y, w.z};
}

/// What holds for every model, at parameters drawn from the whole of the sliders' ranges.
class ModelPropertiesTest : public QObject {
  Q_OBJECT
 private:
  static constexpr int draws = 30;

  static void forRandomMaterials(const std::function<void(const Brdf&, std::mt19937_64&)>& check) {
    std::mt19937_64 random(3);
    for (const Model* model : allModels())
      for (int n = 0; n < draws && !QTest::currentTestFailed(); ++n)
        check(*model->instantiate(randomParameters(model->spec(), random)), random);
  }

 private Q_SLOTS:
  void hardCase48Reciprocity() {
    std::mt19937_64 random(3);
    for (const Model* model : allModels()) {
      int broken = 0;
      for (int n = 0; n < draws; ++n) {
        const auto brdf = model->instantiate(randomParameters(model->spec(), random));
        for (int m = 0; m < 300; ++m) {
          const Direction wi = randomDirection(random), wo = randomDirection(random);
          broken += !near(brdf->evaluate(wi, wo), brdf->evaluate(wo, wi), 1e-12);
        }
      }
      // A model that does not claim it is not: the claim says something.
      QVERIFY2((broken == 0) == model->spec().reciprocal, model->spec().id.data());
      const auto usual = model->instantiate(models::defaultParameters(model->spec()));
      QCOMPARE(usual->isReciprocal(), model->spec().reciprocal);
    }
  }

  /// Isotropic models have no left and no right; a grain has.
  void mirrorSymmetry() {
    int asymmetric = 0;
    forRandomMaterials([&](const Brdf& brdf, std::mt19937_64& random) {
      QCOMPARE(brdf.isMirrorSymmetric(), brdf.isIsotropic());
      for (int m = 0; m < 100; ++m) {
        const Direction wi = randomDirection(random), wo = randomDirection(random);
        const auto mirrored = [](const Direction& w) { return Direction(w.x, -w.y, w.z); };
        const bool isEqual = near(brdf.evaluate(wi, wo), brdf.evaluate(mirrored(wi), mirrored(wo)), 1e-12);
        QVERIFY(isEqual || !brdf.isMirrorSymmetric());
        asymmetric += !isEqual;
      }
    });
    QVERIFY(asymmetric > 0);
  }

  /// A model without parameters of two axes is isotropic; one with them is where each pair is equal, and looks the same
  /// from the opposite side otherwise.
  void isotropy() {
    std::mt19937_64 random(3);
    for (const Model* model : allModels())
      for (int n = 0; n < draws; ++n) {
        const ModelSpec& spec = model->spec();
        ParameterValues values = randomParameters(spec, random);
        const bool hasAxes = std::any_of(spec.parameters.begin(), spec.parameters.end(),
                                         [](const ParameterSpec& p) { return !p.isotropicTwin.empty(); });
        const bool equalAxes = n % 2 == 0;
        for (std::size_t i = 0; equalAxes && i < spec.parameters.size(); ++i)
          if (!spec.parameters[i].isotropicTwin.empty())
            values.values[i] = values.values[spec.find(spec.parameters[i].isotropicTwin).value()];
        const auto brdf = model->instantiate(values);
        QCOMPARE(brdf->isIsotropic(), equalAxes || !hasAxes);
        for (int m = 0; m < 100; ++m) {
          const Direction wi = randomDirection(random), wo = randomDirection(random);
          const double phi = brdf->isIsotropic() ? double(m) : pi;
          QVERIFY2(near(brdf->evaluate(wi, wo), brdf->evaluate(rotated(wi, phi), rotated(wo, phi)), 1e-9),
                   spec.id.data());
        }
      }
  }

  /// Turned by a quarter, with the axes exchanged: the same surface.
  void hardCase49AxesExchanged() {
    std::mt19937_64 random(3);
    for (const Model* model : allModels())
      for (int n = 0; n < draws; ++n) {
        const ModelSpec& spec = model->spec();
        const ParameterValues values = randomParameters(spec, random);
        ParameterValues exchanged = values;
        for (std::size_t i = 0; i < spec.parameters.size(); ++i)
          if (const auto twin = spec.find(spec.parameters[i].isotropicTwin))
            std::swap(exchanged.values[i], exchanged.values[*twin]);
        const auto one = model->instantiate(values), other = model->instantiate(exchanged);
        for (int m = 0; m < 100; ++m) {
          const Direction wi = randomDirection(random), wo = randomDirection(random);
          const auto turned = [](const Direction& w) { return Direction(-w.y, w.x, w.z); };
          QVERIFY2(near(one->evaluate(wi, wo), other->evaluate(turned(wi), turned(wo)), 1e-12), spec.id.data());
        }
      }
  }

  /// A rotation of the grain is a rotation of the surface, the other way round of the directions.
  void rotationsTurnTheSurface() {
    std::mt19937_64 random(3);
    for (const Model* model : allModels()) {
      const auto index = model->spec().find("rotation");
      if (!index) continue;
      for (int n = 0; n < draws; ++n) {
        const ParameterValues values = randomParameters(model->spec(), random);
        ParameterValues straight = values;
        straight.values[*index] = Rgb(0);
        const double angle = values.values[*index].x;
        const auto turned = model->instantiate(values), plain = model->instantiate(straight);
        for (int m = 0; m < 100; ++m) {
          const Direction wi = randomDirection(random), wo = randomDirection(random);
          QVERIFY2(near(turned->evaluate(rotated(wi, angle), rotated(wo, angle)), plain->evaluate(wi, wo), 1e-9),
                   model->spec().id.data());
        }
      }
    }
  }

  /// Canonical parameters are of the same surface, in their ranges, and stay as they are.
  void canonicalParametersGiveTheSameValues() {
    std::mt19937_64 random(7);
    for (const Model* model : allModels())
      for (int n = 0; n < draws; ++n) {
        const ParameterValues values = randomParameters(model->spec(), random);
        ParameterValues canonical = model->canonical(values);
        QVERIFY(clampToHardRange(model->spec(), canonical).empty());
        QVERIFY(model->canonical(canonical) == canonical);
        const auto one = model->instantiate(values), other = model->instantiate(canonical);
        for (int m = 0; m < 50; ++m) {
          const Direction wi = randomDirection(random), wo = randomDirection(random);
          QVERIFY2(near(one->evaluate(wi, wo), other->evaluate(wi, wo), 1e-9), model->spec().id.data());
        }
      }
  }

  void batchIsTheSameAsOneByOne() {
    forRandomMaterials([](const Brdf& brdf, std::mt19937_64& random) {
      std::vector<DirectionPair> pairs(50);
      for (DirectionPair& pair : pairs) pair = {randomDirection(random), -randomDirection(random)};
      for (std::size_t i = 0; i < pairs.size(); i += 2) pairs[i].wo = -pairs[i].wo;
      std::vector<Rgb> values(pairs.size());
      brdf.evaluate(pairs, values);
      for (std::size_t i = 0; i < pairs.size(); ++i) QCOMPARE(values[i], brdf.evaluate(pairs[i].wi, pairs[i].wo));
    });
  }

  /// The value is the sum of its linear parameters, each times something that does not depend on them.
  void linearParametersAreLinear() {
    std::mt19937_64 random(5);
    for (const Model* model : allModels()) {
      const ModelSpec& spec = model->spec();
      for (int n = 0; n < draws; ++n) {
        const ParameterValues values = randomParameters(spec, random);
        const Direction wi = randomDirection(random), wo = randomDirection(random);
        Rgb sum(0);
        for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
          if (!spec.parameters[i].linear) continue;
          ParameterValues alone = values;
          for (std::size_t j = 0; j < spec.parameters.size(); ++j)
            if (spec.parameters[j].linear) alone.values[j] = Rgb(i == j ? 1 : 0);
          sum += values.values[i] * model->instantiateUnclamped(alone)->evaluate(wi, wo);
        }
        QVERIFY(near(model->instantiateUnclamped(values)->evaluate(wi, wo), sum, 1e-12));
      }
    }
  }

  /// The two differ only by the cut at 0.
  void clampedIsTheUnclampedCutAtZero() {
    std::mt19937_64 random(6);
    for (const Model* model : allModels())
      for (int n = 0; n < draws; ++n) {
        const ParameterValues values = randomParameters(model->spec(), random);
        const Direction wi = randomDirection(random), wo = randomDirection(random);
        QCOMPARE(model->instantiate(values)->evaluate(wi, wo),
                 glm::max(model->instantiateUnclamped(values)->evaluate(wi, wo), 0.0));
      }
  }

  void hardCase01GrazingIsFinite() {
    forRandomMaterials([](const Brdf& brdf, std::mt19937_64& random) {
      for (const double z : {1e-4, 1e-8, 1e-11, 1e-13, 1e-300, 0.0, -1e-17})
        for (const double otherZ : {0.5, 1e-8, z})
          for (const double phi : {0.0, 1e-9, 1.0, pi - 1e-9, pi}) {
            const Direction wi(std::sqrt(1 - z * z), 0, z), horizontal(std::cos(phi), std::sin(phi), 0);
            const Direction wo = horizontal * std::sqrt(1 - otherZ * otherZ) + Direction(0, 0, otherZ);
            QVERIFY(finiteAndNotNegative(brdf.evaluate(wi, wo)));
            if (z <= 0) QCOMPARE(brdf.evaluate(wi, wo), Rgb(0));
          }
      QCOMPARE(brdf.evaluate({0, 0, 1}, -randomDirection(random)), Rgb(0));
    });
  }

  void hardCase02AlmostHorizontalIsHorizontal() {
    forRandomMaterials([](const Brdf& brdf, std::mt19937_64& random) {
      const Direction wo = randomDirection(random);
      for (const double z : {-1e-16, 1e-16, -0.9e-12, 0.9e-12})
        QCOMPARE(brdf.evaluate({1, 0, z}, wo), brdf.evaluate({1, 0, 0}, wo));
    });
  }

  void hardCase03RetroReflectionIsContinuous() {
    std::mt19937_64 random(3);
    for (const Model* model : allModels()) {
      const auto brdf = model->instantiate(defaultParameters(model->spec()));
      for (int n = 0; n < 100; ++n) {
        const Direction wi = randomDirection(random), beside = glm::normalize(wi + Direction(1e-9, 0, 0));
        if (wi.z > 0.01) QVERIFY(near(brdf->evaluate(wi, wi), brdf->evaluate(wi, beside), 1e-5));
      }
    }
  }

  void hardCase04OppositeHorizontalDirections() {
    forRandomMaterials([](const Brdf& brdf, std::mt19937_64&) {
      QCOMPARE(brdf.evaluate({1, 0, 0}, {-1, 0, 0}), Rgb(0));
      QVERIFY(finiteAndNotNegative(brdf.evaluate({1, 0, 2e-12}, {-1, 0, 2e-12})));
      const Direction low = fromSpherical(halfPi, 0.3);
      QVERIFY(finiteAndNotNegative(brdf.evaluate(low, -low)));
    });
  }

  void hardCase05MirrorPairs() {
    forRandomMaterials([](const Brdf& brdf, std::mt19937_64& random) {
      for (int n = 0; n < 50; ++n) {
        const Direction wi = randomDirection(random), wo(-wi.x, -wi.y, wi.z);
        QVERIFY(finiteAndNotNegative(brdf.evaluate(wi, wo)));
        QCOMPARE(brdf.evaluate(wi, wo), brdf.evaluate(wo, wi));
      }
    });
  }

  /// Also where exp() of the maskings would overflow; what a table keeps fits a float.
  void hardCase39FiniteAtTheCornersOfTheHardRanges() {
    std::mt19937_64 random(9);
    constexpr int corners = 200;
    for (const Model* model : allModels())
      for (int n = 0; n < corners; ++n) {
        const auto brdf = model->instantiate(randomCorner(model->spec(), random));
        for (const double theta : {0.0, 1e-6, 0.7, 1.5, 1.57, halfPi - 1e-9, halfPi - 2e-12})
          for (const double thetaO : {0.0, 0.7, 1.5, theta})
            for (const double phi : {0.0, 1.0, pi - 1e-6, pi}) {
              const Rgb value = brdf->evaluate(fromSpherical(theta, phi), fromSpherical(thetaO, 0));
              QVERIFY2(finiteAndNotNegative(value), model->spec().id.data());
              if (theta <= 1.57) QVERIFY(maxChannel(value) < double(std::numeric_limits<float>::max()));
            }
      }
  }
};

GONIO_TEST(ModelPropertiesTest)
}  // namespace model_properties_test

#include "model_properties_test.moc"
