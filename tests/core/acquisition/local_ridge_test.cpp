// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/local_ridge.h"

#include <QTest>
#include <cmath>
#include <limits>
#include <map>

#include "core/math/parallel.h"
#include "tests/core/acquisition/reconstruction_oracles.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/smooth_materials.h"
#include "tests/support/test_program.h"

namespace local_ridge_test {
using namespace gonio;
using namespace gonio::acquisition;
using namespace gonio::dictionary;
using Eigen::Index, Eigen::VectorXd;

/// Weighted means and covariances of the training signals at all samples.
struct Weighted {
  VectorXd mean;
  MatrixXd covariance;
  VectorXd weights;
};

/// By definitions, with the samples of `kept` as readings: X are the training signals at all samples.
Weighted weightedBy(const MatrixXd& x, const SampleRows& samples, const std::vector<Index>& kept, int channel,
                    double h) {
  VectorXd distances = VectorXd::Zero(x.cols());
  for (Index j = 0; j < x.cols(); ++j) {
    for (const Index i : kept)
      distances[j] += std::pow(x(i, j) - samples.values(i, channel), 2) /
                      (x.row(i).squaredNorm() / double(x.cols()) + samples.knownNoise[i]);
    distances[j] /= double(kept.size());
  }
  Weighted result;
  result.weights = VectorXd(x.cols());
  for (Index j = 0; j < x.cols(); ++j)
    result.weights[j] = std::max(std::exp(-(distances[j] - distances.minCoeff()) / (2 * h * h)), 0.005);
  result.weights /= result.weights.sum();
  result.mean = x * result.weights;
  const MatrixXd centred = x.colwise() - result.mean;
  result.covariance = centred * result.weights.asDiagonal() * centred.transpose();
  return result;
}

MatrixXd inverseOfPart(const Weighted& of, const SampleRows& samples, const std::vector<Index>& kept, double noise) {
  MatrixXd k = of.covariance(kept, kept);
  for (std::size_t i = 0; i < kept.size(); ++i) k(Index(i), Index(i)) += samples.variances[kept[i]] + noise;
  return test::inverse(k);
}

/// localRidge() by its definition, with at most 40 samples.
LocalRidge direct(const SampleRows& samples, const MatrixXd& v) {
  const MatrixXd x = samples.rows * v.leftCols(samples.rows.cols()).transpose();
  const Index count = x.rows();
  std::map<std::pair<double, double>, double> errors;
  double smallest = std::numeric_limits<double>::infinity();
  for (const double h : {0.11, 0.22, 0.44, 0.89, std::numeric_limits<double>::infinity()})
    for (const double noise :
         {1e-5, 3.16e-5, 1e-4, 3.16e-4, 1e-3, 3.16e-3, 1e-2, 3.16e-2, 1e-1, 3.16e-1, 1.0, 3.16, 10.0, 31.6, 100.0}) {
      double& error = errors[{h, noise}];
      for (Index left = 0; left < count; ++left) {
        std::vector<Index> kept;
        for (Index i = 0; i < count; ++i)
          if (i != left) kept.push_back(i);
        for (int c = 0; c < 3; ++c) {
          const Weighted of = weightedBy(x, samples, kept, c, h);
          const VectorXd difference = samples.values.col(c) - of.mean;
          const double predicted =
              of.mean[left] + of.covariance(left, kept).dot(inverseOfPart(of, samples, kept, noise) * difference(kept));
          error += std::pow(samples.values(left, c) - predicted, 2);
        }
      }
      smallest = std::min(smallest, error);
    }
  std::vector<Index> all;
  for (Index i = 0; i < count; ++i) all.push_back(i);
  LocalRidge result{.coefficients = MatrixXd::Zero(samples.rows.cols(), 3), .posteriorFactor = {}};
  double sum = 0, kept = 0;
  for (const auto& [key, error] : errors) sum += std::pow(error / smallest, -0.5 * double(count));
  for (const auto& [key, error] : errors) {
    const double weight = std::pow(error / smallest, -0.5 * double(count)) / sum;
    if (weight < 1e-3) continue;
    kept += weight;
    for (int c = 0; c < 3; ++c) {
      const Weighted of = weightedBy(x, samples, all, c, key.first);
      const VectorXd meanCoefficients = v.transpose() * of.weights;
      const MatrixXd centred = v.rowwise() - meanCoefficients.transpose();
      const MatrixXd prior = centred.transpose() * of.weights.asDiagonal() * centred;
      result.coefficients.col(c) +=
          weight * (meanCoefficients + prior * samples.rows.transpose() * inverseOfPart(of, samples, all, key.second) *
                                           (samples.values.col(c) - of.mean));
    }
  }
  result.coefficients /= kept;
  return result;
}

class LocalRidgeTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    basis_ = test::learnFrom(test::smoothMaterials(8));
    plan_ = everyCell(basis_, 31);
    QVERIFY(plan_.samples.size() > 3 && plan_.samples.size() < 40);
    values_ = measure(*test::smoothMaterial(77), plan_);
  }

  void equalsItsDefinition() {
    for (const int components : {5, basis_.count()}) {
      const SampleRows samples = sampleRows(basis_, plan_, values_, components);
      const MatrixXd v = basis_.svd.v.leftCols(components);
      const LocalRidge found = localRidge(samples, basis_.svd.v, true), expected = direct(samples, v);
      QVERIFY2((found.coefficients - expected.coefficients).norm() < 1e-7 * expected.coefficients.norm(),
               qPrintable(QString::number((found.coefficients - expected.coefficients).norm())));
      QVERIFY(found.leaveOneOutError > 0 && found.ridge > 0 && found.scale > 0);
      QCOMPARE(found.posteriorFactor.rows(), Index(components));
    }
  }

  /// A training material is recognised: its reconstruction is closer than that of the ridge over all signals.
  void recognisesATrainingMaterial() {
    const auto table = test::smoothMaterial(3);
    const MeasuredValues values = measure(*table, plan_);
    const auto error = [&](ReconstructionMethod method) {
      return difference(basis_, *reconstruct(basis_, plan_, values, {.method = method}).table, *table);
    };
    QVERIFY2(error(ReconstructionMethod::localRidge) < 0.5 * error(ReconstructionMethod::ridge),
             qPrintable(QString::number(error(ReconstructionMethod::localRidge))));
  }

  /// Readings that are all noise say nothing: the uncertainty is the deviation of the training set.
  void uncertaintyOfNoiseIsThatOfTheTrainingSet() {
    MeasuredValues noisy = values_;
    noisy.noise.assign(noisy.rgb.size(), Rgb(1e6));
    const auto found = reconstruct(basis_, plan_, noisy, {.method = ReconstructionMethod::localRidge});
    const auto exact = reconstruct(basis_, plan_, values_, {.method = ReconstructionMethod::localRidge});
    int smaller = 0;
    for (std::size_t i = 0; i < found.standardDeviation.size(); ++i) {
      const double training = std::sqrt(varianceFrom(basis_, i, 0));
      QVERIFY2(std::abs(found.standardDeviation[i] - training) < 0.3 * training + 1e-6,
               qPrintable(QString("%1 %2").arg(found.standardDeviation[i]).arg(training)));
      smaller += exact.standardDeviation[i] < found.standardDeviation[i];
    }
    QVERIFY(smaller > int(found.standardDeviation.size()) * 9 / 10);
  }

  void oneSampleIsAnOrdinaryRidge() {
    const SamplingPlan one{.samples = {plan_.samples[0]}};
    const MeasuredValues value{{values_.rgb[0]}, {}};
    const auto local = reconstruct(basis_, one, value, {.method = ReconstructionMethod::localRidge});
    const auto ridge = reconstruct(basis_, one, value, {});
    QVERIFY(std::ranges::equal(local.table->values(), ridge.table->values()));
  }

  /// With more than 40 samples, which are left out in groups.
  void hardCase50SameBitsForAnyThreads() {
    const SamplingPlan many = everyCell(basis_, 5);
    QVERIFY(many.samples.size() > 40);
    const SampleRows samples = sampleRows(basis_, many, measure(*test::smoothMaterial(77), many), basis_.count());
    std::vector<MatrixXd> found;
    for (const int threads : {1, 16}) {
      const ThreadLimit limit(threads);
      found.push_back(localRidge(samples, basis_.svd.v, false).coefficients);
    }
    QVERIFY(found[0] == found[1] && found[0].allFinite());
  }

  void canBeCancelled() {
    std::stop_source stop;
    stop.request_stop();
    const SampleRows samples = sampleRows(basis_, plan_, values_, basis_.count());
    QVERIFY_EXCEPTION_THROWN(localRidge(samples, basis_.svd.v, false, {stop.get_token(), {}}), Cancelled);
  }

 private:
  PrincipalComponents basis_;
  SamplingPlan plan_;
  MeasuredValues values_;
};

GONIO_TEST(LocalRidgeTest)
}  // namespace local_ridge_test

#include "local_ridge_test.moc"
