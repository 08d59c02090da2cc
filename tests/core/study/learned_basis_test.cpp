// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/learned_basis.h"

#include <QTest>
#include <fstream>

#include "core/models/registry.h"
#include "core/study/training_files.h"
#include "tests/core/io/test_files.h"
#include "tests/support/table_file.h"
#include "tests/support/test_program.h"

namespace learned_basis_test {
using namespace gonio;
using namespace gonio::study;
namespace fs = std::filesystem;

class LearnedBasisTest : public QObject {
  Q_OBJECT
 private:
  fs::path folder_;
  std::vector<std::string> files_;

  void writeMaterial(const std::string& name, double roughness) {
    models::ParameterValues values = models::defaultParameters(models::ggx().spec());
    values.values[models::ggx().spec().find("roughness").value()] = Rgb(roughness);
    const auto path = folder_ / (name + ".binary");
    test::writeTable(*bakeTable(*models::ggx().instantiate(values)), path);
    files_.push_back(path.string());
  }
  static std::vector<fs::path> keptFiles() {
    std::vector<fs::path> files;
    if (fs::exists(keptBasesFolder()))
      for (const auto& entry : fs::directory_iterator(keptBasesFolder())) files.push_back(entry.path());
    return files;
  }

 private Q_SLOTS:
  void initTestCase() {
    qputenv("XDG_CACHE_HOME", QByteArray::fromStdString(test::emptyFolder("learned_basis/cache").string()));
    folder_ = test::emptyFolder("learned_basis/materials");
    for (int i = 0; i < 3; ++i) writeMaterial("m" + std::to_string(i), 0.2 + 0.2 * i);
  }

  /// The second time it is read, and is the same to the bit.
  void learnedOnce() {
    const LearnedBasis first = learnedBasis(files_, 4);
    QVERIFY(first.seconds > 0 && first.basis->components.count() > 0);
    QCOMPARE(keptFiles(), std::vector<fs::path>{first.file});
    const LearnedBasis second = learnedBasis(files_, 4);
    QCOMPARE(second.seconds, 0.0);
    QCOMPARE(second.digest, first.digest);
    QVERIFY(second.basis->components.svd.u.values == first.basis->components.svd.u.values);
    QCOMPARE(second.basis->learnedFrom, (std::vector<std::string>{"m0", "m1", "m2"}));
  }

  /// Other components, another order of precision, a file that was written again: learned anew.
  void whatDiffersIsLearned() {
    QVERIFY(learnedBasis(files_, 3).seconds > 0);
    QVERIFY(learnedBasis(files_, 4, materials::BasisPrecision::single).seconds > 0);
    fs::last_write_time(files_[1], fs::last_write_time(files_[1]) + std::chrono::seconds(1));
    const LearnedBasis changed = learnedBasis(files_, 4);
    QVERIFY(changed.seconds > 0);
    QCOMPARE(keptFiles().size(), std::size_t(4));
    QVERIFY(learnedBasis({files_[0], files_[1]}, 4).basis->components.svd.v.rows() == 6);
  }

  /// Tables of another grid, and of both orders of the directions, of which the mean is learned.
  void gridOfTheTables() {
    const auto folder = test::emptyFolder("learned_basis/both_orders");
    std::vector<std::string> files;
    for (int i = 0; i < 2; ++i) {
      const auto brdf = models::ggx().instantiate(models::defaultParameters(models::ggx().spec()));
      files.push_back((folder / ("w" + std::to_string(i) + ".binary")).string());
      test::writeTable(*bakeTable(*brdf, {16, 16, 64, false}), files.back());
    }
    const HalfDifferenceGrid grid = learnedBasis(files, 2).basis->components.mapping.grid;
    QVERIFY(grid == (HalfDifferenceGrid{16, 16, 32, true}));
  }

  /// A kept file whose bytes changed is not used.
  void damagedFileIsLearnedAgain() {
    const LearnedBasis good = learnedBasis(files_, 4);
    fs::permissions(good.file, fs::perms::owner_write, fs::perm_options::add);
    std::fstream(good.file, std::ios::in | std::ios::out | std::ios::binary).seekp(2000).write("damaged", 7);
    const LearnedBasis again = learnedBasis(files_, 4);
    QVERIFY(again.seconds > 0);
    QCOMPARE(again.digest, good.digest);
    QCOMPARE(learnedBasis(files_, 4).seconds, 0.0);
  }

  /// Where nothing can be kept, the basis is learned each time.
  void unwritableFolder() {
    const QByteArray before = qgetenv("XDG_CACHE_HOME");
    qputenv("XDG_CACHE_HOME", "/proc/nowhere");
    const LearnedBasis one = learnedBasis(files_, 2);
    QVERIFY(one.file.empty() && one.seconds > 0 && one.basis->components.count() == 2);
    qputenv("XDG_CACHE_HOME", "not/absolute");
    QVERIFY(keptBasesFolder().string().ends_with(".cache/gonio/bases"));
    qputenv("XDG_CACHE_HOME", before);
  }
};

GONIO_TEST(LearnedBasisTest)
}  // namespace learned_basis_test

#include "learned_basis_test.moc"
