// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/reproduction/mapped_errors.h"

#include <QTest>
#include <cmath>

#include "core/acquisition/reconstruction.h"
#include "tests/core/acquisition/reconstruction_oracles.h"
#include "tests/support/smooth_materials.h"
#include "tests/support/test_program.h"

namespace mapped_errors_test {
using namespace gonio;
using namespace gonio::dictionary;

/// 1 / MSE of ln(rho w + e) between the material and the table of the code, by the definition.
double inverseErrorOfTables(const PrincipalComponents& basis, const TabulatedBrdf& material,
                            const TabulatedBrdf& decoded) {
  double sum = 0;
  for (std::size_t i = 0; i < basis.mapping.cells.size(); ++i)
    for (int channel = 0; channel < 3; ++channel) {
      const auto logOf = [&](const TabulatedBrdf& table) {
        return std::log(double(table.values()[basis.mapping.cells[i]][channel]) * basis.mapping.weights[i] + 1e-3);
      };
      sum += std::pow(logOf(material) - logOf(decoded), 2);
    }
  return 3 * double(basis.mapping.cells.size()) / sum;
}

class MappedErrorsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    basis_ = test::learnFrom(test::smoothMaterials(6));
    tables_ = {test::smoothMaterial(77), test::smoothMaterial(78), test::smoothMaterial(79)};
  }

  /// Of reconstructions, with and without decoding.
  void errorsAreThoseOfTheTables() {
    const acquisition::SamplingPlan plan = acquisition::everyCell(basis_, 23);
    std::vector<ComponentCode> codes;
    for (const auto& table : tables_) {
      const auto values = acquisition::measure(*table, plan);
      const auto options = acquisition::publishedReconstruction();
      const auto code = acquisition::reconstructCode(basis_, plan, values, options);
      QVERIFY(!code.table);
      const auto whole = acquisition::reconstruct(basis_, plan, values, options);
      for (std::size_t channel = 0; channel < 3; ++channel)
        QVERIFY(code.code.channels[channel] == whole.code.channels[channel]);
      codes.push_back(code.code);
    }
    check(codes);
  }

  /// A large coefficient of a component with both signs decodes to negative BRDF values, which the table has as 0.
  void negativeValuesCountAsBlack() {
    ComponentCode code;
    for (Eigen::VectorXf& channel : code.channels) {
      channel = Eigen::VectorXf::Zero(basis_.count());
      channel[1] = 10 * float(basis_.svd.singularValues[1]);
    }
    const auto decoded = decode(basis_, code);
    std::size_t black = 0;
    for (const std::uint32_t cell : basis_.mapping.cells) black += decoded->values()[cell][0] == 0;
    QVERIFY(black > basis_.mapping.cells.size() / 10 && black < basis_.mapping.cells.size());
    check({code, code, code});
  }

 private:
  void check(const std::vector<ComponentCode>& codes) {
    const std::vector<double> found = reproduction::MappedMaterials(basis_, tables_).inverseErrors(codes, {});
    QCOMPARE(found.size(), tables_.size());
    for (std::size_t t = 0; t < tables_.size(); ++t) {
      const double expected = inverseErrorOfTables(basis_, *tables_[t], *decode(basis_, codes[t]));
      QVERIFY2(std::abs(found[t] / expected - 1) < 1e-4, qPrintable(QString("%1, %2").arg(found[t]).arg(expected)));
    }
  }

  PrincipalComponents basis_;
  std::vector<std::shared_ptr<const TabulatedBrdf>> tables_;
};

GONIO_TEST(MappedErrorsTest)

}  // namespace mapped_errors_test

#include "mapped_errors_test.moc"
