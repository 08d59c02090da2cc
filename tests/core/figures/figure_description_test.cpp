// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/figures/figure_description.h"

#include <QDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/documents/edit_document.h"
#include "core/io/atomic_file.h"
#include "core/support/error.h"
#include "tests/core/figures/small_figure.h"
#include "tests/support/test_program.h"

namespace figure_description_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::documents;
using namespace gonio::figures;
namespace fs = std::filesystem;

/// One with no member at its default.
FigureDescription unusual() {
  FigureDescription figure = test::smallFigure();
  figure.title = "Materials & \"fits\"";
  figure.width = FigureWidth::oneColumn;
  figure.font = "Times";
  figure.fontSize = 6.5;
  figure.representations.push_back({study::representationById("code", 64), "code"});
  figure.representations.push_back({study::representationById("table-cell"), ""});
  figure.pictures = {
      .scene = "row", .environment = "sky", .size = 32, .samples = 8, .exposure = -1.5, .toneMap = ToneMap::filmic};
  figure.numbers = {"ssim", "evaluation-time"};
  figure.inset = FigureInset{0.25, 0.5, 0.125};
  figure.errorMaps = false;
  figure.errorMaximum = 0.25;
  return figure;
}

std::string errorOf(const nlohmann::json& json) {
  try {
    figureFromJson(json);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

class FigureDescriptionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void roundTrip() {
    for (const FigureDescription& figure : {unusual(), test::smallFigure()}) {
      const nlohmann::json json = nlohmann::json::parse(toJson(figure).dump());
      QVERIFY(figureFromJson(json) == figure);
    }
  }

  void mostMembersMayBeLeftOut() {
    const auto json = nlohmann::json::parse(R"({"format": "gonio figure", "version": 1,
        "materials": [{"path": "library:sgd/chrome"}], "representations": [{"id": "ggx"}]})");
    FigureDescription expected;
    expected.materials = {{"library:sgd/chrome"}};
    expected.representations = {{study::representationById("ggx")}};
    QVERIFY(figureFromJson(json) == expected);
  }

  /// What was called the nearest node in older figures is the node at or below.
  void idsOfOlderFigures() {
    nlohmann::json json = nlohmann::json::parse(toJson(unusual()).dump());
    QCOMPARE(json["representations"].back()["id"].get<std::string>(), "table-cell");
    json["representations"].back()["id"] = "table-nearest";
    QVERIFY(figureFromJson(json) == unusual());
  }

  /// Each refusal names the member, what was found and what was expected.
  void refusals() {
    const nlohmann::json good = nlohmann::json::parse(toJson(unusual()).dump());
    QCOMPARE(errorOf(good), std::string("accepted"));
    const auto refused = [&](const char* pointer, const nlohmann::json& value,
                             std::initializer_list<const char*> texts) {
      nlohmann::json json = good;
      json[nlohmann::json::json_pointer(pointer)] = value;
      const std::string error = errorOf(json);
      for (const char* text : texts)
        QVERIFY2(error.find(text) != std::string::npos, (std::string(pointer) + ": " + error).c_str());
    };
    refused("/format", "gonio scene", {"format", "gonio scene", "gonio figure"});
    refused("/version", 2, {"version", "2", "expected 1"});
    refused("/columns", "three", {"columns", "three", "\"one\" or \"two\""});
    refused("/fontSize", 2, {"fontSize", "2", "4"});
    refused("/colums", "one", {"colums"});
    refused("/materials", nlohmann::json::array(), {"materials", "a list of 1 to 50"});
    refused("/materials/1/path", "", {"materials[1].path", "library:SOURCE/NAME"});
    refused("/materials/0/name", "x", {"materials[0].name"});
    refused("/representations/2/id", "ggxx", {"representations[2]", "'ggxx'", "expected one of table-cell"});
    refused("/representations/1/budget", 0.5, {"representations[1]", "0.5", "whole number from 1 to"});
    refused("/representations/1", {{"id", "factors-3d"}}, {"representations[1]", "no budget", "terms"});
    refused("/representations/2/budget", 70000, {"representations[2]", "70000", "65535"});
    refused("/representations/0", {{"id", "components"}, {"budget", 4}}, {"representations[0]", "'components'"});
    refused("/pictures/size", 16.5, {"pictures.size", "16.5", "whole number"});
    refused("/pictures/size", 5000, {"pictures.size", "5000", "2048"});
    refused("/pictures/toneMap", "hard", {"pictures.toneMap", "hard", "\"clamp\" or \"filmic\""});
    refused("/numbers/1", "psnr", {"numbers[1]", "'psnr'", "rendered-snr, mse"});
    refused("/numbers/0", 7, {"numbers[0]", "the number 7"});
    refused("/inset/x", 0.9, {"inset.x", "0.9", "0.875"});
    refused("/inset/size", 0, {"inset.size"});
    refused("/errorMaps", 1, {"errorMaps"});
    refused("/errorMaximum", -1, {"errorMaximum", "-1"});
  }

  void errorsNameTheFile() {
    const fs::path path = folder() / "wrong.json";
    io::writeFileAtomically(path, std::string("{\"format\": 1}"));
    try {
      readFigureDescription(path);
      QFAIL("accepted");
    } catch (const Error& error) {
      QVERIFY(std::string(error.what()).starts_with(path.string() + ": format"));
    }
  }

  /// A description beside its materials can be moved with them.
  void pathsAreRelativeToTheFile() {
    FigureDescription figure = test::smallFigure();
    figure.materials = {
        {(folder() / "below" / "a.binary").string(), ""}, {"/elsewhere/b.bsdf", ""}, {"library:sgd/chrome", ""}};
    figure.pictures.scene = (folder() / "scene.json").string();
    figure.pictures.environment = "sky";
    const fs::path path = folder() / "figure.json";
    const std::string text = figureDescriptionText(figure, path);
    const auto json = nlohmann::json::parse(text);
    QCOMPARE(json["materials"][0]["path"].get<std::string>(), std::string("below/a.binary"));
    QCOMPARE(json["materials"][1]["path"].get<std::string>(), std::string("/elsewhere/b.bsdf"));
    QCOMPARE(json["pictures"]["scene"].get<std::string>(), std::string("scene.json"));
    io::writeFileAtomically(path, text);
    QVERIFY(readFigureDescription(path) == figure);
    QCOMPARE(figureSources(figure).size(), std::size_t(3));
  }

  /// Also the measured file of a document among the materials, and other spellings of a path.
  void outputsAreNoSources() {
    FigureDescription figure = test::smallFigure();
    const fs::path table = folder() / "table.binary", document = folder() / "edited.gonio";
    io::writeFileAtomically(table, std::string("x"));
    documents::EditDocument edited;
    edited.sourcePath = table.string();
    edited.sourceSha256 = std::string(64, 'a');
    documents::writeDocument(edited, document);
    figure.materials = {{document.string(), ""}};
    for (const fs::path& taken : {document, table, folder() / "." / "table.binary"}) try {
        checkFigureOutput(figure, taken);
        QFAIL("accepted");
      } catch (const Error& error) {
        QCOMPARE(std::string(error.what()),
                 taken.string() + ": the figure is made from this file, expected another name");
      }
    checkFigureOutput(figure, folder() / "figure.pdf");
  }

  void numbersHaveDifferentNames() {
    for (const FigureNumber& number : figureNumbers()) {
      QCOMPARE(&figureNumber(number.id), &number);
      QCOMPARE(std::ranges::count(figureNumbers(), number.id, &FigureNumber::id), std::ptrdiff_t(1));
    }
  }

  void valuesAsText() {
    const auto text = [](const char* id, double value) { return valueText(figureNumber(id), value); };
    QCOMPARE(text("rendered-snr", 38.24), std::string("38.2 dB"));
    QCOMPARE(text("rendered-snr", std::numeric_limits<double>::infinity()), std::string("∞ dB"));
    QCOMPARE(text("rendered-snr", std::nan("")), std::string("- dB"));
    QCOMPARE(text("bytes", 84), std::string("84 B"));
    QCOMPARE(text("bytes", 44680), std::string("44.7 kB"));
    QCOMPARE(text("bytes", 999950), std::string("1.00 MB"));
    QCOMPARE(text("encoding-time", 0.0), std::string("0 s"));
    QCOMPARE(text("evaluation-time", 25e-9), std::string("25.0 ns"));
    QCOMPARE(text("frame-time", 0.0123), std::string("12.3 ms"));
    QCOMPARE(text("flip", 0.05), std::string("0.0500"));
  }

 private:
  static fs::path folder() {
    const QString path = QStringLiteral(GONIO_TEST_OUTPUT_DIR "/figure-description");
    QDir().mkpath(path);
    return fs::weakly_canonical(path.toStdString());
  }
};

GONIO_TEST(FigureDescriptionTest)
}  // namespace figure_description_test

#include "figure_description_test.moc"
