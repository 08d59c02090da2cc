// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "python/bindings/task.h"

#include <chrono>
#include <thread>

namespace gonio::python {

namespace {

/// State that the two threads share.
struct Shared {
  std::mutex mutex;
  std::condition_variable changed;
  double fraction = -1;  ///< the last reported one; -1 if it was passed on or there is none
  bool done = false;
  std::exception_ptr failure;

  void report(double value) {
    {
      const std::lock_guard lock(mutex);
      fraction = value;
    }
    changed.notify_one();
  }
  void finish(std::exception_ptr why) {
    const std::lock_guard lock(mutex);
    done = true;
    failure = std::move(why);
    changed.notify_one();
  }
};

/// Interval between checks for Ctrl+C.
constexpr auto signalInterval = std::chrono::milliseconds(50);

/// Runs pending signal handlers, and calls `progress` if there is a new fraction. Throws the Python exception that
/// either raises.
void serve(const py::object& progress, double fraction) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (fraction >= 0 && !progress.is_none()) progress(fraction);
}

/// Waits until the work is done, a new fraction is reported or signalInterval has passed. Returns whether the work is
/// done; sets `fraction` to the new fraction, or to -1 if there is none.
bool waitForNews(Shared& shared, double& fraction) {
  const py::gil_scoped_release released;
  std::unique_lock lock(shared.mutex);
  shared.changed.wait_for(lock, signalInterval, [&] { return shared.done || shared.fraction >= 0; });
  fraction = std::exchange(shared.fraction, -1);
  return shared.done;
}

}  // namespace

void runTask(const py::object& progress, const std::function<void(const TaskControl&)>& work) {
  Shared shared;
  std::stop_source stop;
  TaskControl control{stop.get_token(), {}};
  if (!progress.is_none()) control.progress = [&shared](double fraction) { shared.report(fraction); };
  std::thread worker([&] {
    std::exception_ptr failure;
    try {
      work(control);
    } catch (...) {
      failure = std::current_exception();
    }
    shared.finish(failure);
  });
  std::exception_ptr raised;
  for (bool done = false; !done;) {
    double fraction = -1;
    done = waitForNews(shared, fraction);
    if (raised) continue;
    try {
      serve(progress, fraction);
    } catch (const py::error_already_set&) {
      raised = std::current_exception();
      stop.request_stop();
    }
  }
  {
    const py::gil_scoped_release released;
    worker.join();
  }
  if (raised) std::rethrow_exception(raised);
  if (shared.failure) std::rethrow_exception(shared.failure);
}

}  // namespace gonio::python
