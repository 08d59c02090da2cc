// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>

#include "app/gonio/figures/figure_file_buttons.h"
#include "core/figures/draw_figure.h"
#include "core/figures/figure_formats.h"
#include "core/figures/figure_tables.h"
#include "tests/app/gonio/figure_test_support.h"
#include "tests/support/test_program.h"
#include "widgets/figures/figure_page.h"

namespace figure_making_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::app;
using namespace gonio::app::test_support;
using figures::FigureDescription;

/// What the page of a view shows of a figure: the core's drawing of what is measured, at the page's resolution.
QImage expectedPage(FigureView& view, const FigureDescription& description) {
  const figures::FigureMeasurement part = figures::knownPart(description, view.controller().known());
  const figures::TextWidth width = figures::cairoTextWidth(description.font);
  const double pageWidth = figures::figureLayout(description, part, width).width;
  const figures::Raster raster =
      figures::figureRaster(figures::drawFigure(description, part, width), view.page().pageWidth() / pageWidth * 25.4);
  widgets::FigurePage page;
  page.setPalette(view.page().palette());
  page.resize(view.page().size());
  page.setPage(QImage(raster.rgba.data(), raster.width, raster.height, 4 * raster.width, QImage::Format_RGBA8888), {});
  return page.grab().toImage();
}

/// Measuring a figure, and its files.
class FigureMakingTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The page is grey, fills with each cell, and then follows every change that needs no other measurement.
  void measuresOnce() {
    FigureEditor editor;
    const auto dialog = editor.dialog();
    FigureDescription figure = editor.smallFigure();
    dialog->setDescription(figure);
    QVERIFY(editor.settled(*dialog));
    const FigureController& controller = dialog->view().controller();
    QImage page = dialog->view().page().grab().toImage();
    measureButton(*dialog).click();
    QVERIFY(controller.isMeasuring());
    QCOMPARE(measureButton(*dialog).text().remove('&'), QString("Stop"));
    QVERIFY(editor.settled(*dialog));
    QVERIFY2(dialog->view().status().startsWith("Every cell is measured"), qPrintable(dialog->view().status()));
    QVERIFY(dialog->view().page().grab().toImage() != page);
    QVERIFY(dialog->view().page().grab().toImage() == expectedPage(dialog->view(), figure));
    const figures::FigureMeasurement measured = controller.known();
    const auto redraws = [&](const auto& change) {
      page = dialog->view().page().grab().toImage();
      change(figure);
      dialog->setDescription(figure);
      if (controller.isMeasuring() || !editor.settled(*dialog)) return false;
      const QImage drawn = dialog->view().page().grab().toImage();
      return drawn != page && drawn == expectedPage(dialog->view(), figure) &&
             dialog->view().status().startsWith("Every cell");
    };
    QVERIFY(redraws([](FigureDescription& f) { f.materials[0].label = "mirror"; }));
    QVERIFY(redraws([](FigureDescription& f) { f.representations[0].label = "theirs"; }));
    QVERIFY(redraws([](FigureDescription& f) { f.numbers = {"flip", "log", "ssim"}; }));
    QVERIFY(redraws([](FigureDescription& f) { f.width = figures::FigureWidth::oneColumn; }));
    QVERIFY(redraws([](FigureDescription& f) { f.fontSize = 5; }));
    QVERIFY(redraws([](FigureDescription& f) { f.inset = figures::FigureInset{}; }));
    QVERIFY(redraws([](FigureDescription& f) { f.errorMaximum = 0.5; }));
    QVERIFY(redraws([](FigureDescription& f) { f.pictures.exposure = 1; }));
    QVERIFY(redraws([](FigureDescription& f) { f.pictures.toneMap = ToneMap::filmic; }));
    QVERIFY(redraws([](FigureDescription& f) { std::ranges::reverse(f.materials); }));
    QVERIFY(redraws([](FigureDescription& f) { f.representations.pop_back(); }));
    QVERIFY(controller.known().rows[0].cells == measured.rows[0].cells);
    figure.pictures.samples = 5;
    dialog->setDescription(figure);
    QVERIFY(editor.settled(*dialog));
    QVERIFY(dialog->view().status().startsWith("2 of 2 cells are not measured"));
  }

  /// Results from before a cancellation remain, and the measurement continues from there.
  void cancelKeepsTheCells() {
    FigureEditor editor;
    const auto dialog = editor.dialog();
    FigureDescription figure = editor.smallFigure();
    figure.pictures.size = 64;
    figure.pictures.samples = 64;
    dialog->setDescription(figure);
    QVERIFY(editor.settled(*dialog));
    measureButton(*dialog).click();
    const FigureController& controller = dialog->view().controller();
    QVERIFY(editor.wait([&] { return !controller.known().rows.empty(); }));
    QTest::keyClick(dialog.get(), Qt::Key_Escape);
    QVERIFY(dialog->isVisible());
    QVERIFY(editor.settled(*dialog));
    const auto first = controller.known().rows[0].cells[0];
    QVERIFY(first);
    measureButton(*dialog).click();
    QVERIFY(editor.settled(*dialog));
    QVERIFY(dialog->view().status().startsWith("Every cell"));
    QVERIFY(controller.known().rows[0].cells[0] == first);
  }

  void whatFailsIsStated() {
    FigureEditor editor;
    const auto dialog = editor.dialog();
    FigureDescription figure = editor.smallFigure();
    figure.materials[1].path = editor.path("absent.binary").toStdString();
    dialog->setDescription(figure);
    QVERIFY(editor.settled(*dialog));
    measureButton(*dialog).click();
    QVERIFY(editor.settled(*dialog));
    const QString status = dialog->view().status();
    QVERIFY2(status.startsWith("Cannot measure the cells of the figure: ") && status.contains("absent.binary"),
             qPrintable(status));
    // The cells of the first material are measured nevertheless.
    QCOMPARE(dialog->view().controller().known().missingCells(), std::size_t(2));
  }

  /// The files equal those of goniotool figure for the saved description. Saving measures missing cells, and the page
  /// shows them.
  void filesAreThoseOfTheDescription() {
    FigureEditor editor;
    const auto dialog = editor.dialog();
    FigureDescription figure = editor.smallFigure();
    figure.inset = figures::FigureInset{};
    dialog->setDescription(figure);
    FigureController& controller = dialog->view().controller();
    const FigureToWrite written{dialog->description(), controller.known(), controller.collector()};
    editor.exports.save(editor.path("figure.json"), figureDescriptionSave(dialog->description()));
    for (const char* name : {"a.pdf", "a.svg", "a.PNG"}) editor.exports.save(editor.path(name), figureSave(written));
    for (const char* name : {"a.csv", "a.tex"}) editor.exports.save(editor.path(name), figureNumbersSave(written));
    QVERIFY(editor.wait([&] { return editor.exported.count() + editor.failed.count() == 6; }));
    QVERIFY2(editor.failed.isEmpty(), qPrintable(editor.failed.value(0).value(1).toString()));
    QVERIFY(editor.settled(*dialog));
    QVERIFY(dialog->view().status().startsWith("Wrote "));
    QVERIFY(controller.known().missingCells() == 0 && !measureButton(*dialog).isEnabled());

    const FigureDescription read = figures::readFigureDescription(editor.path("figure.json").toStdString());
    QVERIFY(read == figure);
    QVERIFY(editor.bytes("figure.json").contains("\"path\": \"chrome.binary\""));
    const figures::FigureMeasurement measurement = figures::measureFigure(read);
    const auto same = [&](const char* name, figures::FigureFormat format) {
      const auto expected = figures::figureFile(read, measurement, format);
      const QByteArray bytes = editor.bytes(name);
      return bytes == QByteArray(reinterpret_cast<const char*>(expected.data()), qsizetype(expected.size()));
    };
    QVERIFY(same("a.pdf", figures::FigureFormat::pdf));
    QVERIFY(same("a.svg", figures::FigureFormat::svg));
    QVERIFY(same("a.PNG", figures::FigureFormat::png));
    QCOMPARE(editor.bytes("a.csv").toStdString(), io::toCsv(figures::figureCsv(read, measurement)));
    QCOMPARE(editor.bytes("a.tex").toStdString(), figures::figureLatex(read, measurement));
  }

  /// No saved file overwrites a material of the figure or the source of the open document.
  void sourcesAreNeverReplaced() {
    FigureEditor editor;
    editor.open("chrome");
    const auto dialog = editor.dialog();
    FigureDescription figure = editor.smallFigure();
    const FigureToWrite written{figure, {}};
    const QByteArray chrome = editor.bytes("chrome.binary"), rubber = editor.bytes("rubber.binary");
    QFile::link(editor.path("rubber.binary"), editor.path("link.csv"));
    editor.exports.save(editor.path("chrome.binary"), figureDescriptionSave(figure));
    editor.exports.save(editor.path("rubber.binary"), figureDescriptionSave(figure));
    editor.exports.save(editor.path("link.csv"), figureNumbersSave(written));
    QVERIFY(editor.wait([&] { return editor.failed.count() + editor.exported.count() == 3; }));
    QCOMPARE(editor.failed.count(), 3);
    QCOMPARE(editor.failed[1][1].toString(),
             editor.path("rubber.binary") + ": the figure is made from this file, expected another name");
    QVERIFY(editor.bytes("chrome.binary") == chrome && editor.bytes("rubber.binary") == rubber);
    QVERIFY(editor.exported.isEmpty());
  }

  /// Wrong file names are rejected before the measurement.
  void wrongNamesAreRefused() {
    FigureEditor editor;
    FigureDescription figure = editor.smallFigure();
    figure.pictures.samples = 1 << 20;
    const FigureToWrite written{figure, {}};
    editor.exports.save(editor.path("a.eps"), figureSave(written));
    editor.exports.save(editor.path("a.txt"), figureNumbersSave(written));
    editor.exports.save(editor.path("absent/a.pdf"), figureSave(written));
    QVERIFY(editor.wait([&] { return editor.failed.count() + editor.exported.count() == 3; }));
    QCOMPARE(editor.failed.count(), 3);
    const auto text = [&](int i) { return editor.failed[i][1].toString(); };
    QVERIFY(text(0).endsWith("a.eps: found the suffix '.eps', expected .pdf, .svg or .png"));
    QVERIFY(text(1).endsWith("a.txt: found the suffix '.txt', expected .csv or .tex"));
    QVERIFY(text(2).contains("absent/a.pdf"));
  }

  /// A file that is cancelled during its measurement is not written.
  void aStoppedFileIsNotWritten() {
    FigureEditor editor;
    QSignalSpy cancelled(&editor.exports, &FileExports::cancelled);
    FigureDescription figure = editor.smallFigure();
    figure.pictures.samples = 1 << 18;
    editor.exports.save(editor.path("a.pdf"), figureSave({figure, {}}));
    QVERIFY(editor.tasks.isWritingFiles());
    QTest::qWait(200);
    editor.tasks.cancelTopmost();
    QVERIFY(editor.wait([&] { return cancelled.count() == 1; }));
    QVERIFY(!QFile::exists(editor.path("a.pdf")));
  }
};

GONIO_TEST(FigureMakingTest)
}  // namespace figure_making_test

#include "figure_making_test.moc"
