// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

#include "core/dictionary/principal_components.h"

/// The steps by which principal components are learned, over all cells or over a block of them.
namespace gonio::dictionary {

/// The cells valid in a table and their weights; without a reference.
MappedCells validCells(const TabulatedBrdf& table);

/// Appends rho w of a table's channels as three columns. Cells that are not valid in the table are marked in `missing`.
/// @throws Error if the table's grid is not that of the mapping.
void appendColumns(const TabulatedBrdf& table, const MappedCells& mapping, TallMatrix& columns,
                   std::vector<char>& missing);

/// Removes the marked cells from the mapping. @return the indices of those that remain.
/// @throws Error if none remains.
std::vector<std::size_t> removeMarkedCells(MappedCells& mapping, const std::vector<char>& missing);
/// Removes all other rows, in place.
void selectRows(TallMatrix& columns, std::span<const std::size_t> rows);

/// The median of each row.
std::vector<float> rowMedians(const TallMatrix& columns);
/// Maps rho w to log-relative values in place and subtracts the mean of each row. @return the means.
std::vector<float> mapAndCentre(std::span<const float> reference, TallMatrix& columns, const TaskControl& control);
/// The variance of each row over the columns. Precondition: the mean of each row is 0.
std::vector<float> rowVariance(const TallMatrix& columns);
/// The part of the variance of each row that the components do not explain.
std::vector<float> unexplainedVariance(const PrincipalComponents& pca, std::vector<float> variance);

}  // namespace gonio::dictionary
