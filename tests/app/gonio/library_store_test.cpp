// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/library/library_store.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/test_program.h"

namespace library_store_test {
using gonio::app::LibraryStore;
using gonio::widgets::LibraryNote;

class LibraryStoreTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  /// What was noted is there when the program starts again.
  void notesStay() {
    const LibraryNote gold{true, 4, {"warm metals", "rosé, ‘soft’"}, QDateTime::fromMSecsSinceEpoch(1'700'000'000'123)};
    const LibraryNote felt{.rating = 1};
    {
      LibraryStore store(path());
      QVERIFY(store.failure().isEmpty());
      QVERIFY(store.read().isEmpty());
      store.write({{"library:a/gold", LibraryNote{.rating = 2}}});
      store.write({{"library:a/gold", gold}});
      store.write({{"/tmp/it's; DROP TABLE notes.binary", felt}});
      store.write({{"gone", felt}});
      store.write({{"gone", LibraryNote()}});
    }
    const LibraryStore store(path());
    const gonio::widgets::LibraryNotes notes = store.read();
    QCOMPARE(notes.size(), 2);
    QVERIFY(notes["library:a/gold"] == gold);
    QVERIFY(notes["/tmp/it's; DROP TABLE notes.binary"] == felt);
  }

  /// Those of one call in one step.
  void several() {
    LibraryStore store(path());
    gonio::widgets::LibraryNotes notes;
    for (int i = 0; i < 100; ++i) notes[QString::number(i)] = {.rating = 1 + i % 5};
    QVERIFY(store.write(notes));
    QVERIFY(store.read() == notes);
  }

  /// Each window has one.
  void twoAtOnce() {
    LibraryStore first(path()), second(path());
    first.write({{"a", LibraryNote{.rating = 1}}});
    second.write({{"b", LibraryNote{.rating = 2}}});
    first.write({{"b", LibraryNote{.rating = 3}}});
    QCOMPARE(second.read()["b"].rating, 3);
    QCOMPARE(second.read()["a"].rating, 1);
  }

  /// The program works without it, and the file is not touched.
  void aFileThatIsNone() {
    const QByteArray content = QByteArray("no database").repeated(200);
    QFile file(path());
    QVERIFY(QDir().mkpath(folder_->filePath("deeper")) && file.open(QFile::WriteOnly));
    file.write(content);
    file.close();
    {
      LibraryStore store(path());
      QVERIFY(!store.failure().isEmpty());
      QVERIFY(!store.write({{"a", LibraryNote{.rating = 1}}}));
      QVERIFY(!store.failure().isEmpty() && store.read().isEmpty());
    }
    QVERIFY(file.open(QFile::ReadOnly));
    QCOMPARE(file.readAll(), content);
  }

 private:
  QString path() const { return folder_->filePath("deeper/library.sqlite"); }

  std::unique_ptr<QTemporaryDir> folder_;
};

GONIO_TEST(LibraryStoreTest)
}  // namespace library_store_test

#include "library_store_test.moc"
