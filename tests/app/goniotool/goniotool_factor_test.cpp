// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/baselines/baselines.h"
#include "core/factorization/pdv_operations.h"
#include "core/formats/pdv.h"
#include "core/metrics/brdf_metrics.h"
#include "tests/app/goniotool/goniotool_runner.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace goniotool_factor_test {
using namespace gonio;
using namespace gonio::baselines;
using namespace gonio::test;
using namespace gonio::factorization;

/// goniotool factor, and files of factors as materials.
class GoniotoolFactorTest : public QObject {
  Q_OBJECT
 private:
  PdvFactors readFactors(const char* name) const { return formats::readPdv(folder_.path(name).toStdString()); }

 private Q_SLOTS:
  void initTestCase() {
    plastic_ = folder_.writeTable("plastic.binary", "ggx", plastic);
    rough_ = folder_.writeTable("rough.binary", "ggx", {{Rgb(0.1), Rgb(0.5), Rgb(0.5), Rgb(0.6), Rgb(0)}});
  }

  void factorsAndTheirErrors() {
    const QString out = folder_.path("plastic.pdv"), decoded = folder_.path("decoded.binary");
    const ToolResult result = runJson({"factor", plastic_, "--terms", "3", "--out", out, "--decode", decoded});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["terms"].get<int>(), 3);
    QCOMPARE(qint64(result.json["bytes"].get<std::int64_t>()), bytesOf(out).size());
    QCOMPARE(result.json["residuals"].size(), std::size_t(3));
    for (std::size_t l = 1; l < 3; ++l)
      QVERIFY(result.json["residuals"][l].get<double>() < result.json["residuals"][l - 1].get<double>());
    QVERIFY(result.json["seconds"].get<double>() > 0 && result.json["evaluationNs"].get<double>() > 0);
    const PdvFactors factors = readFactors("plastic.pdv");
    QCOMPARE(factors.terms(), 3);
    QVERIFY(result.json["grid"] == nlohmann::json({factors.thetaNodes.size(), 90, factors.phiNodes.size()}));
    // The errors are those of the factors in double: the file's single precision hardly shows.
    const double error = metrics::brdfErrors(*readTable(plastic_), *makePdvBrdf(factors))[0];
    QVERIFY(std::abs(result.json["errors"]["log"].get<double>() / error - 1) < 1e-3);
    QVERIFY(error < 0.05);
    const double snr = metrics::brdfSignalToNoiseRatio(*readTable(plastic_), *makePdvBrdf(factors));
    QVERIFY2(std::abs(result.json["brdfSnr"].get<double>() - snr) < 0.01, qPrintable(result.out));
    // What was decoded is the model, as a reciprocal table can hold it.
    QVERIFY(metrics::brdfErrors(*readTable(decoded), test::meanOfBothOrders(makePdvBrdf(factors)))[0] < 1e-4);
  }

  void factorFilesAreMaterials() {
    const QString out = folder_.path("material.pdv"), decoded = folder_.path("decoded.binary");
    VERIFY_SUCCESS(runJson({"factor", plastic_, "--samples", "1", "--terms", "1", "--form", "2d", "--out", out}));
    const ToolResult info = runJson({"info", out});
    VERIFY_SUCCESS(info);
    QCOMPARE(info.json["format"].get<std::string>(), "PDV factors");
    QVERIFY(info.json["grid"] == nlohmann::json({90, 90, 1}));
    QVERIFY(info.json["description"].get<std::string>() == "1 term of two factors, transform log-plus");
    VERIFY_SUCCESS(runJson({"convert", out, decoded}));
    const test::FunctionBrdf held = test::meanOfBothOrders(makePdvBrdf(readFactors("material.pdv")));
    QVERIFY(metrics::brdfErrors(*readTable(decoded), held)[0] < 1e-4);
    const ToolResult compared = runJson({"compare", plastic_, out, "--size", "16", "--samples", "4"});
    VERIFY_SUCCESS(compared);
    const double snr = metrics::brdfSignalToNoiseRatio(*readTable(plastic_), *makePdvBrdf(readFactors("material.pdv")));
    QVERIFY2(std::abs(compared.json["brdfSnr"].get<double>() - snr) < 0.01, qPrintable(compared.out));
    folder_.writeText("short.pdv", bytesOf(out).left(500));
    const ToolResult broken = runTool({"info", folder_.path("short.pdv")});
    QCOMPARE(broken.code, 1);
    QVERIFY(broken.error.contains("short.pdv") && broken.error.contains("the size of the file is 500 bytes"));
  }

  /// --as-published gives the same bytes as its separate options, and the values of the library.
  void asPublished() {
    const QString whole = folder_.path("published.pdv"), parts = folder_.path("parts.pdv");
    const QStringList start{"factor", plastic_, "--samples", "1", "--terms", "2", "--form", "2d"};
    const ToolResult result = runJson(start + QStringList{"--as-published", "--out", whole});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["weights"].get<std::string>(), "equal");
    QCOMPARE(result.json["deviations"].get<std::string>(), "library");
    const ToolResult ours =
        runJson(start + QStringList{"--weights", "equal", "--deviations", "library", "--out", parts});
    VERIFY_SUCCESS(ours);
    QVERIFY(bytesOf(whole) == bytesOf(parts));
    QVERIFY(result.json["residuals"] == ours.json["residuals"] && result.json["weights"] == ours.json["weights"]);
    const auto library = factorizePdv(*readTable(plastic_), publishedPdvOptions(PdvForm::twoFactors, 2));
    QVERIFY(result.json["residuals"] == nlohmann::json({library.residuals[1], library.residuals[2]}));
    const ToolResult plain = runJson(start);
    VERIFY_SUCCESS(plain);
    QCOMPARE(plain.json["weights"].get<std::string>(), "projected-solid-angle");
    QCOMPARE(plain.json["deviations"].get<std::string>(), "material");
    QVERIFY(plain.json["residuals"] != result.json["residuals"]);
  }

  /// --joint writes the factors of the library, of the same size with a lower residual.
  void jointTerms() {
    const QString out = folder_.path("joint.pdv");
    const QStringList start{"factor", plastic_, "--samples", "1", "--terms", "2"};
    const ToolResult result = runJson(start + QStringList{"--joint", "--out", out}), plain = runJson(start);
    VERIFY_SUCCESS(result);
    VERIFY_SUCCESS(plain);
    const auto library = factorizePdv(*readTable(plastic_), {.terms = 2, .joint = true});
    QVERIFY(result.json["residuals"] == nlohmann::json({library.residuals[1], library.residuals[2]}));
    QVERIFY(result.json["joint"].get<bool>() && !plain.json["joint"].get<bool>());
    QVERIFY(result.json["residuals"][0] == plain.json["residuals"][0]);
    QVERIFY(result.json["residuals"][1] < plain.json["residuals"][1]);
    QVERIFY(result.json["bytes"] == plain.json["bytes"]);
    QCOMPARE(runTool(start + QStringList{"--joint", "--swap-f1", rough_}).code, 2);
    QCOMPARE(runTool({"factor", out, "--joint"}).code, 2);
  }

  /// --compact writes the factors of the library over fewer nodes; swaps use the same nodes.
  void compactCurves() {
    const QString out = folder_.path("compact.pdv");
    const QStringList start{"factor", plastic_, "--samples", "1", "--terms", "2", "--compact"};
    const ToolResult result = runJson(start + QStringList{"--joint", "--out", out});
    VERIFY_SUCCESS(result);
    const auto library = factorizePdv(*readTable(plastic_), compactPdvOptions({.terms = 2, .joint = true}));
    QVERIFY(result.json["residuals"] == nlohmann::json({library.residuals[1], library.residuals[2]}));
    QVERIFY(result.json["grid"] == nlohmann::json({60, 90, 30}));
    QCOMPARE(result.json["bytes"].get<qint64>(), QFileInfo(out).size());
    const ToolResult swapped = runJson(start + QStringList{"--swap-f1", rough_});
    VERIFY_SUCCESS(swapped);
    QVERIFY(swapped.json["grid"] == nlohmann::json({60, 90, 30}));
    QCOMPARE(runTool(start + QStringList{"--as-published"}).code, 2);
    QCOMPARE(runTool({"factor", out, "--compact"}).code, 2);
  }

  /// Of a file of factors the factors are taken, not found again.
  void factorsOfFactors() {
    const QString all = folder_.path("all.pdv"), two = folder_.path("two.pdv");
    VERIFY_SUCCESS(
        runJson({"factor", plastic_, "--samples", "1", "--terms", "4", "--transform", "root", "--out", all}));
    const ToolResult result = runJson({"factor", all, "--samples", "1", "--terms", "2", "--out", two});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["transform"].get<std::string>(), "root");
    QCOMPARE(result.json["residuals"].size(), std::size_t(0));
    QVERIFY(readFactors("two.pdv") == readFactors("all.pdv").truncated(2));
  }

  /// Swapped on the material's own nodes; the terms behind the first are its own, so they go, or stay when asked for.
  void swaps() {
    const auto path = [&](const char* name) { return folder_.path(name); };
    const QStringList start{"factor", plastic_, "--samples", "1", "--terms", "3", "--out"};
    VERIFY_SUCCESS(runJson(start + QStringList{path("own.pdv")}));
    const PdvFactors own = readFactors("own.pdv");
    const ToolResult result = runJson(start + QStringList{path("swap.pdv"), "--swap-f2", rough_});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["terms"].get<int>(), 1);
    QCOMPARE(result.json["residuals"].size(), std::size_t(1));
    const PdvFactors swapped = readFactors("swap.pdv");
    const PdvFactors other =
        factorizePdv(*readTable(rough_), {.terms = 1, .deviationNodes = own.deviationNodes}).factors;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const PdvTerm &term = swapped.channels[channel][0], &before = own.channels[channel][0];
      QVERIFY(term.f1 == before.f1 && term.f3 == before.f3);
      // The last node is on the rim of the disk, where the file's single precision decides what counts.
      for (std::size_t j = 0; j + 1 < term.f2.size(); ++j)
        QVERIFY2(std::abs(term.f2[j] - other.channels[channel][0].f2[j]) < 1e-4,
                 qPrintable(QString("%1: %2 %3").arg(j).arg(term.f2[j]).arg(other.channels[channel][0].f2[j])));
    }
    // From a file of factors on nodes of its own, both curves at once, with the further terms kept.
    VERIFY_SUCCESS(runJson({"factor", rough_, "--samples", "1", "--terms", "1", "--out", path("rough.pdv")}));
    VERIFY_SUCCESS(runJson(start + QStringList{path("both.pdv"), "--swap-f1", path("rough.pdv"), "--swap-f2",
                                               path("rough.pdv"), "--keep-terms"}));
    const PdvFactors both = readFactors("both.pdv"), file = readFactors("rough.pdv");
    QCOMPARE(both.terms(), 3);
    QVERIFY(both.deviationNodes == own.deviationNodes);
    QVERIFY(both.channels[0][2] == own.channels[0][2]);
    for (std::size_t i = 0; i < both.thetaNodes.size(); ++i)
      QVERIFY(std::abs(both.channels[1][0].f1[i] - file.channels[1][0].f1[i]) < 1e-5);
    QVERIFY(both.channels[1][0].f2 != file.channels[1][0].f2 && both.channels[1][0].f2 != own.channels[1][0].f2);
  }

  /// Every baseline reports what the library computes, and writes the table that it represents.
  void byBaselines_data() {
    QTest::addColumn<QString>("method");
    for (const Baseline& baseline : allBaselines()) QTest::newRow(baseline.id.data()) << QString(baseline.id.data());
  }
  void byBaselines() {
    QFETCH(QString, method);
    const QString out = folder_.path("baseline.binary");
    const ToolResult result =
        runJson({"factor", plastic_, "--samples", "1", "--method", method, "--bytes", "6000", "--out", out});
    VERIFY_SUCCESS(result);
    const auto all = allBaselines();
    const auto& baseline =
        *std::find_if(all.begin(), all.end(), [&](const Baseline& b) { return b.id == method.toStdString(); });
    const std::vector<std::size_t> budgets{6000};
    const auto table = readTable(plastic_);
    const ComparedModel model = baseline.build(*table, budgets, {}).front();
    QCOMPARE(result.json["method"].get<std::string>(), std::string(baseline.id));
    QCOMPARE(result.json["bytes"].get<std::size_t>(), model.bytes);
    const double error = metrics::brdfErrors(*table, *model.brdf)[0];
    QVERIFY(std::abs(result.json["errors"]["log"].get<double>() / error - 1) < 1e-6);
    const double snr = metrics::brdfSignalToNoiseRatio(*table, *model.brdf);
    QVERIFY(std::abs(result.json["brdfSnr"].get<double>() - snr) < 1e-6);
    QVERIFY(result.json["renderedSnr"].get<double>() > 0 && result.json["seconds"].get<double>() > 0);
    QVERIFY(metrics::brdfErrors(*readTable(out), test::meanOfBothOrders(model.brdf))[0] < 1e-4);
  }

  void wrongUsage_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    const QString factors = folder_.path("usage.pdv");
    VERIFY_SUCCESS(runJson({"factor", plastic_, "--samples", "1", "--terms", "1", "--out", factors}));
    QTest::newRow("no terms") << QStringList{"factor", plastic_, "--terms", "0"} << 2;
    QTest::newRow("too many") << QStringList{"factor", plastic_, "--terms", "21"} << 2;
    QTest::newRow("form") << QStringList{"factor", plastic_, "--form", "4d"} << 2;
    QTest::newRow("transform") << QStringList{"factor", plastic_, "--transform", "wish"} << 2;
    QTest::newRow("kept terms of nothing") << QStringList{"factor", plastic_, "--keep-terms"} << 2;
    QTest::newRow("form of factors") << QStringList{"factor", factors, "--form", "2d"} << 2;
    QTest::newRow("weights of factors") << QStringList{"factor", factors, "--weights", "equal"} << 2;
    QTest::newRow("weights") << QStringList{"factor", plastic_, "--weights", "wish"} << 2;
    QTest::newRow("published with parts")
        << QStringList{"factor", plastic_, "--as-published", "--transform", "root"} << 2;
    QTest::newRow("published baseline") << QStringList{"factor", plastic_, "--method", "cp", "--as-published"} << 2;
    QTest::newRow("method") << QStringList{"factor", plastic_, "--method", "wish"} << 2;
    QTest::newRow("bytes of PDV") << QStringList{"factor", plastic_, "--bytes", "5000"} << 2;
    QTest::newRow("terms of a baseline") << QStringList{"factor", plastic_, "--method", "cp", "--terms", "3"} << 2;
    QTest::newRow("factors of a baseline")
        << QStringList{"factor", plastic_, "--method", "cp", "--out", folder_.path("x.pdv")} << 2;
    QTest::newRow("suffix") << QStringList{"factor", plastic_, "--out", folder_.path("x.png")} << 1;
    QTest::newRow("decoded suffix") << QStringList{"factor", plastic_, "--decode", folder_.path("x.pdv")} << 1;
    QTest::newRow("mixed transforms") << QStringList{"factor", plastic_, "--transform", "root", "--swap-f1", factors}
                                      << 1;
  }
  void wrongUsage() {
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    const ToolResult result = runTool(arguments);
    QCOMPARE(result.code, code);
    QVERIFY(!result.error.isEmpty() && result.out.isEmpty());
  }

  void zEveryKeyIsDocumented() { QCOMPARE(undocumentedKeys(), QString()); }

 private:
  TestFolder folder_{"goniotool-factor"};
  QString plastic_, rough_;
};

GONIO_TEST(GoniotoolFactorTest)
}  // namespace goniotool_factor_test

#include "goniotool_factor_test.moc"
