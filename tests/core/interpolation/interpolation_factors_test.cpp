// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>

#include "core/factorization/pdv_blend.h"
#include "core/interpolation/interpolation.h"
#include "core/support/error.h"
#include "tests/core/interpolation/interpolation_test_support.h"
#include "tests/support/test_program.h"

namespace interpolation_factors_test {
using namespace gonio;
using namespace gonio::interpolation;
using namespace gonio::editing;
using namespace gonio::editing::test_support;

class InterpolationFactorsTest : public QObject, private ThreeMaterials {
  Q_OBJECT
 private Q_SLOTS:
  void factorsAreBlendedCurves() {
    InterpolationOptions ofTheSet = options();
    ofTheSet.pdv.deviationNodes.clear();
    const auto between = prepareInterpolation(InterpolationSpace::factors, ends_, ofTheSet);
    const auto blend = between->factors(weights_).value();
    const auto brdf = factorization::makePdvBrdf(blend);
    const Direction wi = fromSpherical(0.4, 0.1), wo = fromSpherical(0.7, 2);
    QCOMPARE(between->brdf(weights_)->evaluate(wi, wo), brdf->evaluate(wi, wo));
    QCOMPARE(maxDifference(*between->table(weights_), *bakeTable(*brdf, smallGrid)), 0.0);
    // All lie on the nodes of the set.
    std::vector<factorization::PdvFactors> each;
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<double> whole(3, 0.0);
      whole[i] = 1;
      each.push_back(between->factors(whole).value());
      QVERIFY(each.back().deviationNodes == each.front().deviationNodes);
    }
    const factorization::PdvFactors* pointers[] = {&each[0], &each[1], &each[2]};
    QVERIFY(factorization::blended(pointers, weights_) == blend);
  }

  /// A table beside a material that is factors is factorised as that is.
  void factorsThatAreGivenAreKept() {
    const factorization::PdvOptions given{
        .form = factorization::PdvForm::twoFactors, .transform = DataTransform::cosineLog, .terms = 3};
    const auto factors = std::make_shared<const factorization::PdvFactors>(factorizePdv(*tables_[1], given).factors);
    const std::vector<InterpolationMaterial> ends{{.table = tables_[0]}, {.table = tables_[1], .factors = factors}};
    const auto between = prepareInterpolation(InterpolationSpace::factors, ends, options());
    QVERIFY(between->factors(std::vector{0.0, 1.0}) == *factors);
    const auto other = between->factors(std::vector{1.0, 0.0}).value();
    QVERIFY(other.transform == DataTransform::cosineLog && other.form == factorization::PdvForm::twoFactors);
    QCOMPARE(other.terms(), 3);
    QVERIFY(other.deviationNodes == factors->deviationNodes);
  }

  void hardCase31FactorsOfDifferentTransforms() {
    std::vector<InterpolationMaterial> ends{ends_[0], ends_[1]};
    for (const std::size_t i : {0, 1}) {
      const factorization::PdvOptions given{.transform = i == 0 ? DataTransform::logPlus : DataTransform::cosineLog,
                                            .terms = 1};
      ends[i].factors = std::make_shared<const factorization::PdvFactors>(factorizePdv(*tables_[i], given).factors);
    }
    QVERIFY_EXCEPTION_THROWN(prepareInterpolation(InterpolationSpace::factors, ends, options()), Error);
  }
};

GONIO_TEST(InterpolationFactorsTest)
}  // namespace interpolation_factors_test

#include "interpolation_factors_test.moc"
