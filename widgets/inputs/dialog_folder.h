// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

namespace gonio::widgets {

/// Where the file dialogs of a purpose ("open", "export", "environment") start: in the folder that was chosen last,
/// kept in the settings. Before the first choice, and where that folder is gone, in the home folder.
QString dialogFolder(const QString& purpose);
/// A file name in that folder, for dialogs that propose one.
QString inDialogFolder(const QString& purpose, const QString& fileName);
/// Remembers the folder of a chosen file; nothing for an empty path.
void rememberDialogFolder(const QString& purpose, const QString& chosenFile);

}  // namespace gonio::widgets
