// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/main_window.h"

#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QStandardPaths>
#include <QTabBar>
#include <QTest>
#include <QWheelEvent>

#include "app/gonio/acquisition/acquisition_panel.h"
#include "app/gonio/document/edit_steps.h"
#include "app/gonio/document/material_files.h"
#include "app/gonio/inspector/inspector.h"
#include "app/gonio/window/action_table.h"
#include "app/gonio/window/command_search.h"
#include "app/gonio/window/dock_layout.h"
#include "app/gonio/window/help.h"
#include "app/gonio/window/start_page.h"
#include "core/materials/bundled_library.h"
#include "core/models/model.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/support/test_program.h"
#include "tests/widgets/child.h"
#include "tests/widgets/offscreen_context.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"
#include "widgets/library/library_view.h"
#include "widgets/panels/edit_stack.h"
#include "widgets/parameters/control_panel.h"
#include "widgets/parameters/formula_text.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_row.h"
#include "widgets/parameters/parameter_text.h"
#include "widgets/preview/preview_overlay.h"
#include "widgets/preview/preview_widget.h"

namespace main_window_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

/// Runs an action of the menus, e.g. "File > New Window".
void run(MainWindow& window, const QString& path) {
  for (const NamedAction& named : window.actionTable().all())
    if (named.path == path) return named.action->trigger();
  QFAIL(qPrintable(path));
}

/// The command search that Ctrl+K opens.
CommandSearch& openSearch(MainWindow& window) {
  run(window, "Help > Search");
  return *window.findChildren<CommandSearch*>().back();
}

/// What the command search lists for a text.
QStringList found(MainWindow& window, const QString& text) {
  CommandSearch& search = openSearch(window);
  search.findChild<QLineEdit*>()->setText(text);
  const auto* list = search.findChild<QListWidget*>();
  QStringList texts;
  for (int i = 0; i < list->count(); ++i) texts << list->item(i)->text();
  delete &search;
  return texts;
}

class MainWindowTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    const test::OffscreenContext context;
    if (!context.isValid()) QSKIP("needs an OpenGL 4.1 context");
  }

  void everyActionHasATextAndShortcutsAreUnique() {
    auto* window = new MainWindow;
    QMap<QString, QAction*> byKey;
    for (const NamedAction& named : window->actionTable().all())
      for (const QKeySequence& key : named.action->shortcuts()) {
        const QString text = key.toString();
        QVERIFY2(!byKey.contains(text) || byKey[text] == named.action, qPrintable(named.path + " " + text));
        byKey[text] = named.action;
      }
    QVERIFY(byKey.contains("Ctrl+Z") && byKey.contains("Ctrl+K") && byKey.contains("F11"));
    // The help is made from the same actions.
    const QString page = shortcutsPage(window->actionTable().all());
    for (const QString& key : byKey.keys())
      QVERIFY2(page.contains(QKeySequence(key).toString(QKeySequence::NativeText).toHtmlEscaped()), qPrintable(key));
    for (const models::Model* model : models::allModels())
      QVERIFY(formulaePage().contains(QString::fromUtf8(model->spec().name.data())));
    for (const editing::CompositionRecord& record : editing::compositionRecords) {
      QVERIFY(formulaePage().contains(widgets::toQString(record.name)));
      const std::string_view formula = record.formula.substr(0, record.formula.find('\n'));
      QVERIFY(formulaePage().contains(widgets::formulaHtml(formula)));
    }
    for (const char* part : {"F1(θR)", "1 + sin θR", "ρ(original curves)", "Tongbuasirilai"})
      QVERIFY2(formulaePage().contains(QString::fromUtf8(part)), part);
    QVERIFY(!formulaePage().contains("%1"));
    delete window;
  }

  /// The menus, the search and the shortcuts show which actions are possible now, and which modes are on.
  void actionsShowTheState() {
    auto* window = new MainWindow;
    Document& document = window->parts().document;
    const auto action = [&](const QString& path) {
      for (const NamedAction& named : window->actionTable().all())
        if (named.path == path) return named.action;
      return static_cast<QAction*>(nullptr);
    };
    QAction *save = action("File > Save"), *undo = action("Edit > Undo"), *compare = action("Analyse > Compare");
    QVERIFY(!save->isEnabled() && !undo->isEnabled() && !compare->isChecked());
    document.setMaterial(greyMaterial());
    adoptDefaultFit(document);
    QVERIFY(save->isEnabled() && action("File > Export for Renderer")->isEnabled());
    setParameter(document, 0, Rgb(0.5));
    QVERIFY(undo->isEnabled() && undo->text().size() > QString("&Undo").size());
    compare->trigger();
    QVERIFY(compare->isChecked() && action("Analyse > Comparison Mode > Split")->isChecked());
    QAction* flicker = action("Analyse > Comparison Mode > Flicker");
    for (int times = 0; times < 2; ++times) flicker->trigger();  // a choice stays checked
    QVERIFY(flicker->isChecked() && !action("Analyse > Comparison Mode > Split")->isChecked());
    // Recent files follow the list.
    window->files().recent().clear();
    QVERIFY(action("File > Open Recent > Nothing opened yet") && !action("File > Open Recent > a.binary"));
    window->files().recent().add("/nowhere/a.binary");
    QVERIFY(!action("File > Open Recent > Nothing opened yet"));
    QVERIFY(!action("File > Open Recent > a.binary")->isEnabled() && action("File > Open Recent > Clear"));
    delete window;
  }

  /// The add-on that the menu saves is the file of the build, and holds the module.
  void theBlenderAddonIsBuiltIn() {
    auto* window = new MainWindow;
    QVERIFY(found(*window, "Blender add-on").filter("File > ").size() == 1);
    delete window;
    QFile addon(QStringLiteral(":/blender/gonio_blender.zip"));
    QVERIFY(addon.open(QIODevice::ReadOnly));
    const QByteArray bytes = addon.readAll();
    QVERIFY(bytes.startsWith("PK") && bytes.contains("gonio/__init__.py"));
  }

  /// At most one figure dialog; the search also finds it by its purpose.
  void figuresFromTheMenu() {
    auto* window = new MainWindow;
    window->show();
    window->parts().document.setMaterial(greyMaterial());
    const QStringList figures = found(*window, "figure paper").filter("Analyse > ");
    QVERIFY(figures.size() == 1 && figures[0].startsWith("Analyse > Figure "));
    for (int times = 0; times < 2; ++times) run(*window, "Analyse > Figure");
    const auto dialogs = window->findChildren<FigureDialog*>();
    QCOMPARE(dialogs.size(), qsizetype(1));
    QVERIFY(dialogs[0]->isVisible());
    // It fits a small screen.
    QVERIFY(dialogs[0]->minimumSizeHint().width() <= 1240 && dialogs[0]->minimumSizeHint().height() <= 720);
    delete window;
  }

  /// Panels that hear of being hidden stop their tasks, so no part of the window goes after the tasks.
  void noPartOutlivesTheTasks() {
    auto* window = new MainWindow;
    window->show();
    window->docks().show("interpolation");
    QTest::qWait(20);
    const QPointer<BackgroundTasks> tasks(&window->parts().tasks);
    int widgets = 0, late = 0;
    const QList<QWidget*> parts = window->findChildren<QWidget*>();
    for (const char* panel : {"InterpolationPanel", "PreviewWidget", "LibraryView", "Inspector", "ComparisonBar"}) {
      const auto found = std::ranges::find_if(
          parts, [&](const QWidget* part) { return QByteArray(part->metaObject()->className()).endsWith(panel); });
      QVERIFY2(found != parts.end(), panel);
      connect(*found, &QObject::destroyed, this, [&] { ++widgets, late += tasks.isNull(); });
    }
    delete window;
    QCOMPARE(widgets, 5);
    QCOMPARE(late, 0);
  }

  /// Parameter panel, document, undo action and title together.
  void editingThroughThePanel() {
    auto* window = new MainWindow;
    window->show();
    QVERIFY(window->windowTitle().contains("Untitled"));
    window->parts().document.setMaterial(greyMaterial());
    adoptDefaultFit(window->parts().document);
    QVERIFY(window->windowTitle().contains("grey"));
    auto* panel = window->parts().inspector.parameters();
    // The edit of the automatic fit is listed once it changes something.
    const auto* edits = window->parts().inspector.edits()->findChild<QListWidget*>();
    QCOMPARE(edits->count(), 0);
    Q_EMIT panel->valueEdited(0, Rgb(0.75));
    QCOMPARE(edits->count(), 1);
    QVERIFY(window->isWindowModified());
    QVERIFY(modelEdit(window->parts().document)->edited.values[0] == Rgb(0.75));
    window->parts().document.history().undo();
    QVERIFY(!window->isWindowModified());
    QVERIFY(modelEdit(window->parts().document)->isIdentity());
    QTest::qWait(50);
    delete window;
  }

  /// Nor is the edit of the fit listed beside edits of another kind; what is asked of an entry changes its edit.
  void theEditOfTheFitIsNotListed() {
    auto* window = new MainWindow;
    Document& document = window->parts().document;
    document.setMaterial(greyMaterial());
    adoptDefaultFit(document);
    factorization::PdvFactors factors{.form = factorization::PdvForm::twoFactors};
    factors.thetaNodes = factors.deviationNodes = {0, 1};
    factors.phiNodes = {0};
    factors.highest = 10;
    for (auto& channel : factors.channels) channel = {{{1, 1}, {1, 0}, {1}}};
    const auto shared = std::make_shared<const factorization::PdvFactors>(factors);
    editing::EditList edits = document.edits();
    edits.push_back({editing::FactorEdit{.original = shared, .edited = shared}});
    document.replaceEdits(edits, "Curves", 1);
    widgets::EditStack& list = *window->parts().inspector.edits();
    QCOMPARE(list.entries().size(), std::size_t(1));
    QCOMPARE(list.selected(), 0);
    Q_EMIT list.strengthEdited(0, 0.5);
    QCOMPARE(document.edits()[1].strength, 0.5);
    QCOMPARE(document.edits()[0].strength, 1.0);
    Q_EMIT list.deleteRequested(0);
    QCOMPARE(document.edits().size(), std::size_t(1));
    QVERIFY(modelEdit(document) && list.entries().empty());
    delete window;
  }

  /// Backspace resets the row with the focus, the diffuse colour among the controls too.
  void backspaceResetsTheDiffuseColour() {
    auto* window = new MainWindow;
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    Document& document = window->parts().document;
    document.setMaterial(greyMaterial());
    adoptDefaultFit(document);
    auto* slider = test::child<widgets::ParameterSlider>(*window->parts().inspector.controls(), "Diffuse colour");
    QVERIFY(slider);
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Home);
    QVERIFY(!modelEdit(document)->isIdentity());
    QTest::keyClick(slider, Qt::Key_Backspace);
    QVERIFY(modelEdit(document)->isIdentity());
    delete window;
  }

  /// After a number was typed the focus is still in its field, which has keys of its own for undo and redo.
  void undoAndRedoAfterTyping() {
    auto* window = new MainWindow;
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window));
    Document& document = window->parts().document;
    document.setMaterial(greyMaterial());
    fitting::FitResult fit;
    fit.model = &models::findModel("lambert");
    fit.parameters = models::defaultParameters(fit.model->spec());
    document.adoptFit(fit);
    const Rgb before = modelEdit(document)->edited.values[0];
    auto* field = window->parts().inspector.parameters()->findChild<widgets::NumberField*>();
    QVERIFY(field);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "0.625");
    // While it is being typed, the field's own undo takes the typing back.
    QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(field->text() != "0.625" && document.history().count() == 0);
    field->selectAll();
    QTest::keyClicks(field, "0.625");
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(modelEdit(document)->edited.values[0] != before);
    const Rgb typed = modelEdit(document)->edited.values[0];
    QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(modelEdit(document)->edited.values[0] == before);
    QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(modelEdit(document)->edited.values[0] == typed);
    delete window;
  }

  void commandSearchRunsWhatItFinds() {
    auto* window = new MainWindow;
    window->show();
    const bool before = window->parts().preview.overlay()->statusWanted();
    CommandSearch& search = openSearch(*window);
    auto* text = search.findChild<QLineEdit*>();
    QTest::keyClicks(text, "view overl");
    QCOMPARE(search.findChild<QListWidget*>()->count(), 1);
    QTest::keyClick(text, Qt::Key_Return);
    QTRY_COMPARE(window->parts().preview.overlay()->statusWanted(), !before);
    delete window;
  }

  /// What is clicked runs once, and not before the list has handled the click: a dialog that it opens has a loop of its
  /// own, in which the list is destroyed.
  void commandsRunAfterTheClick() {
    auto* window = new MainWindow;
    window->show();
    QPointer<CommandSearch> search = &openSearch(*window);
    search->findChild<QLineEdit*>()->setText("view overl");
    auto* list = search->findChild<QListWidget*>();
    int runs = 0;
    bool isClicking = false, ranInside = false;
    for (const NamedAction& named : window->actionTable().all())
      connect(named.action, &QAction::triggered, this, [&] {
        ++runs;
        ranInside = isClicking;
      });
    isClicking = true;
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
    isClicking = false;
    QTRY_VERIFY(!search);
    QCOMPARE(runs, 1);
    QVERIFY(!ranInside);
    delete window;
  }

  /// By any word: parameters, materials, scenes, lights; a word that is nowhere is said to be nowhere.
  void searchFindsWhatIsMeant() {
    auto* window = new MainWindow;
    window->show();
    Document& document = window->parts().document;
    document.setMaterial(greyMaterial());
    adoptDefaultFit(document);
    QVERIFY(found(*window, "rough").contains("Controls > Roughness") &&
            found(*window, "rough").contains("GGX > Roughness"));
    QVERIFY(found(*window, "gold paint").contains("Library > gold-paint (close copy)"));
    QVERIFY(found(*window, "shader ball").contains("Scene > Shader ball"));
    QVERIFY(found(*window, "hdri").contains("Light > Sunset"));
    QCOMPARE(found(*window, "model ward anisotropic"), QStringList{"Model > Ward anisotropic"});
    QVERIFY(found(*window, "exr").contains("Light > Sunset") &&
            found(*window, "carpaint").contains("Model > Car paint"));
    QVERIFY(found(*window, "undo").first().startsWith("Edit > "));
    // Words begin words: "red" is no part of "measured" here.
    QVERIFY(found(*window, "red metallic").first().startsWith("Library > red-metallic-paint"));
    // The laboratory notes are not part of the guide.
    QCOMPARE(found(*window, "guide hostile lost work"), QStringList{"No entry matches \"guide hostile lost work\"."});
    QVERIFY(found(*window, "contact sheet").first().startsWith("Analyse > Contact Sheet"));
    QCOMPARE(found(*window, "xyzzy"), QStringList{"No entry matches \"xyzzy\"."});
    // What is found is done.
    auto* text = openSearch(*window).findChild<QLineEdit*>();
    QTest::keyClicks(text, "shape cylinder");
    QTest::keyClick(text, Qt::Key_Return);
    QTRY_COMPARE(window->parts().preview.content().scene().name, std::string("cylinder"));
    delete window;
  }

  /// The start page covers an empty viewport, offers materials that the library has, and goes when there is something
  /// to show.
  void startPage() {
    auto* window = new MainWindow;
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    StartPage& page = window->startPage();
    QVERIFY(page.isVisible());
    QCOMPARE(page.geometry(), window->parts().preview.rect());
    QCOMPARE(StartPage::materials().size(), qsizetype(6));
    for (const QString& id : StartPage::materials()) {
      QVERIFY2(!materials::librarySha256(id.toStdString()).empty(), qPrintable(id));
      QVERIFY2(QFile::exists(":/start/" + materialName(id) + ".jpg"), qPrintable(id));
    }
    const QList<StartTile*> tiles = page.findChildren<StartTile*>();
    QCOMPARE(tiles.size(), qsizetype(9));
    // A large page has larger pictures, and all materials still in one row.
    page.resize(600, 500);
    const QSize small = tiles.front()->sizeHint();
    page.resize(1400, 1000);
    QVERIFY(tiles.front()->sizeHint().width() > small.width() * 3 / 2);
    QTRY_COMPARE(tiles[5]->mapTo(&page, QPoint()).y(), tiles[0]->mapTo(&page, QPoint()).y());
    QVERIFY(tiles[5]->mapTo(&page, tiles[5]->rect().bottomRight()).x() < page.width());
    window->parts().document.setMaterial(greyMaterial());
    QVERIFY(!page.isVisible());
    delete window;
  }

  /// The row of the inspector opens the panel of a kind of editing, and marks the one that is in view.
  void kindsOfEditing() {
    auto* window = new MainWindow;
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    Inspector& inspector = window->parts().inspector;
    const auto isShown = [&](const char* name) { return !window->docks().dock(name)->isHidden(); };
    QCOMPARE(inspector.kind(), EditingKind::sliders);
    Q_EMIT inspector.kindChosen(EditingKind::curves);
    QVERIFY(isShown("factors"));
    QTRY_COMPARE(inspector.kind(), EditingKind::curves);
    Q_EMIT inspector.kindChosen(EditingKind::blend);
    QVERIFY(isShown("interpolation"));
    QTRY_COMPARE(inspector.kind(), EditingKind::blend);
    // Also when the panel is shown or hidden by other means.
    window->docks().show("interpolation", false);
    window->docks().show("factors", false);
    QTRY_COMPARE(inspector.kind(), EditingKind::sliders);
    delete window;
  }

  /// The wheel over a list box scrolls, and chooses nothing.
  void theWheelChoosesNothing() {
    auto* window = new MainWindow;
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    for (QComboBox* box : window->findChildren<QComboBox*>()) {
      if (!box->isVisible() || box->count() < 2) continue;
      const int before = box->currentIndex();
      QWheelEvent wheel(QPointF(5, 5), box->mapToGlobal(QPointF(5, 5)), {}, {0, -120}, Qt::NoButton, {},
                        Qt::NoScrollPhase, false);
      box->setFocus();
      QApplication::sendEvent(box, &wheel);
      QCOMPARE(box->currentIndex(), before);
    }
    delete window;
  }

  /// The four layouts show what their work needs; the first is the usual one.
  void layouts() {
    auto* window = new MainWindow;
    window->show();
    const auto isShown = [&](const char* name) { return !window->docks().dock(name)->isHidden(); };
    run(*window, "View > Layouts > Compare");
    QVERIFY(isShown("comparison") && !isShown("library"));
    QVERIFY(window->parts().comparison.comparison().mode != widgets::CompareMode::off);
    run(*window, "View > Layouts > Analyse");
    QVERIFY(isShown("plots") && isShown("library"));
    QCOMPARE(window->docks().tabs()->currentIndex(), 2);
    run(*window, "View > Layouts > Measure");
    QVERIFY(isShown("acquisition") && !isShown("library") && !isShown("inspector") && !isShown("plots"));
    run(*window, "View > Layouts > Edit");
    QVERIFY(!isShown("acquisition"));
    QVERIFY(isShown("library") && isShown("inspector") && !isShown("plots") && !isShown("comparison"));
    // The same by the tabs; a press on the current one brings its panels back.
    QTabBar& tabs = *window->docks().tabs();
    QCOMPARE(tabs.currentIndex(), 0);
    QTest::mouseClick(&tabs, Qt::LeftButton, {}, tabs.tabRect(3).center());
    QVERIFY(isShown("acquisition") && !isShown("library"));
    window->docks().show("library");
    QTest::mouseClick(&tabs, Qt::LeftButton, {}, tabs.tabRect(3).center());
    QVERIFY(!isShown("library"));
    QTest::mouseClick(&tabs, Qt::LeftButton, {}, tabs.tabRect(0).center());
    QVERIFY(isShown("library") && !isShown("acquisition"));
    delete window;
  }

  /// \\ shows the second side while it is held, wherever the focus is, but writes itself into a field for text.
  void flickerKey() {
    auto* window = new MainWindow;
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    window->parts().document.setMaterial(greyMaterial());
    adoptDefaultFit(window->parts().document);
    window->parts().comparison.setComparison({.mode = widgets::CompareMode::flicker});
    const auto* shown = window->parts().preview.overlay()->name(0);
    QTest::keyPress(&window->parts().preview, Qt::Key_Backslash);
    QCOMPARE(shown->text(), "Measured");
    QTest::keyRelease(&window->parts().preview, Qt::Key_Backslash);
    QCOMPARE(shown->text(), "Fit: GGX");
    auto* search = window->parts().libraryView.search();
    search->setFocus();
    QTest::keyPress(search, Qt::Key_Backslash, {});
    QCOMPARE(shown->text(), "Fit: GGX");
    QTest::keyRelease(search, Qt::Key_Backslash);
    delete window;
  }

  /// A search of the library leaves a smaller training set.
  void acquisitionsLearnFromWhatTheLibraryShows() {
    auto* window = new MainWindow;
    AcquisitionControls& controls = window->parts().acquisition.controls();
    controls.training().box().setCurrentIndex(4);
    QCOMPARE(controls.training().box().currentText(), "Materials shown in the library");
    // Each material once, in its best quality.
    QSet<QString> materials;
    for (int row = 0; row < window->parts().library.model().materialCount(); ++row)
      materials << window->parts()
                       .library.model()
                       .qualitiesOf(
                           window->parts().library.model().index(row).data(widgets::LibraryModel::IdRole).toString())
                       .front();
    QVERIFY(materials.size() > 140 && materials.size() < window->parts().library.model().materialCount());
    const QStringList all = controls.planSettings().training.ids;
    QCOMPARE(QSet<QString>(all.begin(), all.end()), materials);
    QCOMPARE(all.size(), materials.size());
    window->parts().libraryView.search()->setText("paint blue");
    const QStringList ids = controls.planSettings().training.ids;
    QVERIFY(!ids.isEmpty() && ids.size() < window->parts().library.model().materialCount());
    for (const QString& id : ids) QVERIFY2(id.startsWith("library:") && id.contains("blue"), qPrintable(id));
    delete window;
  }

  /// The ground of the picture is mid-grey in a light window, and dark in a dark one.
  void theGroundFollowsTheTheme() {
    auto* window = new MainWindow;
    const auto ground = [&](const QColor& colour) {
      QPalette palette = window->palette();
      palette.setColor(QPalette::Window, colour);
      window->setPalette(palette);
      return window->parts().preview.display().backgroundCentre.lightness();
    };
    QVERIFY(ground(QColor(40, 40, 40)) < 80);
    const int light = ground(QColor(240, 240, 240));
    QVERIFY(light > 110 && light < 170);
    QVERIFY(ground(QColor(40, 40, 40)) < 80);
    delete window;
  }

  void newWindowsAreWindowsOfTheirOwn() {
    auto* window = new MainWindow;
    run(*window, "File > New Window");
    MainWindow* second = nullptr;
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (auto* other = qobject_cast<MainWindow*>(widget); other && other != window) second = other;
    QVERIFY(second && second->isVisible());
    window->parts().document.setMaterial(greyMaterial());
    QVERIFY(!second->parts().document.material());
    delete second;
    delete window;
  }

  void resetLayoutBringsDocksBack() {
    auto* window = new MainWindow;
    window->show();
    QDockWidget* library = window->docks().dock("library");
    library->hide();
    window->docks().reset();
    QVERIFY(!library->isHidden());
    delete window;
  }
};

GONIO_TEST(MainWindowTest)
}  // namespace main_window_test

#include "main_window_test.moc"
