// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/library/library_controller.h"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <mutex>
#include <span>

#include "app/gonio/library/thumbnail.h"
#include "core/documents/edit_document.h"
#include "core/models/registry.h"
#include "core/support/error.h"
#include "tests/fuzz/reader_seeds.h"
#include "tests/support/test_program.h"

namespace library_controller_test {
using namespace gonio;
using namespace gonio::app;

/// The library with makers of pictures that record what they were asked for.
class LibraryControllerTest : public QObject {
  Q_OBJECT
 private:
  static widgets::LibraryThumbnail anyThumbnail() {
    QImage image(4, 4, QImage::Format_RGBA8888);
    image.fill(Qt::red);
    return {image, 0, 0.5};
  }
  static QStringList idsOf(widgets::LibraryModel& model) {
    QStringList ids;
    for (int row = 0; row < model.rowCount(); ++row)
      ids.push_back(model.index(row, 0).data(widgets::LibraryModel::IdRole).toString());
    return ids;
  }

 private Q_SLOTS:
  /// Files that come and go do so in the library; the pictures of the others stay.
  void aFolderIsWatched() {
    const QString source = QStringLiteral(GONIO_CODES_DIR "/paper_blue.code");
    const QTemporaryDir folder;
    const auto add = [&](const QString& name) { return QFile::copy(source, folder.filePath(name)); };
    QVERIFY(add("a.code"));
    BackgroundTasks tasks;
    std::atomic<int> made = 0;
    LibraryController library(tasks, [&](const QString&, const TaskControl&) {
      ++made;
      return anyThumbnail();
    });
    library.showFolder(folder.path());
    QVERIFY(library.model().isListing());
    QTRY_COMPARE(idsOf(library.model()), QStringList{folder.filePath("a.code")});
    QVERIFY(!library.model().isListing());
    QTRY_VERIFY(library.model().pending().isEmpty());
    QVERIFY(add("b.code"));
    QFile none(folder.filePath("notes.txt"));
    QVERIFY(none.open(QFile::WriteOnly));
    QTRY_COMPARE(idsOf(library.model()), QStringList({folder.filePath("a.code"), folder.filePath("b.code")}));
    QTRY_VERIFY(library.model().pending().isEmpty());
    QCOMPARE(made.load(), 2);
    QVERIFY(QFile::remove(folder.filePath("a.code")));
    QTRY_COMPARE(idsOf(library.model()), QStringList{folder.filePath("b.code")});
    QCOMPARE(made.load(), 2);
  }

  /// Suffixes that other files have too: UTIA files are listed under each of theirs, other images are not.
  void utiaFilesAreListedUnderEachSuffix() {
    const QTemporaryDir folder;
    const auto add = [&](const QString& name, std::span<const std::byte> bytes) {
      QFile file(folder.filePath(name));
      return file.open(QFile::WriteOnly) &&
             file.write(reinterpret_cast<const char*>(bytes.data()), qint64(bytes.size())) == qint64(bytes.size());
    };
    const std::vector<std::byte> utia = fuzz::utiaSeed();
    QVERIFY(add("a.bin", utia) && add("b.exr", utia) && add("c.exr", std::span(utia).first(64)));
    BackgroundTasks tasks;
    LibraryController library(tasks, [](const QString&, const TaskControl&) { return anyThumbnail(); });
    library.showFolder(folder.path());
    QTRY_COMPARE(idsOf(library.model()), QStringList({folder.filePath("a.bin"), folder.filePath("b.exr")}));
  }

  /// The window may take half a second a frame: the pictures must not wait for one each.
  void quickPicturesComeTogether() {
    BackgroundTasks tasks;
    LibraryController library(tasks, [](const QString&, const TaskControl&) { return anyThumbnail(); });
    int turns = 0;
    connect(&tasks, &BackgroundTasks::changed, this, [&] { ++turns; });
    library.showBundled();
    QVERIFY(library.model().rowCount() > 100);
    QTRY_VERIFY(library.model().pending().isEmpty());
    QVERIFY(turns < library.model().rowCount() / 2);
  }

  /// Documents that the user keeps stand before the bundled materials, edits and all, as soon as they are saved.
  void ownMaterials() {
    QTemporaryDir root;
    const QString own = root.filePath("own"), document = own + "/softer.gonio";
    BackgroundTasks tasks;
    LibraryController library(
        tasks,
        [&](const QString& id, const TaskControl& control) {
          return id == document ? materialThumbnail(id, root.filePath("cache"), control) : anyThumbnail();
        },
        own);
    library.showBundled();
    QTRY_VERIFY(library.model().pending().isEmpty());
    QStringList bundled = idsOf(library.model());
    QVERIFY(QDir().mkpath(own));
    const materials::Material source = materials::readMaterial("library:sgd/brass");
    const models::Model& model = models::findModel("ggx");
    editing::DifferentialEdit edit{.model = &model, .fitted = models::defaultParameters(model.spec())};
    edit.edited = edit.fitted;
    edit.edited.values[*model.spec().find("diffuse")] = Rgb(0.9, 0, 0);
    documents::writeDocument(
        {.sourcePath = "library:sgd/brass", .sourceSha256 = source.source.sha256, .edits = {{edit}}},
        document.toStdString());
    const QSignalSpy added(&library, &LibraryController::added);
    library.addOwn(document);
    QCOMPARE(added.value(0).value(0).toString(), document);
    bundled.removeAll(QString());  // headings
    const auto materials = [&] {
      QStringList ids = idsOf(library.model());
      ids.removeAll(QString());
      return ids;
    };
    QTRY_COMPARE(materials(), QStringList{document} + bundled);
    const QModelIndex first = library.model().index(0, 0);
    QCOMPARE(first.data(widgets::LibraryModel::BadgeRole).toString(), QStringLiteral("edited"));
    QTRY_VERIFY(library.model().thumbnail(document));
    const widgets::LibraryThumbnail plain = materialThumbnail("library:sgd/brass", root.filePath("cache"), {});
    const QColor edited = library.model().thumbnail(document)->image.pixelColor(96, 96);
    QVERIFY(edited.red() > plain.image.pixelColor(plain.image.rect().center()).red() + 20);
  }

  void oneThatFailsHoldsNoOtherUp() {
    BackgroundTasks tasks;
    LibraryController library(tasks, [](const QString& id, const TaskControl&) -> widgets::LibraryThumbnail {
      if (id.endsWith("chrome")) throw Error("chrome is broken");
      return anyThumbnail();
    });
    library.showBundled();
    QTRY_VERIFY(library.model().pending().isEmpty());
    for (int row = 0; row < library.model().rowCount(); ++row) {
      const QModelIndex index = library.model().index(row, 0);
      const QString id = index.data(widgets::LibraryModel::IdRole).toString();
      QCOMPARE(index.data(widgets::LibraryModel::FailureRole).toString(),
               id.endsWith("chrome") ? QStringLiteral("chrome is broken") : QString());
    }
  }

  void thoseInSightComeFirst() {
    BackgroundTasks tasks;
    std::mutex mutex;
    QStringList asked;
    std::atomic<bool> isHeld = true;
    LibraryController library(tasks, [&](const QString& id, const TaskControl&) {
      while (isHeld) QThread::msleep(1);
      const std::lock_guard lock(mutex);
      asked.push_back(id);
      QThread::msleep(id == asked.front() ? 150 : 0);  // the first is a batch of its own
      return anyThumbnail();
    });
    library.showBundled();
    const QStringList ids = idsOf(library.model());
    library.setVisible({ids[70], ids[90]});
    isHeld = false;
    QTRY_VERIFY(library.isVisibleComplete());
    const std::lock_guard lock(mutex);
    QCOMPARE(asked.mid(0, 3), QStringList({ids[0], ids[70], ids[90]}));
  }
};

GONIO_TEST(LibraryControllerTest)
}  // namespace library_controller_test

#include "library_controller_test.moc"
