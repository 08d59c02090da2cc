// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/atom_components.h"

#include <QTest>
#include <set>

#include "core/acquisition/sample_selection.h"
#include "core/dictionary/decode.h"
#include "core/support/error.h"
#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/support/test_program.h"

namespace atom_components_test {
using namespace gonio;
using namespace gonio::acquisition;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;

class AtomComponentsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    ensemble_ = randomEnsemble(2);
    const auto priorOf = [](std::vector<std::uint32_t> indices, const Eigen::VectorXf& variances) {
      return CoefficientPrior{std::move(indices), Eigen::VectorXf::Zero(variances.size()), variances};
    };
    prior_ = {.grid = smallGrid,
              .dictionaries = {priorOf({5, 17, 40}, Eigen::Vector3f(4, 1, 0.25F)),
                               priorOf({3, 9}, Eigen::Vector2f(2.25F, 0))}};
  }

  /// The columns are the atoms of both dictionaries with the largest variances, times the standard deviations; the atom
  /// without variance is none of them.
  void columnsAreTheLargestAtoms() {
    struct Atom {
      std::size_t dictionary;
      std::uint32_t index;
      double deviation;
    };
    const std::vector<Atom> expected{{0, 5, 2}, {1, 3, 1.5}, {0, 17, 1}, {0, 40, 0.5}};
    for (const int count : {3, 10}) {
      const PrincipalComponents found = atomComponents(ensemble_, prior_, count);
      const auto columns = std::min<Eigen::Index>(count, 4);
      QCOMPARE(found.svd.v.rows(), columns);
      const Eigen::MatrixXd x =
          found.svd.u.view().cast<double>() * found.svd.singularValues.asDiagonal() * found.svd.v.transpose();
      for (Eigen::Index k = 0; k < columns; ++k) {
        const Atom& atom = expected[std::size_t(k)];
        std::vector<double> tensor(smallGrid.size());
        const std::vector<Coefficient<double>> one{{atom.index, atom.deviation}};
        compose(ensemble_.dictionaries[atom.dictionary].modes, one, tensor.data());
        for (std::size_t i = 0; i < found.mapping.cells.size(); ++i)
          QVERIFY(std::abs(x(Eigen::Index(i), k) - tensor[found.mapping.cells[i]]) < 1e-5);
      }
    }
  }

  void directionsAreChosenOverThem() {
    const PrincipalComponents components = atomComponents(ensemble_, prior_, 4);
    const SampleSelection chosen = selectSamples(components, {.samples = 3});
    QCOMPARE(std::set<std::uint32_t>(chosen.cells.begin(), chosen.cells.end()).size(), std::size_t(3));
    // What the samples leave unexplained falls with each.
    for (std::size_t i = 0; i + 1 < chosen.residuals.size(); ++i)
      QVERIFY(chosen.residuals[i + 1] < chosen.residuals[i]);
  }

  void wrongPriorsAreRefused() {
    QVERIFY_THROWS_EXCEPTION(Error, atomComponents(ensemble_, prior_, 0));
    QVERIFY_THROWS_EXCEPTION(Error, atomComponents(randomEnsemble(3), prior_, 4));
  }

 private:
  Ensemble ensemble_;
  DictionaryPrior prior_;
};

GONIO_TEST(AtomComponentsTest)

}  // namespace atom_components_test

#include "atom_components_test.moc"
