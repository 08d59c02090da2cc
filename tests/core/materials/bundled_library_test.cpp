// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/bundled_library.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/brdf/rgl_brdf.h"
#include "core/factorization/deviation_grid.h"
#include "tests/support/test_program.h"

namespace bundled_library_test {
using namespace gonio;
using namespace gonio::materials;

/// Signal over squared difference of values times the cosine of the light, dB.
double cosineSnr(const Brdf& expected, const Brdf& found, int count) {
  double signal = 0, error = 0;
  for (int i = 0; i < count; ++i) {
    const double light = 1.45 * (i % 37) / 37, viewer = 1.45 * (i % 41) / 41;
    const DirectionPair pair{fromSpherical(light, 0.37 * i), fromSpherical(viewer, 0)};
    const Rgb a = expected.evaluate(pair.wi, pair.wo) * pair.wi.z, b = found.evaluate(pair.wi, pair.wo) * pair.wi.z;
    signal += glm::dot(a, a);
    error += glm::dot(a - b, a - b);
  }
  return 10 * std::log10(signal / error);
}

class BundledLibraryTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void everyMaterialHasASourceAKindAndAnIdOfItsOwn() {
    std::map<LibraryOrigin, int> counts;
    std::set<std::string> ids;
    for (const LibraryEntry& entry : bundledLibrary()) {
      ++counts[entry.origin];
      ids.insert(entry.id);
      QVERIFY2(!entry.kind.empty(), entry.id.c_str());
      QVERIFY2(!entry.description.empty(), entry.id.c_str());
    }
    QCOMPARE(counts[LibraryOrigin::measured], 22);
    QCOMPARE(counts[LibraryOrigin::nearMeasured], 88 + 43 + 6);
    QCOMPARE(counts[LibraryOrigin::publishedFit], 100);
    QCOMPARE(ids.size(), bundledLibrary().size());
  }

  /// 22 measured ones, and of the 137 copies the 115 of materials that are not among them.
  void eachMaterialIsLearnedFromOnce() {
    const std::vector<std::string> paths = libraryTrainingPaths();
    std::set<std::string> names;
    for (const std::string& path : paths) {
      QVERIFY(!librarySha256(path).empty());
      names.insert(path.substr(path.find_last_of('/') + 1));
    }
    QCOMPARE(paths.size(), std::size_t(137));
    QCOMPARE(names.size(), paths.size());
    QVERIFY(!std::ranges::count(paths, "library:rgl-copy/chm_mint") &&
            std::ranges::count(paths, "library:rgl/chm_mint"));
  }

  void eachOpensUnderItsHash() {
    for (const char* id :
         {"rgl/chm_mint", "merl-copy/chrome", "dtu-copy/bluebook", "rgl-copy/spectralon", "sgd/brass"}) {
      const std::string path = std::string("library:") + id;
      const Material material = readMaterial(path);
      QCOMPARE(material.source.path.string(), path);
      QCOMPARE(material.source.sha256, librarySha256(path));
      QCOMPARE(material.source.sha256.size(), std::size_t(64));
    }
    QVERIFY(librarySha256("library:rgl/none").empty() && librarySha256("/tmp/chrome").empty());
  }

  /// Half floats and computed visible normals against the file as it was measured.
  void measuredMaterialsAreTheirFiles_data() {
    QTest::addColumn<QString>("file");
    const std::filesystem::path folder = std::filesystem::path(GONIO_SHARED_DIR) / "data/rgl";
    if (!std::filesystem::exists(folder)) QSKIP("the development data is absent");
    for (const MeasuredMaterial& measured : measuredMaterials())
      QTest::newRow(measured.name.c_str()) << QString::fromStdString((folder / (measured.name + "_rgb.bsdf")).string());
  }
  void measuredMaterialsAreTheirFiles() {
    QFETCH(QString, file);
    const Material bundled = readMaterial(std::string("library:rgl/") + QTest::currentDataTag());
    QVERIFY(formOf<RglBrdf>(*bundled.brdf));
    QVERIFY(!bundled.table);
    const double snr = cosineSnr(*readMaterial(file.toStdString()).brdf, *bundled.brdf, 20000);
    QVERIFY2(snr > 60, qPrintable(QString::number(snr)));
  }

  void copiesAreTablesOfTheMerlGrid() {
    const Material chrome = readMaterial("library:merl-copy/chrome");
    QVERIFY(chrome.table && chrome.table->grid() == HalfDifferenceGrid());
    QCOMPARE(chrome.table->validCount(), std::size_t(1111432));
    QCOMPARE(chrome.source.format, std::string("near-measured copy"));
    // A mirror: all of its energy within some degrees, far more than any paint.
    QVERIFY(chrome.brdf->evaluate({0, 0, 1}, {0, 0, 1}).x > 100);
  }

  /// The stored nodes of |Dp| are those of the library's mean energy. This takes a minute, so only long tests use all
  /// materials; otherwise every 15th material gives similar nodes.
  void nodesOfProjectedDeviations() {
    using namespace factorization;
    const std::vector<std::string> paths = libraryTrainingPaths();
    for (const DataTransform transform : {DataTransform::logPlus, DataTransform::none}) {
      std::vector<double> energy;
      for (std::size_t i = 0; i < paths.size(); i += test::longTests() ? 1 : 15) {
        const auto one =
            publishedDeviationEnergy(*meanOfOrders(readLibraryMaterial(paths[i]).tabulated({})), {}, transform);
        energy.resize(one.size());
        for (std::size_t j = 0; j < one.size(); ++j) energy[j] += one[j];
      }
      const std::vector<double> stored = libraryDeviationNodes(transform),
                                nodes = deviationNodes(energy, defaultDeviations);
      QCOMPARE(nodes.size(), stored.size());
      // The energy rho of few materials is that of the one with the largest values.
      if (transform == DataTransform::none && !test::longTests()) continue;
      const double tolerance = test::longTests() ? 1e-7 : 0.1;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        QVERIFY2(std::abs(nodes[i] - stored[i]) < tolerance,
                 qPrintable(QString("%1: %2 %3").arg(i).arg(nodes[i]).arg(stored[i])));
      }
    }
  }
};

GONIO_TEST(BundledLibraryTest)
}  // namespace bundled_library_test

#include "bundled_library_test.moc"
