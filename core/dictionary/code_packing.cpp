// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/code_packing.h"

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "core/support/error.h"

namespace gonio::dictionary {

namespace {

static_assert(std::endian::native == std::endian::little, "codes are written in the machine's own order");

class Writer {
 public:
  template <typename Number>
  void write(Number number) {
    const auto* begin = reinterpret_cast<const std::byte*>(&number);
    bytes.insert(bytes.end(), begin, begin + sizeof(Number));
  }
  void writeVariable(std::uint32_t number) {
    for (; number >= 0x80; number >>= 7) bytes.push_back(std::byte((number & 0x7F) | 0x80));
    bytes.push_back(std::byte(number));
  }
  std::vector<std::byte> bytes;
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}
  template <typename Number>
  Number read() {
    if (left() < sizeof(Number)) throw Error("the code ends after " + std::to_string(at_) + " bytes, expected more");
    Number number;
    std::memcpy(&number, bytes_.data() + at_, sizeof(Number));
    at_ += sizeof(Number);
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

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
};

float largestSize(const ChannelCode& channel) {
  float largest = 0;
  for (const Coefficient<float>& c : channel.coefficients) largest = std::max(largest, std::abs(c.value));
  return largest;
}

void pack(const ChannelCode& channel, CodePrecision precision, Writer& writer) {
  if (channel.coefficients.size() > std::numeric_limits<std::uint16_t>::max())
    throw Error("found a code with " + std::to_string(channel.coefficients.size()) +
                " coefficients, expected at most 65535");
  if (channel.dictionary < 0 || channel.dictionary > std::numeric_limits<std::uint8_t>::max())
    throw Error("the code refers to dictionary " + std::to_string(channel.dictionary) + ", expected 0 to 255");
  std::vector<Coefficient<float>> sorted = channel.coefficients;
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
  const float scale = largestSize(channel);
  writer.write(std::uint8_t(channel.dictionary));
  writer.write(std::uint16_t(sorted.size()));
  writer.write(scale);
  writer.write(channel.highest);
  std::uint32_t before = 0;
  for (const Coefficient<float>& c : sorted) {
    writer.writeVariable(c.index - before);
    before = c.index;
  }
  for (const Coefficient<float>& c : sorted)
    if (precision == CodePrecision::single)
      writer.write(c.value);
    else
      writer.write(Eigen::half(scale > 0 ? c.value / scale : 0.0f));
}

ChannelCode unpack(Reader& reader, CodePrecision precision, std::size_t cells) {
  ChannelCode channel;
  channel.dictionary = reader.read<std::uint8_t>();
  const std::size_t count = reader.read<std::uint16_t>();
  const float scale = reader.read<float>();
  if (!std::isfinite(scale) || scale < 0) throw Error("a scale of the code is not a finite positive number");
  channel.highest = reader.read<float>();
  if (!std::isfinite(channel.highest) || channel.highest < 0)
    throw Error("a maximum of the code is not a finite positive number");
  if (count > reader.left()) throw Error("the code ends within its indices");
  channel.coefficients.resize(count);
  std::uint64_t index = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t step = reader.readVariable();
    if (i > 0 && step == 0) throw Error("an index of the code occurs twice");
    index += step;
    if (index >= cells)
      throw Error("an index of the code is " + std::to_string(index) + ", expected less than " + std::to_string(cells));
    channel.coefficients[i].index = std::uint32_t(index);
  }
  for (Coefficient<float>& c : channel.coefficients) {
    c.value = precision == CodePrecision::single ? reader.read<float>() : float(reader.read<Eigen::half>()) * scale;
    if (!std::isfinite(c.value)) throw Error("a coefficient of the code is not finite");
  }
  std::sort(channel.coefficients.begin(), channel.coefficients.end(), isLarger<float>);
  return channel;
}

}  // namespace

std::vector<std::byte> packChannels(const SparseCode& code, CodePrecision precision) {
  Writer writer;
  for (const ChannelCode& channel : code.channels) pack(channel, precision, writer);
  return std::move(writer.bytes);
}

void unpackChannels(std::span<const std::byte> bytes, CodePrecision precision, SparseCode& code) {
  Reader reader(bytes);
  for (ChannelCode& channel : code.channels) channel = unpack(reader, precision, code.grid.size());
  if (reader.left() > 0) throw Error("the code has " + std::to_string(reader.left()) + " extra bytes at the end");
}

SparseCode truncatedToBytes(const SparseCode& code, std::size_t bytes) {
  std::size_t low = 0, high = code.coefficients();
  while (low < high) {
    const std::size_t middle = (low + high + 1) / 2;
    if (packChannels(code.truncated(middle), CodePrecision::half).size() <= bytes)
      low = middle;
    else
      high = middle - 1;
  }
  return code.truncated(low);
}

}  // namespace gonio::dictionary
