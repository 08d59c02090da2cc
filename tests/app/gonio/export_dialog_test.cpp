// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/export/export_dialog.h"

#include <QCheckBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <set>

#include "app/gonio/document/edit_steps.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/app/gonio/glossy_material.h"
#include "tests/support/test_program.h"
#include "widgets/inputs/icons.h"
#include "widgets/parameters/parameter_text.h"

namespace export_dialog_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::app;
using namespace gonio::app::test_support;

struct Editor {
  QTemporaryDir folder;
  QSettings settings{folder.filePath("settings.ini"), QSettings::IniFormat};
  Document document;
  BackgroundTasks tasks;
  ExportController controller{document, tasks};

  Editor() {
    settings.setValue("export/folder", folder.path());
    settings.setValue("export/target", "blender");
    settings.setValue("export/snr", 15);
    document.setMaterial(glossyMaterial(0.4, HalfDifferenceGrid{20, 20, 20}));
  }
  QString path(const QString& name) const { return folder.filePath(name); }
};

bool isRefined(const ExportDialog& dialog) { return dialog.trial() && dialog.trial()->isRefined; }

bool wait(const std::function<bool()>& done) { return QTest::qWaitFor(done, patienceMilliseconds); }

class ExportDialogTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// All targets are listed, and the remembered one is chosen.
  void listsTheTargets() {
    Editor editor;
    ExportDialog dialog(editor.controller, editor.settings, sphereScene(studioEnvironment()), nullptr);
    const auto& tree = *dialog.findChild<QTreeWidget*>();
    int rows = 0;
    for (int group = 0; group < tree.topLevelItemCount(); ++group) rows += tree.topLevelItem(group)->childCount();
    QCOMPARE(rows, int(exports::exportTargets().size()));
    QCOMPARE(tree.topLevelItemCount(), 3);
    QCOMPARE(dialog.target().id, std::string_view("blender"));
    QCOMPARE(dialog.name(), editor.path("glossy"));
    dialog.chooseTarget("pbrt");
    QCOMPARE(dialog.target().id, std::string_view("pbrt"));
  }

  /// Each target has an icon and one sentence of its own.
  void targetsHavePurposes() {
    QSet<QString> icons, purposes;
    for (const exports::ExportTarget& target : exports::exportTargets()) {
      const QString icon = widgets::toQString(target.icon), purpose = widgets::toQString(target.purpose);
      QVERIFY2(widgets::hasIcon(icon), target.id.data());
      QVERIFY2(purpose.size() > 20 && purpose.endsWith(u'.') && !purpose.contains(". "), target.id.data());
      icons << icon;
      purposes << purpose;
    }
    QCOMPARE(icons.size(), qsizetype(exports::exportTargets().size()));
    QCOMPARE(purposes.size(), qsizetype(exports::exportTargets().size()));
  }

  /// What an export costs is there before it is written; the files are those of the trial.
  void showsTheCostAndWrites() {
    Editor editor;
    QSignalSpy exported(&editor.controller, &ExportController::exported);
    ExportDialog dialog(editor.controller, editor.settings, sphereScene(studioEnvironment()), nullptr);
    QVERIFY(wait([&] { return isRefined(dialog); }));
    const QTreeWidgetItem& row = *dialog.findChild<QTreeWidget*>()->currentItem();
    QVERIFY(QStringList({"indistinguishable", "close", "approximate"}).contains(row.text(1)) && !row.text(2).isEmpty());
    QVERIFY(row.toolTip(1).endsWith(" dB"));
    const QSize size = editor.controller.picture(editor.document.edited()).size();
    QVERIFY(!size.isEmpty());
    QCOMPARE(dialog.trial()->exported.size(), size);
    QVERIFY(QDir(editor.folder.path()).entryList({"*.py"}).isEmpty());
    const auto bytes = dialog.trial()->made.parts.front().bytes;
    dialog.accept();
    QVERIFY(wait([&] { return exported.count() == 1; }));
    QFile file(editor.path("glossy_blender.py"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size())));
    QCOMPARE(exported.front().front().toString(),
             "glossy_blender.py in " + QDir::toNativeSeparators(editor.folder.path()));
  }

  /// Coarse pictures come first: that of the material before there are any files.
  void showsCoarsePicturesFirst() {
    Editor editor;
    ExportDialog dialog(editor.controller, editor.settings, sphereScene(studioEnvironment()), nullptr);
    const auto width = [&] { return editor.controller.picture(editor.document.edited()).width(); };
    QVERIFY(wait([&] { return width() > 0; }));
    const int coarse = width();
    QVERIFY(!isRefined(dialog));
    QVERIFY(wait([&] { return dialog.trial() != nullptr; }));
    QCOMPARE(dialog.trial()->exported.width(), coarse);
    QVERIFY(wait([&] { return isRefined(dialog); }));
    QVERIFY(width() > coarse);
    QCOMPARE(dialog.trial()->exported.width(), width());
  }

  /// Before there are files, the export is expected to look like the material where a renderer reads its values, and
  /// like its edited fit in an engine; of data, or with edits of another kind, nothing is expected.
  void showsWhatIsExpected() {
    Editor editor;
    adoptDefaultFit(editor.document);
    ExportDialog dialog(editor.controller, editor.settings, sphereScene(studioEnvironment()), nullptr);
    const auto expected = [&](std::string_view id) {
      return editor.controller.expected(editor.document.edited(), *exports::findExportTarget(id));
    };
    QVERIFY(wait([&] { return !expected("mitsuba").isNull(); }));
    QCOMPARE(expected("mitsuba"), editor.controller.picture(editor.document.edited()));
    QVERIFY(!expected("gltf").isNull() && expected("gltf") != expected("mitsuba"));
    QVERIFY(expected("merl").isNull());
  }

  /// What was made of a material is there when its dialog opens again or another target is chosen and left, and not
  /// once an edit has changed the material.
  void keepsWhatIsKnown() {
    Editor editor;
    const auto open = [&] {
      return std::make_unique<ExportDialog>(editor.controller, editor.settings, sphereScene(studioEnvironment()),
                                            nullptr);
    };
    auto dialog = open();
    QVERIFY(wait([&] { return isRefined(*dialog); }));
    const ExportTrialPtr first = dialog->trial();
    dialog->chooseTarget("gltf");
    QVERIFY(!dialog->trial());
    dialog->chooseTarget("blender");
    QCOMPARE(dialog->trial(), first);
    dialog = open();
    QCOMPARE(dialog->trial(), first);
    QVERIFY(editor.tasks.isIdle());
    dialog.reset();
    adoptDefaultFit(editor.document);
    setParameter(editor.document, int(*defaultModel().spec().find("roughness")), Rgb(0.9));
    dialog = open();
    QVERIFY(!dialog->trial());
    QVERIFY(wait([&] { return dialog->trial() != nullptr; }));
    QVERIFY(dialog->trial()->made.parts.front().bytes != first->made.parts.front().bytes);
  }

  /// Mitsuba and pbrt write the same two files, and read different ones: each shows the numbers of the one that it
  /// reads.
  void targetsHaveTheirOwnNumbers() {
    Editor editor;
    ExportDialog dialog(editor.controller, editor.settings, sphereScene(studioEnvironment()), nullptr);
    std::set<std::string_view> others;  // the number of the file that the program does not read
    for (const char* id : {"mitsuba", "pbrt"}) {
      dialog.chooseTarget(id);
      QVERIFY(!dialog.trial());
      QVERIFY(wait([&] { return isRefined(dialog); }));
      const auto expected = exports::makeExport(*exports::findExportTarget(id), editor.document.edited(), {.snr = 15});
      QCOMPARE(dialog.trial()->made.snr, expected.snr);
      others.insert(dialog.trial()->made.facts.back().key);
    }
    QCOMPARE(others, (std::set<std::string_view>{"snrRgb", "snrSpectral"}));
  }

  /// The preview's scene is written beside the material where the target has scenes and the user asks for it.
  void writesTheScene() {
    Editor editor;
    QSignalSpy exported(&editor.controller, &ExportController::exported);
    ExportDialog dialog(editor.controller, editor.settings, sphereScene(studioEnvironment()), nullptr);
    auto* withScene = dialog.findChild<QCheckBox*>();
    withScene->setChecked(true);
    dialog.chooseTarget("gltf");
    QVERIFY(!withScene->isEnabled() && !dialog.withScene());
    dialog.chooseTarget("mitsuba");
    QVERIFY(withScene->isEnabled() && dialog.withScene());
    dialog.accept();
    QVERIFY(wait([&] { return exported.count() == 1; }));
    QCOMPARE(QDir(editor.folder.path()).entryList({"glossy*"}),
             QStringList({"glossy_environment.exr", "glossy_rgb.bsdf", "glossy_scene.xml", "glossy_spec.bsdf"}));
  }

  /// The files follow the edits once these have rested, until another material is opened.
  void keepsUpToDate() {
    Editor editor;
    QSignalSpy exported(&editor.controller, &ExportController::exported);
    const exports::ExportTarget* target = exports::findExportTarget("blender");
    editor.controller.write(editor.document.edited(), {target, {.snr = 10}, editor.path("kept")}, nullptr);
    QVERIFY(wait([&] { return exported.count() == 1; }));
    const auto content = [&] {
      QFile file(editor.path("kept_blender.py"));
      return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const QByteArray before = content();
    editor.controller.setKeptUpToDate(true);
    adoptDefaultFit(editor.document);
    setParameter(editor.document, int(*defaultModel().spec().find("roughness")), Rgb(0.9));
    QVERIFY(wait([&] { return exported.count() == 2; }));
    QVERIFY(content() != before);
    editor.document.setMaterial(glossyMaterial(0.5, HalfDifferenceGrid{20, 20, 20}));
    QVERIFY(!editor.controller.isKeptUpToDate());
  }

  /// The same files once more, of the document as it is; not of another material.
  void exportsAgain() {
    Editor editor;
    QVERIFY(!editor.controller.canRepeat());
    QSignalSpy exported(&editor.controller, &ExportController::exported);
    const exports::ExportTarget* target = exports::findExportTarget("blender");
    editor.controller.write(editor.document.edited(), {target, {.snr = 10}, editor.path("again")}, nullptr);
    QVERIFY(wait([&] { return exported.count() == 1; }));
    QVERIFY(QFile::remove(editor.path("again_blender.py")));
    QVERIFY(editor.controller.canRepeat());
    editor.controller.repeat();
    QVERIFY(wait([&] { return exported.count() == 2; }));
    QVERIFY(QFile::exists(editor.path("again_blender.py")));
    editor.document.setMaterial(glossyMaterial(0.5, HalfDifferenceGrid{20, 20, 20}));
    QVERIFY(!editor.controller.canRepeat());
  }

  /// One sentence, and nothing is written.
  void failuresNameTheFile() {
    Editor editor;
    QSignalSpy failed(&editor.controller, &ExportController::failed);
    const exports::ExportTarget* target = exports::findExportTarget("blender");
    editor.controller.write(editor.document.edited(), {target, {.snr = 10}, editor.path("none/x")}, nullptr);
    QVERIFY(wait([&] { return failed.count() == 1; }));
    QVERIFY(failed.front().back().toString().contains("x_blender.py"));
  }

  /// Each material of a blend is a file that no export replaces.
  void sourcesOfABlendAreRefused() {
    Editor editor;
    const QString source = editor.path("one.binary");
    QFile(source).open(QIODevice::WriteOnly);
    auto blend = std::make_shared<documents::BlendSource>();
    blend->materials.resize(2);
    blend->materials[1].sourcePath = source.toStdString();
    blend->weights = {0.5, 0.5};
    auto material = std::make_shared<LoadedMaterial>(*editor.document.material());
    material->blend = blend;
    editor.document.setMaterial(material);
    QSignalSpy failed(&editor.controller, &ExportController::failed);
    const exports::ExportTarget* target = exports::findExportTarget("merl");
    editor.controller.write(editor.document.edited(), {target, {.snr = 10}, editor.path("one")}, nullptr);
    QVERIFY(wait([&] { return failed.count() == 1; }));
    QVERIFY(failed.front().back().toString().contains("material uses"));
    QCOMPARE(QFile(source).size(), 0);
  }

  /// A dialog that is closed while it works leaves no work behind.
  void closingEndsTheTrial() {
    Editor editor;
    {
      ExportDialog dialog(editor.controller, editor.settings, sphereScene(studioEnvironment()), nullptr);
      QVERIFY(wait([&] { return editor.controller.trialProgress().has_value(); }));
    }
    QVERIFY(editor.tasks.isIdle());
  }
};

GONIO_TEST(ExportDialogTest)
}  // namespace export_dialog_test

#include "export_dialog_test.moc"
