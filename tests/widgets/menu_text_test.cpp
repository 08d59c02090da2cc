// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/inputs/menu_text.h"

#include <QTest>
#include <QWidget>
#include <QWindow>

#include "tests/support/hostile_names.h"
#include "tests/support/test_program.h"

namespace menu_text_test {
using namespace gonio::widgets;

class MenuTextTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void marksOfKeys() {
    QCOMPARE(menuText("R&D && more"), "R&&D &&&& more");
    QCOMPARE(withoutKeyMarks("&Open R&&D &"), "Open R&D ");
    QCOMPARE(menuText("a\tb\nc\u2028d"), "a b c d");
    QVERIFY(menuText(QString(10000, 'x')).size() < 200);
  }

  void everyName() {
    for (const gonio::test::HostileName& name : gonio::test::hostileNames()) {
      const QString text = QString::fromStdString(name.text);
      QVERIFY2(withoutKeyMarks(menuText(text)) == oneLine(text), name.id);
      if (text.size() <= 100) QVERIFY2(oneLine(text).size() == text.size(), name.id);
    }
  }

  /// Qt replaces the mark of unsaved changes in titles.
  void titles() {
    QWidget window;
    window.show();
    window.setWindowTitle("a" + titleText("gold[*]") + "[*]");
    for (const bool modified : {false, true}) {
      window.setWindowModified(modified);
      QCOMPARE(window.windowHandle()->title(), modified ? "agold[*]*" : "agold[*]");
    }
  }
};

GONIO_TEST(MenuTextTest)
}  // namespace menu_text_test

#include "menu_text_test.moc"
