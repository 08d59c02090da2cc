// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/figures/figure_measurement.h"

#include <QTest>
#include <algorithm>
#include <filesystem>

#include "core/figures/draw_figure.h"
#include "core/materials/material.h"
#include "core/metrics/image_errors.h"
#include "core/rendering/error_maps.h"
#include "core/study/accuracy_study.h"
#include "tests/core/figures/small_figure.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace figure_measurement_test {
using namespace gonio;
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
    if (!std::filesystem::exists(path)) materials::writeMaterial(*table, path);
  }
  figure.materials = {{(folder / "chrome.binary").string(), ""}, {(folder / "rubber.binary").string(), "blue rubber"}};
  return figure;
}

/// What the study of one material finds, by itself.
std::vector<study::StudiedRepresentation> studied(const FigureDescription& figure, std::size_t row) {
  const materials::Material material = materials::readMaterial(figure.materials[row].path);
  std::vector<study::StudiedRepresentation> all;
  study::StudyOptions options;
  options.picture = {.width = figure.pictures.size, .height = figure.pictures.size, .samples = figure.pictures.samples};
  options.timed = false;
  options.measured = [&](const study::StudiedRepresentation& one) { all.push_back(one); };
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
    QCOMPARE(measurement.rows[1].name, std::string("blue rubber"));
    double maximum = 0;
    for (std::size_t row = 0; row < 2; ++row) {
      const FigureRow& shown = measurement.rows[row];
      const auto alone = studied(figure, row);
      QCOMPARE(shown.cells.size(), alone.size());
      std::vector<Image> pictures;
      for (std::size_t i = 0; i < alone.size(); ++i) {
        const std::vector<double>& numbers = shown.cells[i].numbers;
        QVERIFY(shown.cells[i].picture.pixels == alone[i].picture.pixels);
        QCOMPARE(numbers[0], alone[i].record.renderedSnr);
        QCOMPARE(numbers[1], metrics::imageErrors(shown.reference, alone[i].picture)[4]);
        QCOMPARE(numbers[2], alone[i].record.errors[0]);
        QCOMPARE(numbers[3], double(alone[i].record.bytes));
        pictures.push_back(alone[i].picture);
      }
      maximum = std::max(maximum, errorMaps(shown.reference, pictures).range);
    }
    // One scale for all: the largest of those that the rows have by themselves.
    QVERIFY(maximum > 0);
    QCOMPARE(measurement.errorMaximum, maximum);
  }

  /// Another scene gives other pictures, and the scale that was asked for.
  void sceneAndScale() {
    FigureDescription figure = quickFigure();
    figure.materials.resize(1);
    figure.representations.resize(1);
    const Image studio = measureFigure(figure).rows[0].reference;
    figure.pictures.environment = "furnace";
    figure.errorMaximum = 0.125;
    const FigureMeasurement furnace = measureFigure(figure);
    QVERIFY(furnace.rows[0].reference.pixels != studio.pixels);
    QCOMPARE(furnace.errorMaximum, 0.125);
    figure.pictures.scene = "no such scene";
    QVERIFY_EXCEPTION_THROWN(measureFigure(figure), Error);
  }

  void timesAreMeasuredOnDemand() {
    FigureDescription figure = quickFigure();
    figure.materials.resize(1);
    figure.representations.resize(1);
    figure.numbers = {"encoding-time", "evaluation-time", "frame-time"};
    for (const double seconds : measureFigure(figure).rows[0].cells[0].numbers) QVERIFY(seconds > 0 && seconds < 100);
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
