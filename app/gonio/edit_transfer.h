// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <optional>

#include "core/editing/edit_document.h"

class QMimeData;

namespace gonio::app {

/// The change that an edit makes, carried over to another fit of the same model: logarithmic parameters by ratio,
/// choices as they are, all others by difference; inside the hard ranges. What the edit left alone stays at the new
/// fit.
models::ParameterValues transferredEdit(const editing::DifferentialEdit& edit, const models::ParameterValues& fitted);

/// A document's edit on the clipboard: its JSON, as text too, so that it can be pasted into a .gonio file.
QMimeData* toClipboard(const editing::EditDocument& document);
/// Nothing when the clipboard holds no edit.
std::optional<editing::DifferentialEdit> editFromClipboard(const QMimeData* data);

}  // namespace gonio::app
