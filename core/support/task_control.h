// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
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

}  // namespace gonio
