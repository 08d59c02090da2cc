// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/autosave.h"

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/test_program.h"

namespace autosave_test {
using namespace gonio;
using namespace gonio::app;

class AutosaveTest : public QObject {
  Q_OBJECT
 private:
  static documents::EditDocument work() {
    documents::EditDocument document;
    document.sourcePath = "library:sgd/chrome";
    document.sourceSha256 = std::string(64, '7');
    return document;
  }

  /// The copies that lie in a folder.
  static QStringList copiesIn(const QString& folder) {
    QStringList copies;
    for (const QFileInfo& file : QDir(folder).entryInfoList({"*.autosave", "*.gonio"}, QDir::Files))
      copies << file.filePath();
    return copies;
  }

 private Q_SLOTS:
  void copiesLieBesideTheDocumentAndGoWithTheSave() {
    const QTemporaryDir folder;
    bool unsaved = true;
    Autosave autosave(folder.filePath("data"), [&] { return unsaved ? std::optional(work()) : std::nullopt; });
    const QString path = folder.filePath("mine.gonio");
    autosave.setDocumentPath(path);
    const QString copy = copiesIn(folder.path()).value(0);
    QVERIFY(copy.startsWith(path + '.') && copy.endsWith(".autosave"));
    unsaved = false;
    autosave.setDocumentPath(path);
    QVERIFY(!QFile::exists(copy));
    QVERIFY(Autosave::recoverable(folder.filePath("data")).isEmpty());
  }

  void nothingUnsavedLeavesNoCopy() {
    const QTemporaryDir folder;
    bool unsaved = true;
    Autosave autosave(folder.filePath("data"), [&] { return unsaved ? std::optional(work()) : std::nullopt; });
    autosave.update();
    QCOMPARE(copiesIn(folder.filePath("data")).size(), 1);
    unsaved = false;
    autosave.update();
    QVERIFY(copiesIn(folder.filePath("data")).isEmpty());
  }

  /// Two editors with one document: neither replaces nor removes the copy of the other.
  void editorsOfOneDocumentHaveACopyEach() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("mine.gonio");
    const auto snapshot = [] { return std::optional(work()); };
    Autosave first(folder.filePath("data"), snapshot), second(folder.filePath("data"), snapshot);
    first.setDocumentPath(path);
    second.setDocumentPath(path);
    QCOMPARE(copiesIn(folder.path()).size(), 2);
    first.discard();
    QCOMPARE(copiesIn(folder.path()).size(), 1);
    second.discard();
    QVERIFY(copiesIn(folder.path()).isEmpty());
  }

  /// Where the document's folder takes no copy, the data folder does.
  void aCopyOfADocumentInALostFolderIsKept() {
    const QTemporaryDir folder;
    const QString data = folder.filePath("data"), path = folder.filePath("gone/mine.gonio");
    Autosave autosave(data, [] { return std::optional(work()); });
    autosave.setDocumentPath(path);
    const QStringList copies = copiesIn(data);
    QCOMPARE(copies.size(), 1);
    QCOMPARE(documents::readDocument(copies[0].toStdString()).sourcePath, work().sourcePath);
  }

  /// A full disk, or a document that cannot be written: what was copied before stays.
  void aFailedCopyKeepsTheOneBefore() {
    const QTemporaryDir folder;
    documents::EditDocument document = work();
    Autosave autosave(folder.filePath("data"), [&] { return std::optional(document); });
    autosave.setDocumentPath(folder.filePath("mine.gonio"));
    const QStringList copies = copiesIn(folder.path());
    document.sourcePath = "library:\xff";  // not UTF-8, so it is not JSON either
    QVERIFY(!autosave.update());
    QCOMPARE(copiesIn(folder.path()), copies);
    QCOMPARE(documents::readDocument(copies[0].toStdString()).sourcePath, work().sourcePath);
    QCOMPARE(QDir(folder.filePath("data")).entryList({"*.record"}, QDir::Files).size(), qsizetype(1));
  }

  /// Only Gonio's own copies are removed, whatever the name of the document is and whatever a record says.
  void discardingRemovesNoOtherFile_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("newline") << QStringLiteral("first\nsecond.gonio");
    QTest::newRow("path of a victim") << QStringLiteral("x\nvictim\n.gonio");
    QTest::newRow("quotes") << QStringLiteral("\"},\"document\":\"victim\".gonio");
  }
  void discardingRemovesNoOtherFile() {
    QFETCH(QString, name);
    const QTemporaryDir folder;
    QVERIFY(QDir::setCurrent(folder.path()));
    const QString data = folder.filePath("data");
    for (const QString& other : {QStringLiteral("victim"), QStringLiteral("first"), name})
      QVERIFY(QFile(folder.filePath(other)).open(QIODevice::WriteOnly));
    auto autosave = std::make_unique<Autosave>(data, [] { return std::optional(work()); });
    autosave->setDocumentPath(folder.filePath(name));
    autosave.reset();
    const auto found = Autosave::recoverable(data);
    QCOMPARE(found.size(), 1);
    const QString copy = found[0].autosavePath;
    QVERIFY(copy.startsWith(folder.filePath(name) + '.') && QFile::exists(copy));
    QCOMPARE(found[0].originalPath, folder.filePath(name));
    Autosave::forget(data, folder.filePath("victim"));
    Autosave::forget(data, copy);
    QVERIFY(!QFile::exists(copy) && Autosave::recoverable(data).isEmpty());
    for (const QString& other : {QStringLiteral("victim"), QStringLiteral("first"), name})
      QVERIFY(QFile::exists(folder.filePath(other)));
  }

  /// Records of November 2026 and before: two lines. One that names another file than its copy is no record of ours.
  void recordsOfOlderVersionsAreRead() {
    const QTemporaryDir folder;
    const QString data = folder.filePath("data"), document = folder.filePath("mine.gonio");
    QVERIFY(QDir().mkpath(data));
    const auto write = [](const QString& path, const QString& text) {
      QFile file(path);
      return file.open(QIODevice::WriteOnly) && file.write(text.toUtf8()) > 0;
    };
    QVERIFY(write(folder.filePath("victim"), "kept"));
    QVERIFY(write(document + ".12345678.autosave", "work") && write(data + "/abcdefgh-2.gonio", "work"));
    QVERIFY(write(data + "/12345678-1.record", document + ".12345678.autosave\n" + document + '\n'));
    QVERIFY(write(data + "/abcdefgh-2.record", data + "/abcdefgh-2.gonio\n\n"));
    QVERIFY(write(data + "/87654321-3.record", folder.filePath("victim") + '\n' + document + '\n'));
    QVERIFY(write(data + "/11111111-4.record", "neither"));
    QStringList copies;
    for (const RecoverableWork& work : Autosave::recoverable(data)) copies << work.autosavePath;
    copies.sort();
    const QStringList expected{data + "/abcdefgh-2.gonio", document + ".12345678.autosave"};
    QCOMPARE(copies, expected);
    Autosave::forget(data, folder.filePath("victim"));
    for (const QString& copy : copies) Autosave::forget(data, copy);
    QVERIFY(QFile::exists(folder.filePath("victim")));
    for (const QString& copy : copies) QVERIFY(!QFile::exists(copy));
  }

  /// A program that dies leaves its copy; the next one finds it, but not while the first still runs.
  void whatWasLeftBehindIsFound() {
    const QTemporaryDir folder;
    const QString data = folder.filePath("data");
    auto autosave = std::make_unique<Autosave>(data, [] { return std::optional(work()); });
    autosave->update();
    QVERIFY(Autosave::recoverable(data).isEmpty());
    autosave.reset();  // without discard(): as if the program had died
    const auto found = Autosave::recoverable(data);
    QCOMPARE(found.size(), 1);
    QVERIFY(found[0].originalPath.isEmpty());
    QCOMPARE(documents::readDocument(found[0].autosavePath.toStdString()).sourceSha256, work().sourceSha256);
    Autosave::forget(data, found[0].autosavePath);
    QVERIFY(!QFile::exists(found[0].autosavePath));
    QVERIFY(Autosave::recoverable(data).isEmpty());
  }
};

GONIO_TEST(AutosaveTest)
}  // namespace autosave_test

#include "autosave_test.moc"
