// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <stop_token>

#include "core/support/error.h"

namespace gonio {

/// What long work takes from its caller: a stop token and a progress callback.
/// `progress` gets a fraction in [0, 1] that never falls; it may be called from any thread, one call at a time.
struct TaskControl {
  std::stop_token stop;
  std::function<void(double fraction)> progress;

  void report(double fraction) const {
    if (progress) progress(fraction);
  }
  /// For a part of the work: its shares in [0, 1] become those in [begin, end] of the whole.
  TaskControl between(double begin, double end) const {
    if (!progress) return {stop, {}};
    return {stop, [whole = progress, begin, end](double fraction) { whole(begin + fraction * (end - begin)); }};
  }
  /// @throws Cancelled when a stop was requested.
  void throwIfStopped() const {
    if (stop.stop_requested()) throw Cancelled();
  }
};

}  // namespace gonio
