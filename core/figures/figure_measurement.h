// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

#include "core/figures/figure_description.h"
#include "core/math/image.h"
#include "core/support/task_control.h"

namespace gonio::figures {

/// A representation of a material: its picture, and the description's numbers in their order.
struct FigureCell {
  Image picture;  ///< linear RGB
  std::vector<double> numbers;
};

/// One material: the picture of the reference, and a cell for each representation.
struct FigureRow {
  std::string name;  ///< the label, or the material's own name
  Image reference;   ///< linear RGB
  std::vector<FigureCell> cells;
};

/// All that a figure shows, measured.
struct FigureMeasurement {
  std::vector<FigureRow> rows;  ///< one a material
  double errorMaximum = 0;      ///< luminance at the end of the scale of all error maps; 0: all pictures are equal
  double seconds = 0;           ///< that the measurement took
};

/// Reads the materials, makes and renders their representations and measures the numbers, as runStudy() does in the
/// scene of the description. Deterministic but for numbers that are times. About two seconds a representation of a
/// material on two cores with pictures of 256 x 256 pixels.
/// @throws Error for a description that checkFigure() refuses, a file that cannot be read; Cancelled.
FigureMeasurement measureFigure(const FigureDescription& description, const TaskControl& control = {});

}  // namespace gonio::figures
