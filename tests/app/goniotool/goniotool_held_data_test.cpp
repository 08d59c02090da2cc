// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QDir>
#include <QFile>
#include <QTest>
#include <cmath>

#include "core/models/model.h"
#include "core/models/parameters_json.h"
#include "tests/app/goniotool/goniotool_runner.h"
#include "tests/support/test_program.h"

namespace goniotool_held_data_test {
using namespace gonio;
using gonio::test::runJson;
using gonio::test::runTool;
using gonio::test::ToolResult;

const QString shared = GONIO_SHARED_DIR;
QString folder() { return QString(GONIO_TEST_OUTPUT_DIR) + "/goniotool-held/"; }

/// Near-measured copies as MERL files, written into the test's folder.
bool makeMerl(const QString& database, const QStringList& materials) {
  return QProcess::execute(shared + "/tools/make-merl", QStringList{folder(), database} + materials) == 0;
}

/// The command line on real measurements (RGL) and on near-measured copies of MERL materials.
class GoniotoolHeldDataTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    if (!QFile::exists(shared + "/tools/make-merl")) QSKIP("the development data are absent");
    QVERIFY(QDir().mkpath(folder()));
    QVERIFY(makeMerl("merl", {"chrome", "gold-metallic-paint", "green-plastic", "white-fabric"}));
    QVERIFY(makeMerl("rgl", {"vch_golden_yellow"}));
  }
  void cleanupTestCase() { QDir(folder()).removeRecursively(); }

  void rglConvertsToMerl() {
    const QString out = folder() + "a.binary";
    const ToolResult converted = runJson({"convert", shared + "/data/rgl/vch_golden_yellow_rgb.bsdf", out});
    QVERIFY2(converted.code == 0, qPrintable(converted.error));
    QCOMPARE(converted.json["from"].get<std::string>(), "RGL");
    const ToolResult info = runJson({"info", out});
    QCOMPARE(info.code, 0);
    QVERIFY(info.json["grid"] == nlohmann::json({90, 90, 180}));
    // A golden yellow: red over green over blue, and never more light than came in.
    const nlohmann::json albedo = info.json["albedo"]["30"];
    QVERIFY(albedo[0] > albedo[1] && albedo[1] > albedo[2] && albedo[0] < 1);
  }

  /// The neural copy rounds the highlight: similar, not equal (29.3 and 17.3 dB).
  void measuredAndNearMeasuredAgree() {
    const ToolResult result = runJson({"compare", shared + "/data/rgl/vch_golden_yellow_rgb.bsdf",
                                       folder() + "vch_golden_yellow.binary", "--size", "96", "--samples", "64"});
    QVERIFY2(result.code == 0, qPrintable(result.error));
    const double snr = result.json["renderedSnr"].get<double>(), brdfSnr = result.json["brdfSnr"].get<double>();
    QVERIFY2(std::abs(snr - 29.3) < 1, qPrintable(QString::number(snr)));
    QVERIFY2(std::abs(brdfSnr - 17.3) < 1, qPrintable(QString::number(brdfSnr)));
  }

  void fitsStayInsideTheirRanges_data() {
    QTest::addColumn<QString>("file");
    for (const char* name : {"chrome", "gold-metallic-paint", "green-plastic", "white-fabric"})
      QTest::newRow(name) << folder() + name + ".binary";
    for (const char* name : {"vch_golden_yellow_rgb", "paper_blue_rgb", "satin_purple_rgb"})
      QTest::newRow(name) << shared + "/data/rgl/" + name + ".bsdf";
  }
  void fitsStayInsideTheirRanges() {
    QFETCH(QString, file);
    const ToolResult matte = runJson({"fit", file, "--model", "lambert"});
    const ToolResult result = runJson({"fit", file, "--model", "ggx"});
    QVERIFY2(result.code == 0, qPrintable(result.error));
    const models::ModelSpec& spec = models::findModel("ggx").spec();
    models::ParameterValues values = models::parametersFromJson(spec, result.json["parameters"], "parameters");
    QVERIFY(models::clampToHardRange(spec, values).empty());
    const double error = result.json["errors"]["log"].get<double>();
    QVERIFY(error > 0 && error < matte.json["errors"]["log"].get<double>());
    qInfo("%s", result.json.dump().c_str());
  }
};

GONIO_TEST(GoniotoolHeldDataTest)
}  // namespace goniotool_held_data_test

#include "goniotool_held_data_test.moc"
