// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

#include "core/documents/edit_document.h"

class QMimeData;

namespace gonio::app {

/// The change of an edit transferred to another fit of the same model: logarithmic parameters by ratio, choices by
/// value, all others by difference, clamped to the hard ranges. Parameters that the edit did not change have the
/// new fit's values.
models::ParameterValues transferredEdit(const editing::DifferentialEdit& edit, const models::ParameterValues& fitted);

/// A document's edits for the clipboard: as JSON, and the same as text so that they can be pasted into a .gonio file.
QMimeData* toClipboard(const editing::EditDocument& document);
/// The edits on a clipboard, without those that have no effect unless there are no others; empty if it contains no
/// edits.
editing::EditList editsFromClipboard(const QMimeData* data);

}  // namespace gonio::app
