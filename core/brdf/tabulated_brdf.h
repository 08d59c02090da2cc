// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/coordinates/half_difference_grid.h"
#include "core/support/task_control.h"

namespace gonio {

struct GridCorners;
struct HalfDifferenceBlock;

/// Interpolation between the nodes of a table.
enum class TableLookup {
  cell,      ///< without interpolation: the node at or below the coordinates (floor), as the MERL reference code does
  trilinear  ///< linear in (sqrt theta_h, theta_d, phi_d); invalid corners are dropped and the weights renormalised
};

/// What a table does with negative values. RGL files have some, for colours outside sRGB.
enum class NegativeValues { becomeZero, stay };

/// An isotropic BRDF as a table over a half-difference grid, with a mask of the invalid cells (below the horizon or not
/// measured; their stored value is 0). Values are finite floats, RGB interleaved, 1/sr, without the cosine; >= 0 unless
/// negative values stay.
class TabulatedBrdf final : public Brdf {
 public:
  using Value = glm::vec3;

  /// @param values grid.size() values, linear RGB, 1/sr, without the cosine; those of invalid cells are ignored and
  /// stored as 0.
  /// @param valid one flag per cell (1 valid, 0 invalid).
  /// @param negatives of valid cells (clampedCount()).
  /// @throws Error if the sizes differ from the grid's or a valid value is not finite; the message names the cell.
  TabulatedBrdf(const HalfDifferenceGrid& grid, std::vector<Value> values, std::vector<std::uint8_t> valid,
                NegativeValues negatives = NegativeValues::becomeZero);

  using Brdf::evaluate;
  /// Trilinear. About 30 ns per pair in long batches, about 100 ns for a single pair.
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override;
  /// @param measured if not empty: receives one flag per pair, 0 where all corners are invalid.
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values, TableLookup lookup,
                std::span<std::uint8_t> measured = {}) const;
  /// The value at half-difference coordinates; 0 if all corners are invalid. `*valid`, if given, receives whether any
  /// is valid.
  Rgb lookup(const HalfDifference& at, TableLookup lookup, bool* valid = nullptr) const;

  bool isReciprocal() const override { return grid_.reciprocal; }
  bool hasData(const DirectionPair& pair) const override;
  /// From the extrema of the cells over phi_d.
  std::shared_ptr<const ValueBound> valueBound() const override;

  const HalfDifferenceGrid& grid() const { return grid_; }
  std::span<const Value> values() const { return values_; }
  std::span<const std::uint8_t> valid() const { return valid_; }
  std::size_t validCount() const { return validCount_; }
  /// Number of channel values of valid cells that were negative and were set to 0.
  std::size_t clampedCount() const { return clampedCount_; }
  std::size_t bytes() const { return values_.size() * sizeof(Value) + valid_.size() + 8 * interior_.size(); }

 private:
  void markInterior();
  void lookupTrilinear(const HalfDifferenceBlock& block, std::span<Rgb> values, std::span<std::uint8_t> measured) const;
  bool isInterior(const GridCorners& corners) const;
  Rgb interpolate(const GridCorners& corners, bool& valid) const;

  HalfDifferenceGrid grid_;
  std::vector<Value> values_;
  std::vector<std::uint8_t> valid_;
  /// One bit per cell, 1 where all eight corners of the cell that starts here are valid, so that weights need no
  /// renormalisation. Bits, since they stay in the near caches; each row of phi_d starts with a word.
  std::vector<std::uint64_t> interior_;
  std::size_t wordsPerRow_ = 0;
  std::size_t validCount_ = 0;
  std::size_t clampedCount_ = 0;
};

/// Samples any BRDF at the nodes of a grid; nodes below the horizon are invalid. Dependencies that the grid cannot
/// represent are averaged: an anisotropic BRDF over `azimuths` rotations about the normal, and, on a reciprocal grid, a
/// BRDF that is not reciprocal over both orders of the directions, which is the best reciprocal approximation in least
/// squares. Finite values beyond the range of float are stored as the largest float. Parallel, deterministic.
/// @throws Cancelled; Error if the BRDF returns a non-finite value.
std::shared_ptr<const TabulatedBrdf> bakeTable(const Brdf& brdf, const HalfDifferenceGrid& grid = {},
                                               const TaskControl& control = {}, int azimuths = 16,
                                               NegativeValues negatives = NegativeValues::becomeZero);

/// The reciprocal part of a table: the mean of both orders of the directions, on the half circle of phi_d, negative
/// values set to 0. What methods for reciprocal materials describe. The table itself if it is reciprocal.
std::shared_ptr<const TabulatedBrdf> meanOfOrders(const std::shared_ptr<const TabulatedBrdf>& table);

/// Range of the valid values of one channel, 1/sr.
struct ChannelRange {
  double min = 0, max = 0;
};

struct TableStatistics {
  std::array<ChannelRange, 3> channels;
  double invalidFraction = 0;  ///< invalid cells / all cells
  double dynamicRange = 0;     ///< largest / smallest positive value of any channel; 0 for a black table
};
TableStatistics tableStatistics(const TabulatedBrdf& table);

}  // namespace gonio
