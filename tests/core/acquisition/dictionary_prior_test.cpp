// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/dictionary_reconstruction.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math/parallel.h"
#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace dictionary_prior_test {
using namespace gonio;
using namespace gonio::acquisition;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;

/// All signals of the materials, one a column.
Eigen::MatrixXd signalsOf(const TrainingMaterials& materials, DataTransform transform) {
  Eigen::MatrixXd signals(Eigen::Index(smallGrid.size()), 3 * Eigen::Index(materials.names.size()));
  for (std::size_t m = 0; m < materials.names.size(); ++m) {
    const auto channels = dictionary::signalsOf(*materials.load(m), transform, *GridGeometry::of(smallGrid));
    for (std::size_t c = 0; c < 3; ++c) signals.col(Eigen::Index(3 * m + c)) = channels[c].matrix().cast<double>();
  }
  return signals;
}

/// Coefficients of signals by the general tensor products.
Eigen::MatrixXd analysed(const Eigen::MatrixXd& signals, const Dictionary& dictionary) {
  const ModeMatrices<double> transposed{dictionary.modes[0].transpose(), dictionary.modes[1].transpose(),
                                        dictionary.modes[2].transpose()};
  Eigen::MatrixXd result(signals.rows(), signals.cols());
  for (Eigen::Index s = 0; s < signals.cols(); ++s)
    result.col(s) = Eigen::Map<const Eigen::VectorXd>(
        composed(tensorOf(signals.col(s).data(), modeSizes(smallGrid)), transposed).data(), signals.rows());
  return result;
}

/// In the 128 largest coefficients.
double maxEnergy(const Eigen::VectorXd& coefficients) {
  std::vector<double> squares(coefficients.begin(), coefficients.end());
  for (double& one : squares) one *= one;
  std::ranges::sort(squares, std::greater());
  return std::accumulate(squares.begin(), squares.begin() + 128, 0.0);
}

/// Up to what analysis may leave out.
void checkMoments(const CoefficientPrior& prior, const Eigen::MatrixXd& coefficients, const Eigen::VectorXd& weights) {
  QCOMPARE(prior.indices.size(), std::size_t(300));
  QVERIFY(std::ranges::is_sorted(prior.indices));
  const Eigen::VectorXd means = coefficients * weights, squares = coefficients.cwiseAbs2() * weights;
  const double energy = squares.sum();
  double kept = 0, difference = 0;
  for (std::size_t k = 0; k < prior.indices.size(); ++k) {
    const double mean = double(prior.means[Eigen::Index(k)]), variance = double(prior.variances[Eigen::Index(k)]);
    kept += mean * mean + variance;
    difference += std::pow(mean - means[prior.indices[k]], 2);
    QVERIFY(std::abs(mean * mean + variance - squares[prior.indices[k]]) < 2e-3 * energy);
  }
  QVERIFY(difference < 3e-4 * energy);
  QVERIFY(std::abs(kept + prior.restVariance * double(smallGrid.size()) - energy) < 1e-3 * energy);
  // No other choice of as many atoms holds more.
  std::vector<double> sorted(squares.begin(), squares.end());
  std::ranges::sort(sorted, std::greater());
  QVERIFY(kept > std::accumulate(sorted.begin(), sorted.begin() + 300, 0.0) - 3e-4 * energy);
}

void checkMax(const DictionaryPrior& prior, const Eigen::MatrixXd& signals) {
  const auto geometry = GridGeometry::of(smallGrid);
  double highest = 0;
  for (std::size_t cell = 0; cell < smallGrid.size(); ++cell)
    if (geometry->aboveHorizon[cell])
      highest =
          std::max(highest, signals.row(Eigen::Index(cell)).maxCoeff() / cellScalingOf(smallGrid, *geometry, cell));
  QVERIFY(std::abs(double(prior.highest) - highest) < 1e-5 * highest);
}

bool sameBits(const DictionaryPrior& a, const DictionaryPrior& b) {
  return std::ranges::equal(a.dictionaries, b.dictionaries, [](const CoefficientPrior& x, const CoefficientPrior& y) {
    return x.indices == y.indices && x.means == y.means && x.variances == y.variances &&
           x.restVariance == y.restVariance;
  });
}

class DictionaryPriorTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void momentsOfTheCoefficients() {
    const Ensemble ensemble = randomEnsemble(2);
    const TrainingMaterials materials = ggxMaterials(5);
    for (const DataTransform transform : {DataTransform::logPlus, DataTransform::cosineLog})
      for (const double sharing : {1.0, 0.25}) {
        const DictionaryPrior prior =
            learnDictionaryPrior(ensemble, materials, {.transform = transform, .atoms = 300, .sharing = sharing});
        const Eigen::MatrixXd signals = signalsOf(materials, transform);
        const std::array coefficients{analysed(signals, ensemble.dictionaries[0]),
                                      analysed(signals, ensemble.dictionaries[1])};
        for (std::size_t d = 0; d < 2; ++d) {
          Eigen::VectorXd weights(signals.cols());
          for (Eigen::Index s = 0; s < signals.cols(); ++s)
            weights[s] = maxEnergy(coefficients[d].col(s)) > maxEnergy(coefficients[1 - d].col(s)) ? 1 : sharing;
          checkMoments(prior.dictionaries[d], coefficients[d], weights / weights.sum());
        }
        QCOMPARE(prior.transform, transform);
        checkMax(prior, signals);
      }
  }

  void sameForAnyNumberOfThreads() {
    const Ensemble ensemble = randomEnsemble(3);
    const DictionaryPriorOptions options{.atoms = 200};
    const DictionaryPrior several = learnDictionaryPrior(ensemble, ggxMaterials(4), options);
    const ThreadLimit limit(1);
    QVERIFY(sameBits(learnDictionaryPrior(ensemble, ggxMaterials(4), options), several));
  }

  void errors() {
    const Ensemble ensemble = randomEnsemble(1);
    const TrainingMaterials materials = ggxMaterials(1);
    const auto errorOf = [&](const Ensemble& e, const TrainingMaterials& m,
                             const DictionaryPriorOptions& options = {}) {
      return QString::fromStdString(gonio::test::errorOf([&] { learnDictionaryPrior(e, m, options); }));
    };
    TrainingMaterials none = materials, other = materials;
    none.names.clear();
    other.grid.phiDCount = 18;
    QVERIFY(errorOf(ensemble, none).contains("no training material"));
    QVERIFY(errorOf(ensemble, other).contains("grid"));
    QVERIFY(errorOf({.grid = smallGrid, .dictionaries = {}, .learnedFrom = {}}, materials).contains("dictionaries"));
    QVERIFY(errorOf(ensemble, materials, {.transform = DataTransform::root}).contains("found the transform root"));
    QVERIFY(errorOf(ensemble, materials, {.atoms = 0}).contains("found 0 atoms"));
    QVERIFY(errorOf(ensemble, materials, {.sharing = 0}).contains("found the weight 0 for a dictionary prior"));
    std::stop_source stop;
    stop.request_stop();
    QVERIFY_THROWS_EXCEPTION(Cancelled, learnDictionaryPrior(ensemble, materials, {}, {.stop = stop.get_token()}));
  }
};

GONIO_TEST(DictionaryPriorTest)
}  // namespace dictionary_prior_test

#include "dictionary_prior_test.moc"
