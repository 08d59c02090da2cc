// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <filesystem>
#include <functional>

#include "core/support/task_control.h"

namespace gonio::app {

/// Something other than the material that a panel shows and that can be saved as a file: factors, a code, a fit.
struct FileSave {
  QString title;   ///< title of the dialog, e.g. "Save Factors"
  QString name;    ///< proposed file name, without folder and suffix
  QString filter;  ///< "PDV factors (*.pdv)"
  QString suffix;  ///< ".pdv"
  /// Not for the GUI thread. @throws Error that names the file; Cancelled.
  std::function<void(const std::filesystem::path& path, const TaskControl& control)> write;
};

}  // namespace gonio::app
