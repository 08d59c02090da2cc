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

/// Runs `work` on a thread of its own without the GIL, while the calling thread waits: it handles signals (Ctrl+C) and
/// calls `progress(fraction)`, where that is not None. Where either raises, the work is asked to stop and the exception
/// leaves this function when it has stopped. Whatever `work` throws is thrown again.
void runTask(const py::object& progress, const std::function<void(const TaskControl&)>& work);

/// The same of work with a result.
template <typename Work>
auto resultOf(const py::object& progress, Work work) {
  std::optional<decltype(work(TaskControl()))> result;
  runTask(progress, [&](const TaskControl& control) { result.emplace(work(control)); });
  return std::move(*result);
}

}  // namespace gonio::python
