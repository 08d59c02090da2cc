// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

#include <algorithm>
#include <mutex>
#include <vector>

namespace gonio {

namespace {

// The thread sanitizer does not see into TBB, which is not built with it: it is told what a parallel loop orders,
// namely all before the loop, then the tasks, then all after it.
#ifdef __SANITIZE_THREAD__
class LoopOrder {
 public:
  LoopOrder() { __tsan_release(&begin_); }
  ~LoopOrder() { __tsan_acquire(&end_); }

  class Task {
   public:
    explicit Task(LoopOrder& order) : order_(order) { __tsan_acquire(&order_.begin_); }
    ~Task() { __tsan_release(&order_.end_); }

   private:
    LoopOrder& order_;
  };

 private:
  char begin_ = 0, end_ = 0;
};
#else
struct LoopOrder {
  struct Task {
    explicit Task(LoopOrder&) {}
  };
};
#endif

}  // namespace

void parallelForBlocks(std::size_t count, std::size_t blockSize,
                       const std::function<void(std::size_t begin, std::size_t end)>& work,
                       const TaskControl& control) {
  control.throwIfStopped();
  if (count == 0) return;
  if (blockSize == 0) blockSize = 1;
  const std::size_t blocks = (count + blockSize - 1) / blockSize;
  std::mutex progressMutex;
  std::size_t done = 0;
  LoopOrder order;
  tbb::task_group_context context;
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, blocks, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        [[maybe_unused]] const LoopOrder::Task task(order);
        for (std::size_t block = range.begin(); block != range.end(); ++block) {
          control.throwIfStopped();
          const std::size_t begin = block * blockSize;
          work(begin, begin + blockSize < count ? begin + blockSize : count);
          if (control.progress) {
            const std::lock_guard lock(progressMutex);
            control.report(static_cast<double>(++done) / static_cast<double>(blocks));
          }
        }
      },
      tbb::simple_partitioner(), context);
  // Within a block of an outer loop that ends by an exception, TBB ends the inner loops too, and returns.
  if (context.is_group_execution_cancelled()) throw Cancelled();
}

double parallelSumBlocks(std::size_t count, std::size_t blockSize,
                         const std::function<double(std::size_t begin, std::size_t end)>& blockSum,
                         const TaskControl& control) {
  if (blockSize == 0) blockSize = 1;
  std::vector<double> sums((count + blockSize - 1) / blockSize, 0.0);
  parallelForBlocks(
      count, blockSize, [&](std::size_t begin, std::size_t end) { sums[begin / blockSize] = blockSum(begin, end); },
      control);
  double total = 0;
  for (const double sum : sums) total += sum;
  return total;
}

void runQuietly(const std::function<void()>& work) {
#ifdef __linux__
  // A quarter of the fraction of a normal thread: idle priority would starve on a machine that is busy otherwise.
  constexpr int niceness = 5;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), niceness);
#endif
  tbb::task_arena(1).execute(work);
}

int threadCount() {
  const auto allowed = int(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  return std::min(allowed, tbb::this_task_arena::max_concurrency());
}

ThreadLimit::ThreadLimit(int threads)
    : control_(new tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                       static_cast<std::size_t>(threads > 0 ? threads : 1))) {}

ThreadLimit::~ThreadLimit() { delete static_cast<tbb::global_control*>(control_); }

}  // namespace gonio
