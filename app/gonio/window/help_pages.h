// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

class QWidget;

namespace gonio::app {

/// The table of all shortcuts of a window, made from its actions.
QString shortcutsPage(const QWidget* window);
/// All models with their parameters, formulae and sources, made from their specs.
QString formulaePage();
/// What Gonio is, its version, its licences and those of what it stands on.
QString aboutPage();

/// Shows a page in a window of its own that can stay open.
void showPage(const QString& title, const QString& html, QWidget* parent);

}  // namespace gonio::app
