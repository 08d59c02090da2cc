// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/figures/figure_measurement.h"

#include <QTest>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "core/documents/edit_document.h"
#include "core/figures/draw_figure.h"
#include "core/figures/figure_description.h"
#include "core/materials/material.h"
#include "core/metrics/image_errors.h"
#include "core/rendering/error_maps.h"
#include "core/study/accuracy_study.h"
#include "tests/core/figures/small_figure.h"
#include "tests/support/function_brdf.h"
#include "tests/support/table_file.h"
#include "tests/support/test_program.h"

namespace figure_measurement_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::figures;

/// Two materials on a small grid.
FigureDescription quickFigure() {
  FigureDescription figure = test::smallFigure();
  const std::filesystem::path folder = GONIO_TEST_OUTPUT_DIR "/figure-measurement";
  std::filesystem::create_directories(folder);
  constexpr HalfDifferenceGrid grid{.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 36};
  for (const auto& [name, roughness] : {std::pair{"chrome", 0.2}, {"rubber", 0.6}}) {
    const std::filesystem::path path = folder / (std::string(name) + ".binary");
    const auto table = bakeTable(*test::ggx(Rgb(0.05, 0.2, 0.3), Rgb(0.9, 0.5, 0.2), roughness, 0.04), grid);
    if (!std::filesystem::exists(path)) test::writeTable(*table, path);
  }
  figure.numbers = {"rendered-snr", "bytes"};  // no times
  figure.materials = {{(folder / "chrome.binary").string(), ""}, {(folder / "rubber.binary").string(), "blue rubber"}};
  return figure;
}

/// What the study of one material finds, by itself.
std::vector<study::MeasuredRepresentation> studied(const FigureDescription& figure, std::size_t row) {
  const materials::Material material = materials::readMaterial(figure.materials[row].path);
  std::vector<study::MeasuredRepresentation> all;
  study::StudyOptions options;
  options.shown = {.width = figure.pictures.size, .height = figure.pictures.size, .samples = figure.pictures.samples};
  options.timed = false;
  options.measured = [&](const study::MeasuredRepresentation& one) { all.push_back(one); };
  std::vector<study::Representation> representations;
  for (const FigureRepresentation& one : figure.representations) representations.push_back(one.representation);
  study::runStudy({material.tabulated(), material.brdf}, representations, options);
  return all;
}

class FigureMeasurementTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void numbersAreThoseOfTheStudy() {
    const FigureDescription figure = quickFigure();
    const FigureMeasurement measurement = measureFigure(figure);
    QCOMPARE(measurement.rows.size(), std::size_t(2));
    QCOMPARE(measurement.rows[0].name, std::string("chrome"));
    QCOMPARE(measurement.rows[1].name, std::string("rubber"));
    QCOMPARE(rowLabel(figure, measurement, 1), std::string("blue rubber"));
    double maximum = 0;
    for (std::size_t row = 0; row < 2; ++row) {
      const FigureRow& shown = measurement.rows[row];
      const auto alone = studied(figure, row);
      QCOMPARE(shown.cells.size(), alone.size());
      std::vector<Image> pictures;
      for (std::size_t i = 0; i < alone.size(); ++i) {
        const FigureCell& cell = *shown.cells[i];
        QVERIFY(cell.picture.pixels == alone[i].picture.pixels);
        QCOMPARE(cell.value("rendered-snr"), alone[i].record.renderedSnr);
        QCOMPARE(cell.value("flip"), metrics::imageErrors(*shown.reference, alone[i].picture)[4]);
        QCOMPARE(cell.value("log"), alone[i].record.errors[0]);
        QCOMPARE(cell.value("bytes"), double(alone[i].record.bytes));
        QVERIFY(std::isnan(cell.value("frame-time")));
        pictures.push_back(alone[i].picture);
      }
      maximum = std::max(maximum, errorRange(*shown.reference, pictures));
    }
    // One scale for all: the largest of those that the rows have by themselves.
    QVERIFY(maximum > 0);
    QCOMPARE(errorMaximum(figure, measurement), maximum);
  }

  /// Another scene gives other pictures, and the scale that was asked for.
  void sceneAndScale() {
    FigureDescription figure = quickFigure();
    figure.materials.resize(1);
    figure.representations.resize(1);
    const Image studio = *measureFigure(figure).rows[0].reference;
    figure.pictures.environment = "furnace";
    figure.errorMaximum = 0.125;
    const FigureMeasurement furnace = measureFigure(figure);
    QVERIFY(furnace.rows[0].reference->pixels != studio.pixels);
    QCOMPARE(errorMaximum(figure, furnace), 0.125);
    figure.pictures.scene = "no such scene";
    QVERIFY_EXCEPTION_THROWN(measureFigure(figure), Error);
  }

  void timesAreMeasuredOnDemand() {
    FigureDescription figure = quickFigure();
    figure.materials.resize(1);
    figure.representations.resize(1);
    figure.numbers = {"encoding-time", "evaluation-time", "frame-time"};
    const FigureMeasurement measurement = measureFigure(figure);
    for (const std::string& id : figure.numbers) {
      const double seconds = measurement.rows[0].cells[0]->value(id);
      QVERIFY(seconds > 0 && seconds < 100);
    }
  }

  /// Changes of labels, layout, exposure, numbers and order, and fewer cells, need no measurement.
  void whatIsKnownIsNotMeasuredAgain() {
    FigureDescription figure = quickFigure();
    const FigureMeasurement first = measureFigure(figure);
    figure.materials[0].label = "mirror";
    figure.width = FigureWidth::oneColumn;
    figure.pictures.exposure = 1;
    figure.pictures.toneMap = ToneMap::filmic;
    figure.inset = FigureInset{};
    figure.errorMaximum = 0.5;
    figure.numbers = {"ssim", "lab"};
    std::ranges::reverse(figure.materials);
    std::ranges::reverse(figure.representations);
    const FigureMeasurement part = knownPart(figure, first);
    QCOMPARE(part.missingCells(), std::size_t(0));
    QVERIFY(part.rows[1].cells[0] == first.rows[0].cells[1]);
    int measured = 0;
    const FigureMeasurement again =
        measureFigure(figure, {}, {.known = first, .measured = [&](const FigureMeasurement&) { ++measured; }});
    QCOMPARE(measured, 0);
    QCOMPARE(rowLabel(figure, again, 1), std::string("mirror"));
    QVERIFY(again.rows[1].reference == first.rows[0].reference);
  }

  /// Cells are missing after a change of scene, samples or size, and if times are added.
  void whatChangesTheMeasurementIsMissing() {
    const FigureDescription figure = quickFigure();
    const FigureMeasurement known = test::madeUpMeasurement(figure);
    const auto missing = [&](const auto& change) {
      FigureDescription changed = figure;
      change(changed);
      return knownPart(changed, known).missingCells();
    };
    QCOMPARE(missing([](FigureDescription& f) { f.pictures.size = 17; }), std::size_t(4));
    QCOMPARE(missing([](FigureDescription& f) { f.pictures.samples = 5; }), std::size_t(4));
    QCOMPARE(missing([](FigureDescription& f) { f.pictures.scene = "row"; }), std::size_t(4));
    QCOMPARE(missing([](FigureDescription& f) { f.pictures.environment = "sky"; }), std::size_t(4));
    QCOMPARE(missing([](FigureDescription& f) { f.numbers = {"frame-time"}; }), std::size_t(4));
    QCOMPARE(missing([](FigureDescription& f) { f.materials.push_back({"library:sgd/chrome", ""}); }), std::size_t(6));
    FigureDescription bundled = figure;
    bundled.materials = {{"library:sgd/chrome", ""}};
    const FigureMeasurement one = test::madeUpMeasurement(bundled);
    QCOMPARE(knownPart(bundled, one).missingCells(), std::size_t(0));
    bundled.representations[0].representation = study::representationById("code", 64);
    QCOMPARE(knownPart(bundled, one).missingCells(), std::size_t(1));
  }

  /// Only materials with a changed file are measured again.
  void changedFilesAreMeasuredAgain() {
    const FigureDescription figure = quickFigure();
    const FigureMeasurement first = measureFigure(figure);
    const std::filesystem::path path = figure.materials[1].path;
    std::filesystem::last_write_time(path, std::filesystem::last_write_time(path) + std::chrono::seconds(1));
    const FigureMeasurement part = knownPart(figure, first);
    QVERIFY(part.rows[0].isComplete() && !part.rows[1].cells[0] && !part.rows[1].reference);
  }

  /// The measured file of a document counts too.
  void changedSourcesOfDocumentsAreMeasuredAgain() {
    FigureDescription figure = quickFigure();
    const std::filesystem::path table = figure.materials[0].path,
                                document = table.parent_path() / "edited-chrome.gonio";
    documents::writeDocument({.sourcePath = table.string(), .sourceSha256 = std::string(64, 'a')}, document);
    figure.materials = {{document.string(), ""}};
    FigureMeasurement known = test::madeUpMeasurement(figure);
    known.fileTimes = knownPart(figure, {}).fileTimes;
    QCOMPARE(knownPart(figure, known).missingCells(), std::size_t(0));
    std::filesystem::last_write_time(table, std::filesystem::last_write_time(table) + std::chrono::seconds(1));
    QCOMPARE(knownPart(figure, known).missingCells(), figure.representations.size());
  }

  /// Measuring cell by cell gives the same bits as measuring all cells at once.
  void partByPartIsTheSame() {
    FigureDescription figure = quickFigure();
    figure.materials.resize(1);
    figure.representations = {{study::representationById("factors-3d", 1), ""},
                              {study::representationById("factors-3d", 3), ""},
                              {study::representationById("ggx"), ""},
                              {study::representationById("factors-3d", 3), "again"}};
    const FigureMeasurement whole = measureFigure(figure);
    FigureDescription part = figure;
    FigureMeasurement known;
    for (std::size_t count = 1; count <= figure.representations.size(); ++count) {
      part.representations.assign(figure.representations.begin(),
                                  figure.representations.begin() + std::ptrdiff_t(count));
      std::size_t reported = 0;
      known = measureFigure(part, {}, {.known = known, .measured = [&](const FigureMeasurement& soFar) {
                                         ++reported;
                                         QCOMPARE(soFar.missingCells(), std::size_t(0));
                                       }});
      QCOMPARE(reported, std::size_t(count < 4));  // the last one is known
    }
    for (std::size_t i = 0; i < whole.rows[0].cells.size(); ++i) {
      const FigureCell &a = *whole.rows[0].cells[i], &b = *known.rows[0].cells[i];
      QVERIFY(a.picture.pixels == b.picture.pixels);
      for (const FigureNumber& number : figureNumbers())
        if (!number.isTimed) QCOMPARE(a.value(number.id), b.value(number.id));
    }
    QVERIFY(whole.rows[0].cells[1] == whole.rows[0].cells[3]);
  }

  void cancelAndProgress() {
    const FigureDescription figure = quickFigure();
    double last = 0;
    bool falls = false;
    measureFigure(figure, {{}, [&](double fraction) {
                             falls = falls || fraction < last || fraction > 1;
                             last = fraction;
                           }});
    QVERIFY(!falls);
    QCOMPARE(last, 1.0);
    for (const double when : {0.0, 0.3, 0.8}) {
      std::stop_source source;
      const TaskControl control{source.get_token(), [&](double fraction) {
                                  if (fraction >= when) source.request_stop();
                                }};
      QVERIFY_EXCEPTION_THROWN(measureFigure(figure, control), Cancelled);
    }
  }

  void emptyDescriptionsAreRefused() {
    FigureDescription figure = quickFigure();
    figure.representations.clear();
    QVERIFY_EXCEPTION_THROWN(measureFigure(figure), Error);
    figure = quickFigure();
    figure.materials.clear();
    QVERIFY_EXCEPTION_THROWN(measureFigure(figure), Error);
  }
};

GONIO_TEST(FigureMeasurementTest)
}  // namespace figure_measurement_test

#include "figure_measurement_test.moc"
