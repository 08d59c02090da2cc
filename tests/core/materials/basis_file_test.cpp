// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/basis_file.h"

#include <QTest>
#include <cmath>

#include "core/brdf/data_transform.h"
#include "tests/core/io/test_files.h"
#include "tests/support/smooth_materials.h"
#include "tests/support/test_program.h"

namespace basis_file_test {
using namespace gonio;
using namespace gonio::io;
using namespace gonio::materials;
using dictionary::PrincipalComponents;

std::shared_ptr<const BasisFile> read(const test::Bytes& bytes) { return readBasis(MemorySource(bytes)); }

/// The bytes with a text of the description replaced by another of the same length.
test::Bytes with(test::Bytes bytes, const std::string& text, const std::string& other) {
  const std::string all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const auto at = all.find(text);
  if (at == std::string::npos || text.size() != other.size()) throw std::logic_error("no such text");
  std::memcpy(bytes.data() + at, other.data(), other.size());
  return bytes;
}

class BasisFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { basis_ = test::learnFrom(test::smoothMaterials(6)); }

  void roundTrip() {
    for (const BasisPrecision precision : {BasisPrecision::single, BasisPrecision::half})
      for (const int components : {0, 5, basis_.count(), 1000}) {
        const auto path = test::outputPath("basis/some.basis");
        writeBasis(basis_, components, {"a", "b c"}, path, precision);
        const auto file = readBasis(path);
        const PrincipalComponents& found = file->components;
        QVERIFY(file->learnedFrom == (std::vector<std::string>{"a", "b c"}));
        const int count = std::min(components, basis_.count());
        QCOMPARE(found.count(), count);
        QVERIFY(found.mapping.grid == basis_.mapping.grid && found.mapping.cells == basis_.mapping.cells);
        QVERIFY(found.mapping.weights == basis_.mapping.weights);
        QVERIFY(found.mapping.reference == basis_.mapping.reference && found.mean == basis_.mean);
        QVERIFY(found.svd.singularValues == basis_.svd.singularValues.head(count));
        QVERIFY(found.svd.v == basis_.svd.v.leftCols(count));
        for (int k = 0; k < count; ++k) {
          const auto expected = basis_.svd.u.view().col(k);
          const float largest = expected.cwiseAbs().maxCoeff();
          const float bound = precision == BasisPrecision::half ? largest / 2048 : largest * 2e-7f;
          QVERIFY((found.svd.u.view().col(k) - expected).cwiseAbs().maxCoeff() <= bound);
        }
      }
  }

  /// What a file leaves out comes back, also of what had left something out before; of all that there is it is nothing.
  void leftOut() {
    const PrincipalComponents truncated = test::learnFrom(test::smoothMaterials(6), {.maxComponents = 5});
    for (const BasisPrecision precision : {BasisPrecision::single, BasisPrecision::half})
      for (const int components : {0, 3, 5}) {
        const std::vector<float> expected = dictionary::leftOutVariance(basis_, components, 0, basis_.mean.size());
        const double largest = std::sqrt(double(*std::ranges::max_element(expected)));
        for (const PrincipalComponents* from : std::initializer_list<const PrincipalComponents*>{&basis_, &truncated}) {
          const std::vector<float> found = read(encodeBasis(*from, components, {}, precision))->components.leftOut;
          QCOMPARE(found.size(), expected.size());
          for (std::size_t i = 0; i < found.size(); ++i)
            QVERIFY(std::abs(std::sqrt(double(found[i])) - std::sqrt(double(expected[i]))) <
                    largest * (precision == BasisPrecision::half ? 1.0 / 2048 : 2e-3));
        }
      }
    QVERIFY(read(encodeBasis(basis_, basis_.count(), {}))->components.leftOut.empty());
  }

  /// Half precision moves a mapped value by at most a 2048th of what each component can make of it.
  void halfPrecisionIsEnough() {
    const auto bytes = encodeBasis(basis_, basis_.count(), {});
    QVERIFY(bytes.size() < encodeBasis(basis_, basis_.count(), {}, BasisPrecision::single).size());
    const auto code = dictionary::encode(basis_, *test::smoothMaterial(3), basis_.count());
    const auto expected = dictionary::decode(basis_, code), found = dictionary::decode(read(bytes)->components, code);
    for (int channel = 0; channel < 3; ++channel) {
      double bound = 1e-5;
      for (int k = 0; k < basis_.count(); ++k)
        bound +=
            std::abs(code.channels[std::size_t(channel)][k]) * basis_.svd.u.view().col(k).cwiseAbs().maxCoeff() / 2048;
      QVERIFY2(bound < 0.02, qPrintable(QString::number(bound)));
      for (std::size_t i = 0; i < basis_.mapping.cells.size(); ++i) {
        const auto mapped = [&](const TabulatedBrdf& table) {
          return logRelative(table.values()[basis_.mapping.cells[i]][channel], basis_.mapping.weights[i],
                             basis_.mapping.reference[i]);
        };
        QVERIFY(std::abs(mapped(*found) - mapped(*expected)) < bound);
      }
    }
  }

  /// Of nothing that varies there are no components.
  void withoutComponents() {
    const PrincipalComponents still = test::learnFrom({test::smoothMaterial(1), test::smoothMaterial(1)});
    PrincipalComponents none = still;
    none.svd = {.u = {{}, still.svd.u.rows, 0}, .singularValues = {}, .v = Eigen::MatrixXd(6, 0)};
    QCOMPARE(read(encodeBasis(none, 3, {}))->components.count(), 0);
  }

  void errorsTellWhat() {
    const test::Bytes good = encodeBasis(basis_, 4, {"one"});
    const auto errorOf = [](const test::Bytes& bytes) { return test::errorOf([&] { read(bytes); }); };
    QVERIFY(errorOf(good).empty());
    QVERIFY(test::contains(errorOf({}), "not a basis file (signature missing)"));
    QVERIFY(test::contains(errorOf({good.begin(), good.begin() + 12}), "basis"));
    QVERIFY(test::contains(errorOf({good.begin(), good.end() - 1}), "the size of the file is "));
    test::Bytes longer = good;
    longer.push_back(std::byte(0));
    QVERIFY(test::contains(errorOf(longer), "the size of the file is "));
    test::Bytes newer = good;
    newer[8] = std::byte(9);
    QVERIFY(test::contains(errorOf(newer), "the version is 9, expected 2"));
    newer[8] = std::byte(1);
    QVERIFY(test::contains(errorOf(newer), "the version is 1, expected 2"));
    QVERIFY(test::contains(errorOf(with(good, "\"half\"", "\"hulf\"")), "found the precision 'hulf'"));
    QVERIFY(test::contains(errorOf(with(good, "\"thetaH\":10", "\"thetaH\":11")), "basis"));
    QVERIFY(test::contains(errorOf(with(good, "\"phiD\":6", "\"phiD\":0")), "phiD"));
    // The numbers of the file, from their end: U of the last component, its scale.
    const std::size_t cells = basis_.mapping.cells.size(), last = good.size() - 2 * cells;
    test::Bytes bad = good;
    bad[good.size() - 1] = std::byte(0x7e);  // half a number that is none
    bad[good.size() - 2] = std::byte(0);
    QVERIFY(test::contains(errorOf(bad), "component 3 with an entry that is not finite"));
    bad = good;
    const float infinite = INFINITY;
    std::memcpy(bad.data() + last - 4, &infinite, 4);
    QVERIFY(test::contains(errorOf(bad), "is not finite, expected a finite number"));
    const std::size_t numbers = good.size() - 4 * (2 * cells + 4) - 4 * 8 * (1 + 18), leftOut = 2 * cells + 4;
    bad = good;
    const double negative = -1;
    std::memcpy(bad.data() + numbers, &negative, 8);
    QVERIFY(test::contains(errorOf(bad), "singular values that are not in descending order"));
    bad = good;
    const float below = -1;
    std::memcpy(bad.data() + numbers - leftOut - 8 * cells, &below, 4);
    QVERIFY(test::contains(errorOf(bad), "a negative reference value"));
    bad = good;
    // What is left out stands before the singular values: its scale, then 2 bytes per cell.
    bad = good;
    std::memcpy(bad.data() + numbers - leftOut, &infinite, 4);
    QVERIFY(test::contains(errorOf(bad), "is not finite, expected a finite number"));
    for (const float scale : {-1.0f, 1e30f}) {
      std::memcpy(bad.data() + numbers - leftOut, &scale, 4);
      QVERIFY(test::contains(errorOf(bad), "a residual standard deviation that is negative or too large"));
    }
    bad = good;
    bad[numbers - 1] = std::byte(0x7e);
    QVERIFY(test::contains(errorOf(bad), "the residual standard deviations with an entry that is not finite"));
    const std::size_t bits = (basis_.mapping.grid.size() + 7) / 8;
    bad[numbers - leftOut - 8 * cells - bits] ^= std::byte(1);
    QVERIFY(test::contains(errorOf(bad), "used cells, expected"));
    const auto path = test::writeFile("basis/bad.basis", bad);
    QVERIFY(test::contains(test::errorOf([&] { readBasis(path); }), "bad.basis: "));
  }

 private:
  PrincipalComponents basis_;
};

GONIO_TEST(BasisFileTest)
}  // namespace basis_file_test

#include "basis_file_test.moc"
