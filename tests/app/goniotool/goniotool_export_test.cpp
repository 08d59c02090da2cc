// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QFile>
#include <QFileInfo>
#include <QTest>

#include "core/export/export_target.h"
#include "tests/app/goniotool/goniotool_runner.h"
#include "tests/support/test_program.h"

namespace goniotool_export_test {
using namespace gonio;
using namespace gonio::test;

class GoniotoolExportTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { plastic_ = folder_.writeTable("plastic.binary", "ggx", plastic); }

  /// The targets of each kind, so that all JSON keys are seen: the files that are listed are there.
  void filesAreWritten_data() {
    QTest::addColumn<QString>("target");
    for (const char* id : {"blender", "gltf", "values", "csv", "slices"}) QTest::newRow(id) << id;
  }
  void filesAreWritten() {
    QFETCH(QString, target);
    const ToolResult result = runJson({"export", plastic_, out("a"), "--for", target, "--snr", "10", "--samples", "8"});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["target"].get<std::string>(), target.toStdString());
    QVERIFY(!result.json["files"].empty());
    for (const auto& file : result.json["files"])
      QCOMPARE(QFileInfo(QString::fromStdString(file["path"].get<std::string>())).size(), file["bytes"].get<qint64>());
    QVERIFY(target == "csv" || target == "slices" ? result.json["snr"].is_null()
                                                  : result.json["snr"].get<double>() > 10);
  }

  void aSceneIsWrittenBeside() {
    const ToolResult result = runJson({"export", plastic_, out("b"), "--for", "pbrt", "--theta-count", "4", "--size",
                                       "4", "--samples", "8", "--environment", "sky"});
    VERIFY_SUCCESS(result);
    for (const char* suffix : {"_rgb.bsdf", "_spec.bsdf", "_scene.pbrt", "_environment_octahedral.exr"})
      QVERIFY2(QFileInfo::exists(out("b") + suffix), suffix);
    // A name in use is refused, whichever of the files has it.
    QVERIFY(QFile::remove(out("b_rgb.bsdf")) && QFile::remove(out("b_spec.bsdf")));
    const ToolResult again = runTool({"export", plastic_, out("b"), "--for", "pbrt", "--scene"});
    QVERIFY(again.code != 0);
    QVERIFY(again.error.contains("b_scene.pbrt: exists already"));
    QVERIFY(!QFileInfo::exists(out("b_rgb.bsdf")));
  }

  void whatATargetCannotDoIsAnError() {
    for (const QStringList& options :
         {QStringList{"--scene"}, QStringList{"--theta-count", "8", "--size", "8"}, QStringList{"--blender", "4"}}) {
      const ToolResult result = runTool(QStringList{"export", plastic_, out("c"), "--for", "gltf"} + options);
      QVERIFY(result.code != 0 && result.error.contains(options[0]));
      QVERIFY(!QFileInfo::exists(out("c.gltf")));
    }
    const ToolResult unknown = runTool({"export", plastic_, out("c"), "--for", "paint"});
    QVERIFY(unknown.code != 0 && unknown.error.contains("--for"));
    for (const char* version : {"2.8", "5", "43", "x"}) {
      const ToolResult other = runTool({"export", plastic_, out("c"), "--for", "blender", "--blender", version});
      QVERIFY(other.code == 2 && other.error.contains("expected 3 or 4"));
    }
  }

  /// The script says for which series of Blender its values are.
  void theSeriesOfBlenderIsChosen() {
    for (const auto& [version, series] :
         {std::pair("", "Blender 4"), std::pair("4.3", "Blender 4"), std::pair("3.4", "Blender 3")}) {
      QStringList arguments{"export", plastic_, out("series"), "--for", "principled", "--samples", "8", "--force"};
      if (*version) arguments << "--blender" << version;
      const ToolResult result = runTool(arguments);
      VERIFY_SUCCESS(result);
      QFile script(out("series_principled.py"));
      QVERIFY(script.open(QIODevice::ReadOnly));
      QVERIFY(script.readAll().contains(QByteArray("For ") + series));
    }
  }

  /// Whichever command writes an edited material: the same bytes, and the same accuracy.
  void everyCommandWritesTheSameBytes() {
    const QString document = out("rough.gonio");
    VERIFY_SUCCESS(
        runTool({"edit", "library:rgl/satin_purple", "--model", "ggx", "--control", "roughness=2", "--out", document}));
    const ToolResult converted = runJson({"convert", document, out("d1.bsdf")});
    const ToolResult replayed = runJson({"edit", document, "--out", out("d2.BSDF")});
    const ToolResult exported = runJson({"export", document, out("d3"), "--for", "mitsuba"});
    const ToolResult forPbrt = runJson({"export", document, out("d4"), "--for", "pbrt"});
    const QByteArray bytes = bytesOf(out("d1.bsdf"));
    QVERIFY(!bytes.isEmpty());
    for (const char* name : {"d2.BSDF", "d3_rgb.bsdf", "d4_rgb.bsdf"}) QVERIFY2(bytesOf(out(name)) == bytes, name);
    QVERIFY(bytesOf(out("d3_spec.bsdf")) == bytesOf(out("d4_spec.bsdf")));
    for (const ToolResult& result : {converted, replayed, exported}) {
      QVERIFY(result.json["snr"].get<double>() >= 40 && result.json["losses"].size() == 1);
      QVERIFY(result.json["snr"] == converted.json["snr"] && result.json["brdfSnr"] == converted.json["brdfSnr"]);
    }
  }

  void everyTargetIsDocumented() {
    const std::string text = completePage("exports").toStdString();
    for (const exports::ExportTarget& target : exports::exportTargets()) {
      const std::size_t row = text.find("\n| `" + std::string(target.id) + "` |");
      QVERIFY2(row != std::string::npos, target.id.data());
      QVERIFY2(text.find(target.purpose, row) < text.find('\n', row + 1), target.id.data());
      std::vector<std::string_view> suffixes = target.suffixes;
      if (target.scene) suffixes.insert(suffixes.end(), {target.scene->textSuffix, target.scene->environmentSuffix});
      for (const std::string_view suffix : suffixes)
        QVERIFY2(text.find("NAME" + std::string(suffix)) != std::string::npos || target.id == "pbrt", suffix.data());
    }
  }

  /// Last of all tests.
  void zEveryKeyIsDocumented() {
    QVERIFY(seenKeys().size() > 10);
    QCOMPARE(undocumentedKeys(), QString());
  }

 private:
  QString out(const char* name) const { return folder_.path(name); }
  TestFolder folder_{"goniotool-export"};
  QString plastic_;
};

GONIO_TEST(GoniotoolExportTest)
}  // namespace goniotool_export_test

#include "goniotool_export_test.moc"
