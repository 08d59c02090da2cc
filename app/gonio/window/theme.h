// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

class QApplication;

namespace gonio::app {

enum class Theme { system, light, dark };

QString themeName(Theme theme);
Theme themeByName(const QString& name);

/// Neutral greys, so that colours are judged fairly, and one accent; text has at least 4.5:1 contrast.
/// The first call notes what the system asked for.
void applyTheme(QApplication& application, Theme theme);

}  // namespace gonio::app
