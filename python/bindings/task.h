// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <pybind11/pybind11.h>

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>

#include "core/support/task_control.h"

namespace gonio::python {

namespace py = pybind11;

/// Runs `work` on a new thread without the GIL. Meanwhile the calling thread handles signals (Ctrl+C) and calls
/// `progress(fraction)` if that is not None. If either raises an exception, the work is asked to stop, and the
/// exception is thrown once it has stopped. Exceptions of `work` are rethrown.
void runTask(const py::object& progress, const std::function<void(const TaskControl&)>& work);

/// The same for work with a result.
template <typename Work>
auto resultOf(const py::object& progress, Work work) {
  std::optional<decltype(work(TaskControl()))> result;
  runTask(progress, [&](const TaskControl& control) { result.emplace(work(control)); });
  return std::move(*result);
}

}  // namespace gonio::python
