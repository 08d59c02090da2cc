// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <condition_variable>
#include <mutex>
#include <stop_token>

namespace gonio {

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
