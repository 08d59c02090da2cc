// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/code_packing.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <unordered_map>

#include "core/dictionary/mode_products.h"
#include "core/dictionary/range_coder.h"
#include "core/support/error.h"

namespace gonio::dictionary {

namespace {

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
  /// A float32 <= 0.
  float readMinimum() {
    const auto number = read<float>();
    if (!std::isfinite(number) || number > 0) throw Error("a minimum of the code is not a finite number <= 0");
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
void checkCount(std::size_t coefficients) {
  constexpr std::size_t maxCount = std::numeric_limits<std::uint16_t>::max();
  if (coefficients > maxCount)
    throw Error("found a code with " + std::to_string(coefficients) + " coefficients, expected at most " +
                std::to_string(maxCount));
}
/// @throws Error as checkCount(), for a dictionary index above 255, and for a coefficient index outside the grid.
void checkLimits(const ChannelCode& channel, const HalfDifferenceGrid& grid) {
  checkCount(channel.coefficients.size());
  if (channel.dictionary < 0 || channel.dictionary > std::numeric_limits<std::uint8_t>::max())
    throw Error("the code refers to dictionary " + std::to_string(channel.dictionary) + ", expected 0 to 255");
  for (const Coefficient<float>& c : channel.coefficients)
    if (c.index >= grid.size())
      throw Error("the code has a coefficient with index " + std::to_string(c.index) + ", expected less than " +
                  std::to_string(grid.size()));
}

constexpr float stepOfSmallest = 1.4f, smallestStep = 0x1p-20f;  // of the smallest and of the largest absolute value
constexpr int sizeClasses = 22;                                  // by the number of bits; the largest is 2^20 steps

/// The quantised values of a channel by their indices. A row is all indices with the same l1 and l2.
struct Levels {
  explicit Levels(const Sizes& sizes) : lastOfRow(std::size_t(sizes[1]) * std::size_t(sizes[2]), -1) {}

  std::int32_t at(std::uint32_t index) const {
    const auto found = values.find(index);
    return found == values.end() ? 0 : found->second;
  }
  bool has(std::uint32_t index) const { return values.contains(index); }

  std::unordered_map<std::uint32_t, std::int32_t> values;
  std::vector<int> lastOfRow;  ///< the largest l0 of each row; -1: the row is empty
  int rows = 0, slices = 0;    ///< one more than the largest l1 and l2
};

/// Number of thresholds that a number reaches.
template <std::size_t count>
int classOf(int number, const std::array<int, count>& thresholds) {
  return int(std::ranges::upper_bound(thresholds, number) - thresholds.begin());
}
constexpr std::array<int, 5> positions{1, 2, 3, 6, 10};                            // of l0
constexpr std::array<int, 11> products{2, 3, 4, 7, 11, 16, 26, 41, 64, 102, 162};  // (1 + l1) (1 + l2)
int sizeClass(std::int32_t level) { return int(std::bit_width(std::uint32_t(std::abs(level)))) - 1; }

/// Estimates of all bits. "Shared": the channel before has the same dictionary.
struct Contexts {
  AdaptiveBit row[2][2][3][products.size() + 1];           ///< shared, filled in the channel before, filled neighbours
  AdaptiveBit significant[2][2][4][positions.size() + 1];  ///< shared, the same there, significant neighbours
  AdaptiveBit last[2][2][positions.size() + 1];            ///< shared, whether the row of the channel before has ended
  AdaptiveBit sign;                                        ///< whether it is that of the channel before
  AdaptiveBit size[sizeClasses + 6][sizeClasses];          ///< by the size there, or by the position where it has none
  AdaptiveBit secondBit[sizeClasses][3];                   ///< by that of the channel before, if it has the same size
};

/// Writes or reads a channel: the order of all bits.
template <typename Coder>
class ChannelCoder {
 public:
  /// @param before the channel before, if it has the same dictionary; else null.
  ChannelCoder(Coder& coder, Contexts& contexts, const Sizes& sizes, Levels& levels, const Levels* before)
      : coder_(coder), contexts_(contexts), sizes_(sizes), levels_(levels), before_(before) {}

  void run() {
    levels_.rows = extent(levels_.rows, sizes_[1]);
    levels_.slices = extent(levels_.slices, sizes_[2]);
    for (int l2 = 0; l2 < levels_.slices; ++l2)
      for (int l1 = 0; l1 < levels_.rows; ++l1) {
        const std::size_t row = std::size_t(l1) + std::size_t(sizes_[1]) * std::size_t(l2);
        if (coder_.bit(rowContext(row, l1, l2), levels_.lastOfRow[row] >= 0)) codeRow(row, l1, l2);
      }
  }

 private:
  int extent(int value, int most) {
    const auto found = int(coder_.number(std::uint32_t(value), int(std::bit_width(std::uint32_t(most)))));
    if (found > most)
      throw Error("the code has " + std::to_string(found) + " rows or slices of coefficients, expected at most " +
                  std::to_string(most));
    return found;
  }

  AdaptiveBit& rowContext(std::size_t row, int l1, int l2) {
    const auto isFilled = [&](std::size_t other) { return levels_.lastOfRow[other] >= 0; };
    const int neighbours =
        (l1 > 0 && isFilled(row - 1) ? 1 : 0) + (l2 > 0 && isFilled(row - std::size_t(sizes_[1])) ? 1 : 0);
    const bool wasFilled = before_ && before_->lastOfRow[row] >= 0;
    return contexts_.row[before_ ? 1 : 0][wasFilled ? 1 : 0][neighbours][classOf((1 + l1) * (1 + l2), products)];
  }

  void codeRow(std::size_t row, int l1, int l2) {
    const auto length = std::uint32_t(sizes_[0]), slice = length * std::uint32_t(sizes_[1]);
    const auto first = std::uint32_t(row) * length;
    for (std::uint32_t l0 = 0;; ++l0) {
      const std::uint32_t index = first + l0;
      const bool ends = l0 + 1 == length;  // then it is significant, since the row is filled
      const int neighbours = (l0 > 0 && levels_.has(index - 1) ? 1 : 0) +
                             (l1 > 0 && levels_.has(index - length) ? 1 : 0) +
                             (l2 > 0 && levels_.has(index - slice) ? 1 : 0);
      const std::int32_t there = before_ ? before_->at(index) : 0;
      const int shared = before_ ? 1 : 0, position = classOf(int(l0), positions);
      if (!ends &&
          !coder_.bit(contexts_.significant[shared][there != 0 ? 1 : 0][neighbours][position], levels_.has(index)))
        continue;
      addLevel(index, codeLevel(levels_.at(index), there, int(l0 + 1) * (l1 + 1) * (l2 + 1)));
      const bool hadEnded = before_ && int(l0) >= before_->lastOfRow[row];
      if (ends || coder_.bit(contexts_.last[shared][hadEnded ? 1 : 0][position], levels_.lastOfRow[row] == int(l0))) {
        levels_.lastOfRow[row] = int(l0);
        return;
      }
    }
  }

  void addLevel(std::uint32_t index, std::int32_t level) {
    levels_.values[index] = level;
    checkCount(levels_.values.size());
  }

  /// @param there of the channel before, 0 if none; @param product (1 + l0) (1 + l1) (1 + l2).
  std::int32_t codeLevel(std::int32_t level, std::int32_t there, int product) {
    const bool isNegative = there != 0 ? coder_.bit(contexts_.sign, (level < 0) == (there < 0)) == (there < 0)
                                       : coder_.directBit(level < 0);
    const int sizeThere = there != 0 ? sizeClass(there) : -1;
    const int row = there != 0 ? sizeThere : sizeClasses + std::min(5, sizeClass(product));
    int size = 0;
    while (!coder_.bit(contexts_.size[row][size], sizeClass(level) == size))
      if (++size == sizeClasses) throw Error("a coefficient of the code is too large");
    const auto magnitude = std::uint32_t(std::abs(level));
    std::uint32_t result = 1;
    for (int bit = size - 1; bit >= 0; --bit) {
      const bool value = (magnitude >> bit & 1) != 0;
      const int second = sizeThere == size ? (std::uint32_t(std::abs(there)) >> bit & 1) : 2;
      result = result << 1 | std::uint32_t(bit == size - 1 ? coder_.bit(contexts_.secondBit[size][second], value)
                                                           : coder_.directBit(value));
    }
    return isNegative ? -std::int32_t(result) : std::int32_t(result);
  }

  Coder& coder_;
  Contexts& contexts_;
  const Sizes sizes_;
  Levels& levels_;
  const Levels* before_;
};

Levels levelsOf(const ChannelCode& channel, const Sizes& sizes) {
  Levels levels(sizes);
  for (const Coefficient<float>& c : channel.coefficients) {
    const std::uint32_t row = c.index / std::uint32_t(sizes[0]);
    levels.values[c.index] = std::int32_t(std::lround(c.value / channel.step));
    levels.lastOfRow[row] = std::max(levels.lastOfRow[row], int(c.index % std::uint32_t(sizes[0])));
    levels.rows = std::max(levels.rows, int(row % std::uint32_t(sizes[1])) + 1);
    levels.slices = std::max(levels.slices, int(row / std::uint32_t(sizes[1])) + 1);
  }
  return levels;
}

std::vector<Coefficient<float>> coefficientsOf(const Levels& levels, float step) {
  std::vector<Coefficient<float>> coefficients;
  for (const auto& [index, level] : levels.values) coefficients.push_back({index, float(level) * step});
  std::ranges::sort(coefficients, isLarger<float>);
  return coefficients;
}

float quantise(ChannelCode& channel) {
  float smallest = 0, largest = 0;
  for (const Coefficient<float>& c : channel.coefficients) {
    const float size = std::abs(c.value);
    largest = std::max(largest, size);
    if (size > 0 && (smallest == 0 || size < smallest)) smallest = size;
  }
  const float step = std::max(stepOfSmallest * smallest, smallestStep * largest);
  for (Coefficient<float>& c : channel.coefficients) c.value = step > 0 ? std::round(c.value / step) * step : 0;
  std::erase_if(channel.coefficients, [](const Coefficient<float>& c) { return c.value == 0; });
  std::ranges::sort(channel.coefficients, isLarger<float>);
  return step;
}

}  // namespace

SparseCode quantised(SparseCode code) {
  for (ChannelCode& channel : code.channels)
    if (!(channel.step > 0)) channel.step = quantise(channel);
  return code;
}

std::vector<std::byte> compressChannels(const SparseCode& exact) {
  const SparseCode code = quantised(exact);
  const Sizes sizes = modeSizes(code.grid);
  ByteWriter writer;
  RangeEncoder coder;
  Contexts contexts;
  std::vector<Levels> levels;
  for (const ChannelCode& channel : code.channels) {
    checkLimits(channel, code.grid);
    writer.write(std::uint8_t(channel.dictionary));
    writer.write(channel.step);
    writer.write(channel.highest);
    if (code.hasBothOrders()) writer.write(channel.lowest);
    if (code.hasLargestValues) writer.write(channel.largestValue);
    levels.push_back(levelsOf(channel, sizes));
  }
  for (std::size_t c = 0; c < levels.size(); ++c) {
    const bool isShared = c > 0 && code.channels[c].dictionary == code.channels[c - 1].dictionary;
    ChannelCoder(coder, contexts, sizes, levels[c], isShared ? &levels[c - 1] : nullptr).run();
  }
  const std::vector<std::byte> coded = coder.finish();
  writer.bytes.insert(writer.bytes.end(), coded.begin(), coded.end());
  return std::move(writer.bytes);
}

void expandChannels(std::span<const std::byte> bytes, SparseCode& code, bool hasLowest) {
  const Sizes sizes = modeSizes(code.grid);
  ByteReader reader(bytes);
  for (ChannelCode& channel : code.channels) {
    channel.dictionary = reader.read<std::uint8_t>();
    channel.step = reader.readNonNegative("a step");
    channel.highest = reader.readNonNegative("a maximum");
    if (hasLowest) channel.lowest = reader.readMinimum();
    if (code.hasLargestValues) channel.largestValue = reader.readNonNegative("a largest value");
  }
  RangeDecoder coder(reader.rest());
  Contexts contexts;
  std::vector<Levels> levels;
  for (std::size_t c = 0; c < code.channels.size(); ++c) {
    ChannelCode& channel = code.channels[c];
    const bool isShared = c > 0 && channel.dictionary == code.channels[c - 1].dictionary;
    levels.emplace_back(sizes);
    ChannelCoder(coder, contexts, sizes, levels[c], isShared ? &levels[c - 1] : nullptr).run();
    if (channel.step == 0 && !levels[c].values.empty())
      throw Error("the step of a channel with coefficients is 0, expected a positive number");
    channel.coefficients = coefficientsOf(levels[c], channel.step);
    for (const Coefficient<float>& coefficient : channel.coefficients)
      if (!std::isfinite(coefficient.value)) throw Error("a coefficient of the code is not finite");
  }
  if (coder.left() > 0) throw Error("the code has " + std::to_string(coder.left()) + " extra bytes at the end");
}

namespace {

float largestSize(const ChannelCode& channel) {
  float largest = 0;
  for (const Coefficient<float>& c : channel.coefficients) largest = std::max(largest, std::abs(c.value));
  return largest;
}

void pack(const ChannelCode& channel, const SparseCode& code, CodePrecision precision, ByteWriter& writer) {
  checkLimits(channel, code.grid);
  std::vector<Coefficient<float>> sorted = channel.coefficients;
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
  const float scale = largestSize(channel);
  writer.write(std::uint8_t(channel.dictionary));
  writer.write(std::uint16_t(sorted.size()));
  writer.write(scale);
  writer.write(channel.highest);
  if (code.hasBothOrders()) writer.write(channel.lowest);
  if (code.hasLargestValues) writer.write(channel.largestValue);
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

ChannelCode unpack(ByteReader& reader, CodePrecision precision, const SparseCode& code, bool hasLowest) {
  const std::size_t cells = code.grid.size();
  ChannelCode channel;
  channel.dictionary = reader.read<std::uint8_t>();
  const std::size_t count = reader.read<std::uint16_t>();
  const float scale = reader.readNonNegative("a scale");
  channel.highest = reader.readNonNegative("a maximum");
  if (hasLowest) channel.lowest = reader.readMinimum();
  if (code.hasLargestValues) channel.largestValue = reader.readNonNegative("a largest value");
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
  for (const ChannelCode& channel : code.channels) pack(channel, code, precision, writer);
  return std::move(writer.bytes);
}

void unpackChannels(std::span<const std::byte> bytes, CodePrecision precision, SparseCode& code, bool hasLowest) {
  if (precision == CodePrecision::quantised) return expandChannels(bytes, code, hasLowest);
  ByteReader reader(bytes);
  for (ChannelCode& channel : code.channels) channel = unpack(reader, precision, code, hasLowest);
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
