// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/background_task.h"

#include <QSignalSpy>
#include <QTest>
#include <QThread>

#include "tests/support/test_program.h"

namespace background_task_test {
using namespace gonio;
using namespace gonio::app;

/// Works until it is stopped.
int untilStopped(const TaskControl& control) {
  for (;;) {
    control.throwIfStopped();
    QThread::msleep(1);
  }
}
class BackgroundTaskTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void resultArrivesInThisThread() {
    BackgroundTasks tasks;
    QThread *worker = nullptr, *receiver = nullptr;
    int result = 0;
    tasks.run<int>(
        {"Count", "count"},
        [&](const TaskControl&) {
          worker = QThread::currentThread();
          return 42;
        },
        [&](int value) {
          result = value;
          receiver = QThread::currentThread();
        });
    QTRY_COMPARE(result, 42);
    QVERIFY(worker != receiver);
    QCOMPARE(receiver, QThread::currentThread());
    QVERIFY(tasks.isIdle());
  }

  /// Long tasks, however many, do not keep a short one waiting.
  void shortTasksDoNotWait() {
    BackgroundTasks tasks;
    for (const char* key : {"a", "b", "c"})
      tasks.run<int>({.title = key, .key = key, .isLong = true}, untilStopped, [](int) { QFAIL("it does not end"); });
    int result = 0;
    tasks.run<int>(
        {"Open", "open"}, [](const TaskControl&) { return 7; }, [&](int value) { result = value; });
    QTRY_COMPARE(result, 7);
    QCOMPARE(tasks.shown().size(), std::size_t(3));
    tasks.stopAll();
  }

  void errorsArriveAsText() {
    BackgroundTasks tasks;
    QString error;
    tasks.run<int>(
        {"Read", "read"}, [](const TaskControl&) -> int { throw Error("a.binary: too short"); },
        [](int) { QFAIL("no result"); }, [&](const QString& text) { error = text; });
    QTRY_COMPARE(error, QStringLiteral("a.binary: too short"));
  }

  void failuresThatNobodyHandlesAreReported() {
    BackgroundTasks tasks;
    QSignalSpy failed(&tasks, &BackgroundTasks::failed);
    tasks.run<int>(
        {"Check", "check"}, [](const TaskControl&) -> int { throw Error("a.binary: too short"); }, [](int) {});
    QTRY_COMPARE(failed.size(), 1);
    QCOMPARE(failed[0][0].toString(), QStringLiteral("Check failed"));
    QCOMPARE(failed[0][1].toString(), QStringLiteral("a.binary: too short"));
  }

  /// Held work waits for its release, in order, or for the time that is given; cancelled meanwhile it does not run.
  void heldWorkWaits() {
    BackgroundTasks tasks;
    int done = 0, cancelled = 0;
    const auto ask = [&](const char* key) {
      tasks.run<int>(
          {key, key}, [](const TaskControl&) { return 1; }, [&](int r) { done += r; }, {}, [&] { ++cancelled; });
    };
    tasks.hold(60000);
    ask("one");
    ask("two");
    QTest::qWait(30);
    QVERIFY(done == 0 && tasks.isRunning("one") && tasks.isRunning("two"));
    tasks.cancel("two");
    tasks.release();
    QTRY_VERIFY(tasks.isIdle());
    QVERIFY(done == 1 && cancelled == 1);
    tasks.hold(20);
    ask("three");
    QTRY_COMPARE(done, 2);
    ask("four");
    QTRY_COMPARE(done, 3);
  }

  /// Live work is neither shown nor stopped by Esc, and does not wait for thumbnails or other work.
  void liveWorkGoesOnUnseen() {
    BackgroundTasks tasks;
    int result = 0;
    tasks.run<int>({"Picture", "picture", true}, untilStopped, [](int) {});
    tasks.run<int>({"One", "one"}, untilStopped, [](int) {});
    tasks.run<int>({"Two", "two"}, untilStopped, [](int) {});
    tasks.run<int>(
        {"Check", "check", false, true}, [](const TaskControl&) { return 7; }, [&](int r) { result = r; });
    QCOMPARE(tasks.topmost()->title, QStringLiteral("Two"));
    QTRY_COMPARE(result, 7);
    tasks.drop("one");
    tasks.drop("two");
    tasks.drop("picture");
    tasks.run<int>({"Check", "check", false, true}, untilStopped, [](int) {});
    QVERIFY(!tasks.topmost());
    tasks.cancelTopmost();
    QTest::qWait(30);
    QVERIFY(tasks.isRunning("check"));
  }

  void cancelStopsTheTopmost() {
    BackgroundTasks tasks;
    bool firstCancelled = false, secondCancelled = false;
    tasks.run<int>(
        {"One", "one"}, untilStopped, [](int) {}, {}, [&] { firstCancelled = true; });
    tasks.run<int>(
        {"Two", "two"}, untilStopped, [](int) {}, {}, [&] { secondCancelled = true; });
    QCOMPARE(tasks.topmost()->title, QStringLiteral("Two"));
    tasks.cancelTopmost();
    QTRY_VERIFY(secondCancelled);
    QVERIFY(!firstCancelled);
    QVERIFY(tasks.isRunning("one"));
    tasks.cancelTopmost();
    QTRY_VERIFY(firstCancelled);
  }

  /// Work that returns its best so far when stopped delivers it.
  void cancelledWorkMayStillDeliver() {
    BackgroundTasks tasks;
    int result = 0;
    tasks.run<int>(
        {"Fit", "fit"},
        [](const TaskControl& control) {
          while (!control.stop.stop_requested()) QThread::msleep(1);
          return 7;
        },
        [&](int value) { result = value; });
    tasks.cancel("fit");
    // Stopped before its start it is cancelled, later it delivers; both end it.
    QTRY_VERIFY(tasks.isIdle());
    QVERIFY(result == 7 || result == 0);
  }

  void aNewerTaskReplacesAnOlderOne() {
    BackgroundTasks tasks;
    QList<int> results;
    bool reported = false;
    tasks.run<int>(
        {"Old", "load"}, untilStopped, [&](int v) { results << v; }, {}, [&] { reported = true; });
    tasks.run<int>(
        {"New", "load"}, [](const TaskControl&) { return 2; }, [&](int v) { results << v; });
    QTRY_COMPARE(results, QList<int>{2});
    QVERIFY(tasks.isIdle());  // the old one is no longer waited for
    QTest::qWait(20);
    QVERIFY(!reported);
    QCOMPARE(results, QList<int>{2});
  }

  void progressIsShown() {
    BackgroundTasks tasks;
    std::atomic<bool> go = false;
    tasks.run<int>(
        {"Half", "half"},
        [&](const TaskControl& control) {
          control.report(0.5);
          while (!go) QThread::msleep(1);
          return 0;
        },
        [](int) {});
    QSignalSpy changed(&tasks, &BackgroundTasks::changed);
    QTRY_VERIFY(tasks.topmost() && tasks.topmost()->fraction == 0.5);
    QTRY_VERIFY(changed.count() > 0);
    go = true;
    QTRY_VERIFY(tasks.isIdle());
  }

  /// A long one, such as a check, does not block a short one, such as a thumbnail.
  void quietTasksRunBesideALongOne() {
    BackgroundTasks tasks;
    tasks.run<int>({"Long", "long", true}, untilStopped, [](int) {});
    bool done = false;
    tasks.run<int>(
        {"Short", "short", true}, [](const TaskControl&) { return 1; }, [&](int) { done = true; });
    QTRY_VERIFY(done);
    tasks.drop("long");
  }

  void quietTasksStepBack() {
    BackgroundTasks tasks;
    tasks.run<int>({"Loud", "loud"}, untilStopped, [](int) {});
    tasks.run<int>({"Quiet", "quiet", true}, untilStopped, [](int) {});
    QCOMPARE(tasks.topmost()->title, QStringLiteral("Loud"));
    tasks.cancelTopmost();
    QTRY_VERIFY(!tasks.isRunning("loud"));
    QCOMPARE(tasks.topmost()->title, QStringLiteral("Quiet"));
    tasks.cancelTopmost();
    QVERIFY(tasks.isRunning("quiet"));
    tasks.drop("quiet");
    QVERIFY(tasks.isIdle());
  }

  void destructionStopsAndWaits() {
    std::atomic<bool> ended = false;
    {
      BackgroundTasks tasks;
      std::atomic<bool> began = false;
      tasks.run<int>(
          {"Long", "long"},
          [&](const TaskControl& control) {
            began = true;
            while (!control.stop.stop_requested()) QThread::msleep(1);
            ended = true;
            return 0;
          },
          [](int) {});
      while (!began) QThread::msleep(1);
    }
    QVERIFY(ended);
  }
};

GONIO_TEST(BackgroundTaskTest)
}  // namespace background_task_test

#include "background_task_test.moc"
