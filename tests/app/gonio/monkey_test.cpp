// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/app/gonio/monkey.h"

#include <QDesktopServices>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QUrl>

#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_context.h"

namespace monkey_test {
using namespace gonio;
using namespace gonio::app;

QStringList messages;

void listen(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (type == QtDebugMsg || type == QtInfoMsg) return;
  messages << text;
}

/// GONIO_MONKEY_SECONDS and GONIO_MONKEY_SEED in the environment ask for another run than the short one.
class MonkeyTest : public QObject {
  Q_OBJECT

  const QTemporaryDir m_home;

 private Q_SLOTS:
  void initTestCase() {
    const test::OffscreenContext context;
    if (!context.isValid()) QSKIP("needs an OpenGL 4.1 context");
    // What it writes goes nowhere else, and no browser opens.
    for (const char* place : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"})
      qputenv(place, m_home.path().toUtf8());
    QVERIFY(QDir::setCurrent(m_home.path()));
    for (const char* scheme : {"file", "http", "https"}) QDesktopServices::setUrlHandler(scheme, this, "ignore");
  }

  /// Whatever is done, the program goes on, and writes nothing on its error output.
  void nothingBreaks() {
    bool isNumber = false;
    const int asked = qEnvironmentVariableIntValue("GONIO_MONKEY_SECONDS", &isNumber);
    const int seconds = isNumber ? asked : 6;
    const auto seed = unsigned(qEnvironmentVariableIntValue("GONIO_MONKEY_SEED"));
    auto* window = new MainWindow;
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    messages.clear();
    const QtMessageHandler before = qInstallMessageHandler(listen);
    test_support::Monkey monkey(*window, seed);
    const QPointer<MainWindow> guard = window;
    for (int second = 0; second < seconds && guard && messages.isEmpty(); ++second) monkey.play(1000);
    const bool alive = guard;
    delete guard;
    qInstallMessageHandler(before);
    QVERIFY2(alive, qPrintable("the window closed after " + monkey.lastActs()));
    QVERIFY2(messages.isEmpty(), qPrintable(messages.join('\n') + "\nafter " + monkey.lastActs()));
    QVERIFY(monkey.count() > 0);
  }

  void ignore(const QUrl&) {}
};

GONIO_TEST(MonkeyTest)
}  // namespace monkey_test

#include "monkey_test.moc"
