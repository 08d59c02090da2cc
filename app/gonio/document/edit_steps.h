// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

#include "app/gonio/document/document.h"
#include "core/documents/edit_document.h"

class QMimeData;

namespace gonio::app {

/// Changes of a document's edits. Each is a named undo step, or none if nothing changes; all changes in one interaction
/// merge into one step. Edits are given by their index in the list.

/// Name of an edit: the one given by the user, else that of its content ("GGX", "Factor curves"), numbered if earlier
/// edits have the same name ("GGX 2").
QString editName(const editing::EditList& edits, int index);

/// "Additive", "Log-plus", "Lobes".
QString compositionName(editing::Composition composition);

/// Sets a parameter of the active differential edit; no effect if there is none.
void setParameter(Document& document, int parameter, const Rgb& value);
/// Resets a parameter to the fitted value; never part of an interaction.
void resetParameter(Document& document, int parameter);
/// Resets all parameters and controls.
void resetParameters(Document& document);
/// Sets one of the artist's controls of the active differential edit; no effect if there is none.
void setControl(Document& document, editing::ArtistControl control, const Rgb& value);
/// Sets all controls of the active differential edit in one step; no effect if there is none. @param controls values of
/// editing::artistControls(). @param text of the step.
void setControls(Document& document, const models::ParameterValues& controls, const QString& text);
/// Resets a control to its neutral value; never part of an interaction.
void resetControl(Document& document, editing::ArtistControl control);
/// Sets how the change of the active differential edit is composed with the measurement; never part of an interaction.
void setComposition(Document& document, editing::Composition composition);
void setKeepsAlbedo(Document& document, bool keepsAlbedo);

/// @param strength fraction of the change that is applied, in [0, 1].
void setEditStrength(Document& document, int edit, double strength);
/// Enables or disables an edit.
void setEditEnabled(Document& document, int edit, bool enabled);
/// @param name empty: the default name.
void renameEdit(Document& document, int edit, const QString& name);
/// Moves the edit from index `from` to index `to`.
void moveEdit(Document& document, int from, int to);
/// Inserts a copy next to the edit and selects it.
void duplicateEdit(Document& document, int edit);
void deleteEdit(Document& document, int edit);
/// Replaces the edits of the same kinds. Edits of new kinds are inserted where the panels insert them: curves next to
/// the measurement, models after all others.
void pasteEdits(Document& document, const editing::EditList& edits);
/// Inserts a new edit after the selected one (or the last) and selects it.
void addEdit(Document& document, const editing::Edit& edit);

/// The change of an edit transferred to another fit of the same model: logarithmic parameters by ratio, choices by
/// value, all others by difference, clamped to the hard ranges. Parameters that the edit did not change have the
/// new fit's values.
models::ParameterValues transferredEdit(const editing::DifferentialEdit& edit, const models::ParameterValues& fitted);

/// A document's edits for the clipboard: as JSON, and the same JSON as plain text, which can be pasted into a .gonio
/// file.
QMimeData* toClipboard(const documents::EditDocument& document);
/// The edits on a clipboard. Edits without effect are left out, unless there are no others. Empty if there are no
/// edits.
editing::EditList editsFromClipboard(const QMimeData* data);

}  // namespace gonio::app
