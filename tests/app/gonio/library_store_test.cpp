// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/library/library_store.h"

#include <QDir>
#include <QFile>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QTemporaryDir>
#include <QTest>
#include <QUuid>

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
    LibraryStore store(path());
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
      QVERIFY(store.read().isEmpty() && !store.failure().isEmpty());
      QVERIFY(!store.write({{"a", LibraryNote{.rating = 1}}}));
      QVERIFY(!store.failure().isEmpty() && !store.retry());
      QCOMPARE(store.read()["a"].rating, 1);  // as long as the program runs
    }
    QVERIFY(file.open(QFile::ReadOnly));
    QCOMPARE(file.readAll(), content);
  }

  /// The window must not wait for another program; what was noted meanwhile is written afterwards.
  void lockedByAnotherProgram() {
    const LibraryNote gold{true, 4, {"warm"}, {}};
    QVERIFY(LibraryStore(path()).write({{"gold", gold}}));
    const auto other = std::make_unique<OtherProgram>(path());
    QVERIFY(other->run("PRAGMA locking_mode = EXCLUSIVE") && other->run("BEGIN EXCLUSIVE"));
    QVERIFY(other->run("UPDATE notes SET rating = 3"));
    LibraryStore store(path());
    QVERIFY(store.read().isEmpty());
    for (const QString& name : QSqlDatabase::connectionNames())
      if (QSqlDatabase::database(name, false).connectOptions().isEmpty()) QCOMPARE(name, other->name());
    QVERIFY2(store.failure().contains("locked by another program"), qPrintable(store.failure()));
    QVERIFY(!store.write({{"gold", LibraryNote{.tags = {"soft"}}}, {"felt", LibraryNote{.rating = 1}}}));
    QVERIFY(!store.retry());
    QVERIFY(other->run("COMMIT"));
    other->close();
    QVERIFY(store.retry());
    QVERIFY(store.failure().isEmpty());
    // Nothing of the stored note is lost.
    const LibraryNote both{true, 3, {"warm", "soft"}, {}};
    const gonio::widgets::LibraryNotes expected{{"gold", both}, {"felt", LibraryNote{.rating = 1}}};
    QVERIFY(store.read() == expected && LibraryStore(path()).read() == expected);
    QVERIFY(!store.retry());
  }

  /// While another program writes, notes can be read.
  void writtenByAnotherProgram() {
    LibraryStore store(path());
    QVERIFY(store.write({{"gold", LibraryNote{.rating = 4}}}));
    OtherProgram other(path());
    QVERIFY(other.run("BEGIN IMMEDIATE") && other.run("UPDATE notes SET rating = 2"));
    QVERIFY(!store.write({{"felt", LibraryNote{.rating = 1}}}));
    QVERIFY(store.failure().contains("locked by another program"));
    QCOMPARE(store.read()["felt"].rating, 1);
    QVERIFY(other.run("COMMIT"));
    QVERIFY(!store.retry());  // nothing new to read
    QVERIFY(store.failure().isEmpty());
    QCOMPARE(LibraryStore(path()).read().size(), 2);
  }

  /// Of a newer version: they keep their values.
  void unknownColumns() {
    QVERIFY(LibraryStore(path()).write({{"gold", LibraryNote{.rating = 4}}}));
    OtherProgram other(path());
    QVERIFY(other.run("ALTER TABLE notes ADD COLUMN colour TEXT") && other.run("UPDATE notes SET colour = 'yellow'"));
    LibraryStore store(path());
    QCOMPARE(store.read()["gold"].rating, 4);
    QVERIFY(store.write({{"gold", LibraryNote{.rating = 5}}, {"felt", LibraryNote{.rating = 1}}}));
    QVERIFY(store.failure().isEmpty());
    QCOMPARE(other.value("SELECT colour FROM notes WHERE material = 'gold'"), "yellow");
    QVERIFY(store.write({{"gold", LibraryNote()}}));
    QCOMPARE(other.value("SELECT colour FROM notes WHERE material = 'gold'"), "yellow");
    const gonio::widgets::LibraryNotes left{{"felt", LibraryNote{.rating = 1}}};
    QVERIFY(LibraryStore(path()).read() == left);
  }

  /// A column that this version cannot fill: what is there can still be changed, and the failure says what is wrong.
  void aColumnThatMustBeFilled() {
    QVERIFY(QDir().mkpath(folder_->filePath("deeper")));
    OtherProgram other(path());
    QVERIFY(other.run("CREATE TABLE notes (material TEXT, favourite, rating, tags, opened, source TEXT NOT NULL)"));
    QVERIFY(other.run("INSERT INTO notes VALUES ('gold', 1, 2, 'warm', NULL, 'MERL')"));
    LibraryStore store(path());
    QCOMPARE(store.read()["gold"].rating, 2);
    QVERIFY(!store.write({{"felt", LibraryNote{.rating = 1}}}));
    QVERIFY2(store.failure().contains("notes.source") && store.failure().contains(path()), qPrintable(store.failure()));
    store.write({{"gold", LibraryNote{.rating = 3}}});
    QCOMPARE(other.value("SELECT rating FROM notes WHERE material = 'gold'"), "3");
    QCOMPARE(store.read()["felt"].rating, 1);
  }

  /// Of an older version: they are added.
  void missingColumns() {
    QVERIFY(QDir().mkpath(folder_->filePath("deeper")));
    OtherProgram other(path());
    QVERIFY(other.run("CREATE TABLE notes (material TEXT PRIMARY KEY, Favourite INTEGER NOT NULL)"));
    QVERIFY(other.run("INSERT INTO notes VALUES ('gold', 1)"));
    LibraryStore store(path());
    QVERIFY(store.read()["gold"].favourite && store.failure().isEmpty());
    const LibraryNote note{true, 4, {"warm"}, QDateTime::fromMSecsSinceEpoch(1'700'000'000'123)};
    QVERIFY(store.write({{"gold", note}}));
    QVERIFY(LibraryStore(path()).read()["gold"] == note);
  }

  /// Where nothing can be written, notes are still shown.
  void readOnly() {
    QVERIFY(LibraryStore(path()).write({{"gold", LibraryNote{.rating = 4}}}));
    QVERIFY(OtherProgram(path()).run("PRAGMA journal_mode = DELETE"));
    QFile file(path());
    constexpr int writeVersionByte = 18;  // of the header; SQLite does not write files of a later version
    QVERIFY(file.open(QFile::ReadWrite) && file.seek(writeVersionByte) && file.putChar(3));
    file.close();
    LibraryStore store(path());
    QCOMPARE(store.read()["gold"].rating, 4);
    QVERIFY(!store.write({{"gold", LibraryNote{.rating = 1}}}) && store.failure().contains("readonly"));
  }

 private:
  /// A connection that uses the file as another program does.
  class OtherProgram {
   public:
    explicit OtherProgram(const QString& path) : m_name(QUuid::createUuid().toString()) {
      QSqlDatabase database = QSqlDatabase::addDatabase("QSQLITE", m_name);
      database.setDatabaseName(path);
      if (!database.open()) qFatal("cannot open the file");
    }
    ~OtherProgram() { close(); }
    bool run(const QString& statement) { return QSqlQuery(QSqlDatabase::database(m_name)).exec(statement); }
    QString value(const QString& statement) {
      QSqlQuery query(statement, QSqlDatabase::database(m_name));
      return query.next() ? query.value(0).toString() : QString();
    }
    QString name() const { return m_name; }
    void close() { QSqlDatabase::removeDatabase(m_name); }

   private:
    QString m_name;
  };

  QString path() const { return folder_->filePath("deeper/library.sqlite"); }

  std::unique_ptr<QTemporaryDir> folder_;
};

GONIO_TEST(LibraryStoreTest)
}  // namespace library_store_test

#include "library_store_test.moc"
