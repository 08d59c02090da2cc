// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/principal_components.h"

#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/brdf/data_transform.h"
#include "core/coordinates/grid_directions.h"
#include "core/math/parallel.h"
#include "core/support/error.h"
#include "tests/support/smooth_materials.h"
#include "tests/support/test_program.h"

namespace principal_components_test {
using namespace gonio;
using namespace gonio::dictionary;

using Table = std::shared_ptr<const TabulatedBrdf>;

constexpr HalfDifferenceGrid grid = test::smoothGrid;

Table material(unsigned seed) { return test::smoothMaterial(seed); }
std::vector<Table> materials(unsigned count) { return test::smoothMaterials(count); }
PrincipalComponents learn(const std::vector<Table>& tables, const PcaOptions& options = {}) {
  return test::learnFrom(tables, options);
}

/// The table with one value changed.
Table with(const Table& table, std::size_t cell, float value, bool valid) {
  std::vector<TabulatedBrdf::Value> values(table->values().begin(), table->values().end());
  std::vector<std::uint8_t> flags(table->valid().begin(), table->valid().end());
  values[cell] = TabulatedBrdf::Value(value);
  flags[cell] = valid;
  return std::make_shared<const TabulatedBrdf>(grid, values, flags);
}

/// Largest difference over the cells that both know, relative to rho w + e.
double difference(const TabulatedBrdf& a, const TabulatedBrdf& b) {
  const GridDirections directions(grid);
  double largest = 0;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    if (!a.valid()[cell] || !b.valid()[cell]) continue;
    const auto node = directions.at(cell);
    const double weight = cosineWeight(node.pair.wi.z, node.pair.wo.z);
    for (int c = 0; c < 3; ++c)
      largest = std::max(largest, std::abs(double(a.values()[cell][c]) - b.values()[cell][c]) * weight /
                                      (b.values()[cell][c] * weight + logRelativeOffset));
  }
  return largest;
}

class PrincipalComponentsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Reference, mean and the columns that U Sigma V^T stands for, from the definitions.
  void mappingByItsDefinition() {
    const auto tables = materials(4);
    const PrincipalComponents pca = learn(tables);
    QCOMPARE(pca.mapping.cells.size(), tables[0]->validCount());
    const auto u = pca.svd.u.view();
    for (std::size_t i = 0; i < pca.mapping.cells.size(); i += 7) {
      const std::size_t cell = pca.mapping.cells[i];
      const DirectionPair pair = grid.directions(cell);
      const double weight = std::max(pair.wi.z * pair.wo.z, 1e-3);
      QVERIFY(std::abs(pca.mapping.weights[i] - weight) < 1e-7);
      std::vector<double> weighted, mapped;
      for (const Table& table : tables)
        for (int c = 0; c < 3; ++c) weighted.push_back(table->values()[cell][c] * weight);
      auto sorted = weighted;
      std::sort(sorted.begin(), sorted.end());
      const double reference = (sorted[5] + sorted[6]) / 2;
      QVERIFY(std::abs(pca.mapping.reference[i] - reference) < 1e-6 * reference);
      double mean = 0;
      for (const double r : weighted) mean += mapped.emplace_back(std::log((r + 1e-3) / (reference + 1e-3))) / 12;
      QVERIFY(std::abs(pca.mean[i] - mean) < 1e-5);
      for (std::size_t column = 0; column < 12; ++column) {
        const Eigen::VectorXd c = pca.svd.singularValues.cwiseProduct(pca.svd.v.row(Eigen::Index(column)).transpose());
        QVERIFY(std::abs(u.row(Eigen::Index(i)).cast<double>().dot(c) - (mapped[column] - mean)) < 1e-5);
      }
    }
  }

  /// With the columns in a file, in blocks of 46 cells that do not divide their number, and a cell that one material
  /// lacks: the same components.
  void learnedFromAFile() {
    auto tables = materials(12);
    const auto cells = [&] { return learn(tables).mapping.cells; };
    const std::size_t lacking = cells()[100];
    tables[7] = with(tables[7], lacking, 0, false);
    const PcaOptions inMemory{.maxComponents = 8}, inFile{.maxComponents = 8, .maxBytes = 40'000};
    const PrincipalComponents a = learn(tables, inMemory), b = learn(tables, inFile);
    QCOMPARE(b.mapping.cells, a.mapping.cells);
    QVERIFY(std::ranges::find(b.mapping.cells, lacking) == b.mapping.cells.end());
    QCOMPARE(b.mapping.reference, a.mapping.reference);
    QCOMPARE(b.mean, a.mean);
    QCOMPARE(b.count(), 8);
    QVERIFY((a.svd.singularValues - b.svd.singularValues).norm() < 1e-9 * a.svd.singularValues[0]);
    QVERIFY((a.svd.v - b.svd.v).cwiseAbs().maxCoeff() < 1e-6);
    QVERIFY((a.svd.u.view() - b.svd.u.view()).cwiseAbs().maxCoeff() < 1e-5);
    QCOMPARE(b.leftOut.size(), a.leftOut.size());
    for (std::size_t i = 0; i < a.leftOut.size(); ++i) QVERIFY(std::abs(a.leftOut[i] - b.leftOut[i]) < 1e-5);
    QVERIFY_THROWS_EXCEPTION(Error, learn(tables, {.maxBytes = 40'000}));  // 35 components alone need more
  }

  void exactAtFullRank() {
    const auto tables = materials(5);
    const PrincipalComponents pca = learn(tables);
    QVERIFY(pca.count() <= 14);  // the mean takes one
    for (const Table& table : tables) {
      const Table back = decode(pca, encode(pca, *table, pca.count()));
      QCOMPARE(back->validCount(), table->validCount());
      QVERIFY(difference(*back, *table) < 2e-5);
    }
    // Not so of a material that is none of them.
    QVERIFY(difference(*decode(pca, encode(pca, *material(99), pca.count())), *material(99)) > 1e-3);
  }

  /// To the last bit of single precision, in cells of small values, too: there the inverse mapping amplifies rounding
  /// errors of the mapped value.
  void decodesByItsDefinition() {
    const auto pca = learn(materials(12));
    const ComponentCode code = encode(pca, *material(99), pca.count());
    const auto u = pca.svd.u.view().cast<double>();
    const Table table = decode(pca, code);
    for (std::size_t i = 0; i < pca.mapping.cells.size(); ++i)
      for (int channel = 0; channel < 3; ++channel) {
        const double y =
            double(pca.mean[i]) + u.row(Eigen::Index(i)).dot(code.channels[std::size_t(channel)].cast<double>());
        const double rho = inverseLogRelative(y, pca.mapping.weights[i], pca.mapping.reference[i]);
        QVERIFY(std::abs(double(table->values()[pca.mapping.cells[i]][channel]) - rho) <= 1e-7 * rho);
      }
  }

  void orthonormal() {
    const PrincipalComponents pca = learn(materials(6));
    const Eigen::MatrixXd u = pca.svd.u.view().cast<double>();
    const double error = (u.transpose() * u - Eigen::MatrixXd::Identity(u.cols(), u.cols())).cwiseAbs().maxCoeff();
    QVERIFY2(error < 1e-5, qPrintable(QString::number(error)));
  }

  /// The squared error that the first components leave of the whole set is the sum of the others' squared singular
  /// values (Eckart and Young 1936), and the codes of the set are Sigma V^T.
  void errorIsThatOfTheComponentsLeftOut() {
    const auto tables = materials(5);
    const PrincipalComponents pca = learn(tables);
    for (const int components : {0, 1, 3, 6}) {
      double left = pca.svd.singularValues.squaredNorm();
      for (std::size_t m = 0; m < tables.size(); ++m) {
        const ComponentCode code = encode(pca, *tables[m], components);
        QCOMPARE(code.components(), components);
        for (std::size_t c = 0; c < 3; ++c) {
          const Eigen::VectorXd expected =
              pca.svd.singularValues.cwiseProduct(pca.svd.v.row(Eigen::Index(3 * m + c)).transpose());
          QVERIFY((code.channels[c].cast<double>() - expected.head(components)).norm() < 1e-5 * expected.norm());
          left -= code.channels[c].cast<double>().squaredNorm();
        }
      }
      const double expected = pca.svd.singularValues.tail(pca.count() - components).squaredNorm();
      QVERIFY(std::abs(left - expected) < 1e-5 * pca.svd.singularValues.squaredNorm());
    }
  }

  void truncationIsEncodingWithFewer() {
    const PrincipalComponents pca = learn(materials(5));
    const Table other = material(42);
    const ComponentCode whole = encode(pca, *other, pca.count()), few = encode(pca, *other, 3);
    for (std::size_t c = 0; c < 3; ++c)
      QVERIFY((whole.truncated(3).channels[c] - few.channels[c]).norm() < 1e-5f * whole.channels[c].norm());
    QCOMPARE(few.bytes(), std::size_t(3 * 3 * 4));
    QCOMPARE(pca.bytes(3), pca.mean.size() * 5 * 4);
    QCOMPARE(learn(materials(5), {.maxComponents = 3}).count(), 3);
  }

  /// One material many times, or one value everywhere: nothing varies, and the mean is all.
  void hardCase14NothingVaries() {
    const Table constant = [] {
      std::vector<TabulatedBrdf::Value> values(grid.size(), TabulatedBrdf::Value(0.2f));
      std::vector<std::uint8_t> valid(grid.size());
      for (std::size_t cell = 0; cell < grid.size(); ++cell) valid[cell] = grid.nodeAboveHorizon(cell);
      return std::make_shared<const TabulatedBrdf>(grid, values, valid);
    }();
    for (const std::size_t count : {1, 4}) {
      const PrincipalComponents pca = learn(std::vector<Table>(count, constant));
      QCOMPARE(pca.count(), 0);
      const ComponentCode code = encode(pca, *constant, 10);
      QCOMPARE(code.components(), 0);
      QVERIFY(difference(*decode(pca, code), *constant) < 1e-6);
    }
  }

  /// Kept and left out add up to the variance of the training signals, however many are kept.
  void leftOutVariances() {
    const auto tables = materials(4);
    const PrincipalComponents all = learn(tables);
    QVERIFY(all.leftOut.empty());
    for (const int kept : {0, 1, 5, all.count()}) {
      const PrincipalComponents pca = learn(tables, {.maxComponents = kept});
      const std::vector<float> total = leftOutVariance(pca, 0, 0, pca.mean.size());
      const std::vector<float> left = leftOutVariance(pca, pca.count(), 0, pca.mean.size());
      QVERIFY(pca.leftOut.empty() || pca.leftOut == left);
      for (std::size_t i = 0; i < pca.mean.size(); i += 7) {
        double variance = 0, expected = 0;
        for (const Table& table : tables)
          for (int c = 0; c < 3; ++c) {
            const double rho = double(table->values()[pca.mapping.cells[i]][c]), weight = pca.mapping.weights[i];
            variance += std::pow(logRelative(rho, weight, pca.mapping.reference[i]) - pca.mean[i], 2) / 12;
          }
        for (int k = kept; k < all.count(); ++k)
          expected += std::pow(all.svd.singularValues[k] * double(all.svd.u.view()(Eigen::Index(i), k)), 2) / 12;
        QVERIFY(std::abs(total[i] - variance) < 1e-5 * variance + 1e-9);
        QVERIFY(std::abs(left[i] - expected) < 1e-5 * variance + 1e-9);
        QCOMPARE(leftOutVariance(pca, 1, i, i + 1)[0], leftOutVariance(pca, 1, 0, pca.mean.size())[i]);
      }
    }
  }

  /// A set in which every material stands twice has the rank of the set, and reconstructs as it does.
  void hardCase24RepeatedMaterials() {
    auto tables = materials(3);
    const int rank = learn(tables).count();
    for (const Table& table : materials(3)) tables.push_back(table);
    const PrincipalComponents pca = learn(tables);
    QCOMPARE(pca.count(), rank);
    QVERIFY(difference(*decode(pca, encode(pca, *tables[1], rank)), *tables[1]) < 2e-5);
  }

  /// A cell that one material of the set lacks does not count; one that the coded material lacks counts as the mean.
  void invalidCells() {
    auto tables = materials(3);
    const std::size_t cell = grid.index(2, 3, 1);
    QVERIFY(tables[0]->valid()[cell]);
    const PrincipalComponents all = learn(tables);
    for (const std::size_t lacking : {0, 2}) {
      auto holed = tables;
      holed[lacking] = with(tables[lacking], cell, 1e6f, false);
      const PrincipalComponents pca = learn(holed);
      QCOMPARE(pca.mapping.cells.size(), all.mapping.cells.size() - 1);
      QVERIFY(std::find(pca.mapping.cells.begin(), pca.mapping.cells.end(), cell) == pca.mapping.cells.end());
      const Table back = decode(pca, encode(pca, *holed[lacking], pca.count()));
      QVERIFY(!back->valid()[cell]);
      QVERIFY(difference(*back, *holed[lacking]) < 2e-5);
    }
    const auto i =
        std::size_t(std::find(all.mapping.cells.begin(), all.mapping.cells.end(), cell) - all.mapping.cells.begin());
    const double mean = inverseLogRelative(all.mean[i], all.mapping.weights[i], all.mapping.reference[i]);
    const ComponentCode code = encode(all, *with(tables[1], cell, 0, false), all.count());
    const ComponentCode expected = encode(all, *with(tables[1], cell, float(mean), true), all.count());
    for (std::size_t c = 0; c < 3; ++c) QVERIFY((code.channels[c] - expected.channels[c]).norm() < 1e-5);
  }

  void hardCase39Overshooting() {
    const PrincipalComponents pca = learn(materials(3));
    ComponentCode code = encode(pca, *material(1), 1);
    std::size_t capped = 0, cappedInAll = 0;
    // Which of the two overshoots depends on the component.
    for (const float coefficient : {1e6f, -1e6f}) {
      for (Eigen::VectorXf& channel : code.channels) channel[0] = coefficient;
      const Table table = decode(pca, code, {}, &capped);
      cappedInAll += capped;
      for (const TabulatedBrdf::Value& value : table->values()) QVERIFY(std::isfinite(value.x) && value.x >= 0);
    }
    QVERIFY(cappedInAll > 0);
    decode(pca, encode(pca, *material(1), 1), {}, &capped);
    QCOMPARE(capped, std::size_t(0));
  }

  void hardCase50SameBitsForAnyThreads() {
    const auto tables = materials(4);
    const PrincipalComponents many = learn(tables);
    const ComponentCode code = encode(many, *tables[2], 5);
    const ThreadLimit limit(1);
    const PrincipalComponents one = learn(tables);
    QVERIFY(one.svd.u.values == many.svd.u.values && one.mean == many.mean);
    QVERIFY(encode(one, *tables[2], 5).channels == code.channels);
  }

  void refusals() {
    QVERIFY_EXCEPTION_THROWN(learn({}), Error);
    const auto other = std::make_shared<const TabulatedBrdf>(
        HalfDifferenceGrid{4, 4, 4}, std::vector<TabulatedBrdf::Value>(64), std::vector<std::uint8_t>(64, 1));
    QVERIFY_EXCEPTION_THROWN(learn({material(1), other}), Error);
    const PrincipalComponents pca = learn(materials(2));
    QVERIFY_EXCEPTION_THROWN(encode(pca, *other, 1), Error);
    ComponentCode long_;
    for (Eigen::VectorXf& channel : long_.channels) channel.setZero(pca.count() + 1);
    QVERIFY_EXCEPTION_THROWN(decode(pca, long_), Error);
    const auto empty = std::make_shared<const TabulatedBrdf>(grid, std::vector<TabulatedBrdf::Value>(grid.size()),
                                                             std::vector<std::uint8_t>(grid.size(), 0));
    QVERIFY_EXCEPTION_THROWN(learn({material(1), empty}), Error);
  }
};

GONIO_TEST(PrincipalComponentsTest)
}  // namespace principal_components_test

#include "principal_components_test.moc"
