// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/figures/figure_dialog.h"

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTabBar>
#include <QTest>

#include "app/gonio/figures/figure_file_buttons.h"
#include "app/gonio/figures/figure_materials.h"
#include "app/gonio/figures/figure_numbers.h"
#include "app/gonio/figures/figure_page_settings.h"
#include "app/gonio/figures/figure_view.h"
#include "core/figures/figure_description.h"
#include "tests/app/gonio/figure_test_support.h"
#include "tests/support/test_program.h"
#include "widgets/figures/entry_list.h"
#include "widgets/figures/figure_page.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/plain_text_style.h"
#include "widgets/library/material_drag.h"

namespace figure_dialog_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;
using figures::FigureDescription;

class FigureDialogTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void withoutAMaterial() {
    FigureEditor editor;
    const auto dialog = editor.dialog();
    QVERIFY(dialog->view().page().message().startsWith("Add materials"));
    QVERIFY(!measureButton(*dialog).isEnabled());
    for (const char* text : {"Save Figure", "Save Numbers", "Save Description"})
      QVERIFY(!buttonOf(*dialog, text)->isEnabled());
    QVERIFY(buttonOf(*dialog, "Open Description")->isEnabled());
    QVERIFY(!entryOf(dialog->materials().list().addMenu(), "The Open Material")->isEnabled());
    QVERIFY(!entryOf(dialog->representations().list().addMenu(), "Current Fit")->isEnabled());
    QVERIFY(editor.tasks.isIdle());
  }

  /// The open material with the current fit, factors and a code; the page is shown before anything is measured.
  void startsWithTheOpenMaterial() {
    FigureEditor editor;
    editor.open("chrome");
    editor.useFit("ward");
    const auto dialog = editor.dialog();
    const FigureDescription figure = dialog->description();
    QCOMPARE(figure.materials.size(), std::size_t(1));
    QCOMPARE(figure.materials[0].path, editor.path("chrome.binary").toStdString());
    QCOMPARE(labelsOf(dialog->representations().list()),
             QStringList({"Ward", "PDV factors, three curves, 10 terms", "Sparse code, 256 coefficients"}));
    QVERIFY(editor.settled(*dialog));
    QVERIFY(dialog->view().page().placeOf(0).isValid() && dialog->view().page().message().isEmpty());
    QVERIFY(dialog->view().status().startsWith("3 of 3 cells are not measured"));
    QVERIFY(editor.tasks.isIdle());
  }

  /// All representations of the study can be added, with their budgets, and edited.
  void rowsAndColumns() {
    FigureEditor editor;
    editor.open("chrome");
    editor.useFit("ggx");
    editor.selected = {"library:sgd/chrome", editor.path("rubber.binary"), "library:sgd/chrome"};
    const auto dialog = editor.dialog();
    FigureMaterials& materials = dialog->materials();
    entryOf(materials.list().addMenu(), "Library Selection (3)")->trigger();
    QVERIFY(!entryOf(materials.list().addMenu(), "The Open Material")->isEnabled());
    QVERIFY(!entryOf(materials.list().addMenu(), "Library Selection (0)")->isEnabled());
    QCOMPARE(labelsOf(materials.list()), QStringList({"chrome", "chrome", "rubber"}));
    const std::unique_ptr<QMimeData> drag(widgets::toDrag("library:sgd/nickel"));
    QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, drag.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&materials, &enter);
    QDropEvent drop(QPointF(9, 9), Qt::CopyAction, drag.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&materials, &drop);
    QCOMPARE(labelsOf(materials.list()).last(), QString("nickel"));
    Q_EMIT materials.list().moveRequested(3, 2);
    Q_EMIT materials.list().removeRequested(1);
    Q_EMIT materials.list().model().labelEdited(0, "mirror");
    QCOMPARE(labelsOf(materials.list()), QStringList({"mirror", "nickel", "rubber"}));
    QCOMPARE(dialog->description().materials[1].path, std::string("library:sgd/nickel"));

    widgets::EntryList& columns = dialog->representations().list();
    entryOf(columns.addMenu(), "Current Fit (GGX)")->trigger();
    for (const char* text : {"5 terms", "512 coefficients", "Cook-Torrance", "Non-parametric", "Table, trilinear"})
      entryOf(columns.addMenu(), text)->trigger();
    QVERIFY(entryOf(columns.addMenu(), "up to 44680 bytes"));  // baselines are offered too
    Q_EMIT columns.model().budgetEdited(1, 7);
    const auto figure = dialog->description();
    QCOMPARE(figure.representations.size(), std::size_t(9));
    QCOMPARE(figure.representations[1].representation.budget, 7.0);
    QCOMPARE(labelsOf(columns)[1], QString("PDV factors, three curves, 7 terms"));
    QCOMPARE(figure.representations[4].representation, study::representationById("factors-2d", 5));
    QCOMPARE(figure.representations[8].representation.id(), std::string("table-trilinear"));
    QVERIFY(editor.settled(*dialog));
    QVERIFY(dialog->view().status().startsWith("27 of 27 cells"));
  }

  /// The numbers are in the order in which they are checked; their count is limited.
  void numbersAsTicked() {
    FigureEditor editor;
    editor.open("chrome");
    const auto dialog = editor.dialog();
    QListWidget& list = dialog->numbers().list();
    QCOMPARE(list.count(), int(figures::figureNumbers().size()));
    const auto tick = [&](int row, bool on) { list.item(row)->setCheckState(on ? Qt::Checked : Qt::Unchecked); };
    tick(0, false);
    tick(4, true);
    tick(0, true);
    const std::vector<std::string> expected{"bytes", "evaluation-time", figures::figureNumbers()[4].id, "rendered-snr"};
    QVERIFY(dialog->description().numbers == expected);
    for (int row = 0; row < list.count(); ++row)
      if (list.item(row)->flags() & Qt::ItemIsEnabled) tick(row, true);
    QCOMPARE(dialog->description().numbers.size(), FigureDescription::maxNumbers);
    for (int row = 0; row < list.count(); ++row)
      QVERIFY(!list.item(row)->data(widgets::richToolTipRole).toString().isEmpty());
  }

  /// The dialog returns a description unchanged, also numbers with more digits than a field shows.
  void descriptionsComeBack() {
    FigureEditor editor;
    const auto dialog = editor.dialog();
    const FigureDescription figure = detailedFigure();
    dialog->setDescription(figure);
    QVERIFY(dialog->description() == figure);
    dialog->setDescription({});
    QVERIFY(dialog->description() == FigureDescription());
    dialog->setDescription(figure);
    Q_EMIT dialog->materials().list().model().labelEdited(0, "other");
    FigureDescription changed = figure;
    changed.materials[0].label = "other";
    QVERIFY(dialog->description() == changed);
  }

  /// A square drawn on a picture of the page becomes the inset.
  void drawsTheInset() {
    FigureEditor editor;
    editor.open("chrome");
    const auto dialog = editor.dialog();
    QVERIFY(editor.settled(*dialog));
    widgets::FigurePage& page = dialog->view().page();
    const QRectF place = page.placeOf(2);
    const auto at = [&](double x, double y) {
      return QPointF(place.x() + x * place.width(), place.y() + y * place.height()).toPoint();
    };
    QTest::mousePress(&page, Qt::LeftButton, {}, at(0.25, 0.5));
    QMouseEvent move(QEvent::MouseMove, at(0.5, 0.75), page.mapToGlobal(at(0.5, 0.75)), Qt::NoButton, Qt::LeftButton,
                     {});
    QCoreApplication::sendEvent(&page, &move);
    QTest::mouseRelease(&page, Qt::LeftButton, {}, at(0.5, 0.75));
    const auto inset = dialog->description().inset;
    QVERIFY(inset);
    QVERIFY(std::abs(inset->x - 0.25) < 0.02 && std::abs(inset->y - 0.5) < 0.02 && std::abs(inset->size - 0.25) < 0.02);
    QVERIFY(editor.settled(*dialog));
    // The page is that of a figure that was opened with this inset, and no longer that of one without.
    const QImage drawn = page.grab().toImage();
    FigureDescription figure = dialog->description();
    const auto pictureOf = [&](const FigureDescription& description) {
      dialog->setDescription(description);
      return editor.settled(*dialog) ? page.grab().toImage() : QImage();
    };
    figure.inset = std::nullopt;
    QVERIFY(pictureOf(figure) != drawn);
    figure.inset = inset;
    QVERIFY(pictureOf(figure) == drawn);
  }

  /// An inset that is enlarged moves, so that it stays inside the picture.
  void insetsStayInThePicture() {
    FigureEditor editor;
    const auto dialog = editor.dialog();
    dialog->page().setInset({.x = 0.7, .y = 0.1, .size = 0.25});
    for (auto* field : dialog->page().findChildren<widgets::NumberField*>())
      if (field->accessibleName() == "Inset, side") {
        field->setText("0.5");
        Q_EMIT field->editingFinished();
        QTest::keyClick(field, Qt::Key_Return);
      }
    const auto inset = dialog->description().inset;
    QCOMPARE(inset->size, 0.5);
    QCOMPARE(inset->x, 0.5);
    QCOMPARE(inset->y, 0.1);
  }

  /// The page states why a figure cannot be drawn, and shows it again when it can.
  void tooManyColumns() {
    FigureEditor editor;
    editor.open("chrome");
    const auto dialog = editor.dialog();
    FigureDescription figure = dialog->description();
    figure.representations.assign(FigureDescription::maxRepresentations, {study::representationById("ggx")});
    figure.width = figures::FigureWidth::oneColumn;
    dialog->setDescription(figure);
    QVERIFY(editor.settled(*dialog));
    QVERIFY(dialog->view().page().message().contains("found 12 representations in a figure 84 mm wide"));
    QVERIFY(!measureButton(*dialog).isEnabled());
    figure.width = figures::FigureWidth::twoColumns;
    dialog->setDescription(figure);
    QVERIFY(editor.settled(*dialog));
    QVERIFY(dialog->view().page().message().isEmpty());
  }

  void unsavedEditsAreMentioned() {
    FigureEditor editor;
    editor.open("chrome");
    const auto dialog = editor.dialog();
    const auto isMentioned = [&] {
      for (const QLabel* label : dialog->materials().findChildren<QLabel*>())
        if (label->text().startsWith("Unsaved edits of chrome")) return true;
      return false;
    };
    QVERIFY(!isMentioned());
    editor.editRoughness();
    QVERIFY(isMentioned());
    editor.document.history().undo();
    QVERIFY(!isMentioned());
  }

  /// The next figure starts with the open material and the settings of the last one.
  void remembersTheLastFigure() {
    FigureEditor editor;
    editor.open("chrome");
    const FigureDescription figure = detailedFigure();
    editor.dialog()->setDescription(figure);
    FigureDescription expected = figure;
    expected.materials = {{editor.path("chrome.binary").toStdString(), ""}};
    QVERIFY(editor.dialog()->description() == expected);
    editor.settings.setValue("figure/description", "{\"format\": 7}");
    QCOMPARE(editor.dialog()->description().representations.size(), std::size_t(3));
  }

  /// Descriptions are read in the background. An error names the file, what was found and what was expected.
  void opensDescriptions() {
    FigureEditor editor;
    const auto dialog = editor.dialog();
    FigureDescription figure = detailedFigure();
    editor.write("good.json", figures::figureDescriptionText(figure, editor.path("good.json").toStdString()));
    dialog->files().open(editor.path("good.json"));
    QVERIFY(editor.wait([&] { return dialog->description() == figure; }));
    editor.write("bad.json", R"({"format": "gonio figure", "version": 2})");
    dialog->files().open(editor.path("bad.json"));
    QVERIFY(editor.wait([&] { return dialog->findChild<QMessageBox*>() != nullptr; }));
    const QString text = dialog->findChild<QMessageBox*>()->informativeText();
    QVERIFY2(text.startsWith(editor.path("bad.json") + ": version: found") && text.contains("expected 1"),
             qPrintable(text));
    QVERIFY(dialog->description() == figure);
  }

  /// Each Alt key goes to one place, whichever tab is in front.
  void altKeysAreUnique() {
    FigureEditor editor;
    const auto dialog = editor.dialog();
    QStringList texts;
    for (const auto* tabs : dialog->findChildren<QTabBar*>())
      for (int i = 0; i < tabs->count(); ++i) texts << tabs->tabText(i);
    for (const auto* button : dialog->findChildren<QAbstractButton*>()) texts << button->text();
    for (const auto* label : dialog->findChildren<QLabel*>())
      if (label->buddy()) texts << label->text();
    QMap<QChar, QString> keys;
    for (const QString& text : texts)
      if (const auto at = text.indexOf('&'); at >= 0) {
        const QChar key = text[at + 1].toUpper();
        QVERIFY2(!keys.contains(key), qPrintable(text + " and " + keys[key]));
        keys[key] = text;
      }
    QVERIFY(keys.size() > 20);
  }

  /// Closing the dialog ends its tasks.
  void closingEndsTheWork() {
    FigureEditor editor;
    editor.open("chrome");
    {
      const auto dialog = editor.dialog();
      QVERIFY(editor.settled(*dialog));
      measureButton(*dialog).click();
      QVERIFY(!editor.tasks.isIdle());
    }
    QVERIFY(editor.tasks.isIdle());
  }
};

GONIO_TEST(FigureDialogTest)
}  // namespace figure_dialog_test

#include "figure_dialog_test.moc"
