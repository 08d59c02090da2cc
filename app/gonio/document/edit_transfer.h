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

/// A document's edits for the clipboard: as JSON, and the same JSON as plain text, which can be pasted into a .gonio
/// file.
QMimeData* toClipboard(const editing::EditDocument& document);
/// The edits on a clipboard. Edits without effect are left out, unless there are no others. Empty if there are no
/// edits.
editing::EditList editsFromClipboard(const QMimeData* data);

}  // namespace gonio::app
