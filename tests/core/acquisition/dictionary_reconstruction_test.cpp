// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/dictionary_reconstruction.h"

#include <QTest>
#include <cmath>
#include <limits>
#include <set>

#include "core/dictionary/decode.h"
#include "core/math/parallel.h"
#include "tests/core/dictionary/code_test_support.h"
#include "tests/core/io/test_files.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/test_program.h"

namespace dictionary_reconstruction_test {
using namespace gonio;
using namespace gonio::factorization;
using namespace gonio::acquisition;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double restVariance = 1e-3;

DictionaryPrior randomPrior(int dictionaries, int atoms) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  DictionaryPrior prior{.grid = smallGrid, .transform = DataTransform::cosineLog, .highest = 1e6f, .dictionaries = {}};
  for (int d = 0; d < dictionaries; ++d) {
    std::set<std::uint32_t> indices;
    while (int(indices.size()) < atoms) indices.insert(std::uint32_t(random() % smallGrid.size()));
    CoefficientPrior& one = prior.dictionaries.emplace_back();
    one.indices.assign(indices.begin(), indices.end());
    one.means = Eigen::VectorXf::NullaryExpr(atoms, [&] { return float(normal(random)); });
    one.variances = Eigen::VectorXf::NullaryExpr(atoms, [&] { return float(1 + std::abs(normal(random))); });
    one.restVariance = restVariance;
  }
  return prior;
}

/// The atoms of a prior over all cells, one a column, by the general tensor products.
MatrixXd denseAtoms(const Dictionary& dictionary, const CoefficientPrior& prior) {
  MatrixXd atoms(Eigen::Index(smallGrid.size()), Eigen::Index(prior.indices.size()));
  for (Eigen::Index k = 0; k < atoms.cols(); ++k) {
    Tensor one({smallGrid.phiDCount, smallGrid.thetaDCount, smallGrid.thetaHCount});
    one[prior.indices[std::size_t(k)]] = 1;
    atoms.col(k) = Eigen::Map<const VectorXd>(composed(one, dictionary.modes).data(), atoms.rows());
  }
  return atoms;
}

/// A scaled signal for each channel with coefficients drawn from the prior, and cells where all are positive.
struct Truth {
  MatrixXd coefficients, signals;
  std::vector<std::uint32_t> cells;
};
Truth drawn(const Ensemble& ensemble, const DictionaryPrior& prior, std::size_t dictionary, std::size_t samples) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const CoefficientPrior& one = prior.dictionaries[dictionary];
  Truth truth;
  truth.coefficients.resize(one.means.size(), 3);
  for (Eigen::Index c = 0; c < 3; ++c)
    for (Eigen::Index k = 0; k < one.means.size(); ++k)
      truth.coefficients(k, c) = one.means[k] + std::sqrt(one.variances[k]) * normal(random);
  truth.signals = denseAtoms(ensemble.dictionaries[dictionary], one) * truth.coefficients;
  const auto geometry = GridGeometry::of(smallGrid);
  std::set<std::uint32_t> cells;
  for (int tries = 0; cells.size() < samples && tries < 1 << 16; ++tries) {
    const auto cell = std::uint32_t(random() % smallGrid.size());
    if (geometry->aboveHorizon[cell] && pairNode(smallGrid, cell) == cell && truth.signals.row(cell).minCoeff() > 0)
      cells.insert(cell);
  }
  truth.cells.assign(cells.begin(), cells.end());
  return truth;
}

MeasuredValues valuesOf(const Truth& truth) {
  const auto geometry = GridGeometry::of(smallGrid);
  MeasuredValues values;
  for (const std::uint32_t cell : truth.cells) {
    Rgb& rgb = values.rgb.emplace_back(0);
    for (int c = 0; c < 3; ++c)
      rgb[c] = inverseTransformed(DataTransform::cosineLog,
                                  truth.signals(cell, c) / cellScalingOf(smallGrid, *geometry, cell),
                                  double(geometry->weights[cell]));
  }
  return values;
}

/// Of a code the coefficients in the order of the prior.
MatrixXd coefficientsOf(const DictionaryReconstruction& found, const DictionaryPrior& prior) {
  const auto& indices = prior.dictionaries[std::size_t(found.dictionary)].indices;
  MatrixXd result(Eigen::Index(indices.size()), 3);
  for (Eigen::Index c = 0; c < 3; ++c)
    for (const auto& one : found.code.channels[std::size_t(c)].coefficients)
      result(std::lower_bound(indices.begin(), indices.end(), one.index) - indices.begin(), c) = double(one.value);
  return result;
}

template <typename Work>
QString messageOf(Work work) {
  return QString::fromStdString(gonio::test::errorOf(work));
}

class DictionaryReconstructionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// More samples than atoms and next to no noise: the coefficients are known.
  void exactInTheSpan() {
    const Ensemble ensemble = randomEnsemble(1);
    const DictionaryPrior prior = randomPrior(1, 12);
    const Truth truth = drawn(ensemble, prior, 0, 60);
    const auto found =
        reconstructInDictionaries(ensemble, prior, planFor(smallGrid, truth.cells), valuesOf(truth), {.noise = 1e-8});
    QVERIFY((coefficientsOf(found, prior) - truth.coefficients).norm() < 1e-4 * truth.coefficients.norm());
    QCOMPARE(found.dictionary, 0);
    for (const std::uint32_t cell : truth.cells)
      QVERIFY(
          std::abs(
              std::log(double(found.table->values()[cell].x)) -
              std::log(
                  valuesOf(truth)
                      .rgb[std::size_t(std::find(truth.cells.begin(), truth.cells.end(), cell) - truth.cells.begin())]
                      .x)) < 0.02);
  }

  /// The posterior of a Gaussian over all cells with the covariance that the atoms make, written out.
  void equalsTheDenseGaussian() {
    const Ensemble ensemble = randomEnsemble(1);
    const DictionaryPrior prior = randomPrior(1, 60);
    const Truth truth = drawn(ensemble, prior, 0, 20);
    const SamplingPlan plan = planFor(smallGrid, truth.cells);
    MeasuredValues values = valuesOf(truth);
    const auto geometry = GridGeometry::of(smallGrid);
    for (const bool hasKnownNoise : {false, true}) {
      VectorXd reported = VectorXd::Zero(20);
      if (hasKnownNoise)
        for (std::size_t s = 0; s < 20; ++s) {
          const std::uint32_t cell = truth.cells[s];
          values.noise.push_back(0.03 * double(s) * values.rgb[s]);
          for (int c = 0; c < 3; ++c) {
            // By a difference of the transform itself.
            const double w = double(geometry->weights[cell]), rho = values.rgb[s][c], step = 1e-6 * rho;
            const double slope = (transformed(DataTransform::cosineLog, rho + step, w) -
                                  transformed(DataTransform::cosineLog, rho - step, w)) /
                                 (2 * step);
            reported[Eigen::Index(s)] +=
                std::pow(cellScalingOf(smallGrid, *geometry, cell) * slope * values.noise[s][c], 2) / 3;
          }
        }
      constexpr double noise = 3;
      const auto found = reconstructInDictionaries(ensemble, prior, plan, values, {.noise = noise});
      const CoefficientPrior& one = prior.dictionaries[0];
      const MatrixXd atoms = denseAtoms(ensemble.dictionaries[0], one);
      const MatrixXd covariance = atoms * one.variances.cast<double>().asDiagonal() * atoms.transpose();
      const VectorXd mean = atoms * one.means.cast<double>();
      MatrixXd ofSamples = covariance(truth.cells, truth.cells);
      ofSamples.diagonal().array() += noise * (restVariance + reported.array());
      const MatrixXd residuals = (truth.signals.colwise() - mean)(truth.cells, Eigen::all);
      const MatrixXd dual = test::solved(ofSamples, residuals);
      const MatrixXd expected = (covariance(Eigen::all, truth.cells) * dual).colwise() + mean;
      const auto signals = decodeSignals(ensemble, found.code);
      for (std::size_t cell = 0; cell < smallGrid.size(); ++cell)
        for (Eigen::Index c = 0; c < 3; ++c)
          QVERIFY(
              std::abs(double(signals[std::size_t(c)][Eigen::Index(cell)]) * cellScalingOf(smallGrid, *geometry, cell) -
                       expected(Eigen::Index(cell), c)) < 1e-4 * expected.cwiseAbs().maxCoeff());
      if (hasKnownNoise) continue;
      const double energy = residuals.cwiseProduct(dual).sum();
      const double evidence =
          -0.5 * (61 * std::log((energy + 1) / 61) + 3 * test::singularValues(ofSamples).array().log().sum());
      QVERIFY(std::abs(found.logEvidence - evidence) < 1e-6 * std::abs(evidence));
      double leftOut = 0;
      for (Eigen::Index s = 0; s < 20; ++s) {
        std::vector<Eigen::Index> others;
        for (Eigen::Index other = 0; other < 20; ++other)
          if (other != s) others.push_back(other);
        const MatrixXd weights = test::solved(ofSamples(others, others), ofSamples(others, std::vector{s}));
        leftOut += (residuals.row(s) - weights.transpose() * residuals(others, Eigen::all)).squaredNorm();
      }
      QVERIFY(std::abs(found.leaveOneOutError - std::sqrt(leftOut / 60)) < 1e-8);
    }
  }

  void theDictionaryIsFound() {
    const Ensemble ensemble = randomEnsemble(4);
    const DictionaryPrior prior = randomPrior(4, 15);
    for (std::size_t d = 0; d < 4; ++d) {
      const Truth truth = drawn(ensemble, prior, d, 25);
      for (const auto choice : {DictionaryChoice::evidence, DictionaryChoice::leaveOneOut}) {
        const auto found = reconstructInDictionaries(ensemble, prior, planFor(smallGrid, truth.cells), valuesOf(truth),
                                                     {.choice = choice});
        QCOMPARE(found.dictionary, int(d));
        QVERIFY((coefficientsOf(found, prior) - truth.coefficients).norm() < 0.1 * truth.coefficients.norm());
      }
    }
  }

  /// What never varies is not changed by samples, whatever they say.
  void withoutVarianceTheMean() {
    const Ensemble ensemble = randomEnsemble(2);
    DictionaryPrior prior = randomPrior(2, 15);
    const Truth truth = drawn(ensemble, prior, 0, 10);
    for (CoefficientPrior& one : prior.dictionaries) one.variances.setZero();
    for (const double rest : {restVariance, 0.0}) {
      for (CoefficientPrior& one : prior.dictionaries) one.restVariance = rest;
      const auto found = reconstructInDictionaries(ensemble, prior, planFor(smallGrid, truth.cells), valuesOf(truth));
      const VectorXd means = prior.dictionaries[std::size_t(found.dictionary)].means.cast<double>();
      QVERIFY(coefficientsOf(found, prior) == means.replicate(1, 3));
    }
  }

  void sameForAnyNumberOfThreads() {
    const Ensemble ensemble = randomEnsemble(5);
    const DictionaryPrior prior = randomPrior(5, 40);
    const Truth truth = drawn(ensemble, prior, 2, 12);
    const SamplingPlan plan = planFor(smallGrid, truth.cells);
    const auto several = reconstructInDictionaries(ensemble, prior, plan, valuesOf(truth));
    const ThreadLimit limit(1);
    const auto one = reconstructInDictionaries(ensemble, prior, plan, valuesOf(truth));
    QVERIFY(sameBits(one.code, several.code));
    QCOMPARE(one.logEvidence, several.logEvidence);
  }

  void errors() {
    const Ensemble ensemble = randomEnsemble(2);
    const DictionaryPrior prior = randomPrior(2, 15);
    const Truth truth = drawn(ensemble, prior, 0, 10);
    const SamplingPlan plan = planFor(smallGrid, truth.cells);
    const MeasuredValues values = valuesOf(truth);
    const auto run = [&](const DictionaryPrior& p, const MeasuredValues& v, double noise = 1) {
      return [&, noise] { reconstructInDictionaries(ensemble, p, plan, v, {.noise = noise}); };
    };
    MeasuredValues negative = values, few = values;
    negative.rgb[3].y = -1;
    few.rgb.pop_back();
    QVERIFY(messageOf(run(prior, negative)).contains("sample 4: found a value of -1"));
    QVERIFY(messageOf(run(prior, few)).contains("found 9 values for a plan of 10 samples"));
    QVERIFY(messageOf(run(randomPrior(1, 5), values)).contains("found 1 dictionaries, expected 2"));
    QVERIFY(messageOf(run(prior, values, -1)).contains("noise"));
    DictionaryPrior beyond = prior;
    beyond.dictionaries[1].indices.back() = std::uint32_t(smallGrid.size());
    QVERIFY(messageOf(run(beyond, values)).contains("atom"));
    std::stop_source stop;
    stop.request_stop();
    QVERIFY_THROWS_EXCEPTION(Cancelled,
                             reconstructInDictionaries(ensemble, prior, plan, values, {}, {.stop = stop.get_token()}));
  }
};

GONIO_TEST(DictionaryReconstructionTest)
}  // namespace dictionary_reconstruction_test

#include "dictionary_reconstruction_test.moc"
