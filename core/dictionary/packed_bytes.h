// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "core/dictionary/sparse_code.h"
#include "core/support/error.h"

/// What the two serialisations of codes share (code_packing.h, quantised_code.h).
namespace gonio::dictionary {

static_assert(std::endian::native == std::endian::little, "codes are written in the machine's own order");

class ByteWriter {
 public:
  template <typename Number>
  void write(Number number) {
    const auto* begin = reinterpret_cast<const std::byte*>(&number);
    bytes.insert(bytes.end(), begin, begin + sizeof(Number));
  }
  /// Seven bits per byte, lowest first, with the eighth bit set if more bytes follow.
  void writeVariable(std::uint32_t number) {
    for (; number >= 0x80; number >>= 7) bytes.push_back(std::byte((number & 0x7F) | 0x80));
    bytes.push_back(std::byte(number));
  }
  std::vector<std::byte> bytes;
};

/// All functions throw Error if the bytes end too early.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <typename Number>
  Number read() {
    if (left() < sizeof(Number))
      throw Error("the code ends after " + std::to_string(bytes_.size()) + " bytes, expected more");
    Number number;
    std::memcpy(&number, bytes_.data() + at_, sizeof(Number));
    at_ += sizeof(Number);
    return number;
  }
  /// A float32 >= 0. @param what for the error.
  float readNonNegative(const char* what) {
    const auto number = read<float>();
    if (!std::isfinite(number) || number < 0)
      throw Error(std::string(what) + " of the code is not a finite number >= 0");
    return number;
  }
  std::uint64_t readVariable() {
    std::uint64_t number = 0;
    for (int shift = 0; shift < 35; shift += 7) {
      const auto next = read<std::uint8_t>();
      number |= std::uint64_t(next & 0x7F) << shift;
      if (next < 0x80) return number;
    }
    throw Error("an index of the code has more than five bytes");
  }
  std::size_t left() const { return bytes_.size() - at_; }
  std::span<const std::byte> rest() const { return bytes_.subspan(at_); }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
};

/// @throws Error for more coefficients than a file can have.
inline void checkCount(std::size_t coefficients) {
  constexpr std::size_t maxCount = std::numeric_limits<std::uint16_t>::max();
  if (coefficients > maxCount)
    throw Error("found a code with " + std::to_string(coefficients) + " coefficients, expected at most " +
                std::to_string(maxCount));
}
/// @throws Error as checkCount(), for a dictionary index above 255, and for a coefficient index outside the grid.
inline void checkLimits(const ChannelCode& channel, const HalfDifferenceGrid& grid) {
  checkCount(channel.coefficients.size());
  if (channel.dictionary < 0 || channel.dictionary > std::numeric_limits<std::uint8_t>::max())
    throw Error("the code refers to dictionary " + std::to_string(channel.dictionary) + ", expected 0 to 255");
  for (const Coefficient<float>& c : channel.coefficients)
    if (c.index >= grid.size())
      throw Error("the code has a coefficient with index " + std::to_string(c.index) + ", expected less than " +
                  std::to_string(grid.size()));
}

}  // namespace gonio::dictionary
