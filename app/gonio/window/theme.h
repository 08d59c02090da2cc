// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

class QApplication;

namespace gonio::app {

enum class Theme { system, light, dark };

QString themeName(Theme theme);
Theme themeByName(const QString& name);

/// Neutral greys, which do not bias the perception of colours, and one accent; text has a contrast of at least 4.5:1.
/// The first call stores the system's theme.
void applyTheme(QApplication& application, Theme theme);

}  // namespace gonio::app
