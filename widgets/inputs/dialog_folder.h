// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

namespace gonio::widgets {

/// The start folder of file dialogs for a purpose ("open", "export", "environment"): the last chosen folder, from the
/// settings; the home folder if there is none or it does not exist.
QString dialogFolder(const QString& purpose);
/// The path of a proposed file name in that folder.
QString inDialogFolder(const QString& purpose, const QString& fileName);
/// Stores the folder of a chosen file; no effect for an empty path.
void rememberDialogFolder(const QString& purpose, const QString& chosenFile);

}  // namespace gonio::widgets
