// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QCoreApplication>
#include <QString>
#include <new>

#include "core/support/error.h"

namespace gonio::widgets {

/// Failures of work in another thread, where nobody catches: QFuture would throw them again wherever it is waited for,
/// in a destructor too.
class TaskFailure {
  Q_DECLARE_TR_FUNCTIONS(TaskFailure)

 public:
  /// Does the work. @returns what it threw, for people; nothing where it was done or stopped.
  template <typename Work>
  static QString of(const Work& work) {
    try {
      work();
    } catch (const Cancelled&) {
      return {};
    } catch (const std::bad_alloc&) {
      return tr("There is not enough memory for this.");
    } catch (const std::exception& exception) {
      return QString::fromUtf8(exception.what());
    }
    return {};
  }
};

}  // namespace gonio::widgets
