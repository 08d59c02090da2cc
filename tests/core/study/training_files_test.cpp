// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/training_files.h"

#include <QTest>

#include "tests/support/test_program.h"

namespace training_files_test {
using namespace gonio;
using namespace gonio::study;

class TrainingFilesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Methods learn from the mean of both orders unless they ask for both; reciprocal materials have one.
  void ordersOfTheTables() {
    const std::vector<std::string> files{"library:rgl/paper_blue", "library:merl-copy/chrome"};
    const HalfDifferenceGrid grid;
    const auto mean = trainingMaterials(files), both = trainingMaterials(files, grid, TrainingOrders::both);
    QVERIFY((both.names == std::vector<std::string>{"paper_blue", "chrome"}));
    QVERIFY(mean.load(0)->grid() == grid);
    QVERIFY(both.grid == grid);
    QVERIFY(both.load(0)->grid() == grid.wholeCircle());
    QVERIFY(both.load(1)->grid() == grid);
  }

  /// The file and both grids are named.
  void anotherGridIsRefused() {
    const HalfDifferenceGrid small{.thetaHCount = 12, .thetaDCount = 12, .phiDCount = 16};
    const auto materials = trainingMaterials({"library:merl-copy/chrome"}, small, TrainingOrders::both);
    try {
      materials.load(0);
      QFAIL("loaded");
    } catch (const Error& error) {
      const QString text(error.what());
      QVERIFY2(text.contains("chrome") && text.contains("90 x 90 x 180") && text.contains("12 x 12 x 16"),
               qPrintable(text));
    }
  }
};

GONIO_TEST(TrainingFilesTest)
}  // namespace training_files_test

#include "training_files_test.moc"
