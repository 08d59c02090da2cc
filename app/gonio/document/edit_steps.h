// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/document/document.h"

/// What the user does to the edits of a document: each an undo step with a name, none where nothing changes; all that
/// happens in one interaction is one step. Edits are given by their number in the list.
namespace gonio::app {

/// What an edit is called: the name that the user gave it, else what it is ("GGX", "Factor curves"); numbered where
/// edits before it are called the same ("GGX 2").
QString editName(const editing::EditList& edits, int index);

/// "Additive", "Log-plus", "Lobes".
QString compositionName(editing::Composition composition);

/// Of the active differential edit; nothing where there is none.
void setParameter(Document& document, int parameter, const Rgb& value);
/// Back to the fitted value; never part of an interaction.
void resetParameter(Document& document, int parameter);
/// Parameters and controls.
void resetParameters(Document& document);
/// One of the artist's controls of the active differential edit; nothing where there is none.
void setControl(Document& document, editing::ArtistControl control, const Rgb& value);
/// Back to where it changes nothing; never part of an interaction.
void resetControl(Document& document, editing::ArtistControl control);
/// How its change is brought to the measurement; never part of an interaction.
void setComposition(Document& document, editing::Composition composition);

/// How much of the change is added, in [0, 1].
void setEditStrength(Document& document, int edit, double strength);
/// Whether the edit counts at all.
void setEditEnabled(Document& document, int edit, bool enabled);
/// @param name empty: none, what it is stands for it.
void renameEdit(Document& document, int edit, const QString& name);
/// The edit `from` becomes number `to`.
void moveEdit(Document& document, int from, int to);
/// The copy comes next to the edit and is selected.
void duplicateEdit(Document& document, int edit);
void deleteEdit(Document& document, int edit);
/// Edits in the place of those of their kinds; an edit of a kind that there was none of comes to where the panels put
/// it: curves next to the measurement, models behind all others.
void pasteEdits(Document& document, const editing::EditList& edits);
/// A new edit behind the selected one (or the last), which is selected then.
void addEdit(Document& document, const editing::Edit& edit);

}  // namespace gonio::app
