// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>
#include <limits>

#include "tests/core/acquisition/reconstruction_oracles.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/smooth_materials.h"
#include "tests/support/test_program.h"

namespace reconstruction_deviation_test {
using namespace gonio;
using namespace gonio::acquisition;
using namespace gonio::dictionary;
using Eigen::VectorXd;

class ReconstructionDeviationTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    basis_ = test::learnFrom(test::smoothMaterials(6));
    plan_ = everyCell(basis_, 9);
    values_ = measure(*test::smoothMaterial(77), plan_);
  }

  /// The posterior of the cells by brute force: v (d (I - Q^T (Q Q^T + N)^-1 Q) d^T + t l), N = diag(eta + t l), l the
  /// variance in components that are not used: none where all are.
  void byBruteForce() {
    for (const auto& [plan, components] :
         {std::pair(everyCell(basis_, 97), basis_.count()), std::pair(plan_, basis_.count()), std::pair(plan_, 5)}) {
      const MeasuredValues values = measure(*test::smoothMaterial(77), plan);
      const MatrixXd q = rowsAt(basis_, plan, components), y = mappedAt(basis_, plan, values);
      for (const double ridge : {1e-3, 1.0, 40.0}) {
        const MatrixXd k = test::inverse(covarianceAt(basis_, plan, components, ridge));
        const MatrixXd posterior = MatrixXd::Identity(components, components) - q.transpose() * k * q;
        const double estimated = (1 / signals + (y.transpose() * k * y).trace()) / double(1 + y.size());
        for (const std::optional<double> noise : {std::optional<double>(), std::optional<double>(0.3)}) {
          const Reconstruction found =
              reconstruct(basis_, plan, values, {.ridge = ridge, .components = components, .noise = noise});
          const double variance = noise ? 0.09 / ridge : estimated;
          QCOMPARE(found.standardDeviation.size(), basis_.mapping.cells.size());
          for (std::size_t i = 0; i < found.standardDeviation.size(); i += 5) {
            const VectorXd d = basis_.svd.u.view()
                                   .row(Eigen::Index(i))
                                   .head(components)
                                   .cast<double>()
                                   .transpose()
                                   .cwiseProduct(basis_.svd.singularValues.head(components));
            const double others = signals * varianceFrom(basis_, i, components);
            const double expected = std::sqrt(variance * (d.dot(posterior * d) + others));
            QVERIFY(std::abs(found.standardDeviation[i] - expected) < 2e-4 * expected + 1e-5);
          }
        }
      }
    }
    ReconstructionOptions without;
    without.uncertainty = false;
    QVERIFY(reconstruct(basis_, plan_, values_, without).standardDeviation.empty());
  }

  /// Where the samples have no information the deviation is that of the training signals, whatever is used or was kept.
  void untoldIsTheTrainingSet() {
    const auto tables = test::smoothMaterials(6);
    const ReconstructionOptions withoutNoise{.ridge = std::numeric_limits<double>::infinity()};
    for (const int kept : {0, 1, 5, basis_.count()}) {
      const PrincipalComponents truncated = test::learnFrom(tables, {.maxComponents = kept});
      for (const int components : {1, 4, 0}) {
        ReconstructionOptions options = withoutNoise;
        options.components = components;
        const std::vector<float> found = reconstruct(truncated, plan_, values_, options).standardDeviation;
        if (kept == 0) {
          QVERIFY(found.empty());
          continue;
        }
        for (std::size_t i = 0; i < found.size(); ++i)
          QVERIFY(std::abs(found[i] - std::sqrt(varianceFrom(basis_, i, 0))) < 1e-3);
      }
    }
  }

  /// Values that are stated to be mostly noise make nothing certain: the deviation rises to the training signals'.
  void toldNoiseMakesUncertain() {
    for (const double ridge : {1e-3, 40.0}) {
      const auto found = [&](double noise) {
        MeasuredValues values = values_;
        values.noise.assign(values.rgb.size(), Rgb(noise));
        return reconstruct(basis_, plan_, values, {.ridge = ridge}).standardDeviation;
      };
      const std::vector<float> drowned = found(1e9),
                               withoutNoise = reconstruct(basis_, plan_, values_, {.ridge = ridge}).standardDeviation,
                               none = found(0);
      for (std::size_t i = 0; i < drowned.size(); ++i) {
        QVERIFY(std::abs(drowned[i] - std::sqrt(varianceFrom(basis_, i, 0))) < 1e-3);
        QCOMPARE(none[i], withoutNoise[i]);
      }
    }
  }

  /// A basis that kept five components and five of all: the same.
  void keptOrUsed() {
    const PrincipalComponents truncated = test::learnFrom(test::smoothMaterials(6), {.maxComponents = 5});
    for (const std::optional<double> ridge : {std::optional<double>(), std::optional<double>(40)}) {
      const Reconstruction used = reconstruct(basis_, plan_, values_, {.ridge = ridge, .components = 5});
      const Reconstruction kept = reconstruct(truncated, plan_, values_, {.ridge = ridge});
      QVERIFY(std::abs(kept.ridge / used.ridge - 1) < 1e-5);
      QVERIFY(difference(basis_, *used.table, *kept.table) < 1e-3);
      for (std::size_t i = 0; i < used.standardDeviation.size(); ++i)
        QVERIFY(std::abs(kept.standardDeviation[i] - used.standardDeviation[i]) <
                1e-3f * used.standardDeviation[i] + 1e-4f);
    }
  }

  /// With a measurement the uncertainty there falls, and nowhere it rises.
  void measuringMakesCertain() {
    SamplingPlan fewer = plan_;
    MeasuredValues values = values_;
    const ReconstructionOptions options{.ridge = 40, .noise = 0.3};
    const Reconstruction all = reconstruct(basis_, plan_, values_, options);
    const std::size_t position = positionOf(basis_, fewer.samples.back());
    fewer.samples.pop_back();
    values.rgb.pop_back();
    const Reconstruction left = reconstruct(basis_, fewer, values, options);
    QVERIFY(all.standardDeviation[position] < left.standardDeviation[position]);
    for (std::size_t i = 0; i < all.standardDeviation.size(); ++i)
      QVERIFY(all.standardDeviation[i] < left.standardDeviation[i] * 1.0001f);
  }

 private:
  static constexpr double signals = 18;

  PrincipalComponents basis_;
  SamplingPlan plan_;
  MeasuredValues values_;
};

GONIO_TEST(ReconstructionDeviationTest)
}  // namespace reconstruction_deviation_test

#include "reconstruction_deviation_test.moc"
