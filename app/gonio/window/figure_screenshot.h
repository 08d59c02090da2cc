// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

#include "app/gonio/figures/figure_dialog.h"

namespace gonio::app {

/// Opens the dialog of a figure with a description (a file), measures the figure, and saves a picture of the dialog
/// once every cell is measured, or after the maximum wait; then ends the program (Screenshot). The dialog reports a
/// description that it cannot read.
void takeFigureScreenshot(const FigureDialog::Parts& parts, QWidget& parent, const QString& description,
                          const QString& path, double maxWaitSeconds);

}  // namespace gonio::app
