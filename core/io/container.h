// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/io/byte_source.h"

/// The container of Gonio's own binary files, little-endian: a signature of eight characters, a version, then the
/// fields of the format in sequence: numbers, arrays of numbers, and descriptions (uint32 length, JSON).
namespace gonio::io {

struct ContainerFormat {
  std::string_view name;          ///< for errors, e.g. "PDV" in "not a PDV file (signature missing)"
  std::string_view signature;     ///< eight characters
  std::uint32_t version = 1;      ///< that is written
  std::uint32_t readVersion = 0;  ///< the oldest that is read; 0: only `version`
  std::size_t versionBytes = sizeof(std::uint32_t);
  std::uint64_t maxBytes = std::uint64_t(1) << 33;
};

bool hasSignature(const ByteSource& source, const ContainerFormat& format);
/// @throws FormatMismatch if the signature is missing.
void expectSignature(const ByteSource& source, const ContainerFormat& format);

class ContainerWriter {
 public:
  /// Starts a file with signature and version.
  explicit ContainerWriter(const ContainerFormat& format);

  template <typename Number>
  requires std::is_arithmetic_v<Number>
  void number(Number value) { append(std::as_bytes(std::span(&value, 1))); }
  /// Appends a vector, array or matrix (column by column): any type with data() and size().
  template <typename Values>
  void values(const Values& values) {
    append(std::as_bytes(std::span(values.data(), std::size_t(values.size()))));
  }
  void description(const nlohmann::json& json);
  void append(std::span<const std::byte> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

  /// The file so far.
  const std::vector<std::byte>& bytes() const& { return bytes_; }
  std::vector<std::byte> bytes() && { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

/// Reads the fields of a file in sequence. Every error begins with the name of the format and states what was found and
/// what was expected.
class ContainerReader {
 public:
  /// @throws FormatMismatch if the signature is missing; Error if the file is too large, ends within its header or has
  /// another version.
  ContainerReader(const ContainerFormat& format, const ByteSource& source);
  std::uint32_t version() const { return version_; }

  template <typename Number>
  requires std::is_arithmetic_v<Number> Number number() {
    Number value;
    const auto bytes = take(sizeof value);
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
  }
  /// Fills a container with data() and size(). Call expectRemaining() before allocating it. @param what name of the
  /// value in the error for values that are not finite, e.g. "mean".
  template <typename Values>
  void values(Values& target, std::string_view what) {
    using Value = std::remove_cvref_t<decltype(target.data()[0])>;
    const auto bytes = take(std::size_t(target.size()) * sizeof(Value));
    if (!bytes.empty()) std::memcpy(target.data(), bytes.data(), bytes.size());
    if constexpr (std::floating_point<Value>)
      for (std::size_t i = 0; i < std::size_t(target.size()); ++i)
        if (!std::isfinite(target.data()[i])) failNotFinite(what, i);
  }
  /// Reads a square matrix of finite numbers; checks the size of the file before it allocates memory.
  template <typename Scalar>
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> squareMatrix(int size) {
    expectAtLeast(std::size_t(size) * std::size_t(size) * sizeof(Scalar));
    Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> matrix(size, size);
    values(matrix, "matrix entry");
    return matrix;
  }
  nlohmann::json description();
  std::span<const std::byte> rest() { return take(left_.size()); }

  /// @throws Error unless exactly `bytes` bytes remain.
  void expectRemaining(std::uint64_t bytes) const;

  [[noreturn]] void fail(const std::string& fault) const;

 private:
  std::span<const std::byte> take(std::size_t bytes);
  void expectAtLeast(std::size_t bytes) const;
  [[noreturn]] void failNotFinite(std::string_view what, std::size_t index) const;

  std::string name_;
  std::uint32_t version_ = 0;
  std::vector<std::byte> bytes_;
  std::span<const std::byte> left_;
};

}  // namespace gonio::io
