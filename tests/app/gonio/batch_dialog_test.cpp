// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/export/batch_dialog.h"

#include <QCheckBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/gonio/document/material_files.h"
#include "core/formats/merl.h"
#include "core/io/atomic_file.h"
#include "tests/app/gonio/glossy_material.h"
#include "tests/app/gonio/patience.h"
#include "tests/support/test_program.h"
#include "tests/widgets/child.h"

namespace batch_dialog_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

struct Editor {
  QTemporaryDir library, folder;
  QSettings settings{folder.filePath("settings.ini"), QSettings::IniFormat};
  Document document;
  BackgroundTasks tasks;
  ExportController controller{document, tasks};
  QSignalSpy exported{&controller, &ExportController::exported}, failed{&controller, &ExportController::failed};
  QStringList ids;

  Editor() {
    settings.setValue("export/folder", folder.path());
    settings.setValue("export/target", "csv");
    for (const char* name : {"one", "two", "three"}) {
      ids << library.filePath(QString(name) + ".binary");
      const auto material = glossyMaterial(0.4, HalfDifferenceGrid{20, 20, 20});
      io::writeFileAtomically(ids.back().toStdString(), formats::encodeMerl(*material->table()));
    }
  }
  bool finish() {
    return QTest::qWaitFor([&] { return tasks.isIdle(); }, patienceMilliseconds);
  }
  QStringList written() const { return QDir(folder.path()).entryList({"*.csv"}); }
};

class BatchDialogTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// One file each, named as the material.
  void writesEachMaterial() {
    Editor editor;
    BatchDialog dialog(editor.controller, editor.settings, editor.ids, nullptr);
    QCOMPARE(dialog.target().id, std::string_view("csv"));
    // The sentence that states when to choose the target; what it cannot represent is in the tool tip.
    const QString purpose = QString::fromStdString(std::string(dialog.target().purpose));
    QVERIFY(!purpose.isEmpty() && test::child<QLabel>(dialog, purpose));
    dialog.accept();
    QCOMPARE(editor.tasks.shown().size(), std::size_t(3));
    QVERIFY(editor.finish());
    QCOMPARE(editor.exported.count(), 3);
    QCOMPARE(editor.written(), QStringList({"one.csv", "three.csv", "two.csv"}));
  }

  /// Files that are there are kept until the user allows it.
  void replacesOnlyWhenAllowed() {
    Editor editor;
    QFile old(editor.folder.filePath("two.csv"));
    QVERIFY(old.open(QIODevice::WriteOnly));
    BatchDialog dialog(editor.controller, editor.settings, editor.ids, nullptr);
    dialog.accept();
    QVERIFY(editor.tasks.isIdle() && editor.written().size() == 1);
    dialog.findChild<QCheckBox*>()->setChecked(true);
    dialog.accept();
    QVERIFY(editor.finish());
    QVERIFY(editor.exported.count() == 3 && QFileInfo(old).size() > 0);
  }

  /// A measured file is never replaced; one that cannot be read is reported, and the others are written.
  void failuresLeaveTheOthers() {
    Editor editor;
    QFile broken(editor.ids[0]);
    QVERIFY(broken.open(QIODevice::WriteOnly | QIODevice::Truncate));
    broken.close();
    BatchDialog dialog(editor.controller, editor.settings, editor.ids, nullptr);
    dialog.accept();
    QVERIFY(editor.finish());
    QVERIFY(editor.failed.count() == 1 && editor.failed[0][1].toString().contains("one.binary"));
    QCOMPARE(editor.exported.count(), 2);

    BatchDialog over(editor.controller, editor.settings, {editor.ids[1]}, nullptr);
    over.chooseTarget("merl");
    over.folder().setText(editor.library.path());
    over.findChild<QCheckBox*>()->setChecked(true);
    const qint64 size = QFileInfo(editor.ids[1]).size();
    over.accept();
    QVERIFY(editor.finish());
    QVERIFY(editor.failed.count() == 2 && editor.failed[1][1].toString().contains("material uses"));
    QCOMPARE(QFileInfo(editor.ids[1]).size(), size);
  }

  /// Materials of one name do not replace each other.
  void namesAreDistinct() {
    QCOMPARE(distinctNames({"library:rgl/paper", "library:rgl-copy/paper", "library:sgd/gold"}),
             QStringList({"paper_rgl", "paper_rgl-copy", "gold"}));
    QCOMPARE(distinctNames({"/a/x.binary", "/a/x.bsdf", "/b/x.bsdf"}), QStringList({"x_binary", "x_bsdf", "x_bsdf_"}));
  }

  void namesOfMaterials() {
    QCOMPARE(materialName("library:merl-copy/red.paint"), QString("red.paint"));
    QCOMPARE(materialName("/data/paint2.bsdf"), QString("paint2"));
  }
};

GONIO_TEST(BatchDialogTest)

}  // namespace batch_dialog_test

#include "batch_dialog_test.moc"
