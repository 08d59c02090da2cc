// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QCoreApplication>
#include <QString>
#include <new>

#include "core/support/error.h"

namespace gonio::widgets {

/// Converts exceptions of work in another thread to messages. Otherwise QFuture would rethrow them in every function
/// that waits for it, including destructors.
class TaskFailure {
  Q_DECLARE_TR_FUNCTIONS(TaskFailure)

 public:
  /// Runs the work. @return a message for the user if it threw; empty if it was finished or cancelled.
  template <typename Work>
  static QString of(const Work& work) {
    try {
      work();
    } catch (const Cancelled&) {
      return {};
    } catch (const std::bad_alloc&) {
      return tr("Not enough memory. Close other windows or programs and try again.");
    } catch (const std::exception& exception) {
      return QString::fromUtf8(exception.what());
    }
    return {};
  }
};

}  // namespace gonio::widgets
