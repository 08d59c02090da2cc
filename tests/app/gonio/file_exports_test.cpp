// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/file_exports.h"

#include <QFile>
#include <QImage>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/gonio/document/document_controller.h"
#include "core/formats/formats.h"
#include "core/io/atomic_file.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/app/gonio/glossy_material.h"
#include "tests/app/gonio/patience.h"
#include "tests/support/test_program.h"

namespace file_exports_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A document about a measured file in a folder of its own.
struct Editor {
  QTemporaryDir folder;
  QString source = folder.filePath("measured.binary");
  BackgroundTasks tasks;
  Document document;
  FileExports exports{document, tasks};
  QSignalSpy exported{&exports, &FileExports::exported}, failed{&exports, &FileExports::failed},
      cancelled{&exports, &FileExports::cancelled};

  Editor() {
    io::writeFileAtomically(source.toStdString(), std::string("the measured values"));
    auto material = std::make_shared<LoadedMaterial>(*glossyMaterial(0.4, HalfDifferenceGrid{20, 20, 20}));
    material->material.source.path = source.toStdString();
    document.setMaterial(material);
  }
  bool sourceIsWhole() const { return bytesOf(source) == "the measured values"; }
};

class FileExportsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// By no export, under whatever name the file is reached.
  void theSourceIsNeverReplaced() {
    Editor editor;
    const QString link = editor.folder.filePath("link.binary");
    QVERIFY(QFile::link(editor.source, link));
    const QString roundabout =
        editor.folder.filePath("../" + editor.folder.path().section('/', -1) + "/measured.binary");
    for (const QString& name : {editor.source, link, roundabout}) {
      editor.failed.clear();
      editor.exports.writeMaterial(name, formats::merlFormat);
      QCOMPARE(editor.failed.count(), 1);
      QVERIFY(editor.failed[0][1].toString().contains("measured file"));
      editor.exports.writePng(name, QImage(2, 2, QImage::Format_RGBA8888));
      editor.exports.renderPicture({.path = name});
      QCOMPARE(editor.failed.count(), 3);
    }
    QVERIFY(editor.tasks.isIdle());
    QVERIFY(editor.sourceIsWhole());
  }

  /// Of a blend each material is a source.
  void theSourcesOfABlendAreNeverReplaced() {
    Editor editor;
    auto blend = std::make_shared<documents::BlendSource>();
    blend->materials.resize(2);
    blend->materials[1].sourcePath = editor.source.toStdString();
    blend->weights = {0.5, 0.5};
    auto material = std::make_shared<LoadedMaterial>(*editor.document.material());
    material->material.source.path.clear();
    material->blend = blend;
    editor.document.setMaterial(material);
    QVERIFY(editor.exports.refuses(editor.source));
    QVERIFY(!editor.exports.refuses(editor.folder.filePath("other.binary")));
  }

  /// A second export does not take the place of the first: both files are there in the end.
  void exportsWaitForEachOther() {
    Editor editor;
    QStringList names;
    for (int i = 0; i < 3; ++i) {
      names << editor.folder.filePath(QStringLiteral("copy%1.binary").arg(i));
      editor.exports.writeMaterial(names.back(), formats::merlFormat);
    }
    QCOMPARE(editor.tasks.shown().size(), std::size_t(3));
    QVERIFY(editor.tasks.isWritingFiles());
    QTRY_COMPARE_WITH_TIMEOUT(editor.exported.count(), 3, patienceMilliseconds);
    for (int i = 0; i < 3; ++i) {
      QCOMPARE(editor.exported[i][0].toString(), names[i]);
      QVERIFY(QFile::exists(names[i]));
    }
    QVERIFY(!editor.tasks.isWritingFiles());
  }

  /// One that waits can be taken away; the others go on, and it is said.
  void anExportThatWaitsIsCancelled() {
    Editor editor;
    const QString first = editor.folder.filePath("first.binary"), second = editor.folder.filePath("second.binary");
    editor.exports.writeMaterial(first, formats::merlFormat);
    editor.exports.writeMaterial(second, formats::merlFormat);
    editor.tasks.cancel(editor.tasks.shown()[1].id);
    QTRY_COMPARE_WITH_TIMEOUT(editor.exported.count(), 1, patienceMilliseconds);
    QTRY_COMPARE_WITH_TIMEOUT(editor.cancelled.count(), 1, patienceMilliseconds);
    QCOMPARE(editor.cancelled[0][0].toString(), second);
    QVERIFY(QFile::exists(first) && !QFile::exists(second));
  }

  /// A MERL file cannot hold an anisotropic edit: this is asked before it is written.
  void whatAFileCannotHoldIsSaid() {
    Editor editor;
    const models::Model& ward = models::findModel("ward-anisotropic");
    editing::DifferentialEdit edit{&ward, models::defaultParameters(ward.spec()),
                                   models::defaultParameters(ward.spec())};
    edit.edited.values[*ward.spec().find("roughness-x")] = Rgb(0.03);
    edit.edited.values[*ward.spec().find("roughness-y")] = Rgb(0.4);
    editor.document.replaceEdits({{edit}}, "Brush");
    QString found;
    std::function<void()> confirm;
    QObject::connect(&editor.exports, &FileExports::lossesFound, &editor.document,
                     [&](const QString&, const QString& text, const std::function<void()>& write) {
                       found = text;
                       confirm = write;
                     });
    const QString path = editor.folder.filePath("brushed.binary");
    editor.exports.writeMaterial(path, formats::merlFormat);
    QTRY_VERIFY_WITH_TIMEOUT(confirm, patienceMilliseconds);
    QVERIFY(found.contains("anisotropic") && found.contains("dB"));
    QVERIFY(!QFile::exists(path));
    confirm();
    QTRY_COMPARE_WITH_TIMEOUT(editor.exported.count(), 1, patienceMilliseconds);
    QVERIFY(QFile::exists(path));
  }

  void aPictureIsWritten() {
    Editor editor;
    QImage picture(3, 2, QImage::Format_RGBA8888);
    picture.fill(QColor(10, 200, 30, 128));
    const QString path = editor.folder.filePath("view.png");
    editor.exports.writePng(path, picture);
    QTRY_COMPARE_WITH_TIMEOUT(editor.exported.count(), 1, patienceMilliseconds);
    const QImage back(path);
    QCOMPARE(back.size(), picture.size());
    QCOMPARE(back.pixelColor(1, 1), QColor(10, 200, 30, 128));
  }
};

GONIO_TEST(FileExportsTest)
}  // namespace file_exports_test

#include "file_exports_test.moc"
