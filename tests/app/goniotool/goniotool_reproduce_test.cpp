// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QDateTime>
#include <QTest>
#include <cmath>

#include "core/acquisition/factor_prediction.h"
#include "core/io/csv_text.h"
#include "core/materials/material.h"
#include "core/rendering/render_picture.h"
#include "core/reproduction/figure_record.h"
#include "tests/app/goniotool/goniotool_runner.h"
#include "tests/support/test_program.h"

namespace goniotool_reproduce_test {
using namespace gonio;
using namespace gonio::test;

/// goniotool reproduce: figures 4.3 and 5.3 of a quick run.
class GoniotoolReproduceTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Figure 5.3 of the bundled copies is what the library measures; the report has the printed values beside it.
  void figureOfTheCopies() {
    const ToolResult result = reproduce("copies", {"--only", "5.3"});
    VERIFY_SUCCESS(result);
    QVERIFY(result.json["copies"] == true && result.json["figures"].size() == 1);
    const auto table = materials::readMaterial("library:merl-copy/blue-metallic-paint2").tabulated();
    const rendering::RenderedComparison comparison(*table, rendering::smallComparisonPicture());
    const auto measurement = acquisition::measureFactors(*table, {.axes = acquisition::FactorAxes::halfOut});
    const auto brdf = acquisition::predictFromFactors(measurement, acquisition::FactorBound::none);
    const double expected = comparison.signalToNoiseRatio(comparison.render(*brdf));
    const double printed = 25.59;
    QCOMPARE(value(result, 0, "Half-out, rendered SNR")["value"].get<double>(), expected);
    QCOMPARE(value(result, 0, "Half-out, rendered SNR")["printed"].get<double>(), printed);
    const auto csv = io::readCsvText(bytesOf(folder_.path("copies/figure-5.3.csv")).toStdString());
    const auto row = std::ranges::find(csv.rows, "Half-out", [&](const auto& one) { return one.fields[1]; });
    QVERIFY(row != csv.rows.end());
    QCOMPARE(csv.number(*row, csv.requiredColumn("rendered snr [db]")), expected);
    const QByteArray report = bytesOf(folder_.path("copies/report.html"));
    for (const char* text : {"25.59 dB", "No MERL files were given", "blue-metallic-paint2 for red-metallic-paint",
                             "figure-5.3.pdf", "<b>Quick run:</b>"})
      QVERIFY2(report.contains(text), text);
    QVERIFY(bytesOf(folder_.path("copies/figure-5.3.pdf")).startsWith("%PDF"));
    // No path of this machine.
    QVERIFY(!report.contains(QDir::currentPath().toUtf8()));
  }

  /// Diffuse materials are exact products of curves: every printed value is exceeded by far, and every one is compared.
  void diffuseMaterialsAreExact() {
    for (const char* name : {"blue-metallic-paint", "nickel", "yellow-matte-plastic", "red-metallic-paint"})
      writeDiffuse(name, 0.4);
    const ToolResult result = diffuse();
    VERIFY_SUCCESS(result);
    QVERIFY(result.json["copies"] == false);
    const std::array ids{std::string("4.3"), std::string("5.3")};
    const auto records = reproduction::selectedFigures(ids);
    for (std::size_t f = 0; f < records.size(); ++f) {
      QVERIFY(!records[f]->printed.empty());
      for (const auto& printed : records[f]->printed) {
        const auto found = value(result, f, std::string(printed.name));
        QVERIFY2(!found.is_null(), printed.name.data());
        QCOMPARE(found["printed"].get<double>(), printed.value);
        // Infinite is null.
        QVERIFY2(found["value"].is_null() || found["value"].get<double>() > 45, printed.name.data());
      }
    }
  }

  /// Nothing is made twice; a figure is made again when one of its materials changes or its file is damaged.
  void unchangedFiguresAreKept() {
    const QDateTime before = QFileInfo(folder_.path("diffuse/figure-5.3.pdf")).lastModified();
    const ToolResult again = diffuse();
    VERIFY_SUCCESS(again);
    QVERIFY(kept(again, 0) && kept(again, 1));
    QCOMPARE(QFileInfo(folder_.path("diffuse/figure-5.3.pdf")).lastModified(), before);
    writeDiffuse("red-metallic-paint", 0.5);
    const ToolResult changed = diffuse();
    QVERIFY(kept(changed, 0) && !kept(changed, 1));
    folder_.writeText("diffuse/figure-5.3.json", "{\"figure\": ");
    QVERIFY(!kept(diffuse(), 1));
    QVERIFY(kept(diffuse(), 1));
  }

  void unknownFiguresAndFolders() {
    const ToolResult result = reproduce("unknown", {"--only", "4.3,9.9"});
    QCOMPARE(result.code, 2);
    QVERIFY(result.error.contains("9.9") && result.error.contains("4.3, 4.4") && result.errorLines() == 1);
    const ToolResult folder = reproduce("unknown", {"--only", "2.1", "--merl", folder_.path("nowhere")});
    QVERIFY(folder.code == 1 && folder.error.contains("nowhere: found no folder"));
    QVERIFY(!QFile::exists(folder_.path("unknown")));
  }

  /// A figure without its material is an error of its own.
  void othersAreMade() {
    const ToolResult result = reproduce("others", {"--merl", folder_.path("materials"), "--only", "2.1,5.4,5.3"});
    QCOMPARE(result.code, 1);
    const auto& figures = result.json["figures"];
    QVERIFY(figures.size() == 3 && figures[0]["error"].is_null() && figures[1]["error"].is_null());
    const std::string error = figures[2]["error"];
    QVERIFY2(error.find("found no material chrome or chrome-steel") != std::string::npos, error.c_str());
    QVERIFY(bytesOf(folder_.path("others/report.html")).contains("Not made: "));
  }

  /// The complete page of the documentation has the table of the records.
  void thePageListsAllFigures() {
    const ToolResult result = runTool({"reproduce", "--list"});
    VERIFY_SUCCESS(result);
    QVERIFY(result.out.contains("| figure 4.3 |") && completePage("reproduction").contains(result.out));
    runJson({"reproduce", "--list"});
  }

  void zEveryKeyIsDocumented() { QCOMPARE(undocumentedKeys(), QString()); }

 private:
  ToolResult reproduce(const QString& out, const QStringList& further) const {
    return runJson(QStringList{"reproduce", "--quick", "--out", folder_.path(out)} + further);
  }
  ToolResult diffuse() const {
    return reproduce("diffuse", {"--merl", folder_.path("materials"), "--only", "4.3,5.3"});
  }
  void writeDiffuse(const QString& name, double albedo) const {
    QDir().mkpath(folder_.path("materials"));
    folder_.writeTable("materials/" + name + ".binary", "lambert", {{Rgb(albedo)}});
  }
  static nlohmann::json value(const ToolResult& result, std::size_t figure, const std::string& name) {
    for (const auto& one : result.json["figures"][figure]["values"])
      if (one["name"] == name) return one;
    return nullptr;
  }
  static bool kept(const ToolResult& result, std::size_t figure) { return result.json["figures"][figure]["kept"]; }

  TestFolder folder_{"goniotool_reproduce"};
};

GONIO_TEST(GoniotoolReproduceTest)
}  // namespace goniotool_reproduce_test

#include "goniotool_reproduce_test.moc"
