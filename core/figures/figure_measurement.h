// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

#include "core/figures/figure_description.h"
#include "core/math/image.h"
#include "core/support/task_control.h"

namespace gonio::figures {

/// One representation of a material: its picture, and the numbers of the description in their order.
struct FigureCell {
  Image picture;  ///< linear RGB
  std::vector<double> numbers;
};

/// One material: the reference picture, and one cell per representation.
struct FigureRow {
  std::string name;  ///< the label, or the material's own name
  Image reference;   ///< linear RGB
  std::vector<FigureCell> cells;
};

/// The measured content of a figure.
struct FigureMeasurement {
  std::vector<FigureRow> rows;  ///< one per material
  double errorMaximum = 0;  ///< luminance difference at the end of the scale of all error maps; 0 if all pictures are
                            ///< equal
  double seconds = 0;       ///< duration of the measurement
};

/// Reads the materials, encodes and renders their representations and measures the numbers with study::runStudy(), in
/// the scene of the description. Deterministic except for times. About two seconds per material and representation on
/// two cores, for pictures of 256 x 256 pixels. @throws Error as checkFigure(), or if a file cannot be read; Cancelled.
FigureMeasurement measureFigure(const FigureDescription& description, const TaskControl& control = {});

}  // namespace gonio::figures
