// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <fcntl.h>
#include <pty.h>
#include <unistd.h>

#include "tests/app/goniotool/interruption.h"
#include "tests/support/test_program.h"

namespace goniotool_signals_test {
using namespace gonio::test;

class GoniotoolSignalsTest : public QObject {
  Q_OBJECT

  /// Seconds of rendering, with a report of progress every 5 %.
  QStringList longCommand() const {
    return {"render", plastic_, "--size", "64", "--samples", "4000", "--progress", "--out", image_};
  }

 private Q_SLOTS:
  void initTestCase() { plastic_ = folder_.writeTable("plastic.binary", "ggx", plastic); }

  void aSignalEndsTheWork_data() {
    QTest::addColumn<int>("signal");
    QTest::newRow("keyboard") << SIGINT;
    QTest::newRow("kill") << SIGTERM;
    QTest::newRow("closed terminal") << SIGHUP;
  }
  /// The parent sees that the signal ended the program, as it would without a handler, but nothing is left half done.
  void aSignalEndsTheWork() {
    QFETCH(int, signal);
    const Interruption run = interrupt(longCommand(), signal, "rendering");
    QCOMPARE(run.endedBySignal, signal);
    QVERIFY2(run.error.endsWith("goniotool: interrupted\n"), qPrintable(run.error));
    QVERIFY(!QFile::exists(image_));
  }

  /// As `timeout` sends it: to the process, then to its group.
  void repeatedAtOnceASignalCountsOnce() {
    const Interruption run = interrupt(longCommand(), SIGTERM, "rendering", 3);
    QCOMPARE(run.endedBySignal, SIGTERM);
    QVERIFY2(run.error.endsWith("goniotool: interrupted\n"), qPrintable(run.error));
  }

  /// Of whatever kind, where the first one does not stop the work: here, because nobody reads the progress.
  void aLaterSignalEndsTheProgram() {
    int full[2];
    QCOMPARE(::pipe(full), 0);
    const int size = ::fcntl(full[1], F_GETPIPE_SZ);
    QCOMPARE(::write(full[1], QByteArray(size, ' ').data(), std::size_t(size)), ssize_t(size));
    QProcess process;
    process.setChildProcessModifier([&full] {
      for (const int signal : {SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
      ::dup2(full[1], STDERR_FILENO);
    });
    process.start(GONIO_TOOL, longCommand());
    QVERIFY(process.waitForStarted());
    QTest::qWait(500);
    ::kill(pid_t(process.processId()), SIGTERM);
    QVERIFY(!process.waitForFinished(1000));
    ::kill(pid_t(process.processId()), SIGHUP);
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitCode(), SIGHUP);
    for (const int end : full) ::close(end);
  }

  /// Neither by a part of its new results nor by none.
  void anInterruptedStudyReplacesNoResults() {
    const QString out = folder_.path("study");
    const QStringList study{"study", plastic_,     "--representations", "fits",  "--models", "lambert",
                            "ggx",   "--no-times", "--progress",        "--out", out};
    const auto results = [&] {
      QFile file(out + "/plastic.json");
      return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    QCOMPARE(runTool(study + QStringList{"--size", "16"}).code, 0);
    const QByteArray before = results();
    QVERIFY(!before.isEmpty());
    const Interruption stopped = interrupt(study + QStringList{"--samples", "300"}, SIGTERM, "studying");
    QCOMPARE(stopped.endedBySignal, 0);
    QCOMPARE(results(), before);
  }

  /// Not behind the progress that stands there.
  void theMessageHasALineOfItsOwn() {
    int master = -1, terminal = -1;
    QCOMPARE(::openpty(&master, &terminal, nullptr, nullptr, nullptr), 0);
    QProcess process;
    process.setChildProcessModifier([terminal] {
      ::dup2(terminal, STDERR_FILENO);
      std::signal(SIGINT, SIG_DFL);
    });
    process.start(GONIO_TOOL, longCommand());
    QVERIFY(process.waitForStarted());
    ::close(terminal);
    QByteArray shown;
    char part[256];
    bool interrupted = false;
    for (ssize_t count = 0; (count = ::read(master, part, sizeof part)) > 0;) {
      shown.append(part, count);
      if (interrupted || !shown.contains("rendering")) continue;
      interrupted = true;
      ::kill(pid_t(process.processId()), SIGINT);
    }
    ::close(master);
    QVERIFY(process.waitForFinished(60000));
    QVERIFY2(shown.endsWith("%\r\033[Kgoniotool: interrupted\r\n"), shown.right(100).constData());
  }

  /// As under nohup, and in the background of a shell script.
  void signalsThatTheParentIgnoresStayIgnored() {
    QProcess process;
    process.setChildProcessModifier([] { std::signal(SIGHUP, SIG_IGN); });
    process.start(GONIO_TOOL, longCommand());
    process.setReadChannel(QProcess::StandardError);
    QVERIFY(process.waitForReadyRead(60000));
    ::kill(pid_t(process.processId()), SIGHUP);
    // Two more reports follow: it works on.
    for (int report = 0; report < 2; ++report) {
      (void)process.readAllStandardError();
      QVERIFY(process.waitForReadyRead(60000));
    }
    ::kill(pid_t(process.processId()), SIGTERM);
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitCode(), SIGTERM);
  }

 private:
  TestFolder folder_{"goniotool-signals"};
  QString plastic_, image_ = folder_.path("image.exr");
};

GONIO_TEST(GoniotoolSignalsTest)
}  // namespace goniotool_signals_test

#include "goniotool_signals_test.moc"
