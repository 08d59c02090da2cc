// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

#include "core/documents/edit_document.h"

class QMimeData;

namespace gonio::app {

/// The change that an edit makes, carried over to another fit of the same model: logarithmic parameters by ratio,
/// choices as they are, all others by difference; inside the hard ranges. What the edit left alone stays at the new
/// fit.
models::ParameterValues transferredEdit(const editing::DifferentialEdit& edit, const models::ParameterValues& fitted);

/// A document's edits on the clipboard: their JSON, as text too, so that they can be pasted into a .gonio file.
QMimeData* toClipboard(const editing::EditDocument& document);
/// The edits on a clipboard, those that change nothing only where there is no other; empty when it holds none.
editing::EditList editsFromClipboard(const QMimeData* data);

}  // namespace gonio::app
