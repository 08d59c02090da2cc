// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <optional>

#include "core/editing/differential_edit.h"

class QMimeData;

namespace gonio::app {

/// The change that an edit makes, carried over to another fit of the same model: logarithmic parameters by ratio,
/// choices as they are, all others by difference; inside the hard ranges. What the edit left alone stays at the new
/// fit.
models::ParameterValues transferredEdit(const editing::DifferentialEdit& edit, const models::ParameterValues& fitted);

/// An edit on the clipboard: as JSON, readable as text too.
QMimeData* editToClipboard(const editing::DifferentialEdit& edit);
/// Nothing when the clipboard holds no edit.
std::optional<editing::DifferentialEdit> editFromClipboard(const QMimeData* data);

}  // namespace gonio::app
