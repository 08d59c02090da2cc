// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/figures/figure_description.h"
#include "core/math/image.h"
#include "core/support/task_control.h"

namespace gonio::figures {

/// One measured representation of a material. Immutable, so that several measurements can share it.
struct FigureCell {
  study::Representation representation;
  Image picture;               ///< linear RGB
  std::vector<double> values;  ///< of all figureNumbers(), in their order; times are NaN unless isTimed
  bool isTimed = false;

  /// The value of one of figureNumbers(). @throws Error for an unknown id.
  double value(std::string_view number) const;
};

/// One material: the reference picture, and one cell per representation.
struct FigureRow {
  std::string path;                        ///< as in the description
  std::string name;                        ///< the material's name; derived from the path until the file is read
  std::shared_ptr<const Image> reference;  ///< linear RGB; null until it is rendered
  std::vector<std::shared_ptr<const FigureCell>> cells;  ///< null until they are measured

  bool isComplete() const;
};

/// The measured content of a figure. It does not depend on labels, layout, exposure or the choice of numbers (except
/// times): changes of these need no new measurement. Cheap to copy.
struct FigureMeasurement {
  FigurePictures pictures;  ///< settings of the rendered pictures
  /// For each of figureSources(), the modification times when it was read: of its file or, for a document, of the
  /// document and the files that it edits.
  std::map<std::string, std::vector<std::filesystem::file_time_type>> fileTimes;
  std::vector<FigureRow> rows;  ///< one per material
  double seconds = 0;           ///< duration of the measurement

  std::size_t missingCells() const;
};

struct MeasureFigureOptions {
  FigureMeasurement known = {};  ///< an earlier measurement; cells that are still valid are not measured again
  /// Called on the calling thread after each cell, with all results so far.
  std::function<void(const FigureMeasurement&)> measured = {};
};

/// Whether two descriptions give the same rendered pictures. Exposure and tone map do not matter: they are applied
/// after rendering.
bool rendersTheSame(FigurePictures a, const FigurePictures& b);

/// The rows and cells of a description that are known from an earlier measurement: of the same scene, size and samples,
/// of files that have not changed since, and with times if the description shows times. Reads the modification times of
/// the files.
FigureMeasurement knownPart(const FigureDescription& description, const FigureMeasurement& known);

/// Reads the materials, encodes and renders their representations and measures the numbers with study::runStudy(), in
/// the scene of the description. The results other than times are deterministic and do not
/// depend on MeasureFigureOptions::known. About two seconds per material and representation on two cores, for pictures
/// of 256 x 256 pixels. @throws Error as checkFigure(), or if a file cannot be read; Cancelled.
FigureMeasurement measureFigure(const FigureDescription& description, const TaskControl& control = {},
                                const MeasureFigureOptions& options = {});

/// The label of a row: that of the description, or the material's name.
std::string rowLabel(const FigureDescription& description, const FigureMeasurement& measurement, std::size_t row);

/// Luminance difference at the end of the scale of all error maps: that of the description, or the largest of the
/// 99.5th percentiles of the differences in each row, rounded up; 0 if all pictures are equal.
double errorMaximum(const FigureDescription& description, const FigureMeasurement& measurement);

}  // namespace gonio::figures
