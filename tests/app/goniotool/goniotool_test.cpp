// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QSet>
#include <QTest>
#include <cmath>
#include <limits>

#include "core/documents/open_material.h"
#include "core/editing/edit.h"
#include "core/io/image_io.h"
#include "core/metrics/brdf_metrics.h"
#include "core/metrics/image_errors.h"
#include "core/models/parameters_json.h"
#include "core/rendering/render_picture.h"
#include "tests/app/goniotool/goniotool_runner.h"
#include "tests/support/function_brdf.h"
#include "tests/support/grain.h"
#include "tests/support/table_file.h"
#include "tests/support/test_program.h"

namespace goniotool_test {
using namespace gonio;
using namespace gonio::test;

class GoniotoolTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    plastic_ = folder_.writeTable("plastic.binary", "ggx", plastic);
    matte_ = folder_.writeTable("matte.binary", "lambert", {{Rgb(0.5, 0.4, 0.3)}});
  }

  void infoOfALambertianTable() {
    const ToolResult result = runJson({"info", matte_});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["format"].get<std::string>(), "MERL");
    QVERIFY(result.json["grid"] == nlohmann::json({30, 30, 36}));
    QVERIFY(std::abs(result.json["channels"][1]["max"].get<double>() - 0.4 / pi) < 1e-6);
    QVERIFY(std::abs(result.json["albedo"]["30"][0].get<double>() - 0.5) < 0.02);
    QVERIFY(std::abs(result.json["dynamicRange"].get<double>() - 5.0 / 3) < 1e-5);
    const auto table = readTable(matte_);
    const double invalidFraction = 1 - double(table->validCount()) / double(table->grid().size());
    QVERIFY(std::abs(result.json["invalidFraction"].get<double>() - invalidFraction) < 1e-12);
    QVERIFY(runTool({"info", matte_}).out.contains("albedo at 80 degrees"));
  }

  /// What sampling costs is what compare says of the sampled table; a table itself loses nothing.
  void infoTellsTheErrorOfTheTable() {
    QVERIFY(runJson({"info", plastic_, "--table-error"}).json["tableSnr"].is_null());
    QVERIFY(!runJson({"info", plastic_}).json.contains("tableSnr"));
    const QString factors = folder_.path("plastic.pdv"), sampled = folder_.path("sampled.binary");
    VERIFY_SUCCESS(runTool({"factor", plastic_, "--terms", "1", "--out", factors}));
    VERIFY_SUCCESS(runTool({"convert", factors, sampled, "--whole-circle"}));
    QCOMPARE(runTool({"info", factors, "--size", "64"}).code, 2);
    const QStringList small{"--size", "64", "--samples", "16"};
    const ToolResult result = runJson(QStringList{"info", factors, "--table-error"} + small);
    VERIFY_SUCCESS(result);
    const double snr = runJson(QStringList{"compare", factors, sampled} + small).json["renderedSnr"].get<double>();
    QVERIFY(snr < 100 && std::abs(result.json["tableSnr"].get<double>() - snr) < 1e-9);
  }

  void evaluateIsTheTable() {
    const QString in = folder_.path("directions.csv"), out = folder_.path("values.csv");
    folder_.writeText("directions.csv",
                      "# a comment\nphi_o,theta_o,name,theta_i,phi_i\n180,30,a,30,0\n40,100,b,10,0\n");
    const ToolResult result = runJson({"evaluate", plastic_, "--directions", in, "--out", out});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["evaluated"].get<int>(), 2);
    const QList<QByteArray> lines = bytesOf(out).split('\n');
    QCOMPARE(lines[0], QByteArray("theta_i,phi_i,theta_o,phi_o,r,g,b"));
    const Rgb expected = readTable(plastic_)->evaluate(fromSpherical(radians(30), 0), fromSpherical(radians(30), pi));
    const QList<QByteArray> fields = lines[1].split(',');
    QCOMPARE(fields[3], QByteArray("180"));
    QCOMPARE(fields[5].toDouble(), expected.y);
    QCOMPARE(lines[2], QByteArray("10,0,100,40,0,0,0"));
  }

  /// Half-out coordinates: theta_h = 0 is the mirror direction. Where no light has the coordinates, fields are empty.
  void evaluateInOtherCoordinates() {
    const QString in = folder_.path("half-out.csv"), out = folder_.path("values.csv");
    folder_.writeText("half-out.csv", "theta_o,theta_h,phi_h\n30,0,0\n80,80,180\n");
    const ToolResult result =
        runJson({"evaluate", plastic_, "--coordinates", "half-out", "--directions", in, "--out", out, "--force"});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["evaluated"].get<int>(), 1);
    QCOMPARE(result.json["withoutDirections"].get<int>(), 1);
    const QList<QByteArray> lines = bytesOf(out).split('\n');
    QCOMPARE(lines[0], QByteArray("theta_o,theta_h,phi_h,theta_i,phi_i,phi_o,r,g,b"));
    const QList<QByteArray> mirror = lines[1].split(',');
    QVERIFY(std::abs(mirror[3].toDouble() - 30) < 1e-9);
    const Rgb expected = readTable(plastic_)->evaluate(fromSpherical(radians(30), 0), fromSpherical(radians(30), pi));
    QVERIFY(std::abs(mirror[6].toDouble() / expected.x - 1) < 1e-9);
    QCOMPARE(lines[2], QByteArray("80,80,180,,,,,,"));
    QCOMPARE(runTool({"evaluate", plastic_, "--coordinates", "pdv", "--directions", in, "--out", out}).code, 2);
  }

  void evaluateTellsTheLine() {
    const QString in = folder_.path("wrong.csv");
    folder_.writeText("wrong.csv", "1,2,3,4\n1,2,x,4\n");
    const ToolResult result = runTool({"evaluate", plastic_, "--directions", in, "--out", folder_.path("no.csv")});
    QCOMPARE(result.code, 1);
    QVERIFY2(result.error.contains("wrong.csv: line 2: found 'x' for theta_o"), qPrintable(result.error));
    QVERIFY(!QFile::exists(folder_.path("no.csv")));
  }

  void checkPassesAndFails() {
    const ToolResult passed = runJson({"check", matte_});
    VERIFY_SUCCESS(passed);
    QVERIFY(passed.json["passed"].get<bool>());
    QCOMPARE(passed.json["checks"].size(), std::size_t(4));
    const QString bright = folder_.writeTable("bright.binary", "lambert", {{Rgb(2)}});
    const ToolResult failed = runJson({"check", bright});
    QCOMPARE(failed.code, 1);
    QVERIFY(!failed.json["passed"].get<bool>());
    QCOMPARE(failed.errorLines(), 1);
    QVERIFY(failed.error.contains("bright.binary") && failed.error.contains("energy"));
  }

  void convertKeepsBytes() {
    const QString out = folder_.path("copy.binary");
    const ToolResult result = runJson({"convert", plastic_, out});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["from"].get<std::string>(), "MERL");
    QCOMPARE(bytesOf(out), bytesOf(plastic_));
    QCOMPARE(qint64(result.json["bytes"].get<std::int64_t>()), bytesOf(out).size());
  }

  void bundledMaterials() {
    const ToolResult info = runJson({"info", "library:sgd/chrome"});
    VERIFY_SUCCESS(info);
    QCOMPARE(info.json["format"].get<std::string>(), "SGD fit");
    const QString out = folder_.path("chrome.binary");
    VERIFY_SUCCESS(runTool({"convert", "library:sgd/chrome", out}));
    QVERIFY(runJson({"info", out}).json["grid"] == nlohmann::json({90, 90, 180}));
    QCOMPARE(runTool({"info", "library:sgd/no-such-material"}).code, 1);
  }

  /// An RGL file is not reciprocal: a table that folds phi_d holds the mean of both orders of its directions.
  void wholeCircleKeepsWhatIsNotReciprocal() {
    const QString material = "library:rgl/satin_purple", folded = folder_.path("folded.binary"),
                  whole = folder_.path("whole.binary");
    VERIFY_SUCCESS(runTool({"convert", material, folded}));
    VERIFY_SUCCESS(runTool({"convert", material, whole, "--whole-circle"}));
    QVERIFY(runJson({"info", whole}).json["grid"] == nlohmann::json({90, 90, 360}));
    const auto snr = [&](const QString& table) {
      return runJson({"compare", material, table, "--size", "48", "--samples", "16"}).json["renderedSnr"].get<double>();
    };
    const auto table = readTable(folded);
    const auto mean = meanOfBothOrders(documents::openMaterial("library:rgl/satin_purple").brdf);
    for (std::size_t node = 0; node < table->grid().size(); node += 997) {
      if (!table->grid().nodeWithin(node, radians(85))) continue;
      const DirectionPair at = table->grid().directions(node);
      const Rgb expected = mean.evaluate(at.wi, at.wo), found = table->evaluate(at.wi, at.wo);
      QVERIFY(maxChannel(glm::abs(found - expected)) <= 1e-4 * maxChannel(expected) + 1e-6);
    }
    const double ofFolded = snr(folded), ofWhole = snr(whole);
    qInfo("folded %.1f dB, whole circle %.1f dB", ofFolded, ofWhole);
    QVERIFY(ofWhole > ofFolded + 6);
    const QString copy = folder_.path("copy-of-whole.binary");
    VERIFY_SUCCESS(runTool({"convert", whole, copy, "--whole-circle"}));
    QCOMPARE(bytesOf(copy), bytesOf(whole));
  }

  void fitRecoversAndBakes() {
    const QString out = folder_.path("fitted.binary");
    const ToolResult result = runJson({"fit", plastic_, "--model", "ggx", "--out", out});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["model"].get<std::string>(), "ggx");
    QVERIFY(std::abs(result.json["parameters"]["roughness"].get<double>() / 0.15 - 1) < 0.01);
    QVERIFY(std::abs(result.json["parameters"]["f0"].get<double>() / 0.1 - 1) < 0.01);
    QVERIFY(std::abs(result.json["parameters"]["specular"][2].get<double>() / 0.7 - 1) < 0.01);
    QCOMPARE(result.json["errors"].size(), metrics::allBrdfMetrics().size());
    QVERIFY(result.json["seconds"].get<double>() > 0);
    const int cells = result.json["usedCells"].get<int>() + result.json["invalidCells"].get<int>() +
                      result.json["grazingCells"].get<int>();
    QCOMPARE(std::size_t(cells), smallGrid.size());
    QVERIFY(metrics::brdfErrors(*readTable(plastic_), *readTable(out))[0] < 1e-5);
  }

  /// GGX contains the Lambertian model: of any measurement its error is not the larger, and its parameters are allowed.
  void fitsOfMeasurements_data() {
    QTest::addColumn<QString>("material");
    for (const char* name : {"rgl/vch_golden_yellow", "rgl/paper_blue", "merl-copy/chrome", "merl-copy/white-fabric"})
      QTest::newRow(name) << QString("library:") + name;
  }
  void fitsOfMeasurements() {
    QFETCH(QString, material);
    const ToolResult matte = runJson({"fit", material, "--model", "lambert"}),
                     result = runJson({"fit", material, "--model", "ggx"});
    VERIFY_SUCCESS(matte);
    VERIFY_SUCCESS(result);
    const models::ModelSpec& spec = models::findModel("ggx").spec();
    models::ParameterValues values = models::parametersFromJson(spec, result.json["parameters"], "parameters");
    QVERIFY(models::clampToHardRange(spec, values).empty());
    const double error = result.json["errors"]["log"].get<double>();
    QVERIFY(error > 0 && error < matte.json["errors"]["log"].get<double>());
  }

  void fitAllRanksEveryModel() {
    const ToolResult result =
        runJson({"fit", matte_, "--all", "--metric", "cube-root", "--sort", "snr", "--samples", "4"});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["fits"].size(), models::allModels().size());
    QCOMPARE(result.json["metric"].get<std::string>(), "cube-root");
    double last = std::numeric_limits<double>::infinity();
    for (const nlohmann::json& fit : result.json["fits"]) {
      const std::string model = fit["model"].get<std::string>();
      // ModelSpec::constantError is by the log metric; by the cube-root metric errors are up to 2.5 times as large.
      const double most = std::max(1e-3, 2.5 * models::findModel(model).spec().constantError);
      const double error = fit["errors"]["cube-root"].get<double>();
      QVERIFY2(error < most, qPrintable(QString("%1: error %2, expected less than %3. A model that cannot reproduce a "
                                                "constant states its ModelSpec::constantError.")
                                            .arg(model.c_str())
                                            .arg(error)
                                            .arg(most)));
      QVERIFY(fit["parameterCount"].get<int>() >= 3);
      const double snr = fit["renderedSnr"].is_null() ? last : fit["renderedSnr"].get<double>();
      QVERIFY2(snr <= last, model.c_str());
      last = snr;
    }
  }

  void fitByTheGammaMetric() {
    const ToolResult one = runJson({"fit", plastic_, "--model", "ward", "--metric", "gamma", "--gamma", "2.5"});
    VERIFY_SUCCESS(one);
    QCOMPARE(one.json["gamma"].get<double>(), 2.5);
    const ToolResult chosen = runJson({"fit", plastic_, "--model", "ward", "--metric", "gamma", "--gamma", "auto"});
    VERIFY_SUCCESS(chosen);
    QCOMPARE(chosen.json["trials"].size(), std::size_t(9));
    QCOMPARE(chosen.json["gamma"].get<double>(), chosen.json["trials"][0]["gamma"].get<double>());
  }

  /// An anisotropic file is fitted with its azimuths: the rotation of its grain comes out.
  void fitOfAnAnisotropicFile() {
    const QString file = folder_.path("brushed.bin"), out = folder_.path("brushed-fit.binary");
    writeUtiaFile(*grainBrdf({"ggx-anisotropic", 0.25, 0.6, radians(30)}), file.toStdString());
    const ToolResult brushed = runJson({"fit", file, "--model", "ggx-anisotropic", "--out", out});
    VERIFY_SUCCESS(brushed);
    const nlohmann::json& parameters = brushed.json["parameters"];
    QVERIFY(std::abs(parameters["rotation"].get<double>() - radians(30)) < radians(0.5));
    QVERIFY(parameters["roughness-y"].get<double>() > 1.5 * parameters["roughness-x"].get<double>());
    QCOMPARE(brushed.json["averagedAzimuths"].get<int>(), editing::bakedAzimuths);
    const ToolResult plain = runJson({"fit", file, "--model", "ggx"});
    VERIFY_SUCCESS(plain);
    QCOMPARE(plain.json["usedCells"].get<int>(), brushed.json["usedCells"].get<int>());
    QCOMPARE(plain.json["averagedAzimuths"].get<int>(), 0);
    QVERIFY(plain.json["errors"]["log"].get<double>() > 3 * brushed.json["errors"]["log"].get<double>());
  }

  void editOfNothingKeepsEveryByte() {
    const QString out = folder_.path("unchanged.binary");
    const ToolResult result = runJson({"edit", plastic_, "--model", "ggx", "--out", out});
    VERIFY_SUCCESS(result);
    QVERIFY(result.json["fitted"] == result.json["edited"]);
    QCOMPARE(bytesOf(out), bytesOf(plastic_));
  }

  /// The file is what the library makes of the same parameters; where the model does not change, nothing does.
  /// A table cannot hold it: that is said, in the answer and in words.
  void anisotropicEditIsAveragedAndToldSo() {
    const QString out = folder_.path("brushed.binary"), document = folder_.path("brushed.gonio");
    const QStringList change{"edit", plastic_, "--model", "ward-anisotropic", "--set", "roughness-x=0.05"};
    const ToolResult result = runJson(change + QStringList{"roughness-y=0.5", "--out", out});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["averagedAzimuths"].get<int>(), editing::bakedAzimuths);
    const ToolResult described = runJson(change + QStringList{"roughness-y=0.5", "--out", document});
    VERIFY_SUCCESS(described);
    QCOMPARE(described.json["averagedAzimuths"].get<int>(), 0);  // a document loses nothing
    const ToolResult replayed = runTool({"edit", document, "--out", out});
    VERIFY_SUCCESS(replayed);
    QVERIFY(replayed.out.contains("anisotropic"));
    // The document is anisotropic, and the table differs from it as much as the mean over the azimuths does.
    const ToolResult compared = runJson({"compare", document, out, "--size", "48", "--samples", "16"});
    VERIFY_SUCCESS(compared);
    QVERIFY(compared.json["brdfSnr"].get<double>() < 20);
    QVERIFY(compared.json["renderedSnr"].get<double>() < 30);
    const ToolResult same = runJson({"compare", document, document, "--size", "16", "--samples", "1"});
    QVERIFY(same.json["identical"].get<bool>());
    QVERIFY(runTool({"info", document}).out.contains("anisotropic"));
    QCOMPARE(runJson({"edit", plastic_, "--model", "ggx", "--set", "f0=0.5", "--out", out})
                 .json["averagedAzimuths"]
                 .get<int>(),
             0);
  }

  void editIsTheDifferentialEdit() {
    const QString out = folder_.path("shiny.binary");
    const ToolResult result = runJson({"edit", plastic_, "--model", "ggx", "--set", "f0=0.5", "specular=1,2,0.5",
                                       "roughness=1", "--strength", "0.5", "--compose", "additive", "--out", out});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["edited"]["f0"].get<double>(), 0.5);
    QCOMPARE(result.json["edited"]["roughness"].get<double>(), 1.0);
    QVERIFY(result.json["edited"]["diffuse"] == result.json["fitted"]["diffuse"]);
    const models::Model& ggx = models::findModel("ggx");
    const auto parameters = [&](const char* key) {
      return models::parametersFromJson(ggx.spec(), result.json[key], key);
    };
    const editing::Edit edit{editing::DifferentialEdit{&ggx, parameters("fitted"), parameters("edited")}, "", 0.5};
    const auto expected = editing::bakeEdits(readTable(plastic_), std::span(&edit, 1));
    test::writeTable(*expected, folder_.path("expected.binary").toStdString());
    QCOMPARE(bytesOf(out), bytesOf(folder_.path("expected.binary")));
    QCOMPARE(result.json["composition"].get<std::string>(), "additive");
  }

  /// Nothing is clamped: the sentence states value and limits, before anything is read.
  void hardCase54ParametersOutsideTheirRange() {
    const QString out = folder_.path("outside.binary");
    const auto sentence = [&](const QStringList& change) {
      const ToolResult result = runTool(QStringList{"edit", plastic_, "--model", "ggx", "--out", out} + change);
      return result.code == 2 && !QFile::exists(out) ? result.error : QString("exit code %1").arg(result.code);
    };
    QVERIFY2(sentence({"--set", "roughness=2"}).contains("edit: roughness is 2, expected 0.0001 to 1"),
             qPrintable(sentence({"--set", "roughness=2"})));
    const QString colour = sentence({"--set", "specular=1,-2,0.5", "f0=3"});
    QVERIFY2(colour.contains("specular (green) is -2, expected 0 to ") && colour.contains("; f0 is 3, expected "),
             qPrintable(colour));
    QVERIFY(sentence({"--control", "roughness=1e9"}).contains("edit: roughness is 1e+09, expected "));
  }

  /// Each composition is written as it is evaluated, and read again from a document.
  void compositionsOfAnEdit() {
    const QString out = folder_.path("composed.binary"), document = folder_.path("composed.gonio");
    QSet<QByteArray> materials;
    for (const QString composition : {"additive", "log-plus", "lobes"}) {
      const QStringList change{"edit", plastic_, "--model", "layered", "--set", "base-roughness=0.5", "--compose"};
      VERIFY_SUCCESS(runJson(change + QStringList{composition, "--out", out}));
      const QByteArray direct = bytesOf(out);
      materials.insert(direct);
      VERIFY_SUCCESS(runJson(change + QStringList{composition, "--out", document}));
      VERIFY_SUCCESS(runJson({"edit", document, "--out", out}));
      QCOMPARE(bytesOf(out), direct);
    }
    QCOMPARE(materials.size(), 3);
    const ToolResult refused = runTool({"edit", plastic_, "--model", "phong", "--compose", "lobes", "--out", out});
    QCOMPARE(refused.code, 2);
    QVERIFY(refused.error.contains("ggx-anisotropic, beckmann-anisotropic, layered, car-paint), found phong"));
  }

  /// A control is the parameters that it changes, and a document keeps it.
  void controlsOfAnEdit() {
    const QString out = folder_.path("controlled.binary"), document = folder_.path("controlled.gonio");
    const QStringList change{"edit",      plastic_,      "--model",   "ggx",
                             "--control", "roughness=2", "--control", "tint=1,0.5,0.25"};
    const ToolResult result = runJson(change + QStringList{"--out", out});
    VERIFY_SUCCESS(result);
    const double fitted = result.json["fitted"]["roughness"].get<double>();
    QCOMPARE(result.json["edited"]["roughness"].get<double>(), 2 * fitted);
    QCOMPARE(result.json["controls"]["roughness"].get<double>(), 2.0);
    const QByteArray direct = bytesOf(out);
    VERIFY_SUCCESS(runJson(change + QStringList{"--out", document}));
    VERIFY_SUCCESS(runJson({"edit", document, "--out", out}));
    QCOMPARE(bytesOf(out), direct);
    const ToolResult refused =
        runTool({"edit", plastic_, "--model", "ggx", "--control", "coat-strength=2", "--out", out});
    QCOMPARE(refused.code, 2);
    QVERIFY(refused.error.contains("ggx has no parameter that --control coat-strength changes"));
  }

  void documentsAreReplayed() {
    const QString document = folder_.path("edit.gonio"), direct = folder_.path("direct.binary");
    const QStringList change{"--model", "ggx", "--set", "roughness=0.4"};
    VERIFY_SUCCESS(runJson(QStringList{"edit", plastic_} + change + QStringList{"--out", document}));
    VERIFY_SUCCESS(runJson(QStringList{"edit", plastic_} + change + QStringList{"--out", direct}));
    const QString replayed = folder_.path("replayed.binary");
    const ToolResult result = runJson({"edit", document, "--out", replayed});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["edits"].get<int>(), 1);
    QCOMPARE(bytesOf(replayed), bytesOf(direct));
    QCOMPARE(runJson({"info", document}).json["format"].get<std::string>(), "gonio document");
    QCOMPARE(runTool({"edit", document, "--model", "ggx", "--out", replayed}).code, 2);
  }

  void aChangedSourceIsRefused() {
    const QString source = folder_.path("source.binary"), document = folder_.path("moved.gonio");
    QVERIFY(QFile::copy(plastic_, source));
    VERIFY_SUCCESS(runTool({"edit", source, "--model", "lambert", "--set", "diffuse=1", "--out", document}));
    QVERIFY(QFile::remove(source) && QFile::copy(matte_, source));
    const ToolResult result = runTool({"edit", document, "--out", folder_.path("no.binary")});
    QCOMPARE(result.code, 1);
    QVERIFY(result.error.contains("moved.gonio") && result.error.contains("source.binary"));
    QVERIFY(!QFile::exists(folder_.path("no.binary")));
  }

  void renderWritesPictures() {
    const QString one = folder_.path("one.exr"), two = folder_.path("two.exr"), png = folder_.path("picture.png");
    const QStringList common{"render", plastic_, "--size", "40x24", "--samples", "4", "--environment", "sky"};
    const ToolResult result = runJson(common + QStringList{"--out", one, "--threads", "1"});
    VERIFY_SUCCESS(result);
    QCOMPARE(result.json["samples"].get<int>(), 4);
    QCOMPARE(result.json["environment"].get<std::string>(), "sky");
    QVERIFY(result.json["plan"].size() >= 4);
    QCOMPARE(result.json["counters"]["shadowRays"].get<int>(), 0);
    VERIFY_SUCCESS(runJson(common + QStringList{"--out", two, "--threads", "2"}));
    const Image image = io::readImage(std::filesystem::path(one.toStdString()));
    QCOMPARE(image.width, 40);
    QCOMPARE(image.height, 24);
    QVERIFY(image.pixels == io::readImage(std::filesystem::path(two.toStdString())).pixels);
    VERIFY_SUCCESS(runTool({"render", plastic_, "--size", "16", "--light", "1", "1", "1", "--out", png, "--effects"}));
    QVERIFY(bytesOf(png).startsWith("\x89PNG"));
  }

  void compareTellsEqualAndDifferent() {
    const QStringList small{"--size", "32", "--samples", "4"};
    const ToolResult equal = runJson(QStringList{"compare", plastic_, plastic_} + small);
    VERIFY_SUCCESS(equal);
    QVERIFY(equal.json["identical"].get<bool>() && equal.json["renderedSnr"].is_null());
    QCOMPARE(equal.json["errors"]["log"].get<double>(), 0.0);
    for (const auto& record : gonio::metrics::imageMetricRecords())
      QCOMPARE(equal.json["imageMetrics"][std::string(record.id)].get<double>(), record.id == "ssim" ? 1.0 : 0.0);
    const QString image = folder_.path("comparison.png");
    const ToolResult different = runJson(QStringList{"compare", plastic_, matte_, "--image", image} + small);
    VERIFY_SUCCESS(different);
    QVERIFY(!different.json["identical"].get<bool>());
    for (const char* key : {"renderedSnr", "renderedPsnr", "brdfSnr"}) QVERIFY(different.json[key].is_number());
    QCOMPARE(different.json["scene"].get<std::string>(), "sphere-studio");
    const auto plastic = readTable(plastic_), matte = readTable(matte_);
    const std::vector<double> errors = metrics::brdfErrors(*plastic, *matte);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const std::string id(metrics::metricId(metrics::allBrdfMetrics()[i]));
      QVERIFY2(std::abs(different.json["errors"][id].get<double>() / errors[i] - 1) < 1e-9, id.c_str());
    }
    QVERIFY(std::abs(different.json["brdfSnr"].get<double>() - metrics::brdfSignalToNoiseRatio(*plastic, *matte)) <
            1e-9);
    const rendering::RenderedComparison comparison(*plastic, {.width = 32, .height = 32, .samples = 4});
    const double snr = comparison.signalToNoiseRatio(comparison.render(*matte));
    QVERIFY(std::abs(different.json["renderedSnr"].get<double>() - snr) < 1e-9);
    for (const auto& record : gonio::metrics::imageMetricRecords()) {
      const double value = different.json["imageMetrics"][std::string(record.id)].get<double>();
      QVERIFY(value > 0 && (record.id != "ssim" || value < 1));
    }
    QVERIFY(bytesOf(image).startsWith("\x89PNG"));
  }

  /// Every key that the runs above printed stands in the documentation, in backquotes. Last of all tests.
  void zEveryKeyIsDocumented() {
    QVERIFY(gonio::test::seenKeys().size() > 40);
    QCOMPARE(gonio::test::undocumentedKeys(), QString());
  }

 private:
  gonio::test::TestFolder folder_{"goniotool"};
  QString plastic_, matte_;
};

GONIO_TEST(GoniotoolTest)
}  // namespace goniotool_test

#include "goniotool_test.moc"
