// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/code_packing.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <string>

#include "core/dictionary/packed_bytes.h"
#include "core/dictionary/quantised_code.h"
#include "core/support/error.h"

namespace gonio::dictionary {

namespace {

float largestSize(const ChannelCode& channel) {
  float largest = 0;
  for (const Coefficient<float>& c : channel.coefficients) largest = std::max(largest, std::abs(c.value));
  return largest;
}

void pack(const ChannelCode& channel, const HalfDifferenceGrid& grid, CodePrecision precision, ByteWriter& writer) {
  checkLimits(channel, grid);
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

ChannelCode unpack(ByteReader& reader, CodePrecision precision, std::size_t cells) {
  ChannelCode channel;
  channel.dictionary = reader.read<std::uint8_t>();
  const std::size_t count = reader.read<std::uint16_t>();
  const float scale = reader.readNonNegative("a scale");
  channel.highest = reader.readNonNegative("a maximum");
  if (count > reader.left()) throw Error("the code is truncated: it ends before its last index");
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
  if (precision == CodePrecision::quantised) return compressChannels(code);
  ByteWriter writer;
  for (const ChannelCode& channel : code.channels) pack(channel, code.grid, precision, writer);
  return std::move(writer.bytes);
}

void unpackChannels(std::span<const std::byte> bytes, CodePrecision precision, SparseCode& code) {
  if (precision == CodePrecision::quantised) return expandChannels(bytes, code);
  ByteReader reader(bytes);
  for (ChannelCode& channel : code.channels) channel = unpack(reader, precision, code.grid.size());
  if (reader.left() > 0) throw Error("the code has " + std::to_string(reader.left()) + " extra bytes at the end");
}

SparseCode truncatedToBytes(const SparseCode& code, std::size_t bytes) {
  std::size_t low = 0, high = code.coefficients();
  while (low < high) {
    const std::size_t middle = (low + high + 1) / 2;
    if (compressChannels(code.truncated(middle)).size() <= bytes)
      low = middle;
    else
      high = middle - 1;
  }
  return code.truncated(low);
}

}  // namespace gonio::dictionary
