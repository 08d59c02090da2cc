// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/figure_screenshot.h"

#include "app/gonio/figures/figure_file_buttons.h"
#include "app/gonio/figures/figure_view.h"
#include "app/gonio/window/screenshot.h"

namespace gonio::app {

void takeFigureScreenshot(const FigureDialog::Parts& parts, QWidget& parent, const QString& description,
                          const QString& path, double maxWaitSeconds) {
  auto* dialog = new FigureDialog(parts, &parent);
  QObject::connect(&dialog->files(), &FigureFileButtons::opened, dialog,
                   [dialog] { dialog->view().controller().measure(); });
  dialog->show();
  dialog->files().open(description);
  const auto isMeasured = [&view = dialog->view()] {
    const figures::FigureMeasurement& known = view.controller().known();
    return view.isSettled() && !known.rows.empty() && known.missingCells() == 0;
  };
  new Screenshot(*dialog, isMeasured, path, maxWaitSeconds);
}

}  // namespace gonio::app
