// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <functional>

#include "core/support/task_control.h"

namespace gonio {

/// Calls `work(begin, end)` for consecutive blocks of [0, count), on all cores (or the number set by ThreadLimit).
/// The blocks depend only on `count` and `blockSize`, so work that writes to its own range, or to a slot of its own
/// block, gives bitwise equal results for any number of threads. Progress is reported per block. @throws Cancelled if
/// the control's stop was requested; whatever `work` throws.
void parallelForBlocks(std::size_t count, std::size_t blockSize,
                       const std::function<void(std::size_t begin, std::size_t end)>& work,
                       const TaskControl& control = {});

/// Sum of `blockSum(begin, end)` over the blocks, added in their order: deterministic for any number of threads.
double parallelSumBlocks(std::size_t count, std::size_t blockSize,
                         const std::function<double(std::size_t begin, std::size_t end)>& blockSum,
                         const TaskControl& control = {});

/// Runs low-priority work on the calling thread only: its parallel loops use no other thread. Lowers the thread's
/// priority permanently where the system permits it, so call this on a thread without other work.
void runAtLowPriority(const std::function<void()>& work);

/// Number of threads that parallel loops of the calling thread may use now.
int threadCount();

/// Limits the number of threads of all parallel loops of the process during its lifetime (tests of determinism,
/// `goniotool --threads`). Do not create instances on several threads at once.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  void* control_;
};

}  // namespace gonio
