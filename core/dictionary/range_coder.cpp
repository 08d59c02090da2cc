// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/range_coder.h"

#include <string>
#include <utility>

#include "core/support/error.h"

namespace gonio::dictionary {

namespace {
constexpr std::uint32_t smallestRange = std::uint32_t(1) << 24, half = std::uint32_t(1) << (AdaptiveBit::precision - 1);
constexpr int bytesAtEnd = 5;

template <typename Coder>
std::uint32_t codeNumber(Coder& coder, std::uint32_t value, int bits) {
  std::uint32_t result = 0;
  for (int bit = bits - 1; bit >= 0; --bit) result |= std::uint32_t(coder.directBit((value >> bit & 1) != 0)) << bit;
  return result;
}
}  // namespace

void RangeEncoder::encode(std::uint32_t probabilityOfOne, bool value) {
  const std::uint32_t bound = (range_ >> AdaptiveBit::precision) * probabilityOfOne;
  if (value) {
    range_ = bound;
  } else {
    low_ += bound;
    range_ -= bound;
  }
  for (; range_ < smallestRange; range_ <<= 8) shiftLow();
}

/// Writes the byte above the range, unless a carry may still change it.
void RangeEncoder::shiftLow() {
  const auto carry = std::uint8_t(low_ >> 32);
  if (carry != 0 || low_ < 0xFF000000U) {
    for (std::uint8_t byte = held_; pending_ > 0; --pending_, byte = 0xFF)
      bytes_.push_back(std::byte(std::uint8_t(byte + carry)));
    held_ = std::uint8_t(low_ >> 24);
  }
  ++pending_;
  low_ = (low_ & 0x00FFFFFF) << 8;
}

bool RangeEncoder::bit(AdaptiveBit& context, bool value) {
  encode(context.probabilityOfOne(), value);
  context.add(value);
  return value;
}

bool RangeEncoder::directBit(bool value) {
  encode(half, value);
  return value;
}

std::uint32_t RangeEncoder::number(std::uint32_t value, int bits) { return codeNumber(*this, value, bits); }

std::vector<std::byte> RangeEncoder::finish() {
  for (int i = 0; i < bytesAtEnd; ++i) shiftLow();
  bytes_.erase(bytes_.begin());  // always 0: the carry of the first byte
  return std::move(bytes_);
}

RangeDecoder::RangeDecoder(std::span<const std::byte> bytes) : bytes_(bytes) {
  for (int i = 0; i < bytesAtEnd - 1; ++i) code_ = code_ << 8 | next();
}

std::uint32_t RangeDecoder::next() {
  if (at_ == bytes_.size()) throw Error("the code ends after " + std::to_string(at_) + " bytes, expected more");
  return std::uint32_t(bytes_[at_++]);
}

bool RangeDecoder::decode(std::uint32_t probabilityOfOne) {
  const std::uint32_t bound = (range_ >> AdaptiveBit::precision) * probabilityOfOne;
  const bool value = code_ < bound;
  if (value) {
    range_ = bound;
  } else {
    code_ -= bound;
    range_ -= bound;
  }
  for (; range_ < smallestRange; range_ <<= 8) code_ = code_ << 8 | next();
  return value;
}

bool RangeDecoder::bit(AdaptiveBit& context, bool) {
  const bool value = decode(context.probabilityOfOne());
  context.add(value);
  return value;
}

bool RangeDecoder::directBit(bool) { return decode(half); }

std::uint32_t RangeDecoder::number(std::uint32_t, int bits) { return codeNumber(*this, 0, bits); }

}  // namespace gonio::dictionary
