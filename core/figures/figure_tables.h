// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <string_view>

#include "core/figures/figure_measurement.h"
#include "core/io/csv_text.h"

namespace gonio::figures {

// All functions require complete measurements.

/// A CSV table with one row per material and representation, in the order of the figure: material, representation,
/// label, budget, and the numbers in full precision without prefixes ("size [B]").
io::CsvTable figureCsv(const FigureDescription& description, const FigureMeasurement& measurement);

/// The same rows as a LaTeX tabular for \input, with rules of the package booktabs and the best errors of each material
/// in bold.
std::string figureLatex(const FigureDescription& description, const FigureMeasurement& measurement);

/// plainText() with the special characters of LaTeX escaped, also those that form ligatures ("--" is a dash) or, at the
/// begin of a cell, an option of the command before it ("[").
std::string latexText(std::string_view text);

/// A description of the pictures, such as "sphere-studio, 256 x 256, 64 samples", with the environment if it is
/// replaced.
std::string figurePicturesText(const FigurePictures& pictures);

}  // namespace gonio::figures
