// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Adaptive binary range coding (Martin 1979, Range encoding: an algorithm for removing redundancy from a digitised
/// message; carries as in the coder of LZMA). Only integers, so that every machine reads what any other has written.
/// RangeEncoder and RangeDecoder have the same interface: one function can describe both directions. bit(), directBit()
/// and number() take the value to write and return it; the decoder ignores the argument and returns the value read.
namespace gonio::dictionary {

/// The probability of a bit, estimated from the bits before it in the same context.
class AdaptiveBit {
 public:
  static constexpr int precision = 15;  ///< bits of probabilityOfOne()

  std::uint32_t probabilityOfOne() const { return (std::uint32_t(ones_) << precision) / (ones_ + zeros_); }
  void add(bool bit) {
    constexpr int memory = 400;
    ++(bit ? ones_ : zeros_);
    if (ones_ + zeros_ <= memory) return;
    ones_ = std::uint16_t((ones_ + 1) / 2);
    zeros_ = std::uint16_t((zeros_ + 1) / 2);
  }

 private:
  std::uint16_t ones_ = 1, zeros_ = 1;
};

class RangeEncoder {
 public:
  bool bit(AdaptiveBit& context, bool value);
  /// A bit with equally probable values (a direct bit of LZMA).
  bool directBit(bool value);
  /// A number of `bits` direct bits.
  std::uint32_t number(std::uint32_t value, int bits);

  /// The bytes; call once, at the end.
  std::vector<std::byte> finish();

 private:
  void encode(std::uint32_t probabilityOfOne, bool value);
  void shiftLow();

  std::uint64_t low_ = 0, pending_ = 1;
  std::uint32_t range_ = ~std::uint32_t(0);
  std::uint8_t held_ = 0;
  std::vector<std::byte> bytes_;
};

class RangeDecoder {
 public:
  /// `bytes` must outlive this object. @throws Error if there are too few.
  explicit RangeDecoder(std::span<const std::byte> bytes);

  /// All throw Error if the bytes end too early.
  bool bit(AdaptiveBit& context, bool = false);
  bool directBit(bool = false);
  std::uint32_t number(std::uint32_t, int bits);

  /// Bytes that were not needed.
  std::size_t left() const { return bytes_.size() - at_; }

 private:
  bool decode(std::uint32_t probabilityOfOne);
  std::uint32_t next();

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  std::uint32_t range_ = ~std::uint32_t(0), code_ = 0;
};

}  // namespace gonio::dictionary
