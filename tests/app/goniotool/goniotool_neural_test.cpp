// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>

#include "core/baselines/neural_fit.h"
#include "core/formats/neural.h"
#include "core/materials/bundled_library.h"
#include "core/metrics/brdf_metrics.h"
#include "tests/app/goniotool/goniotool_runner.h"
#include "tests/support/test_program.h"

namespace goniotool_neural_test {
using namespace gonio;
using namespace gonio::test;

/// goniotool train-neural, and its files as materials.
class GoniotoolNeuralTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { plastic_ = folder_.writeTable("plastic.binary", "ggx", plastic); }

  void trainedNetworkIsThatOfTheLibrary() {
    const QString out = folder_.path("plastic.nbrdf");
    const ToolResult result = runJson({"train-neural", plastic_, "--steps", "200", "--samples", "1", "--out", out});
    VERIFY_SUCCESS(result);
    const auto table = readTable(plastic_);
    const baselines::NeuralFit fit = baselines::fitNeural(*table, {.steps = 200});
    QVERIFY(std::ranges::equal(formats::readNeural(std::filesystem::path(out.toStdString())).weights(), fit.weights));
    QVERIFY(result.json["losses"] == nlohmann::json(fit.losses));
    QCOMPARE(result.json["weights"].get<int>(), 675);
    QCOMPARE(qint64(result.json["bytes"].get<std::int64_t>()), bytesOf(out).size());
    const double snr = metrics::brdfSignalToNoiseRatio(*table, NeuralBrdf(fit.weights));
    QVERIFY(std::abs(result.json["brdfSnr"].get<double>() - snr) < 0.01);

    const QString table2 = folder_.path("decoded.binary");
    VERIFY_SUCCESS(runJson({"convert", out, table2}));
    QVERIFY(metrics::brdfErrors(*readTable(table2), NeuralBrdf(fit.weights))[0] < 1e-4);
    const ToolResult info = runJson({"info", out});
    VERIFY_SUCCESS(info);
    QCOMPARE(info.json["format"].get<std::string>(), std::string("neural BRDF"));
  }

  /// Weights as they were published, rows of 675 numbers.
  void publishedWeights() {
    const auto& copies = materials::nearMeasuredMaterials();
    QByteArray rows;
    for (std::size_t i = 0; i < 2; ++i)
      rows.append(reinterpret_cast<const char*>(copies[i].weights.data()), qsizetype(copies[i].weights.size_bytes()));
    folder_.writeText("published.f32", rows);
    const QString out = folder_.path("second.nbrdf"), weights = folder_.path("published.f32");
    const QStringList start{"train-neural", plastic_, "--samples", "1", "--weights", weights};
    VERIFY_SUCCESS(runJson(start + QStringList{"--row", "1", "--out", out}));
    QVERIFY(
        std::ranges::equal(formats::readNeural(std::filesystem::path(out.toStdString())).weights(), copies[1].weights));
    const ToolResult beyond = runTool(start + QStringList{"--row", "2"});
    QCOMPARE(beyond.code, 1);
    QVERIFY(beyond.error.contains("published.f32") && beyond.error.contains("up to row 2"));
  }

  void wrongUsage() {
    QCOMPARE(runTool({"train-neural", plastic_, "--steps", "0"}).code, 2);
    QCOMPARE(runTool({"train-neural", plastic_, "--row", "1"}).code, 2);
    QCOMPARE(runTool({"train-neural", plastic_, "--steps", "1", "--out", folder_.path("x.png")}).code, 1);
  }

  void zEveryKeyIsDocumented() { QCOMPARE(undocumentedKeys(), QString()); }

 private:
  TestFolder folder_{"goniotool-neural"};
  QString plastic_;
};

GONIO_TEST(GoniotoolNeuralTest)
}  // namespace goniotool_neural_test

#include "goniotool_neural_test.moc"
