// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/dictionary/decode.h"
#include "core/formats/code.h"
#include "core/metrics/brdf_metrics.h"
#include "tests/app/goniotool/interruption.h"
#include "tests/support/test_program.h"

namespace goniotool_dictionary_test {
using namespace gonio;
using namespace gonio::test;

/// goniotool dictionary, encode and decode, and codes as materials.
class GoniotoolDictionaryTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    const models::ParameterValues rough{{Rgb(0.1), Rgb(0.5), Rgb(0.5), Rgb(0.6), Rgb(0)}};
    plastic_ = folder_.writeTable("plastic.binary", "ggx", plastic);
    rough_ = folder_.writeTable("rough.binary", "ggx", rough);
    merl_ = folder_.writeTable("merl.binary", "ggx", rough, HalfDifferenceGrid());
  }

  /// Over a grid of its own. What it learned from, it encodes well; a checkpoint is left, and is of that training
  /// alone.
  void learnsAndEncodes() {
    const QString out = folder_.path("two.dictionary"), checkpoint = folder_.path("two.checkpoint");
    const QStringList options{"--dictionaries",  "1",     "--sparsities", "40", "--iterations", "1",
                              "--subspace-loss", "0.001", "--out",        out};
    const ToolResult trained = runJson(QStringList{"dictionary", "train", plastic_, rough_} + options);
    VERIFY_SUCCESS(trained);
    QVERIFY(trained.json["complete"].get<bool>());
    QCOMPARE(trained.json["materials"].get<int>(), 2);
    QVERIFY(trained.json["orthonormality"].get<double>() < 1e-10);
    const auto& ensemble = trained.json["ensembles"][0];
    QVERIFY(ensemble["errors"].back() <= ensemble["errors"].front());
    QVERIFY(ensemble["errorAfterSweep"] <= ensemble["errorBeforeSweep"]);

    const ToolResult info = runJson({"dictionary", "info", out});
    VERIFY_SUCCESS(info);
    QVERIFY(info.json["learnedFrom"] == nlohmann::json({"plastic", "rough"}));
    QVERIFY(info.json["grid"] == nlohmann::json({30, 30, 36}));
    QVERIFY(info.json["sparsities"] == nlohmann::json({40}));

    const QString code = folder_.path("plastic.code"), decoded = folder_.path("decoded.binary");
    const ToolResult encoded =
        runJson({"encode", plastic_, "--dictionary", out, "--coefficients", "100", "--out", code});
    VERIFY_SUCCESS(encoded);
    QCOMPARE(qint64(encoded.json["bytes"].get<std::int64_t>()), bytesOf(code).size());
    QCOMPARE(encoded.json["candidates"].size(), std::size_t(2));
    VERIFY_SUCCESS(runJson({"decode", code, "--dictionary", out, "--out", decoded}));
    const double error = metrics::brdfErrors(*readTable(plastic_), *readTable(decoded))[0];
    QVERIFY(std::abs(encoded.json["errors"]["log"].get<double>() / error - 1) < 1e-3);
    QVERIFY2(error < 0.02, qPrintable(QString::number(error)));
    // Over the bundled dictionary it is nothing.
    const ToolResult foreign = runTool({"info", code});
    QCOMPARE(foreign.code, 1);
    QVERIFY(foreign.error.contains("plastic.code") && foreign.error.contains("another dictionary"));

    // Extended: the numbers of the learned dictionaries follow.
    const QString more = folder_.path("more.dictionary");
    VERIFY_SUCCESS(runJson({"dictionary", "train", rough_, "--extend", out, "--normalise", "--dictionaries", "2",
                            "--sparsities", "7", "--iterations", "1", "--subspace-loss", "0.001", "--out", more}));
    const ToolResult extended = runJson({"dictionary", "info", more});
    VERIFY_SUCCESS(extended);
    QVERIFY(extended.json["sparsities"] == nlohmann::json({40, 7, 7}));
    QVERIFY(extended.json["learnedFrom"] == nlohmann::json({"plastic", "rough"}));
  }

  /// Without the scale, of the dictionary or of the code alone; by basis pursuit; by principal components. Each file
  /// holds what is reported.
  void otherMethods() {
    const QString out = folder_.path("published.dictionary"), code = folder_.path("published.code"),
                  decoded = folder_.path("published.binary");
    const ToolResult trained =
        runJson({"dictionary", "train", plastic_, rough_, "--as-published", "--dictionaries", "1", "--sparsities", "40",
                 "--iterations", "1", "--subspace-loss", "0.001", "--out", out});
    VERIFY_SUCCESS(trained);
    QVERIFY(!trained.json["scaled"].get<bool>());
    QVERIFY(!runJson({"dictionary", "info", out}).json["scaled"].get<bool>());
    const auto encoded = [&](const QStringList& options) {
      const QStringList all =
          QStringList{"encode", plastic_, "--dictionary", out, "--coefficients", "100", "--out", code};
      const ToolResult result = runJson(all + options);
      if (runTool({"decode", code, "--dictionary", out, "--out", decoded}).code != 0) return -1.0;
      const double error = metrics::brdfErrors(*readTable(plastic_), *readTable(decoded))[0];
      const double reported = result.json["errors"]["log"].get<double>();
      return std::abs(reported / error - 1) < 1e-3 && !result.json["scaled"].get<bool>() ? error : -1.0;
    };
    for (const QStringList& options :
         {QStringList(), QStringList{"--as-published"}, QStringList{"--method", "basis-pursuit"}}) {
      const double error = encoded(options);
      QVERIFY2(error > 0 && error < 0.05, qPrintable(options.join(' ') + QString::number(error)));
    }
    // A code without the scale over the bundled dictionary is a material of every subcommand.
    VERIFY_SUCCESS(runJson({"encode", merl_, "--coefficients", "200", "--as-published", "--out", code}));
    const ToolResult info = runJson({"info", code});
    VERIFY_SUCCESS(info);
    QVERIFY(info.out.contains("sparse code"));

    QCOMPARE(runTool({"encode", plastic_, "--method", "components"}).code, 2);
    QCOMPARE(runTool({"encode", plastic_, "--method", "basis-pursuit", "--as-published"}).code, 2);
    QCOMPARE(runTool({"encode", plastic_, "--method", "lars"}).code, 2);
  }

  /// The training materials themselves are represented by the components that they have, and written as a table.
  void principalComponents() {
    const QString other = folder_.writeTable("other.binary", "ggx", plastic, HalfDifferenceGrid());
    const QString plan = folder_.path("few.csv"), basis = folder_.path("few.basis"),
                  decoded = folder_.path("components.binary");
    VERIFY_SUCCESS(runJson({"plan", "--train", other, merl_, "--samples", "2", "--out", plan}));
    const QStringList components{"encode", other, "--method", "components", "--basis", basis};
    const ToolResult two = runJson(components + QStringList{"--coefficients", "2", "--out", decoded});
    VERIFY_SUCCESS(two);
    QCOMPARE(two.json["method"].get<std::string>(), "components");
    QCOMPARE(two.json["coefficients"].get<int>(), 2);
    const double error = metrics::brdfErrors(*readTable(other), *readTable(decoded))[0];
    QVERIFY(std::abs(two.json["errors"]["log"].get<double>() / error - 1) < 1e-3);
    const ToolResult one = runJson(components + QStringList{"--coefficients", "1"});
    VERIFY_SUCCESS(one);
    QVERIFY(two.json["errors"]["log"] < one.json["errors"]["log"]);
    QCOMPARE(runTool(components + QStringList{"--coefficients", "262"}).code, 1);
    QCOMPARE(runTool(components + QStringList{"--coefficients", "2", "--single"}).code, 2);
  }

  /// Codes of patches over a dictionary that K-SVD learned from the material itself; the printed errors are those of
  /// the file.
  void codesOfPatches() {
    const models::ParameterValues rough{{Rgb(0.1), Rgb(0.5), Rgb(0.5), Rgb(0.6), Rgb(0)}};
    const HalfDifferenceGrid grid{.thetaHCount = 36, .thetaDCount = 36, .phiDCount = 36};  // a multiple of the patches
    const QString blocks = folder_.writeTable("blocks.binary", "ggx", rough, grid);
    const QString decoded = folder_.path("patches.binary");
    const ToolResult result =
        runJson({"encode", blocks, "--method", "k-svd", "--train", blocks, "--coefficients", "400", "--out", decoded});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["method"].get<std::string>(), "k-svd");
    QCOMPARE(result.json["materials"].get<int>(), 1);
    QVERIFY(result.json["coefficients"].get<int>() <= 400 && result.json["bytes"].get<int>() > 0);
    const double error = metrics::brdfErrors(*readTable(blocks), *readTable(decoded))[0];
    QVERIFY(error > 0 && std::abs(result.json["errors"]["log"].get<double>() / error - 1) < 1e-3);
    QCOMPARE(runTool({"encode", blocks, "--method", "k-svd", "--train", plastic_, "--bytes", "100"}).code, 2);
    QCOMPARE(runTool({"encode", blocks, "--train", blocks}).code, 2);
    QCOMPARE(runTool({"encode", blocks, "--method", "k-svd", "--train", folder_.path("absent.binary")}).code, 1);
  }

  void wrongTrainingsAreTold() {
    const QString out = folder_.path("none.dictionary");
    const ToolResult none = runTool({"dictionary", "train", plastic_, "--exclude", "plastic", "--out", out});
    QCOMPARE(none.code, 1);
    QVERIFY(none.error.contains("no material is left"));
    const ToolResult misspelt = runTool({"dictionary", "train", plastic_, "--exclude", "plastik", "--out", out});
    QCOMPARE(misspelt.code, 1);
    QVERIFY(misspelt.error.contains("plastik"));
    const ToolResult mixed = runTool({"dictionary", "train", plastic_, merl_, "--out", out});
    QCOMPARE(mixed.code, 1);
    QVERIFY2(mixed.error.contains("merl.binary: found a table of 90 x 90 x 180 cells, expected 30 x 30 x 36"),
             qPrintable(mixed.error));
    QCOMPARE(runTool({"encode", plastic_, "--bytes", "900", "--single"}).code, 2);
    QVERIFY(!QFile::exists(out));
    QCOMPARE(runTool({"dictionary", "info", plastic_}).code, 1);
    QCOMPARE(runTool({"dictionary", "train", plastic_}).code, 2);
  }

  /// Over the bundled dictionary: budgets, precisions, a target, and the code as a material of every subcommand.
  void bundledEnsemble() {
    const QString code = folder_.path("bundled.code"), single = folder_.path("single.code");
    const ToolResult half = runJson({"encode", merl_, "--bytes", "900", "--out", code});
    VERIFY_SUCCESS(half);
    QVERIFY(bytesOf(code).size() <= 900 && bytesOf(code).size() > 700);
    VERIFY_SUCCESS(
        runJson({"encode", merl_, "--coefficients", "60", "--single", "--transform", "log-plus", "--out", single}));
    QVERIFY(formats::readCode(single.toStdString()).precision == dictionary::CodePrecision::single);
    const ToolResult info = runJson({"info", single});
    VERIFY_SUCCESS(info);
    QCOMPARE(QString::fromStdString(info.json["format"]), QString("sparse code"));
    const ToolResult compared = runJson({"compare", merl_, code, "--size", "16", "--samples", "4"});
    VERIFY_SUCCESS(compared);
    QVERIFY(std::abs(compared.json["brdfSnr"].get<double>() - half.json["brdfSnr"].get<double>()) < 0.01);
    // In one transform: the search through both is that of picture_encoding.
    const ToolResult target =
        runJson({"encode", merl_, "--coefficients", "12", "--rendered-snr", "15", "--transform", "log-plus"});
    VERIFY_SUCCESS(target);
    QVERIFY2(target.json["renderedSnr"].get<double>() >= 15 || target.json["coefficients"].get<int>() == 12,
             qPrintable(target.out));
  }

  void anInterruptedTrainingWritesNothing_data() {
    QTest::addColumn<QString>("progress");
    QTest::newRow("before there are dictionaries") << "learning from";
    // The first dictionaries are learned, for minutes.
    QTest::newRow("while dictionaries are learned") << " 15 %";
  }
  /// With --only-complete.
  void anInterruptedTrainingWritesNothing() {
    QFETCH(QString, progress);
    const QString out = folder_.path("never.dictionary");
    const Interruption run = interrupt({"dictionary", "train", merl_, "--subspace-loss", "1e-9", "--tolerance", "0",
                                        "--iterations", "10000", "--only-complete", "--progress", "--out", out},
                                       SIGINT, progress);
    QCOMPARE(run.endedBySignal, SIGINT);
    QVERIFY2(run.error.contains("never.dictionary: not written"), qPrintable(run.error));
    QVERIFY(!QFile::exists(out));
  }

  void zEveryKeyIsDocumented() { QCOMPARE(undocumentedKeys(), QString()); }

 private:
  TestFolder folder_{"goniotool-dictionary"};
  QString plastic_, rough_, merl_;
};

GONIO_TEST(GoniotoolDictionaryTest)
}  // namespace goniotool_dictionary_test

#include "goniotool_dictionary_test.moc"
