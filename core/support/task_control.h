// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>

#include "core/support/error.h"

namespace gonio {

/// The control of long work by its caller: a stop token and a progress callback. `progress` receives a non-decreasing
/// fraction in [0, 1]; it may be called from any thread, one call at a time.
struct TaskControl {
  std::stop_token stop;
  std::function<void(double fraction)> progress;

  void report(double fraction) const {
    if (progress) progress(fraction);
  }
  /// Control for a part of the work: its progress in [0, 1] is mapped to [begin, end] of the whole.
  TaskControl between(double begin, double end) const {
    if (!progress) return {stop, {}};
    return {stop, [whole = progress, begin, end](double fraction) { whole(begin + fraction * (end - begin)); }};
  }
  /// @throws Cancelled if a stop was requested.
  void throwIfStopped() const {
    if (stop.stop_requested()) throw Cancelled();
  }
};

/// A switch that pauses long work between its parts while it is on. Thread-safe.
class Pause {
 public:
  void set(bool on) {
    {
      const std::lock_guard lock(mutex_);
      on_ = on;
    }
    changed_.notify_all();
  }
  bool isOn() const {
    const std::lock_guard lock(mutex_);
    return on_;
  }
  /// Waits until the switch is off or a stop is requested.
  void wait(const std::stop_token& stop) const {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, stop, [this] { return !on_; });
  }

 private:
  mutable std::mutex mutex_;
  mutable std::condition_variable_any changed_;
  bool on_ = false;
};

}  // namespace gonio
