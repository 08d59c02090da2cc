// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/bundled_library.h"

#include <QTest>
#include <cmath>
#include <set>

#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace sgd_library_test {
using namespace gonio;
using namespace gonio::test;

/// The published formula with the published normalisation kap, straight from the columns of the table.
double published(const std::vector<double>& v, double thetaI, double thetaO, double thetaH, double thetaD) {
  enum { rhoD, rhoS, alpha, p, f0, f1, kap, lambda, c, k, theta0 };
  const double tan2 = std::tan(thetaH) * std::tan(thetaH), ax = v[alpha] + tan2 / v[alpha];
  const double d = v[kap] * std::exp(-ax) / (pi * std::pow(ax, v[p]) * std::pow(std::cos(thetaH), 4));
  const auto g1 = [&](double theta) {
    const double beyond = std::max(0.0, theta - v[theta0]);
    return std::clamp(1 + v[lambda] * (1 - std::exp(v[c] * std::pow(beyond, v[k]))), 0.0, 1.0);
  };
  const double cosD = std::cos(thetaD), fresnel = v[f0] - v[f1] * cosD + (1 - v[f0]) * std::pow(1 - cosD, 5);
  return (v[rhoD] + v[rhoS] * fresnel * d * g1(thetaI) * g1(thetaO) / (std::cos(thetaI) * std::cos(thetaO))) / pi;
}

class SgdLibraryTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void hundredMaterialsInsideTheModelsRanges() {
    std::set<std::string> hashes;
    for (const materials::SgdFit& fit : materials::sgdFits()) {
      models::ParameterValues parameters = fit.parameters;
      QVERIFY2(models::clampToHardRange(models::findModel("sgd").spec(), parameters).empty(), fit.name.c_str());
      hashes.insert(materials::readMaterial("library:sgd/" + fit.name).source.sha256);
    }
    QCOMPARE(hashes.size(), std::size_t(100));
    QVERIFY(materials::librarySha256("library:sgd/none").empty() && materials::librarySha256("/tmp/chrome").empty());
  }

  /// Row blue-metallic-paint, read here by hand: every column reaches its parameter, at several pairs of directions.
  void valuesAgreeWithThePublishedFormula() {
    const std::vector<std::vector<double>> channels = {
        {0.00390446, 0.0706771, 0.155564, 1.01719, 0.149347, -0.487331, 4.4222, 2.54345, 6.04906e-08, 23.9533,
         -0.34053},
        {0.00337319, 0.0415082, 0.139, 1.02602, 0.153181, -0.76557, 4.59265, 2.33884, 5.81858e-08, 25.0641, -0.294595},
        {0.00848198, 0.104423, 0.15088, 1.16153, 1.87241e-14, -1.0, 3.93929, 2.24405, 1.2419e-07, 24.6856, -0.258117}};
    const materials::Material material = materials::readMaterial("library:sgd/blue-metallic-paint");
    for (const auto& [thetaI, thetaO, phi] : std::vector<std::array<double, 3>>{
             {0.1, 0.1, 3.14}, {0.5, 0.3, 2.5}, {1.2, 0.2, 1}, {1.4, 1.45, 3.1}, {0, 0, 0}}) {
      const Direction wi = fromSpherical(thetaI, 0), wo = fromSpherical(thetaO, phi);
      const HalfDifference at = toHalfDifference(wi, wo);
      const Rgb found = material.brdf->evaluate(wi, wo);
      for (int channel = 0; channel < 3; ++channel) {
        const double expected = published(channels[std::size_t(channel)], thetaI, thetaO, at.thetaH, at.thetaD);
        QVERIFY(std::abs(found[channel] - expected) < 0.01 * expected);  // kap is printed for a rounded alpha and p
      }
    }
  }

  void materialIsLabelledAsAFit() {
    const materials::Material material = materials::readMaterial("library:sgd/chrome");
    QCOMPARE(material.name, std::string("chrome"));
    QCOMPARE(material.source.path.string(), std::string("library:sgd/chrome"));
    QCOMPARE(material.source.format, std::string("SGD fit"));
    QCOMPARE(material.source.description, std::string("SGD fit of MERL chrome, Bagher et al. 2012"));
    QCOMPARE(material.source.sha256.size(), std::size_t(64));
    QVERIFY(!material.table);
  }

  void bakesToAFiniteTable() {
    const auto table = materials::readMaterial("library:sgd/chrome").tabulated();
    QCOMPARE(table->validCount(), std::size_t(1111432));
    QCOMPARE(table->clampedCount(), std::size_t(0));
  }

  void errorsTellNameLineAndColumn() {
    QVERIFY(contains(errorOf([] { materials::readMaterial("library:sgd/unobtainium"); }), "unobtainium"));
    QVERIFY(contains(errorOf([] { materials::readMaterial("library:other"); }), "library:other"));
    const std::string table(materials::sgdTableCsv());
    std::string broken = table;
    broken.replace(broken.find("0.0478786"), 9, "0.04x8786");
    const std::string error = errorOf([&] { materials::parseSgdTable(broken); });
    QVERIFY2(contains(error, "line 2: found '0.04x8786' for rhod_r, expected a finite number"), error.c_str());
    broken = table.substr(0, table.size() - 150);
    QVERIFY(contains(errorOf([&] { materials::parseSgdTable(broken); }), "line 101"));
    broken = table;
    broken.replace(broken.find("alpha_g"), 7, "alpha_x");
    QVERIFY(contains(errorOf([&] { materials::parseSgdTable(broken); }), "expected one named alpha_g"));
  }
};

GONIO_TEST(SgdLibraryTest)
}  // namespace sgd_library_test

#include "sgd_library_test.moc"
