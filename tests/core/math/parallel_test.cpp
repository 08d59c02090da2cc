// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/parallel.h"

#include <QTest>
#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/support/test_program.h"

namespace parallel_test {
using namespace gonio;

class ParallelTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void everyIndexIsVisitedOnce() {
    for (const std::size_t count : {0, 1, 63, 64, 65, 10000})
      for (const std::size_t block : {0, 1, 64, 20000}) {
        std::vector<int> visits(count, 0);
        parallelForBlocks(count, block, [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) ++visits[i];
        });
        for (const int n : visits) QCOMPARE(n, 1);
      }
  }

  void sumHasTheSameBitsForAnyThreadCount() {
    const auto sum = [] {
      return parallelSumBlocks(1000003, 1000, [](std::size_t begin, std::size_t end) {
        double s = 0;
        for (std::size_t i = begin; i < end; ++i) s += std::sin(double(i)) / double(i + 1);
        return s;
      });
    };
    const double all = sum();
    for (const int threads : {1, 2, 3}) {
      const ThreadLimit limit(threads);
      QVERIFY(sum() == all);
    }
  }

  void progressRisesToOne() {
    double last = 0;
    bool fell = false;
    TaskControl control;
    control.progress = [&](double fraction) {
      fell = fell || fraction < last;
      last = fraction;
    };
    parallelForBlocks(
        1000, 7, [](std::size_t, std::size_t) {}, control);
    QVERIFY(!fell);
    QCOMPARE(last, 1.0);
  }

  void stopIsObeyed() {
    std::stop_source source;
    TaskControl control;
    control.stop = source.get_token();
    std::atomic<int> blocks = 0;
    QVERIFY_THROWS_EXCEPTION(Cancelled, parallelForBlocks(
                                            10000, 1,
                                            [&](std::size_t, std::size_t) {
                                              if (++blocks == 10) source.request_stop();
                                            },
                                            control));
    QVERIFY(blocks < 10000);
    QVERIFY_THROWS_EXCEPTION(Cancelled, parallelForBlocks(
                                            0, 1, [](std::size_t, std::size_t) {}, control));
  }

  /// A block of an outer loop fails while another runs a loop of its own: that one ends by an exception too, or is
  /// complete. It never returns with blocks left out.
  void anInnerLoopIsCompleteOrThrows() {
    constexpr int innerBlocks = 2000;
    for (int trial = 0; trial < 20; ++trial) {
      std::atomic<int> done = 0;
      std::atomic<bool> started = false, returnedIncomplete = false;
      const auto outer = [&](std::size_t begin, std::size_t) {
        if (begin == 0) {
          for (int wait = 0; wait < 1000 && !started; ++wait)
            std::this_thread::sleep_for(std::chrono::microseconds(10));
          throw Error("the outer loop fails");
        }
        parallelForBlocks(innerBlocks, 1, [&](std::size_t, std::size_t) {
          started = true;
          std::this_thread::sleep_for(std::chrono::microseconds(1));
          ++done;
        });
        if (done < innerBlocks) returnedIncomplete = true;
      };
      QVERIFY_THROWS_EXCEPTION(Error, parallelForBlocks(2, 1, outer));
      QVERIFY(!returnedIncomplete);
    }
  }

  void exceptionsOfTheWorkComeThrough() {
    QVERIFY_THROWS_EXCEPTION(Error, parallelForBlocks(100, 1, [](std::size_t begin, std::size_t) {
                               if (begin == 50) throw Error("fifty");
                             }));
  }
};

GONIO_TEST(ParallelTest)
}  // namespace parallel_test

#include "parallel_test.moc"
