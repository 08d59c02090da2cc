// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>

#include "tests/app/goniotool/goniotool_runner.h"
#include "tests/support/test_program.h"

namespace goniotool_shards_test {
using namespace gonio;
using namespace gonio::test;

/// goniotool study in shards, resumed and without times, and goniotool merge.
class GoniotoolShardsTest : public QObject {
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

  /// Also where a shard has no material.
  void shardsJoinToOneRun() {
    for (const int count : {2, 4}) {
      QStringList shards;
      for (int i = count; i >= 1; --i) {
        const QString shard = QString("%1-of-%2").arg(i).arg(count);
        const ToolResult result = study(shard, materials_, {"--shard", QString("%1/%2").arg(i).arg(count)});
        VERIFY_SUCCESS(result);
        QCOMPARE(result.json["shard"].get<int>(), i);
        QVERIFY(!QFile::exists(folder_.path(shard + "/summary.json")));
        shards << folder_.path(shard);
      }
      const QString joined = QString("joined-%1").arg(count);
      const ToolResult merged = runJson(QStringList{"merge"} + shards + QStringList{"--out", folder_.path(joined)});
      VERIFY_SUCCESS(merged);
      compareFolders(joined, "whole");
      QCOMPARE(merged.json["records"].size(), std::size_t(9));
    }
  }

  /// Times, infinite and undefined numbers are copied with their bits.
  void timesAreJoinedAsTheyAre() {
    for (const QString i : {"1", "2"})
      VERIFY_SUCCESS(runTool(QStringList{"study"} + materials_ + tiny_ +
                             QStringList{"--samples", "4", "--out", folder_.path("timed-" + i), "--shard", i + "/2"}));
    VERIFY_SUCCESS(
        runTool({"merge", folder_.path("timed-1"), folder_.path("timed-2"), "--out", folder_.path("timed-joined")}));
    for (const char* suffix : {".json", ".csv", ".svg"})
      for (int i = 0; i < 3; ++i) {
        const QString file = QString("/m%1%2").arg(i).arg(suffix);
        QCOMPARE(bytesOf(folder_.path("timed-joined" + file)),
                 bytesOf(folder_.path((i == 1 ? "timed-2" : "timed-1") + file)));
      }
    QVERIFY(QFile::exists(folder_.path("timed-joined/summary.svg")));
  }

  void wrongShardsAreReported() {
    const auto shard = [&](const QString& name, const QString& number, const QStringList& further) {
      VERIFY_SUCCESS(study(name, materials_, QStringList{"--shard", number} + further));
    };
    shard("a1", "1/2", {});
    shard("a2", "2/2", {});
    shard("b2", "2/2", {"--samples", "5"});
    shard("c3", "3/3", {});
    VERIFY_SUCCESS(study("d2", materials_.mid(1), {"--shard", "2/2"}));
    const auto fails = [&](const QStringList& shards, const char* text) {
      QStringList command{"merge"};
      for (const QString& name : shards) command << folder_.path(name);
      const ToolResult result = runTool(command << "--out" << folder_.path("never"));
      QCOMPARE(result.code, 1);
      QVERIFY2(result.error.contains(text), qPrintable(result.error));
      QCOMPARE(result.errorLines(), 1);
      QVERIFY(!QFile::exists(folder_.path("never")));
    };
    fails({"a1"}, "shards are missing: 2/2");
    fails({"a1", "a2", "a1"}, "found shard 1/2 twice");
    fails({"a1", "b2"}, "b2 are not shards of one study: different settings: pictures");
    fails({"a1", "c3"}, "found shards 1/2 and 3/3");
    fails({"a1", "d2"}, "they contain different materials");
    fails({"a1", "whole"}, "whole/shard.json: not found");
    QVERIFY(QFile::remove(folder_.path("a2/m1.json")));
    fails({"a1", "a2"}, "a2/m1.json");
    QVERIFY(QFile::copy(folder_.path("b2/m1.json"), folder_.path("a2/m1.json")));
    fails({"a1", "a2"}, "m1.json: result of another study");
    for (const char* text : {"0/2", "3/2", "2", "1/x"}) QCOMPARE(study("e", materials_, {"--shard", text}).code, 2);
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
    for (const char* file : {"whole/m0.json", "1-of-2/shard.json"})
      collectKeys(nlohmann::json::parse(bytesOf(folder_.path(file)).toStdString()));
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

  TestFolder folder_{"goniotool-shards"};
  QStringList materials_;
  const QStringList tiny_{"--size", "16", "--representations", "table,fits", "--models", "lambert"};
};

GONIO_TEST(GoniotoolShardsTest)
}  // namespace goniotool_shards_test

#include "goniotool_shards_test.moc"
