// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/formats/merl.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/formats/formats.h"
#include "core/io/byte_source.h"
#include "core/materials/encode.h"
#include "core/math/parallel.h"

namespace gonio::formats {

using materials::EditedMaterial, materials::Encoded, materials::EncodeOptions, materials::Material;

namespace {

static_assert(std::endian::native == std::endian::little, "the formats are little-endian and are read as they lie");

constexpr std::size_t blockCells = 8192;
constexpr double invalidRaw = -1;
constexpr std::int32_t maxAxisCount = 1 << 20;
constexpr std::uint64_t maxCells = std::uint64_t(1) << 28;
const std::string expectedSize = "three axis counts (90 90 180) and 24 bytes for each cell";

std::string gridName(const std::array<std::int32_t, 3>& counts) {
  return std::to_string(counts[0]) + " x " + std::to_string(counts[1]) + " x " + std::to_string(counts[2]);
}

bool isWholeCircle(const HalfDifferenceGrid& grid) {
  return std::int64_t(grid.phiDCount) == 4 * std::int64_t(grid.thetaDCount);
}

/// One block of cells of a file: raw planes, converted into the table's arrays.
class BlockReader {
 public:
  BlockReader(const io::ByteSource& source, std::size_t cells) : source_(source), cells_(cells) {}

  /// @return the plane-order index of the first value that is not finite, or none.
  std::size_t convert(std::size_t begin, std::size_t end, TabulatedBrdf::Value* values, std::uint8_t* valid,
                      std::uint64_t& clamped) const {
    const std::size_t count = end - begin;
    const auto raw = std::make_unique_for_overwrite<double[]>(3 * count);
    for (std::size_t channel = 0; channel < 3; ++channel)
      source_.readAt(merlHeaderBytes + (channel * cells_ + begin) * sizeof(double),
                     std::as_writable_bytes(std::span(raw.get() + channel * count, count)));
    std::size_t bad = none;
    for (std::size_t i = 0; i < count; ++i) {
      const double r = raw[i], g = raw[count + i], b = raw[2 * count + i];
      const bool isValid = r > invalidRaw && g > invalidRaw && b > invalidRaw;
      const TabulatedBrdf::Value value(float(std::max(r, 0.0) * merlScale[0]), float(std::max(g, 0.0) * merlScale[1]),
                                       float(std::max(b, 0.0) * merlScale[2]));
      // A NaN or an infinity in any channel makes the sum so; std::max keeps them where they are its first argument.
      if (!std::isfinite(value.x + value.y + value.z + (r + g + b) * 0))
        bad = std::min(bad, firstBad(raw, count, i, begin));
      valid[begin + i] = isValid;
      values[begin + i] = value;
      if (isValid) clamped += std::uint64_t(r < 0) + std::uint64_t(g < 0) + std::uint64_t(b < 0);
    }
    return bad;
  }

  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

 private:
  std::size_t firstBad(const std::unique_ptr<double[]>& raw, std::size_t count, std::size_t i,
                       std::size_t begin) const {
    for (std::size_t channel = 0; channel < 3; ++channel)
      if (!std::isfinite(float(raw[channel * count + i] * merlScale[channel]))) return channel * cells_ + begin + i;
    return none;
  }

  const io::ByteSource& source_;
  std::size_t cells_;
};

[[noreturn]] void throwNotFinite(const io::ByteSource& source, const HalfDifferenceGrid& grid, std::size_t index) {
  double value = 0;
  source.readAt(merlHeaderBytes + index * sizeof(double), std::as_writable_bytes(std::span(&value, 1)));
  const std::size_t cell = index % grid.size(), phi = std::size_t(grid.phiDCount), td = std::size_t(grid.thetaDCount);
  throw Error("value " + std::to_string(index) + " (" + channelNames[index / grid.size()] + ", theta_h " +
              std::to_string(cell / (phi * td)) + ", theta_d " + std::to_string(cell / phi % td) + ", phi_d " +
              std::to_string(cell % phi) + ") is " + std::to_string(value) +
              ", expected a finite number in the range of single precision");
}

}  // namespace

HalfDifferenceGrid readMerlHeader(const io::ByteSource& source) {
  std::array<std::int32_t, 3> counts{};
  if (source.size() < merlHeaderBytes) throw io::FormatMismatch(std::to_string(source.size()) + " bytes", expectedSize);
  source.readAt(0, std::as_writable_bytes(std::span(counts)));
  if (*std::min_element(counts.begin(), counts.end()) < 1)
    throw io::FormatMismatch("axis counts " + gridName(counts), "three positive axis counts (90 90 180)");
  // Counts of at most 2^20: their product fits 64 bits.
  if (*std::max_element(counts.begin(), counts.end()) > maxAxisCount)
    throw io::FormatMismatch("axis counts " + gridName(counts),
                             "axis counts of at most " + std::to_string(maxAxisCount));
  const std::uint64_t cells = std::uint64_t(counts[0]) * std::uint64_t(counts[1]) * std::uint64_t(counts[2]);
  const std::uint64_t dataBytes = source.size() - merlHeaderBytes;
  const std::uint64_t wholeBytes = 24 * cells;
  if (dataBytes != wholeBytes) {
    const std::string found = "axis counts " + gridName(counts) + " and " + std::to_string(source.size()) + " bytes";
    const std::string expected = "12 + 24 x " + std::to_string(cells) + " bytes for these counts";
    if (dataBytes > wholeBytes) throw io::FormatMismatch(found, expected);
    throw io::FormatMismatch::truncated(found, expected, source.size(), merlHeaderBytes + wholeBytes);
  }
  if (cells > maxCells)
    throw io::FormatMismatch(std::to_string(cells) + " cells", "at most " + std::to_string(maxCells));
  HalfDifferenceGrid grid{counts[0], counts[1], counts[2], true};
  grid.reciprocal = !isWholeCircle(grid);
  return grid;
}

MerlTable readMerl(const io::ByteSource& source, const TaskControl& control) {
  const HalfDifferenceGrid grid = readMerlHeader(source);
  const std::size_t cells = grid.size();
  std::vector<TabulatedBrdf::Value> values(cells);
  std::vector<std::uint8_t> valid(cells);
  std::atomic<std::uint64_t> clamped = 0;
  std::atomic<std::size_t> bad = BlockReader::none;
  const BlockReader reader(source, cells);
  parallelForBlocks(
      cells, blockCells,
      [&](std::size_t begin, std::size_t end) {
        std::uint64_t blockClamped = 0;
        const std::size_t blockBad = reader.convert(begin, end, values.data(), valid.data(), blockClamped);
        clamped += blockClamped;
        std::size_t known = bad;
        while (blockBad < known && !bad.compare_exchange_weak(known, blockBad)) continue;
      },
      control);
  if (bad != BlockReader::none) throwNotFinite(source, grid, bad);
  return {std::make_shared<const TabulatedBrdf>(grid, std::move(values), std::move(valid)), clamped};
}

std::vector<std::byte> encodeMerl(const TabulatedBrdf& table) {
  const HalfDifferenceGrid& grid = table.grid();
  const std::array<std::int32_t, 3> counts{grid.thetaHCount, grid.thetaDCount, grid.phiDCount};
  if (grid.reciprocal == isWholeCircle(grid))
    throw Error("a MERL file with " + gridName(counts) + " cells would be read as " +
                (grid.reciprocal
                     ? "non-reciprocal, because it has 4 phi_d samples per theta_d sample; expected a different "
                       "number for a reciprocal table"
                     : "reciprocal; expected 4 phi_d samples per theta_d sample for a non-reciprocal table"));
  const std::size_t cells = grid.size();
  std::vector<std::byte> bytes(merlHeaderBytes + 3 * cells * sizeof(double));
  std::memcpy(bytes.data(), counts.data(), merlHeaderBytes);
  parallelForBlocks(cells, blockCells, [&](std::size_t begin, std::size_t end) {
    for (int channel = 0; channel < 3; ++channel) {
      std::byte* target = bytes.data() + merlHeaderBytes + (std::size_t(channel) * cells + begin) * sizeof(double);
      for (std::size_t cell = begin; cell < end; ++cell, target += sizeof(double)) {
        const double raw =
            table.valid()[cell] ? double(table.values()[cell][channel]) / merlScale[channel] : invalidRaw;
        std::memcpy(target, &raw, sizeof(double));
      }
    }
  });
  return bytes;
}

namespace {

template <bool reciprocal>
void sniffMerl(const io::ByteSource& source) {
  if (readMerlHeader(source).reciprocal != reciprocal)
    throw io::FormatMismatch(reciprocal ? "phi_d from 0 to 360 degrees" : "phi_d from 0 to 180 degrees",
                             reciprocal ? "0 to 180 degrees" : "0 to 360 degrees");
}

void readMerlMaterial(const io::ByteSource& source, const TaskControl& control, Material& material) {
  const MerlTable merl = readMerl(source, control);
  const HalfDifferenceGrid& grid = merl.table->grid();
  material.table = merl.table;
  material.brdf = merl.table;
  material.source.grid = {grid.thetaHCount, grid.thetaDCount, grid.phiDCount};
  if (merl.clampedCount > 0)
    material.source.notes.push_back(std::to_string(merl.clampedCount) + " small negative values were set to 0");
}

std::string negativesLoss(const TabulatedBrdf& table) {
  return std::to_string(table.clampedCount()) + " negative values were set to 0";
}

/// The table of a material with a grid that folds phi_d or does not; null if it has none.
std::shared_ptr<const TabulatedBrdf> ownTable(const EditedMaterial& material, bool reciprocal,
                                              const TaskControl& control) {
  const auto& [shown, base] = std::tie(material.shown, material.base);
  if (shown.table && shown.table->grid().reciprocal == reciprocal) return shown.table;
  if (!base.table || base.table->grid().reciprocal != reciprocal) return nullptr;
  // Cell by cell: cells without data keep none.
  return editing::bakeEdits(base.table, material.edits, control);
}

/// What a file can hold: invalid cells are negative there, so that negative values become 0.
Encoded encodedTable(const std::shared_ptr<const TabulatedBrdf>& own) {
  const auto isNegative = [](const TabulatedBrdf::Value& v) { return v.x < 0 || v.y < 0 || v.z < 0; };
  if (std::ranges::none_of(own->values(), isNegative)) return {encodeMerl(*own), own};
  const auto table =
      std::make_shared<const TabulatedBrdf>(own->grid(), std::vector(own->values().begin(), own->values().end()),
                                            std::vector(own->valid().begin(), own->valid().end()));
  return {encodeMerl(*table), table, {negativesLoss(*table)}};
}

/// The table to write. For a table with such a grid: that table, edited cell by cell; for other materials: the grid of
/// the options, or else 90 x 90 x 180 angles (360 over the whole circle of phi_d).
template <bool reciprocal>
Encoded encodeMerlMaterial(const EditedMaterial& material, const EncodeOptions& options, const TaskControl& control) {
  constexpr HalfDifferenceGrid usual{.phiDCount = reciprocal ? 180 : 360, .reciprocal = reciprocal};
  if (auto copy = copyOfFile(material, reciprocal ? merlFormat : merlCircleFormat)) return std::move(*copy);
  const HalfDifferenceGrid grid = options.grid && options.grid->reciprocal == reciprocal ? *options.grid : usual;
  if (const auto own = ownTable(material, reciprocal, control)) return encodedTable(own);
  const auto table = bakeTable(*material.shown.brdf, grid, control, editing::bakedAzimuths);
  Encoded made{encodeMerl(*table), table};
  made.losses.push_back("the values were sampled at " + gridName({grid.thetaHCount, grid.thetaDCount, grid.phiDCount}) +
                        " half-difference angles");
  if (table->clampedCount() > 0) made.losses.push_back(negativesLoss(*table));
  return made;
}

template <bool reciprocal>
bool isMerlTable(const Brdf& brdf) {
  const auto* table = formOf<TabulatedBrdf>(brdf);
  return table && table->grid().reciprocal == reciprocal;
}

constexpr std::string_view merlSuffixes[] = {".binary"};

}  // namespace

constinit const MaterialFormat merlFormat{.name = "MERL",
                                          .label = "MERL file",
                                          .suffixes = merlSuffixes,
                                          .isMeasurement = true,
                                          .sniff = sniffMerl<true>,
                                          .read = readMerlMaterial,
                                          .encode = encodeMerlMaterial<true>,
                                          .isOwnForm = isMerlTable<true>};

constinit const MaterialFormat merlCircleFormat{.name = "360-degree MERL",
                                                .label = "360-degree MERL file",
                                                .suffixes = merlSuffixes,
                                                .isMeasurement = true,
                                                .holds = {.nonReciprocal = true},
                                                .sniff = sniffMerl<false>,
                                                .read = readMerlMaterial,
                                                .encode = encodeMerlMaterial<false>,
                                                .isOwnForm = isMerlTable<false>};

}  // namespace gonio::formats
