// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/formats/pdv.h"

#include <QTest>
#include <cmath>
#include <limits>

#include "core/factorization/pdv_operations.h"
#include "core/materials/edited_material.h"
#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace pdv_file_test {
using namespace gonio;
using namespace gonio::factorization;
using namespace gonio::formats;
using namespace gonio::io;
using namespace gonio::materials;

/// Values that single precision holds.
PdvFactors someFactors(PdvForm form) {
  const bool flat = form == PdvForm::twoFactors;
  PdvFactors f{.form = form,
               .transform = DataTransform::cosineLog,
               .thetaNodes = {0, 0.5, 1.25},
               .deviationNodes = {0, 0.125, 0.5, 2},
               .phiNodes = flat ? std::vector<double>{0} : std::vector<double>{0, 1.5, 3},
               .channels = {},
               .highest = 9.5};
  for (std::size_t channel = 0; channel < 3; ++channel)
    for (int term = 0; term < 2; ++term)
      f.channels[channel].push_back({{1.0 + term, 2, 3.0 + double(channel)},
                                     {1, 0.5, 0.25, -0.125},
                                     flat ? std::vector<double>{1} : std::vector<double>{1, -0.5, 0.75}});
  return f;
}

class PdvFileTest : public QObject {
  Q_OBJECT
 private:
  /// The error of the file with one number of the header replaced: 0 is the version, 7 the highest value.
  static std::string errorWith(std::size_t number, auto value) {
    const auto path = test::outputPath("pdv/header.pdv");
    writePdv(someFactors(PdvForm::threeFactors), path);
    test::Bytes bytes = test::readFile(path);
    std::memcpy(bytes.data() + 8 + 4 * number, &value, 4);
    return test::errorOf([&] { readPdv(test::writeFile("pdv/changed.pdv", bytes)); });
  }

 private Q_SLOTS:
  /// A curve of 1e300: the file holds what evaluation uses, so that it can be read, and a warning states it.
  void hardCase56HugeCurve() {
    PdvFactors f = someFactors(PdvForm::threeFactors);
    f.channels[1][0].f1[2] = -1e300;
    f.highest = 1e300;
    const auto path = test::outputPath("pdv/huge.pdv");
    writePdv(f, path);
    QCOMPARE(readPdv(path).channels[1][0].f1[2], double(-1e30f));
    const std::string warning = curveLimitWarning(f);
    QVERIFY2(warning.starts_with("1 value of the factor curves is larger than 1e+30 (1e+300 in F1 of term 1 in green)"),
             warning.c_str());
    QVERIFY(curveLimitWarning(someFactors(PdvForm::threeFactors)).empty());
    // With an edit that makes it, the material states it.
    const auto original = std::make_shared<const PdvFactors>(someFactors(PdvForm::threeFactors));
    const std::vector<editing::Edit> edits{
        {.content = editing::FactorEdit{original, std::make_shared<const PdvFactors>(f)}}};
    const Material base = unedited("base", makePdvBrdf(*original)).base;
    QCOMPARE(withEdits(base, edits).source.notes, std::vector{"warning: " + warning});
  }

  /// Version 2 has the bound of negative values; without them files are those of version 1.
  void roundTrip() {
    for (const PdvForm form : {PdvForm::twoFactors, PdvForm::threeFactors})
      for (const double lowest : {0.0, -0.75}) {
        PdvFactors f = someFactors(form);
        f.lowest = lowest;
        const auto path = test::outputPath("pdv/round_trip.pdv");
        writePdv(f, path);
        QVERIFY(isPdv(path));
        QVERIFY(readPdv(path) == f);
        QCOMPARE(std::filesystem::file_size(path), pdvFileBytes(f));
        QCOMPARE(test::readFile(path)[8], std::byte(lowest < 0 ? 2 : 1));
      }
  }

  /// Ten terms of three factors in RGB over 90, 90 and 180 nodes: the dissertation's 87 KB in half the precision.
  void sizeOfTheUsualModel() {
    PdvFactors f{.thetaNodes = std::vector<double>(90),
                 .deviationNodes = std::vector<double>(90),
                 .phiNodes = std::vector<double>(180)};
    for (auto& channel : f.channels) channel.resize(10);
    QVERIFY(pdvFileBytes(f) < 45000);
  }

  void hardCase13CorruptHeadersAreRefused() {
    const auto contains = [](const std::string& text, const char* part) {
      return text.find(part) != std::string::npos;
    };
    QVERIFY(contains(errorWith(0, 3u), "the version is 3, expected 1 to 2"));
    QVERIFY(contains(errorWith(0, 3u), "changed.pdv"));
    // The number behind the highest value is then the first node of theta_R, which is 0: the file is too short.
    QVERIFY(contains(errorWith(0, 2u), "the size of the file"));
    QVERIFY(contains(errorWith(1, 7u), "the form is 7, expected 0 (two curves) or 1"));
    QVERIFY(contains(errorWith(2, 99u), "the transform is 99"));
    QVERIFY(contains(errorWith(3, 0xffffffffu), "nodes of theta_R is 4294967295"));
    QVERIFY(contains(errorWith(6, 0u), "the count of terms is 0, expected 1 to 20"));
    QVERIFY(contains(errorWith(6, 3u), "the size of the file"));
    QVERIFY(contains(errorWith(7, std::numeric_limits<float>::infinity()),
                     "the maximum transformed BRDF value is not finite"));
    PdvFactors negative = someFactors(PdvForm::threeFactors);
    negative.lowest = 0.5;  // written in version 1, without this bound
    const auto path = test::outputPath("pdv/positive_bound.pdv");
    writePdv(negative, path);
    QCOMPARE(readPdv(path).lowest, 0.0);
    QVERIFY(contains(errorWith(8, 0.5f), "the first node of theta_R"));
    QVERIFY(contains(errorWith(9, -1.0f), "node 1 of theta_R"));
    QVERIFY(contains(errorWith(30, std::nanf("")), "number 22 is not finite"));
  }

  void hardCase13ShortAndForeignFilesAreRefused() {
    const auto path = test::outputPath("pdv/short.pdv");
    writePdv(someFactors(PdvForm::threeFactors), path);
    test::Bytes bytes = test::readFile(path);
    for (const std::size_t length : {std::size_t(0), std::size_t(7), std::size_t(39), bytes.size() - 1}) {
      const test::Bytes part(bytes.begin(), bytes.begin() + std::ptrdiff_t(length));
      QVERIFY(!test::errorOf([&] { readPdv(test::writeFile("pdv/part.pdv", part)); }).empty());
    }
    bytes[0] = std::byte('X');
    const auto foreign = test::writeFile("pdv/foreign.pdv", bytes);
    QVERIFY(!isPdv(foreign) && !isPdv("no such file"));
    QVERIFY(test::errorOf([&] { readPdv(foreign); }).find("not a PDV file (signature missing)") != std::string::npos);
  }
};

GONIO_TEST(PdvFileTest)
}  // namespace pdv_file_test

#include "pdv_file_test.moc"
