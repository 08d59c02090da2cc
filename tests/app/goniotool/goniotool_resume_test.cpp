// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QDateTime>
#include <QTest>

#include "tests/app/goniotool/goniotool_runner.h"
#include "tests/support/test_program.h"

namespace goniotool_resume_test {
using namespace gonio;
using namespace gonio::test;

/// goniotool study without times, resumed, and with one job a material.
class GoniotoolResumeTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    for (int i = 0; i < 3; ++i)
      materials_ << folder_.writeTable(QString("m%1.binary").arg(i), "ggx",
                                       {{Rgb(0.1 + 0.2 * i), Rgb(0.9 - 0.2 * i), Rgb(0.15 + 0.2 * i), Rgb(0.1)}});
    VERIFY_SUCCESS(study("whole", materials_, {"--threads", "1"}));
  }

  /// Neither the run nor the number of threads changes a bit; no time and nothing of the machine is stated.
  void withoutTimesAllBitsAreTheSame() {
    const ToolResult result = study("again", materials_, {"--threads", "2"});
    VERIFY_SUCCESS(result);
    compareFolders("again", "whole");
    for (const auto& record : result.json["records"])
      for (const char* key : {"encodeSeconds", "evaluationNs", "frameMs"}) QVERIFY(record[key].is_null());
    QVERIFY(!result.json["machine"].contains("processor") && !result.json["machine"].contains("date"));
    QVERIFY(!bytesOf(folder_.path("whole/m0.svg")).contains("frame ["));
    QCOMPARE(study("budget", materials_, {"--max-frame-ms", "1"}).code, 2);
  }

  /// What is kept is recognised by a number that no study would write.
  void resumeKeepsWhatIsOfTheSameStudy() {
    const auto change = [&] {
      QByteArray text = bytesOf(folder_.path("resumed/m0.json"));
      QVERIFY(text.contains("\"budget\": 3.0"));
      folder_.writeText("resumed/m0.json", text.replace("\"budget\": 3.0", "\"budget\": 99.0"));
    };
    const auto budget = [](const ToolResult& result) { return result.json["records"][2]["budget"].get<double>(); };
    VERIFY_SUCCESS(study("resumed", materials_, {}));
    change();
    QVERIFY(QFile::remove(folder_.path("resumed/m1.json")) && QFile::remove(folder_.path("resumed/summary.json")));
    const ToolResult resumed = study("resumed", materials_, {"--resume"});
    VERIFY_SUCCESS(resumed);
    QCOMPARE(budget(resumed), 99.0);
    for (const char* name : {"/m1.json", "/m2.json"})
      QCOMPARE(bytesOf(folder_.path("resumed") + name), bytesOf(folder_.path("whole") + name));
    // In results of older versions the node at or below is called the nearest.
    const QByteArray now = bytesOf(folder_.path("resumed/m0.json"));
    QVERIFY(now.contains("table-cell 0") && now.contains("\"representation\": \"table-cell\""));
    folder_.writeText("resumed/m0.json", QByteArray(now).replace("table-cell", "table-nearest"));
    const ToolResult older = study("resumed", materials_, {"--resume"});
    QCOMPARE(budget(older), 99.0);
    QCOMPARE(older.json["records"][0]["representation"].get<std::string>(), "table-cell");
    // Other settings, another material of the name, a damaged file: measured again.
    QVERIFY(budget(study("resumed", materials_, {"--resume", "--samples", "5"})) != 99.0);
    VERIFY_SUCCESS(study("resumed", materials_, {}));
    change();
    QVERIFY(QDir().mkpath(folder_.path("other")) && QFile::copy(materials_[1], folder_.path("other/m0.binary")));
    QVERIFY(budget(study("resumed", {folder_.path("other/m0.binary")}, {"--resume"})) != 99.0);
    folder_.writeText("resumed/m0.json", "{\"material\": \"m0\"");
    VERIFY_SUCCESS(study("resumed", materials_, {"--resume"}));
    compareFolders("resumed", "whole");
  }

  /// One run for each material, then one for the summary, write what a single run writes.
  void materialsOneByOne() {
    for (const QString& material : materials_) VERIFY_SUCCESS(study("one-by-one", {material}, {}));
    QVERIFY(!QFile::exists(folder_.path("one-by-one/summary.json")));
    const QDateTime before = QFileInfo(folder_.path("one-by-one/m0.json")).lastModified();
    VERIFY_SUCCESS(study("one-by-one", materials_, {"--resume"}));
    QCOMPARE(QFileInfo(folder_.path("one-by-one/m0.json")).lastModified(), before);
    compareFolders("one-by-one", "whole");
  }

  /// Each by the first dictionary that has not learned from it: as if that dictionary alone were given.
  void heldOutDictionaries() {
    const auto train = [&](const QString& name, const QStringList& sources) {
      VERIFY_SUCCESS(runTool(
          QStringList{"dictionary", "train"} + sources +
          QStringList{"--dictionaries", "1", "--sparsities", "20", "--iterations", "1", "--out", folder_.path(name)}));
    };
    train("first.dictionary", {materials_[0], materials_[2]});
    train("second.dictionary", {materials_[1]});
    const auto codes = [&](const QString& out, const QStringList& materials, const QStringList& dictionaries) {
      QStringList command = QStringList{"study"} + materials;
      for (const QString& name : dictionaries) command << "--dictionary" << folder_.path(name);
      return runJson(command + QStringList{"--representations", "codes", "--coefficients", "20", "--size", "16",
                                           "--samples", "4", "--no-times", "--out", folder_.path(out)});
    };
    const ToolResult both = codes("both", materials_, {"first.dictionary", "second.dictionary"});
    VERIFY_SUCCESS(both);
    for (int i = 0; i < 3; ++i) {
      const ToolResult one = codes("one", {materials_[i]}, {i == 1 ? "first.dictionary" : "second.dictionary"});
      VERIFY_SUCCESS(one);
      QVERIFY(one.json["records"][0] == both.json["records"][std::size_t(i)]);
    }
    const ToolResult none = codes("none", {materials_[1]}, {"second.dictionary", "second.dictionary"});
    QVERIFY(none.code == 1 && none.error.contains("m1: every dictionary was trained"));
  }

  void foldersAreTheirMaterials() {
    for (const QString& material : materials_)
      QVERIFY(QDir().mkpath(folder_.path("collection")) &&
              QFile::copy(material, folder_.path("collection/" + QFileInfo(material).fileName())));
    VERIFY_SUCCESS(study("of-a-folder", {folder_.path("collection")}, {}));
    compareFolders("of-a-folder", "whole");
  }

  void zEveryKeyIsDocumented() {
    collectKeys(nlohmann::json::parse(bytesOf(folder_.path("whole/m0.json")).toStdString()));
    QCOMPARE(undocumentedKeys(), QString());
  }

 private:
  ToolResult study(const QString& out, const QStringList& materials, const QStringList& further) const {
    return runJson(QStringList{"study"} + materials + tiny_ + QStringList{"--no-times", "--out", folder_.path(out)} +
                   (further.contains("--samples") ? QStringList{} : QStringList{"--samples", "4"}) + further);
  }

  /// The same files with the same bytes.
  void compareFolders(const QString& a, const QString& b) const {
    const QStringList files = QDir(folder_.path(a)).entryList(QDir::Files);
    QCOMPARE(files, QDir(folder_.path(b)).entryList(QDir::Files));
    QVERIFY(files.size() == 12);
    for (const QString& file : files)
      QVERIFY2(bytesOf(folder_.path(a + "/" + file)) == bytesOf(folder_.path(b + "/" + file)), qPrintable(file));
  }

  TestFolder folder_{"goniotool-resume"};
  QStringList materials_;
  const QStringList tiny_{"--size", "16", "--representations", "table,fits", "--models", "lambert"};
};

GONIO_TEST(GoniotoolResumeTest)
}  // namespace goniotool_resume_test

#include "goniotool_resume_test.moc"
