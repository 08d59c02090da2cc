// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/math/gram_svd.h"
#include "core/support/task_control.h"

namespace gonio::dictionary {

/// The cells of a grid that count, and how their reflectances are mapped (core/brdf/log_relative.h).
struct MappedCells {
  HalfDifferenceGrid grid;
  std::vector<std::uint32_t> cells;  ///< indices into the grid, ascending: those valid in every material of the set
  std::vector<float> weights;        ///< cosineWeight() of each
  std::vector<float> reference;      ///< of rho w: the set's median
};

/// Principal components of measured materials, in the form of Nielsen et al. 2015, "On Optimal, Minimal BRDF Sampling
/// for Reflectance Acquisition": every colour channel of every material is a column of log-relative values over the
/// cells, less their mean; X - mean = U Sigma V^T. A material is then
///   y = mean + U c, three times p coefficients c. Immutable.
struct PrincipalComponents {
  MappedCells mapping;
  std::vector<float> mean;  ///< of the mapped values, one per cell
  GramSvd svd;              ///< U: cells x components; the rows of V are material * 3 + channel
  /// Of each cell, the variance over the training signals of what the components that were not kept would add to the
  /// mapped value; empty where all were kept.
  std::vector<float> leftOut;

  int count() const { return int(svd.singularValues.size()); }
  /// What has to be kept to decode materials of `components` coefficients per channel, in single precision.
  std::size_t bytes(int components) const;
};

/// A material: coefficients of the first components for red, green, blue; as many in each.
struct ComponentCode {
  std::array<Eigen::VectorXf, 3> channels;

  int components() const { return int(channels[0].size()); }
  std::size_t bytes() const { return 3 * std::size_t(components()) * sizeof(float); }
  /// What a file of half precision would hold: values over the channel's largest as float16, and that as float32.
  ComponentCode inHalfPrecision() const;
  /// Bytes of such a file.
  static std::size_t halfBytes(int components);
  /// The code of the first components alone: the same as encoding with so many.
  ComponentCode truncated(int components) const;
};

/// Of each of the cells [begin, end), the variance over the training signals of what the first `components` leave out
/// of the mapped value: sigma_k^2 u_k^2 / signals of the others, and `leftOut`. O(cells x other components).
std::vector<float> leftOutVariance(const PrincipalComponents& pca, int components, std::size_t begin, std::size_t end);

struct PcaOptions {
  int maxComponents = std::numeric_limits<int>::max();
};

/// @param load the table of a material, of one grid for all; asked for one after another, so that memory holds one.
/// Memory: 4 bytes x 3 materials x cells (411 columns of 1.1 million cells: 1.8 GB) and some ten MB.
/// @throws Error when there are no materials, their grids differ, or no cell is valid in all; Cancelled.
PrincipalComponents learnPrincipalComponents(
    std::size_t materials, const std::function<std::shared_ptr<const TabulatedBrdf>(std::size_t material)>& load,
    const PcaOptions& options = {}, const TaskControl& control = {});

/// Projects a material: the nearest in the span of the first components, by mapped values. A cell that is not valid in
/// it counts as the mean. @param components at most count(). @throws Error when the grid is another; Cancelled.
ComponentCode encode(const PrincipalComponents& pca, const TabulatedBrdf& table, int components,
                     const TaskControl& control = {});

/// The table that a code stands for; cells that do not count are invalid. Values beyond the range of float are its
/// largest number, and counted in `*cappedCount` when given. @throws Error when the code has more components;
/// Cancelled.
std::shared_ptr<const TabulatedBrdf> decode(const PrincipalComponents& pca, const ComponentCode& code,
                                            const TaskControl& control = {}, std::size_t* cappedCount = nullptr);

}  // namespace gonio::dictionary
