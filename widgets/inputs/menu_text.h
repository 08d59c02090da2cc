// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

namespace gonio::widgets {

/// A text with spaces for line breaks and control characters, shortened in the middle if it is long.
QString oneLine(QString text);

/// The name of a material or file for display: spaces for underscores.
QString spacedName(QString name);

/// A name as the text of a menu entry or a button, on one line; '&' marks no key.
QString menuText(const QString& name);

/// The text of a menu entry without the marks of keys.
QString withoutKeyMarks(const QString& menuText);

/// A name on one line as part of a window's title, in which Qt reads "[*]" as the mark of unsaved changes.
QString titleText(const QString& name);

}  // namespace gonio::widgets
