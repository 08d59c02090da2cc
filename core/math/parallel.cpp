// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "core/support/system.h"

namespace gonio {

namespace {

#ifdef GONIO_THREAD_SANITIZER
/// TBB is not built with the thread sanitizer, which would take its ways of passing work on for data races: plain
/// threads do the work instead.
void forEachBlock(std::size_t blocks, const std::function<void(std::size_t block)>& work) {
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto run = [&] {
    try {
      for (std::size_t block = next++; block < blocks && !failed; block = next++) work(block);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failed.exchange(true)) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (int thread = 1; thread < threadCount(); ++thread) others.emplace_back(run);
    run();
  }
  if (failure) std::rethrow_exception(failure);
}
#else
void forEachBlock(std::size_t blocks, const std::function<void(std::size_t block)>& work) {
  tbb::task_group_context context;
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, blocks, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t block = range.begin(); block != range.end(); ++block) work(block);
      },
      tbb::simple_partitioner(), context);
  // Within a block of an outer loop that ends by an exception, TBB ends the inner loops too, and returns.
  if (context.is_group_execution_cancelled()) throw Cancelled();
}
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
  forEachBlock(blocks, [&](std::size_t block) {
    control.throwIfStopped();
    const std::size_t begin = block * blockSize;
    work(begin, begin + blockSize < count ? begin + blockSize : count);
    if (control.progress) {
      const std::lock_guard lock(progressMutex);
      control.report(static_cast<double>(++done) / static_cast<double>(blocks));
    }
  });
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

void runAtLowPriority(const std::function<void()>& work) {
  system::lowerThreadPriority();
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
