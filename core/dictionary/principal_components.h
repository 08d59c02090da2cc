// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/math/decompositions.h"
#include "core/support/task_control.h"

namespace gonio::dictionary {

/// The cells of a grid that a basis covers, and the data of their log-relative mapping (core/brdf/data_transform.h).
struct MappedCells {
  HalfDifferenceGrid grid;
  std::vector<std::uint32_t> cells;  ///< indices into the grid, ascending: those valid in every material of the set
  std::vector<float> weights;        ///< cosineWeight() of each
  std::vector<float> reference;      ///< median of rho w over the set, 1/sr
};

/// Numbers of the cells, such as BRDF values or standard deviations, as a table, in which the other cells are invalid.
/// @param values one per cell and channel.
std::shared_ptr<const TabulatedBrdf> tableOfCells(const MappedCells& mapping, std::span<const glm::vec3> values);

/// Principal components of measured materials, in the form of Nielsen et al. 2015, "On Optimal, Minimal BRDF Sampling
/// for Reflectance Acquisition": every colour channel of every material is a column of X, its log-relative values over
/// the cells, and X - mean = U Sigma V^T. A material is then y = mean + U c, with p coefficients c per channel.
struct PrincipalComponents {
  MappedCells mapping;
  std::vector<float> mean;  ///< of the mapped values, one per cell
  GramSvd svd;              ///< U: cells x components; the rows of V are material * 3 + channel
  /// Per cell, the variance over the training signals of the mapped value's part in components that were dropped; empty
  /// if none was dropped.
  std::vector<float> leftOut;

  int count() const { return int(svd.singularValues.size()); }
  /// Size of the data needed to decode materials of `components` coefficients per channel, in single precision.
  std::size_t bytes(int components) const;
};

/// A material: coefficients of the first components for red, green and blue, the same number in each.
struct ComponentCode {
  std::array<Eigen::VectorXf, 3> channels;

  int components() const { return int(channels[0].size()); }
  std::size_t bytes() const { return 3 * std::size_t(components()) * sizeof(float); }
  /// The code as a half-precision file stores it: the largest absolute value of each channel as float32, and the values
  /// divided by it as float16.
  ComponentCode inHalfPrecision() const;
  /// Size of that file's content in bytes.
  static std::size_t halfBytes(int components);
  /// The code of the first components; equal to encode() with that number.
  ComponentCode truncated(int components) const;
};

/// For the cells [begin, end), the variance over the training signals of the part of the mapped value that the first
/// `components` leave out: the sum of sigma_k^2 u_k^2 / signals over the other components, plus `leftOut`. O(cells x
/// other components).
std::vector<float> leftOutVariance(const PrincipalComponents& pca, int components, std::size_t begin, std::size_t end);

struct PcaOptions {
  int maxComponents = std::numeric_limits<int>::max();
  /// Columns that need more memory than this are stored in a temporary file (in the folder of the environment variable
  /// TMPDIR, else /tmp) and read by blocks of cells. The components equal those learned in memory to rounding.
  std::uint64_t maxBytes = 6'000'000'000;
};

/// Learns the components. @param materials number of training materials. @param load returns the table of a material;
/// all must have the same grid. Called for one material after another, so that only one table is in memory. Memory: 4
/// bytes x 3 x materials x cells (411 columns of 1.1 million cells: 1.8 GB) and a few tens of MB. If the columns need
/// more than options.maxBytes, they are in a temporary file, and the memory is the sum of options.maxBytes / 2, 16
/// bytes x (3 x materials)^2, and 4 bytes x components x cells for the components.
/// @throws Error if there are no materials, their grids differ, no cell is valid in all of them, the components alone
/// need more than options.maxBytes, or the temporary file cannot be written; Cancelled.
PrincipalComponents learnPrincipalComponents(
    std::size_t materials, const std::function<std::shared_ptr<const TabulatedBrdf>(std::size_t material)>& load,
    const PcaOptions& options = {}, const TaskControl& control = {});

/// Projects the mapped values of a material onto the first components. Invalid cells count as the mean. @param
/// components limited to count(). @throws Error if the grids differ; Cancelled.
ComponentCode encode(const PrincipalComponents& pca, const TabulatedBrdf& table, int components,
                     const TaskControl& control = {});

/// The table of a code; cells outside the mapping are invalid. Values beyond the range of float become the largest
/// float and are counted in `*cappedCount`, if given. @throws Error if the code has more components than the basis;
/// Cancelled.
std::shared_ptr<const TabulatedBrdf> decode(const PrincipalComponents& pca, const ComponentCode& code,
                                            const TaskControl& control = {}, std::size_t* cappedCount = nullptr);

}  // namespace gonio::dictionary
