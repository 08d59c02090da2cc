// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <functional>

#include "core/support/task_control.h"

namespace gonio {

/// Calls `work(begin, end)` for consecutive blocks of [0, count), on all cores (or the number set by ThreadLimit).
/// The blocks depend only on `count` and `blockSize`, never on the number of threads: work that writes to its own
/// range, or to a slot of its own block, gives the same bits for any number of threads. Progress is reported by block.
/// @throws Cancelled when the control's stop was requested; whatever `work` throws.
void parallelForBlocks(std::size_t count, std::size_t blockSize,
                       const std::function<void(std::size_t begin, std::size_t end)>& work,
                       const TaskControl& control = {});

/// Sum of `blockSum(begin, end)` over the blocks, added in the order of the blocks: deterministic for any thread count.
double parallelSumBlocks(std::size_t count, std::size_t blockSize,
                         const std::function<double(std::size_t begin, std::size_t end)>& blockSum,
                         const TaskControl& control = {});

/// Runs `work` on the calling thread alone: its parallel loops take no other core. The thread's priority is lowered
/// where the system allows it, for good: call this on a thread that does nothing else. For work that nobody waits for.
void runQuietly(const std::function<void()>& work);

/// How many threads parallel loops of the calling thread may use now.
int threadCount();

/// While alive, bounds the number of threads that parallel loops of this process use (tests of determinism,
/// `goniotool --threads`). Not nestable from several threads at once.
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
