// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/io/image_io.h"
#include "core/metrics/brdf_metrics.h"
#include "core/photograph/photograph.h"
#include "tests/app/goniotool/goniotool_runner.h"
#include "tests/support/test_program.h"

namespace goniotool_photograph_test {
using namespace gonio;
using namespace gonio::test;

constexpr HalfDifferenceGrid trainingGrid{45, 15, 18, true};

/// With ' in place of ".
QByteArray quoted(QByteArray text) { return text.replace('\'', '"'); }

/// goniotool photograph: images are simulated, a material comes back from them, and the next one is planned.
class GoniotoolPhotographTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    QDir().mkpath(folder_.path("train"));
    for (int i = 0; i < 6; ++i)
      folder_.writeTable(
          QString("train/train%1.binary").arg(i), "ggx",
          {{Rgb(0.1 + 0.08 * i, 0.3, 0.5 - 0.08 * i), Rgb(0.9 - 0.1 * i), Rgb(0.15 + 0.1 * i), Rgb(0.04 + 0.03 * i)}},
          trainingGrid);
    folder_.writeText("sphere.json", description("studio.exr", quoted("{'environment': 'studio', 'rotation': 0}")));
    simulated_ = runJson({"photograph", "simulate", folder_.path("sphere.json"), folder_.path("train/train2.binary"),
                          "--samples", "64", "--noise", "0.01"});
    VERIFY_SUCCESS(simulated_);
  }

  void simulates() {
    const QString file = folder_.path("studio.exr");
    QCOMPARE(QString::fromStdString(simulated_.json["files"][0]), file);
    const Image image = io::readImage(file.toStdString());
    QCOMPARE(image.width, 48);
    QVERIFY(image.at(24, 24).x > 0);
    const QStringList again{"photograph", "simulate", folder_.path("sphere.json"), folder_.path("train/train2.binary")};
    const ToolResult refused = runTool(again);
    QVERIFY(refused.code == 1 && refused.error.contains("--force"));
  }

  void fits() {
    const QString out = folder_.path("found.binary"), uncertainty = folder_.path("deviation.binary");
    const ToolResult found = runJson(fitting("sphere.json") + QStringList{"--out", out, "--uncertainty", uncertainty});
    VERIFY_SUCCESS(found);
    QCOMPARE(found.json["exposure"].get<double>(), 1.0);
    QVERIFY2(found.json["images"][0]["residualSnr"].get<double>() > 20, qPrintable(found.out));
    QVERIFY(found.json["regions"].get<int>() <= 200);
    const auto material = readTable(folder_.path("train/train2.binary"));
    const double error = metrics::brdfErrors(*material, *readTable(out))[0];
    for (const int other : {0, 1, 3, 4}) {
      const auto table = readTable(folder_.path(QString("train/train%1.binary").arg(other)));
      QVERIFY(error < metrics::brdfErrors(*material, *table)[0]);
    }
    QCOMPARE(readTable(uncertainty)->validCount(), readTable(out)->validCount());
    const ToolResult text = runTool(fitting("sphere.json") + QStringList{"--out", out});
    VERIFY_SUCCESS(text);
    QVERIFY2(text.out.contains("studio.exr: sphere at 24, 24"), qPrintable(text.out));
  }

  /// A cylinder is simulated, planned and fitted like a sphere, without an outline.
  void otherShapes() {
    const QByteArray shape = quoted(", 'shape': {'cylinder': {'axis': [0, 1, 0], 'length': 1.8}}");
    folder_.writeText("cylinder.json", description("cylinder.exr", quoted("{'environment': 'studio'}"), shape));
    const QString file = folder_.path("cylinder.json"), out = folder_.path("cylinder.binary");
    VERIFY_SUCCESS(runTool({"photograph", "simulate", file, folder_.path("train/train2.binary")}));
    const ToolResult found = runJson(fitting("cylinder.json") + QStringList{"--out", out});
    VERIFY_SUCCESS(found);
    const auto& image = found.json["images"][0];
    QCOMPARE(image["shape"].get<std::string>(), std::string("cylinder"));
    QVERIFY(!image.contains("sphere"));
    QVERIFY2(image["residualSnr"].get<double>() > 20, qPrintable(found.out));
    for (const auto& check : found.json["checks"])
      QVERIFY(!check["property"].get<std::string>().starts_with("outline"));
    const ToolResult text = runTool(fitting("cylinder.json") + QStringList{"--out", out});
    VERIFY_SUCCESS(text);
    QVERIFY2(text.out.contains("cylinder.exr: cylinder; residual"), qPrintable(text.out));
    const ToolResult planned = runJson({"photograph", "plan", file, "--train", folder_.path("train"), "--rotations",
                                        "2", "--cameras", "2", "--materials", "2"});
    VERIFY_SUCCESS(planned);
    QVERIFY(planned.json["images"][1]["deviation"].get<double>() <
            planned.json["images"][0]["deviation"].get<double>());
  }

  /// The planned description has one image more; it can be simulated and fitted.
  void plans() {
    const QString next = folder_.path("next.json");
    QStringList command{"photograph",
                        "plan",
                        folder_.path("sphere.json"),
                        "--train",
                        folder_.path("train"),
                        "--rotations",
                        "4",
                        "--lights",
                        "3",
                        "--cameras",
                        "2",
                        "--materials",
                        "4",
                        "--out",
                        next};
    const ToolResult planned = runJson(command);
    VERIFY_SUCCESS(planned);
    const auto& images = planned.json["images"];
    QCOMPARE(images.size(), std::size_t(2));
    QCOMPARE(planned.json["candidates"].size(), std::size_t(9));
    const double before = planned.json["before"]["deviation"], one = images[0]["deviation"],
                 two = images[1]["deviation"];
    QVERIFY(before > one && one > two);
    QVERIFY(!images[0]["chosen"].get<bool>() && images[1]["chosen"].get<bool>());
    for (const auto& candidate : planned.json["candidates"]) QVERIFY(candidate["deviation"].get<double>() >= two);
    const auto description = photograph::readDescription(next.toStdString(), false);
    QCOMPARE(description.set.photographs.size(), std::size_t(2));
    QCOMPARE(description.set.photographs[1].name, images[1]["file"].get<std::string>());
    VERIFY_SUCCESS(
        runTool({"photograph", "simulate", next, folder_.path("train/train2.binary"), "--samples", "16", "--force"}));
    const ToolResult found = runJson(fitting("next.json") + QStringList{"--out", folder_.path("two.binary")});
    VERIFY_SUCCESS(found);
    QCOMPARE(found.json["images"].size(), std::size_t(2));
    const ToolResult text = runTool(command.mid(0, command.size() - 2));
    VERIFY_SUCCESS(text);
    QVERIFY2(text.out.contains("+ " + QString::fromStdString(images[1]["file"])), qPrintable(text.out));
  }

  /// The stored values of a PNG image with a stated gamma are those of the linear image.
  void encodedImages() {
    const Image linear = io::readImage(folder_.path("studio.exr").toStdString());
    std::vector<unsigned char> rgba;
    for (const glm::vec3& pixel : linear.pixels) {
      for (int c = 0; c < 3; ++c)
        rgba.push_back(static_cast<unsigned char>(255 * std::pow(std::clamp(pixel[c], 0.0f, 1.0f), 1 / 2.2f) + 0.5f));
      rgba.push_back(255);
    }
    io::writePng(rgba, linear.width, linear.height, folder_.path("studio.png").toStdString());
    const QByteArray light = quoted("{'environment': 'studio', 'rotation': 0}");
    folder_.writeText("encoded.json", description("studio.png", light, quoted(", 'gamma': 2.2")));
    const QString out = folder_.path("encoded.binary");
    const ToolResult found = runJson(fitting("encoded.json") + QStringList{"--out", out});
    VERIFY_SUCCESS(found);
    QVERIFY2(found.json["warnings"].dump().find("gamma of 2.2") != std::string::npos, qPrintable(found.out));
    folder_.writeText("unstated.json", description("studio.png", light));
    const ToolResult refused = runTool(fitting("unstated.json") + QStringList{"--out", out});
    QVERIFY(refused.code == 1 && refused.error.contains("not linear") && refused.error.contains("gamma"));
  }

  void wrongInput_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("message");
    const QByteArray studio = quoted("{'environment': 'studio'}");
    QTest::newRow("no JSON") << QByteArray("{") << "JSON";
    QTest::newRow("another format") << quoted("{'format': 'x'}") << "gonio photographs";
    QTest::newRow("no such image") << description("missing.exr", studio) << "missing.exr";
    QTest::newRow("no such environment") << description("studio.exr", quoted("{'environment': 'moon'}")) << "moon";
    QTest::newRow("misspelt member") << description("studio.exr", studio, quoted(", 'shpere': 1")) << "shpere";
    QTest::newRow("shape and outline") << description("studio.exr", studio,
                                                      quoted(", 'shape': {'flat': {'normal': [0, 0, 1], 'radius': 1}}, "
                                                             "'sphere': 'find'"))
                                       << "images[0].sphere";
    QTest::newRow("gamma of a linear image") << description("studio.exr", studio, quoted(", 'gamma': 2.2")) << "gamma";
    QTest::newRow("grey patch outside") << description("studio.exr", studio,
                                                       quoted(", 'greyPatch': {'x': 90, 'y': 0, 'width': 4, 'height': "
                                                              "4, 'normal': [0, 0, 1], 'reflectance': 0.5}"))
                                        << "grey patch";
  }
  /// One line that names the file, or the member and what is expected.
  void wrongInput() {
    QFETCH(QByteArray, text);
    QFETCH(QString, message);
    folder_.writeText("wrong.json", text);
    const QString out = folder_.path("never.binary");
    const ToolResult result = runTool(fitting("wrong.json") + QStringList{"--out", out});
    QCOMPARE(result.code, 1);
    QCOMPARE(result.errorLines(), 1);
    QVERIFY2(result.error.contains("wrong.json") && result.error.contains(message), qPrintable(result.error));
    QVERIFY(!QFile::exists(out));
  }

  void wrongUse() {
    const QString sphere = folder_.path("sphere.json"), out = folder_.path("never.binary");
    const QString train = folder_.path("train");
    for (const QStringList& wrong :
         {QStringList{"fit", sphere}, QStringList{"fit", sphere, "--out", out, "--train", train, "--basis", out},
          QStringList{"plan", sphere, "--train", train},
          QStringList{"plan", sphere, "--rotations", "2", "--out", "/elsewhere/next.json"},
          QStringList{"plan", sphere, "--rotations", "100"}, QStringList{"simulate", sphere}})
      QVERIFY2(runTool(QStringList{"photograph"} + wrong).code == 2, qPrintable(wrong.join(' ')));
    const ToolResult suffix = runTool(fitting("sphere.json") + QStringList{"--out", folder_.path("never.exr")});
    QVERIFY(suffix.code != 0 && suffix.error.contains("never.exr"));
  }

  void zEveryKeyIsDocumented() { QCOMPARE(undocumentedKeys(), QString()); }

 private:
  static QByteArray description(const QByteArray& file, const QByteArray& light, const QByteArray& members = {}) {
    return quoted("{'format': 'gonio photographs', 'version': 1, 'images': [{'file': '") + file +
           quoted("', 'camera': {'position': [0, 0, 4]}, 'width': 48, 'height': 48, 'lights': [") + light + "]" +
           members + "}]}";
  }
  QStringList fitting(const QString& file) const {
    return {"photograph", "fit", folder_.path(file), "--train", folder_.path("train"), "--regions", "200", "--force"};
  }

  TestFolder folder_{"goniotool-photograph"};
  ToolResult simulated_;
};

GONIO_TEST(GoniotoolPhotographTest)
}  // namespace goniotool_photograph_test

#include "goniotool_photograph_test.moc"
