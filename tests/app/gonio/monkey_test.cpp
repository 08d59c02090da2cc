// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/app/gonio/monkey.h"

#include <QDesktopServices>
#include <QElapsedTimer>
#include <QPixmapCache>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QUrl>
#include <cstdio>
#include <optional>

#include "app/gonio/window/theme.h"
#include "core/dictionary/signals.h"
#include "core/geometry/bundled_meshes.h"
#include "core/materials/basis_file.h"
#include "core/materials/dictionary_file.h"
#include "tests/support/resident_memory.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_context.h"
#include "widgets/preview/gl/textures.h"

namespace monkey_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::geometry;
using namespace gonio::app;

QStringList messages;

void listen(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (type == QtDebugMsg || type == QtInfoMsg) return;
  messages << text;
}

/// The workspace that GONIO_MONKEY_WORKSPACE names.
std::optional<DockLayout::Workspace> askedWorkspace() {
  const QList<QByteArray> names{"edit", "compare", "analyse", "acquire"};
  const qsizetype index = names.indexOf(qgetenv("GONIO_MONKEY_WORKSPACE"));
  if (index < 0) return std::nullopt;
  return DockLayout::Workspace(index);
}

/// GONIO_MONKEY_SECONDS, GONIO_MONKEY_SEED and GONIO_MONKEY_WORKSPACE (edit, compare, analyse, acquire) in the
/// environment ask for another run than half a minute. Qt Test stops a run of more than five minutes unless
/// QTEST_FUNCTION_TIMEOUT (milliseconds) allows it. After ten minutes and at the end the memory is compared.
class MonkeyTest : public QObject {
  Q_OBJECT

  const QTemporaryDir m_home;

  static constexpr int secondsOfMark = 600;

  /// Data that the program computes at their first use and then keeps. Before the mark, so that the memory that is
  /// compared does not depend on when an action uses them first.
  static void computeWhatIsKept() {
    (void)materials::bundledEnsemble();
    (void)materials::bundledBasis();
    (void)dictionary::GridGeometry::of(HalfDifferenceGrid());
    for (const std::string& name : bundledEnvironmentNames())
      (void)widgets::environmentTexels(bundledEnvironment(name));
    for (const std::string& name : bundledMeshNames()) (void)bundledMesh(name);
  }

  /// The same state each time, whatever was opened, learned and chosen before: a new window that shows one material, at
  /// rest. Memory that has grown then belongs to nothing that is shown. Qt's cache of icons, which is limited to 10 MB,
  /// is empty.
  static MainWindow* settledWindow(MainWindow* old) {
    delete old;
    QPixmapCache::clear();
    QSettings().clear();
    auto* window = new MainWindow;
    window->show();
    window->files().open("library:rgl/satin_purple");
    constexpr int patienceMs = 120'000, restMs = 10'000, rests = 60;
    for (std::size_t before = 0, i = 0; i < rests && test::allocatedMegabytes() != before; ++i) {
      before = test::allocatedMegabytes();
      QTest::qWait(restMs);
      (void)QTest::qWaitFor([&] { return window->parts().isSettled(); }, patienceMs);
    }
    return window;
  }

 private Q_SLOTS:
  void initTestCase() {
    applyTheme(*qApp, Theme::system);
    const test::OffscreenContext context;
    if (!context.isValid()) QSKIP("needs an OpenGL 4.1 context");
    // What it writes goes nowhere else, and no browser opens.
    for (const char* place : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"})
      qputenv(place, m_home.path().toUtf8());
    QVERIFY(QDir::setCurrent(m_home.path()));
    for (const char* scheme : {"file", "http", "https"}) QDesktopServices::setUrlHandler(scheme, this, "ignore");
  }

  void cleanupTestCase() {
    for (const char* scheme : {"file", "http", "https"}) QDesktopServices::unsetUrlHandler(scheme);
  }

  /// Whatever is done, the program goes on, and writes nothing on its error output.
  void nothingBreaks() {
    bool isNumber = false;
    const int asked = qEnvironmentVariableIntValue("GONIO_MONKEY_SECONDS", &isNumber);
    const int seconds = isNumber ? asked : 30;
    const auto seed = unsigned(qEnvironmentVariableIntValue("GONIO_MONKEY_SEED"));
    if (seconds > secondsOfMark) computeWhatIsKept();
    QPointer<MainWindow> window = new MainWindow;
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window));
    messages.clear();
    const QtMessageHandler before = qInstallMessageHandler(listen);
    auto monkey = std::make_unique<test_support::Monkey>(*window, seed, askedWorkspace());
    std::size_t marked = 0, last = 0;
    qint64 minute = 0;
    int count = 0;
    QElapsedTimer clock;
    for (clock.start(); clock.elapsed() < 1000 * seconds && window && messages.isEmpty();) {
      monkey->play(1000);
      const qint64 passed = clock.elapsed() / 1000;
      const bool isMark = marked == 0 && passed >= secondsOfMark, isEnd = passed >= seconds;
      if (!window || (!isMark && !isEnd && passed / 60 == minute)) continue;
      minute = passed / 60;
      if (isMark || (isEnd && marked > 0)) {
        count += monkey->count();
        monkey.reset();
        window = settledWindow(window);
        monkey = std::make_unique<test_support::Monkey>(*window, seed + 1, askedWorkspace());
      }
      last = test::residentMegabytes();
      if (isMark) marked = last;
      std::printf("%lld s, %d acts: %zu MB resident, %zu MB in use\n", passed, count + monkey->count(), last,
                  test::allocatedMegabytes());
      std::fflush(stdout);
    }
    const bool alive = window;
    delete window;
    qInstallMessageHandler(before);
    QVERIFY2(alive, qPrintable("the window closed after " + monkey->lastActs()));
    QVERIFY2(messages.isEmpty(), qPrintable(messages.join('\n') + "\nafter " + monkey->lastActs()));
    QVERIFY(count + monkey->count() > 0);
    // The allocators of sanitizers keep freed memory.
    if (marked > 0 && test::jemallocControl())
      QVERIFY2(double(last) <= 1.05 * double(marked), "memory grew after ten minutes");
  }

  void ignore(const QUrl&) {}
};

GONIO_TEST(MonkeyTest)
}  // namespace monkey_test

#include "monkey_test.moc"
