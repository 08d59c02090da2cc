// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <string_view>

#include "core/figures/figure_measurement.h"
#include "core/plots/csv_table.h"

namespace gonio::figures {

/// A row for each material and representation, in the order of the figure: material, representation, label, budget, and
/// the numbers in full precision and without prefixes ("size [B]").
plots::CsvTable figureCsv(const FigureDescription& description, const FigureMeasurement& measurement);

/// A LaTeX tabular of the same rows, with the rules of the package booktabs and the best errors of each material in
/// bold, as a file to \input.
std::string figureLatex(const FigureDescription& description, const FigureMeasurement& measurement);

/// Text with the characters escaped that LaTeX reads as commands.
std::string latexText(std::string_view text);

/// "sphere-studio, 256 x 256, 64 samples", with the environment where the description replaces it.
std::string figurePicturesText(const FigurePictures& pictures);

}  // namespace gonio::figures
