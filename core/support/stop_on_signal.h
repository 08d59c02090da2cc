// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <stop_token>
#include <thread>

namespace gonio::system {

/// While it exists, the first SIGINT, SIGTERM or SIGHUP asks the work to stop, so that no temporary file remains.
/// Another one ends the program at once; within half a second it counts as the same request. Signals that the parent
/// process ignores (`nohup`) stay ignored. Only one instance may exist in a process.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;

  std::stop_token token() const { return stop_.get_token(); }

 private:
  void watch(const std::stop_token& end);

  std::stop_source stop_;
  std::jthread watcher_;
};

/// Ends the process by the signal that requested the stop, as its parent expects of an interrupted program (a shell
/// then ends its loop, too). Without a signal it returns. No StopOnSignal may exist.
void endByReceivedSignal();

}  // namespace gonio::system
