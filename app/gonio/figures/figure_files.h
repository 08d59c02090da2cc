// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>

#include "app/gonio/document/file_saves.h"
#include "core/figures/figure_measurement.h"

namespace gonio::app {

/// The input of an output file, as it was when the user asked for the file.
struct FigureToWrite {
  figures::FigureDescription description;
  figures::FigureMeasurement known;  ///< missing cells are measured before the file is written
  std::function<void(const figures::FigureMeasurement&)> measured = {};  ///< receives the new results
};

/// The figure as .pdf, .svg or .png, for FileExports::save(). The suffix of the path selects the format. This and the
/// other output files of a figure cannot overwrite its sources.
FileSave figureSave(const FigureToWrite& figure);
/// The numbers of the figure: .csv, or .tex for LaTeX.
FileSave figureNumbersSave(const FigureToWrite& figure);
/// The description of the figure: .json.
FileSave figureDescriptionSave(const figures::FigureDescription& description);

}  // namespace gonio::app
