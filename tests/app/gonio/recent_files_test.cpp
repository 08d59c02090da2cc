// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/material_files.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/test_program.h"

namespace recent_files_test {
using gonio::app::RecentFiles;

class RecentFilesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void newestFirstTenAtMostAndKept() {
    const QTemporaryDir folder;
    QSettings settings(folder.filePath("settings.ini"), QSettings::IniFormat);
    RecentFiles recent(settings);
    for (int i = 0; i < 12; ++i) recent.add(QStringLiteral("/data/%1.binary").arg(i));
    recent.add("/data/5.binary");
    recent.add("library:sgd/chrome");
    QCOMPARE(recent.paths().size(), 10);
    QCOMPARE(recent.paths().mid(0, 3), QStringList({"library:sgd/chrome", "/data/5.binary", "/data/11.binary"}));
    QCOMPARE(RecentFiles(settings).paths(), recent.paths());
    QVERIFY(RecentFiles::exists("library:sgd/chrome"));
    QVERIFY(!RecentFiles::exists("/data/5.binary"));
    recent.clear();
    QVERIFY(RecentFiles(settings).paths().isEmpty());
  }
};

GONIO_TEST(RecentFilesTest)
}  // namespace recent_files_test

#include "recent_files_test.moc"
