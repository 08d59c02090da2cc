// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/preferences.h"

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "app/gonio/library/thumbnail.h"
#include "core/math/parallel.h"
#include "tests/support/test_program.h"

namespace preferences_test {
using namespace gonio;
using namespace gonio::app;

class PreferencesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

  /// What is written is read; what makes no sense is brought into its range.
  void keepsItsValues() {
    const QTemporaryDir folder;
    QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
    const Preferences first = Preferences::read(settings);
    QVERIFY(first.threads == 0 && first.historyMegabytes > 1 && first.theme == Theme::dark);
    const Preferences chosen{Theme::dark, 77, 1, widgets::RoughnessDisplay::squareRoot};
    chosen.write(settings);
    QVERIFY(Preferences::read(settings) == chosen);
    settings.setValue("threads", -5);
    settings.setValue("history/megabytes", "many");
    QVERIFY(Preferences::read(settings).threads == 0 && Preferences::read(settings).historyMegabytes == 1);
  }

  /// The dialog gives back what it was given, and what is changed in it.
  void theDialogKeepsThem() {
    const Preferences given{Theme::light, 300, 1, widgets::RoughnessDisplay::squareRoot};
    PreferencesDialog dialog(given, "Renderer X; 4.5", nullptr);
    QVERIFY(dialog.preferences() == given);
    bool hasGraphics = false;
    for (const QLabel* label : dialog.findChildren<QLabel*>()) hasGraphics |= label->text() == "Renderer X; 4.5";
    QVERIFY(hasGraphics);
    dialog.findChild<QComboBox*>()->setCurrentIndex(int(Theme::dark));
    QCOMPARE(dialog.preferences().theme, Theme::dark);
  }

  void threadsAreLimited() {
    const int all = threadCount();
    limitThreads(1);
    QCOMPARE(threadCount(), 1);
    limitThreads(0);
    QCOMPARE(threadCount(), all);
  }

  /// Only pictures that the program made go.
  void thumbnailsAreCleared() {
    QDir folder(thumbnailCacheFolder());
    QVERIFY(folder.mkpath("."));
    QVERIFY(QFile(folder.filePath("one.png")).open(QIODevice::WriteOnly));
    QVERIFY(QFile(folder.filePath("notes.txt")).open(QIODevice::WriteOnly));
    PreferencesDialog dialog({}, {}, nullptr);
    for (QPushButton* button : dialog.findChildren<QPushButton*>())
      if (button->text().remove('&') == "Clear") button->click();
    QCOMPARE(folder.entryList(QDir::Files), QStringList{"notes.txt"});
    QVERIFY(folder.remove("notes.txt"));
  }
};

GONIO_TEST(PreferencesTest)

}  // namespace preferences_test

#include "preferences_test.moc"
