// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/support/error.h"

/// Matrices among the numbers of a file, column by column.
namespace gonio::io {

template <typename Scalar>
void appendMatrix(const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& matrix,
                  std::vector<std::byte>& numbers) {
  const auto bytes = std::as_bytes(std::span(matrix.data(), std::size_t(matrix.size())));
  numbers.insert(numbers.end(), bytes.begin(), bytes.end());
}

/// A square matrix, which is taken off the front of the numbers.
/// @param what for the errors: "dictionary". @throws Error where the numbers end or one is not finite.
template <typename Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> takeMatrix(std::span<const std::byte>& numbers, int size,
                                                                 std::string_view what) {
  const std::size_t bytes = std::size_t(size) * std::size_t(size) * sizeof(Scalar);
  if (numbers.size() < bytes) throw Error(std::string(what) + ": the file ends within its matrices");
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> matrix(size, size);
  std::memcpy(matrix.data(), numbers.data(), bytes);
  numbers = numbers.subspan(bytes);
  if (!matrix.allFinite()) throw Error(std::string(what) + ": found a number that is not finite");
  return matrix;
}

}  // namespace gonio::io
