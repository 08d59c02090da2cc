// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

class QWidget;

namespace gonio::app {

/// Table of all shortcuts of a window, generated from its actions.
QString shortcutsPage(const QWidget* window);
/// All models with their parameters, formulae and sources, generated from their specs.
QString formulaePage();
/// Description, version and licence of Gonio, and the licences of its dependencies.
QString aboutPage();

/// Shows a page in a separate, non-modal window.
void showPage(const QString& title, const QString& html, QWidget* parent);

}  // namespace gonio::app
