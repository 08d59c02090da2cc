// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>
#include <set>

#include "core/metrics/brdf_metric.h"
#include "tests/app/goniotool/goniotool_runner.h"
#include "tests/support/test_program.h"

namespace goniotool_study_test {
using namespace gonio;
using namespace gonio::test;

const QStringList tiny{"--size",   "16",          "--samples", "4",  "--representations", "table,fits,factors",
                       "--models", "lambert,ggx", "--terms",   "1,3"};

/// goniotool study.
class GoniotoolStudyTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    plastic_ = folder_.writeTable("plastic.binary", "ggx", plastic);
    rough_ = folder_.writeTable("rough.binary", "ggx", {{Rgb(0.1), Rgb(0.5), Rgb(0.5), Rgb(0.6), Rgb(0)}});
  }

  void recordsFilesAndSummary() {
    const QString out = folder_.path("new/results");
    const ToolResult result =
        runJson(QStringList{"study", plastic_, rough_, "--out", out, "--max-bytes", "10000", "--min-snr", "10"} + tiny);
    VERIFY_SUCCESS(result);
    // Two tables, two fits, two counts of terms in two forms; of two materials.
    QCOMPARE(result.json["records"].size(), std::size_t(16));
    QCOMPARE(result.json["summary"].size(), std::size_t(8));
    QVERIFY(result.json["complete"].get<bool>());
    std::set<std::string> names;
    for (const auto& record : result.json["records"]) {
      names.insert(record["material"]);
      QVERIFY(record["evaluationNs"].get<double>() > 0 && record["frameMs"].get<double>() > 0);
      QVERIFY(record["bytes"].get<double>() > 0);
      QCOMPARE(record["errors"].size(), metrics::allBrdfMetrics().size());
      const bool isTable = record["representation"] == "table-trilinear";
      QCOMPARE(record["identical"].get<bool>(), isTable);
      QCOMPARE(record["renderedSnr"].is_null(), isTable);
      // Nothing is as good as the table itself.
      if (isTable) QVERIFY(!record["front"].empty());
    }
    QVERIFY(names == (std::set<std::string>{"plastic", "rough"}));
    QCOMPARE(result.json["chosen"].size(), std::size_t(2));
    // A fit of the model that made the material.
    QCOMPARE(result.json["chosen"][0]["best"]["representation"].get<std::string>(), "ggx");
    QVERIFY(!result.json["machine"]["processor"].get<std::string>().empty());
    for (const char* name : {"plastic", "rough", "summary"}) {
      const QString stem = out + "/" + name;
      const auto json = nlohmann::json::parse(bytesOf(stem + ".json").toStdString());
      QCOMPARE(json["records"].size(), std::size_t(8));
      collectKeys(json);
      QVERIFY(bytesOf(stem + ".svg").contains("Pareto front"));
      QCOMPARE(bytesOf(stem + ".csv").split('\n').size() - 1, 5 + 1 + 8);
    }
  }

  /// The same number for the same thing, whichever command states it: a measured file that is not reciprocal, its fit
  /// and its code.
  void oneDefinitionOfEachNumber() {
    const QString material = "library:rgl/paper_blue", code = folder_.path("paper.code"),
                  fit = folder_.path("fit.gonio");
    const QString out = folder_.path("numbers");
    const ToolResult study =
        runJson({"study", material, "--out", out, "--representations", "ggx,code", "--coefficients", "64"});
    VERIFY_SUCCESS(study);
    const auto recordOf = [&](const std::string& id) {
      for (const auto& record : study.json["records"])
        if (record["representation"] == id) return record;
      return nlohmann::json();
    };
    const auto agrees = [](const nlohmann::json& a, const nlohmann::json& b, const char* key) {
      return std::abs(a[key].get<double>() - b[key].get<double>()) < 1e-3;
    };
    const ToolResult encoded = runJson({"encode", material, "--coefficients", "64", "--out", code});
    VERIFY_SUCCESS(encoded);
    const ToolResult compared = runJson({"compare", material, code});
    VERIFY_SUCCESS(compared);
    for (const auto& other : {compared.json, nlohmann::json(recordOf("code"))}) {
      QVERIFY(agrees(encoded.json, other, "renderedSnr"));
      QVERIFY(agrees(encoded.json["errors"], other["errors"], "log"));
    }
    QVERIFY(agrees(encoded.json, compared.json, "brdfSnr"));
    QCOMPARE(encoded.json["bytes"].get<int>(), recordOf("code")["bytes"].get<int>());
    const ToolResult fitted = runJson({"fit", material, "--model", "ggx"});
    VERIFY_SUCCESS(fitted);
    QVERIFY(agrees(fitted.json, recordOf("ggx"), "renderedSnr"));
    const ToolResult figure =
        runJson({"figure", "--materials", material, "--representations", "ggx", "code:64", "--size", "64", "--csv",
                 folder_.path("figure.csv"), "--numbers", "rendered-snr"});
    VERIFY_SUCCESS(figure);
    const QStringList rows = QString(bytesOf(folder_.path("figure.csv"))).trimmed().split('\n').last(2);
    QVERIFY(std::abs(rows[0].split(',').last().toDouble() - recordOf("ggx")["renderedSnr"].get<double>()) < 1e-2);
    QVERIFY(std::abs(rows[1].split(',').last().toDouble() - recordOf("code")["renderedSnr"].get<double>()) < 1e-2);
    for (const ToolResult* one : {&encoded, &fitted})
      QVERIFY(one->json["evaluationNs"].get<double>() > 0 && one->json["frameMs"].get<double>() > 0);
    QVERIFY(compared.json["costOfB"]["evaluationNs"].get<double>() > 0);
    VERIFY_SUCCESS(runTool({"edit", material, "--model", "ggx", "--control", "roughness=2", "--out", fit}));
  }

  void textForPeople() {
    const QString out = folder_.path("text");
    const ToolResult result = runTool(QStringList{"study", plastic_, "--out", out, "--max-frame-ms", "0"} + tiny);
    VERIFY_SUCCESS(result);
    QVERIFY(result.out.contains("PDV factors, three curves, 3 terms"));
    QVERIFY(result.out.contains("no representation meets the budget"));
    QVERIFY(!QFile::exists(out + "/summary.json"));
  }

  void principalComponentsOfATrainingSet() {
    const QString merl = folder_.writeTable("merl.binary", "ggx", plastic, HalfDifferenceGrid());
    const QString other = folder_.writeTable("other.binary", "lambert", {{Rgb(0.2, 0.3, 0.4)}}, HalfDifferenceGrid());
    const ToolResult result =
        runJson({"study", merl, "--out", folder_.path("components"), "--representations", "components",
                 "--components-from", merl + "," + other, "--components", "2,5,100", "--size", "16", "--samples", "4"});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["records"].size(), std::size_t(2));  // two materials have six
    QVERIFY(result.json["records"][1]["errors"]["log"] < result.json["records"][0]["errors"]["log"]);
  }

  /// A material with a row has the record of this row, as `compare` measures it; another material has none.
  void publishedNonparametricFactors() {
    const QString table = writeNpf("npf/table.bin", 3);
    const auto study = [&](const QString& npf, const QStringList& further) {
      return runJson(QStringList{"study", rough_, plastic_, "--npf", npf, "--out", folder_.path("npf-study"),
                                 "--representations", "table,baselines", "--baselines", "mccool", "--size", "16",
                                 "--samples", "4"} +
                     further);
    };
    const ToolResult result = study(table, {});
    VERIFY_SUCCESS(result);
    const auto& records = result.json["records"];
    QCOMPARE(records.size(), std::size_t(3 + 4));
    const auto& row = records[5];
    QCOMPARE(row["material"].get<std::string>(), "plastic");
    QCOMPARE(row["representation"].get<std::string>(), "published-nonparametric");
    QCOMPARE(row["family"].get<std::string>(), "published-nonparametric");
    QCOMPARE(row["bytes"].get<int>(), 3264);
    QVERIFY(row["encodeSeconds"].is_null() && row["frameMs"].get<double>() > 0);
    const ToolResult compared = runJson({"compare", plastic_, table + "#plastic", "--size", "16", "--samples", "4"});
    VERIFY_SUCCESS(compared);
    QVERIFY(row["errors"] == compared.json["errors"]);
    QVERIFY(row["renderedSnr"] == compared.json["renderedSnr"]);
    // Beside the other factors, also in the summary, whose first material lacks it.
    QCOMPARE(result.json["summary"][2]["representation"].get<std::string>(), "published-nonparametric");
    QCOMPARE(result.json["summary"][2]["materials"].get<int>(), 1);
    collectKeys(nlohmann::json::parse(bytesOf(folder_.path("npf-study/plastic.json")).toStdString()));
  }

  /// A study that was resumed uses its results, also for a material without a row, but not with another table.
  void publishedFactorsAreResumed() {
    const QString table = writeNpf("npf/table.bin", 3);
    const auto study = [&](const QString& npf, const QStringList& further) {
      return runJson(QStringList{"study", rough_, plastic_, "--npf", npf, "--out", folder_.path("npf-resumed"),
                                 "--no-times", "--representations", "published-nonparametric,fits", "--models",
                                 "lambert", "--size", "16", "--samples", "4"} +
                     further);
    };
    VERIFY_SUCCESS(study(table, {}));
    for (const char* name : {"npf-resumed/rough.json", "npf-resumed/plastic.json"}) {
      QByteArray text = bytesOf(folder_.path(name));
      QVERIFY(text.contains("\"budget\": 3.0"));
      folder_.writeText(name, text.replace("\"budget\": 3.0", "\"budget\": 99.0"));
    }
    const auto budgets = [](const ToolResult& result) {
      std::vector<double> found;
      for (const auto& record : result.json["records"])
        if (record["family"] == "fits") found.push_back(record["budget"]);
      return found;
    };
    QVERIFY(budgets(study(table, {"--resume"})) == (std::vector<double>{99, 99}));
    QVERIFY(budgets(study(writeNpf("npf/other/table.bin", 4), {"--resume"})) == (std::vector<double>{3, 3}));
  }

  /// Baselines have the bytes and errors that the command `factor` reports for the same budget.
  void baselinesOfTheLiterature() {
    const ToolResult result =
        runJson({"study", plastic_, "--out", folder_.path("baselines"), "--representations", "baselines", "--baselines",
                 "bivariate,mccool", "--terms", "1,3", "--size", "16", "--samples", "4"});
    VERIFY_SUCCESS(result);
    const auto& records = result.json["records"];
    QCOMPARE(records.size(), std::size_t(3));
    QCOMPARE(records[0]["representation"].get<std::string>(), "mccool");  // in the order of the table
    QCOMPARE(records[0]["budget"].get<int>(), 0);
    QCOMPARE(records[2]["family"].get<std::string>(), "baselines");
    QCOMPARE(records[2]["budget"].get<int>(), 14'440);
    const ToolResult factor =
        runJson({"factor", plastic_, "--samples", "1", "--method", "bivariate", "--bytes", "14440"});
    VERIFY_SUCCESS(factor);
    QVERIFY(factor.json["bytes"] == records[2]["bytes"] && factor.json["errors"] == records[2]["errors"]);
  }

  void wrongStudiesAreTold() {
    const QString out = folder_.path("none");
    const auto fails = [&](const QStringList& arguments, int code, const char* text) {
      const ToolResult result = runTool(QStringList{"study", "--out", out} + arguments);
      QCOMPARE(result.code, code);
      QVERIFY2(result.error.contains(text), qPrintable(result.error));
      QCOMPARE(result.errorLines(), 1);
    };
    fails({plastic_, "--representations", "tables"}, 1, "'tables', expected one of table, fits");
    fails({plastic_, "--models", "gxx"}, 1, "found 'gxx', expected one of lambert");
    fails({plastic_, plastic_}, 2, "plastic");
    fails({plastic_, "--representations", "components"}, 2, "--components-from");
    fails({plastic_, "--representations", "patches"}, 2, "--patches-from");
    fails({plastic_, "--representations", "published-nonparametric"}, 2, "--npf FILE");
    fails({plastic_, "--npf", folder_.path("absent.bin")}, 1, "absent.bin: cannot be opened");
    fails({rough_, "--npf", writeNpf("npf/table.bin", 3)}, 1,
          "npf/table.bin: found rows of 1 materials, expected one with the name of a material of the study, such as "
          "rough");
    fails({plastic_, "--baselines", "cp"}, 2, "--baselines needs --representations with baselines");
    fails({plastic_, "--representations", "baselines", "--baselines", "nonparametric"}, 1,
          "'nonparametric', expected one of kautz-mccool");
    fails({folder_.path("absent.binary")}, 1, "absent.binary");
    QCOMPARE(runTool({"study", plastic_}).code, 2);
    folder_.writeText("taken.txt", "a file");
    const ToolResult file = runTool({"study", plastic_, "--out", folder_.path("taken.txt")});
    QCOMPARE(file.code, 1);
    QVERIFY(file.error.contains("taken.txt: the folder cannot be created"));
  }

  void zEveryKeyIsDocumented() { QCOMPARE(undocumentedKeys(), QString()); }

 private:
  /// A table of non-parametric factors with one row, plastic, and the names beside it; returns its path.
  QString writeNpf(const QString& name, float specular) const {
    std::vector<float> columns(512, 0.0f);
    columns[0] = 0.2f, columns[1] = specular;
    for (int i = 0; i < 90; ++i) columns[2 + i] = std::exp(-0.1f * float(i)), columns[93 + i] = 1, columns[183 + i] = 1;
    QByteArray bytes;
    for (const float value : columns)
      for (int channel = 0; channel < 3; ++channel) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    QDir().mkpath(QFileInfo(folder_.path(name)).path());
    folder_.writeText(name, bytes);
    folder_.writeText(QFileInfo(name).path() + "/npf_row_order.csv", "row,material\n0,plastic\n");
    return folder_.path(name);
  }

  TestFolder folder_{"goniotool-study"};
  QString plastic_, rough_;
};

GONIO_TEST(GoniotoolStudyTest)
}  // namespace goniotool_study_test

#include "goniotool_study_test.moc"
