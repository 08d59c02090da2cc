// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/brdf/weighted_sum.h"
#include "core/formats/pdv.h"
#include "core/metrics/brdf_metrics.h"
#include "tests/app/goniotool/goniotool_runner.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace goniotool_interpolate_test {
using namespace gonio;
using namespace gonio::test;

/// goniotool interpolate.
class GoniotoolInterpolateTest : public QObject {
  Q_OBJECT
 private:
  QString path(const char* name) const { return folder_.path(name); }
  static models::ParameterValues ggx(double diffuse, double roughness) {
    return {{Rgb(diffuse), Rgb(0.8), Rgb(roughness), Rgb(0.2), Rgb(0)}};
  }
  /// Log error between two tables, by their paths.
  static double logError(const QString& a, const QString& b) {
    return metrics::brdfErrors(*readTable(a), *readTable(b))[0];
  }

 private Q_SLOTS:
  void initTestCase() {
    smooth_ = folder_.writeTable("smooth.binary", "ggx", ggx(0.3, 0.15));
    rough_ = folder_.writeTable("rough.binary", "ggx", ggx(0.1, 0.6));
    middle_ = folder_.writeTable("middle.binary", "ggx", ggx(0.2, 0.3));
  }

  void linearIsTheMixtureOfTheFiles() {
    const QString out = path("linear.binary");
    const ToolResult result =
        runJson({"interpolate", smooth_, rough_, middle_, "--weights", "0.5,0.2,0.3", "--out", out});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["space"].get<std::string>(), "linear");
    QVERIFY(result.json["weights"] == nlohmann::json({0.5, 0.2, 0.3}));
    QCOMPARE(result.json["out"].get<std::string>(), out.toStdString());
    QVERIFY(result.json["seconds"].get<double>() >= 0);
    const std::vector tables{readTable(smooth_), readTable(rough_), readTable(middle_)};
    const auto expected = weightedSum(tables, std::vector{0.5, 0.2, 0.3});
    QVERIFY(metrics::brdfErrors(*expected, *readTable(out))[0] < 1e-6);
  }

  /// RGL files stay RGL files, by a command that states how near the file is; a document of the blend's file too.
  void rglFilesStayRglFiles() {
    const QString out = path("blend.bsdf");
    const ToolResult result =
        runJson({"interpolate", "library:rgl/paper_blue", "library:rgl/paper_white", "--at", "0.25", "--out", out});
    VERIFY_SUCCESS(result);
    QVERIFY(result.json["snr"].get<double>() > 40);
    QVERIFY(result.json["nodes"].get<int>() <= 1);
    const auto blend = materials::readMaterial(out.toStdString()).brdf;
    QVERIFY(formOf<RglBrdf>(*blend));
    const auto blue = materials::readMaterial("library:rgl/paper_blue").brdf,
               white = materials::readMaterial("library:rgl/paper_white").brdf;
    double error = 0, whole = 0;
    for (double theta = 0.1; theta < 1.3; theta += 0.1) {
      const Direction wi = fromSpherical(theta, 0.3), wo = fromSpherical(0.9 * theta, 2.5);
      const Rgb expected = 0.75 * blue->evaluate(wi, wo) + 0.25 * white->evaluate(wi, wo);
      error += glm::length(blend->evaluate(wi, wo) - expected);
      whole += glm::length(expected);
    }
    QVERIFY(error < 0.03 * whole);
  }

  void theEndsAreTheFilesThemselves() {
    for (const char* space : {"linear", "parameters", "differential", "factors"})
      for (const bool second : {false, true}) {
        VERIFY_SUCCESS(runJson({"interpolate", smooth_, rough_, "--at", second ? "1" : "0", "--space", space, "--terms",
                                "1", "--out", path("end.binary")}));
        QVERIFY(readTable(path("end.binary"))->values().front() ==
                readTable(second ? rough_ : smooth_)->values().front());
        QCOMPARE(logError(path("end.binary"), second ? rough_ : smooth_), 0.0);
      }
  }

  /// Near a material the blend is near it; of the representation alone it is as far as that is. Beside an RGL file the
  /// blend is not reciprocal, which a MERL file loses.
  void theMeasuredDetailIsKept() {
    const auto nearSmooth = [&](const QStringList& more) {
      const ToolResult result = runJson(QStringList{"interpolate", smooth_, rough_, "--at", "0.005", "--space",
                                                    "factors", "--terms", "1", "--out", path("near.binary")} +
                                        more);
      if (result.code == 0 && result.json["keepDetail"].get<bool>() != more.isEmpty()) return 1e300;
      return result.code == 0 ? logError(smooth_, path("near.binary")) : 1e300;
    };
    const double kept = nearSmooth({}), discarded = nearSmooth({"--discard-detail"});
    QVERIFY2(kept < 0.05 * discarded && discarded < 1e300, qPrintable(QString("%1 %2").arg(kept).arg(discarded)));
    QVERIFY(!runJson({"interpolate", smooth_, rough_, "--out", path("near.binary")}).json.contains("keepDetail"));
    for (const bool keeps : {true, false}) {
      QStringList command{
          "interpolate", "library:rgl/paper_blue", rough_, "--space", "parameters", "--model", "lambert",
          "--out",       path("paper.binary")};
      if (!keeps) command << "--discard-detail";
      const ToolResult paper = runJson(command);
      VERIFY_SUCCESS(paper);
      const bool losesOrder = paper.json["losses"].dump().find("recipro") != std::string::npos;
      QVERIFY2(losesOrder == keeps, paper.json["losses"].dump().c_str());
    }
  }

  /// Half way between two roughnesses lies their geometric mean, where the space knows of roughness.
  void parametersMeetTheMaterialInBetween() {
    VERIFY_SUCCESS(runJson({"interpolate", smooth_, rough_, "--out", path("half.binary")}));
    const double mixed = logError(middle_, path("half.binary"));
    for (const char* space : {"parameters", "differential"}) {
      const ToolResult result =
          runJson({"interpolate", smooth_, rough_, "--t", "0.5", "--space", space, "--out", path("half.binary")});
      VERIFY_SUCCESS(result);
      QVERIFY(std::abs(result.json["parameters"]["roughness"].get<double>() - 0.3) < 0.003);
      QVERIFY(logError(middle_, path("half.binary")) < mixed / 10);
    }
    const ToolResult text = runTool(
        {"interpolate", smooth_, rough_, "--space", "parameters", "--model", "ward", "--out", path("half.binary")});
    QCOMPARE(text.code, 0);
    QVERIFY(text.out.contains("half.binary: parameters, weights 0.5 0.5"));
  }

  void factorsAreWrittenAsCurvesAndAsATable() {
    const ToolResult result =
        runJson({"interpolate", smooth_, rough_, "--space", "factors", "--terms", "2", "--out", path("half.pdv")});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["terms"].get<int>(), 3);  // the first, and the second of both
    VERIFY_SUCCESS(runJson({"interpolate", smooth_, rough_, "--space", "factors", "--terms", "2", "--discard-detail",
                            "--out", path("half.binary")}));
    const auto curves = factorization::makePdvBrdf(formats::readPdv(path("half.pdv").toStdString()));
    QVERIFY(metrics::brdfErrors(*readTable(path("half.binary")), test::meanOfBothOrders(curves))[0] < 1e-3);
    // A file of factors is taken as it is, and the table beside it factorised on its nodes.
    const ToolResult again = runJson({"interpolate", path("half.pdv"), rough_, "--space", "factors", "--terms", "7",
                                      "--at", "0.25", "--out", path("quarter.pdv")});
    VERIFY_SUCCESS(again);
    QCOMPARE(again.json["terms"].get<int>(), 5);
    QVERIFY(formats::readPdv(path("quarter.pdv").toStdString()).deviationNodes ==
            formats::readPdv(path("half.pdv").toStdString()).deviationNodes);
  }

  /// Over a dictionary that learned from the ends: codes that are files, and tables.
  void dictionaryGivesCodesAndTables() {
    const QString own = path("own.dictionary");
    VERIFY_SUCCESS(runTool({"dictionary", "train", smooth_, rough_, "--dictionaries", "1", "--sparsities", "60",
                            "--iterations", "1", "--out", own}));
    const QStringList space{"--space", "dictionary", "--dictionary", own, "--coefficients", "300", "--out"};
    const ToolResult result =
        runJson(QStringList{"interpolate", smooth_, rough_} + space + QStringList{path("half.code")});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["coefficients"].get<int>(), 300);
    VERIFY_SUCCESS(runJson(QStringList{"interpolate", smooth_, rough_, "--discard-detail"} + space +
                           QStringList{path("half.binary")}));
    VERIFY_SUCCESS(runTool({"decode", path("half.code"), "--dictionary", own, "--out", path("decoded.binary")}));
    QVERIFY(logError(path("half.binary"), path("decoded.binary")) < 0.01);  // the file's half precision
    // Of a code its own coefficients are taken, in its own transform.
    const ToolResult whole = runJson(QStringList{"interpolate", path("half.code"), rough_, "--at", "0"} + space +
                                     QStringList{path("again.code")});
    VERIFY_SUCCESS(whole);
    QCOMPARE(bytesOf(path("again.code")), bytesOf(path("half.code")));
    const ToolResult mixed = runJson(QStringList{"interpolate", path("half.code"), rough_, "--at", "0.25"} + space +
                                     QStringList{path("quarter.code")});
    VERIFY_SUCCESS(mixed);
    QVERIFY(mixed.json["transform"] == result.json["transform"]);
    // Over the bundled dictionary it is nothing.
    const ToolResult foreign =
        runTool({"interpolate", path("half.code"), rough_, "--space", "dictionary", "--out", path("x.code")});
    QCOMPARE(foreign.code, 1);
    QVERIFY(foreign.error.contains("half.code") && foreign.error.contains("another dictionary"));
    QCOMPARE(runTool({"interpolate", smooth_, rough_, "--out", path("x.code")}).code, 2);
  }

  void theBundledDictionaryIsTheDefault() {
    const ToolResult result = runJson({"interpolate", smooth_, rough_, "--space", "dictionary", "--coefficients", "100",
                                       "--out", path("bundled.code")});
    VERIFY_SUCCESS(result);
    const ToolResult info = runJson({"info", path("bundled.code")});
    VERIFY_SUCCESS(info);
    QCOMPARE(info.json["format"].get<std::string>(), "sparse code");
  }

  void seriesOfSteps() {
    const ToolResult result =
        runJson({"interpolate", smooth_, rough_, "--steps", "11", "--out", path("series.binary")});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["steps"].size(), std::size_t(11));
    QVERIFY(result.json["steps"][3]["weights"] == nlohmann::json({0.7, 0.3}));
    QCOMPARE(result.json["steps"][3]["out"].get<std::string>(), path("series-03.binary").toStdString());
    QCOMPARE(logError(path("series-00.binary"), smooth_), 0.0);
    QCOMPARE(logError(path("series-10.binary"), rough_), 0.0);
    VERIFY_SUCCESS(runJson({"interpolate", smooth_, rough_, "--at", "0.3", "--out", path("one.binary")}));
    QVERIFY(logError(path("series-03.binary"), path("one.binary")) < 1e-6);
  }

  void wrongUsage_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::newRow("one material") << QStringList{smooth_} << 2;
    QTest::newRow("three without weights") << QStringList{smooth_, rough_, middle_} << 2;
    QTest::newRow("too few weights") << QStringList{smooth_, rough_, middle_, "--weights", "0.5,0.5"} << 2;
    QTest::newRow("sum") << QStringList{smooth_, rough_, "--weights", "0.5,0.6"} << 2;
    QTest::newRow("negative") << QStringList{smooth_, rough_, "--weights=-0.5,1.5"} << 2;
    QTest::newRow("not a number") << QStringList{smooth_, rough_, "--weights", "nan,1"} << 2;
    QTest::newRow("at nan") << QStringList{smooth_, rough_, "--at", "nan"} << 2;
    QTest::newRow("outside") << QStringList{smooth_, rough_, "--at", "1.5"} << 2;
    QTest::newRow("both") << QStringList{smooth_, rough_, "--at", "0.5", "--weights", "0.5,0.5"} << 2;
    QTest::newRow("one step") << QStringList{smooth_, rough_, "--steps", "1"} << 2;
    QTest::newRow("space") << QStringList{smooth_, rough_, "--space", "hyperspace"} << 2;
    QTest::newRow("no such file") << QStringList{smooth_, folder_.path("none.binary")} << 1;
  }
  void wrongUsage() {
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    const ToolResult result = runTool(QStringList{"interpolate"} + arguments + QStringList{"--out", path("x.binary")});
    QCOMPARE(result.code, code);
    QVERIFY(!result.error.isEmpty() && !QFile::exists(path("x.binary")));
  }

  void outputsThatCannotBe() {
    QCOMPARE(runTool({"interpolate", smooth_, rough_, "--out", path("x.pdv")}).code, 2);
    const ToolResult suffix = runTool({"interpolate", smooth_, rough_, "--out", path("x.mat")});
    QCOMPARE(suffix.code, 1);
    QVERIFY(suffix.error.contains("x.mat") && suffix.errorLines() == 1);
  }

  /// Every key that the runs above printed stands in the documentation, in backquotes. Last of all tests.
  void zEveryKeyIsDocumented() { QCOMPARE(undocumentedKeys(), QString()); }

 private:
  TestFolder folder_{"goniotool-interpolate"};
  QString smooth_, rough_, middle_;
};

GONIO_TEST(GoniotoolInterpolateTest)
}  // namespace goniotool_interpolate_test

#include "goniotool_interpolate_test.moc"
