// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/hdr_codec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>

#include "core/io/colour_primaries.h"
#include "core/io/exr_codec.h"
#include "core/io/text_lines.h"
#include "core/math/colour.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::io {

namespace {

/// A line takes four bytes at least; runs of the old kind may fill it.
constexpr std::size_t maxHdrPixelsPerByte = 4096;

struct HdrHeader {
  bool isXyz = false;
  double exposure = 1;
  glm::dvec3 correction{1};
  std::optional<ColourPrimaries> primaries;
  std::vector<std::string> notes;
  std::string_view resolution;
  std::size_t end = 0;  ///< where the pixels begin
};

/// The numbers of a header line. @throws Error if there are not `count` finite ones, above 0 where `arePositive`.
std::vector<double> headerNumbers(std::string_view line, std::size_t count, bool arePositive) {
  const std::string_view text = line.substr(line.find('=') + 1);
  std::vector<double> numbers;
  for (const std::string_view word : words(text))
    if (const auto number = finiteNumber(word); number && (*number > 0 || !arePositive)) numbers.push_back(*number);
  if (numbers.size() != count || words(text).size() != count)
    throw Error("found '" + plainText(line.substr(0, 60)) + "' in the Radiance HDR header, expected " +
                std::to_string(count) + (arePositive ? " numbers above 0" : " numbers"));
  return numbers;
}

void readHeaderLine(std::string_view line, HdrHeader& header, bool& hasFormat) {
  if (line.starts_with("FORMAT=")) {
    const std::string_view format = line.substr(line.find('=') + 1);
    if (format != "32-bit_rle_rgbe" && format != "32-bit_rle_xyze")
      throw Error("found '" + plainText(line.substr(0, 60)) +
                  "' in the Radiance HDR header, expected FORMAT=32-bit_rle_rgbe or 32-bit_rle_xyze");
    header.isXyz = format == "32-bit_rle_xyze";
    hasFormat = true;
  } else if (line.starts_with("EXPOSURE=")) {
    header.exposure *= headerNumbers(line, 1, true)[0];
  } else if (line.starts_with("COLORCORR=")) {
    const std::vector<double> numbers = headerNumbers(line, 3, true);
    header.correction *= glm::dvec3(numbers[0], numbers[1], numbers[2]);
  } else if (line.starts_with("PRIMARIES=")) {
    const std::vector<double> n = headerNumbers(line, 8, false);
    header.primaries = ColourPrimaries{{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}, {n[6], n[7]}};
    if (std::ranges::all_of(n, [](double number) { return number == 0; })) header.primaries.reset();
  } else if (line.starts_with("GAMMA=") && headerNumbers(line, 1, true)[0] != 1) {
    header.notes.push_back("'" + plainText(line.substr(0, 60)) + "' was ignored: the values are linear");
  }
}

HdrHeader readHeader(std::span<const std::byte> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  HdrHeader header;
  const auto next = [&]() -> std::optional<std::string_view> {
    const std::size_t end = text.find('\n', header.end);
    if (end == std::string_view::npos) return std::nullopt;
    std::string_view line = text.substr(header.end, end - header.end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    header.end = end + 1;
    return line;
  };
  bool hasFormat = false;
  std::optional<std::string_view> line = next();
  for (; line && !line->empty(); line = next()) readHeaderLine(*line, header, hasFormat);
  header.resolution = line ? next().value_or("") : "";
  if (header.resolution.empty() || !hasFormat)
    throw Error("found a Radiance HDR header without '-Y HEIGHT +X WIDTH' and 'FORMAT=32-bit_rle_rgbe', expected both");
  return header;
}

/// One axis of the resolution line, as it runs in the file.
struct HdrAxis {
  bool isX = false, isReversed = false;  ///< reversed: from right to left, or from the bottom up
  int length = 0;

  int at(int step) const { return isReversed ? length - 1 - step : step; }
};

HdrAxis axisOf(std::string_view name, std::string_view length) {
  HdrAxis axis{.isX = name.ends_with('X'), .isReversed = name == "-X" || name == "+Y"};
  const auto number = finiteNumber(length);
  if (number && *number == std::floor(*number) && std::abs(*number) < 1e9) axis.length = int(*number);
  return axis;
}

/// Lines, and the pixels of a line.
std::array<HdrAxis, 2> axesOf(std::string_view resolution) {
  const std::vector<std::string_view> part = words(resolution);
  const auto isAxis = [&](std::size_t at, char letter) {
    return part[at].size() == 2 && (part[at][0] == '+' || part[at][0] == '-') && part[at][1] == letter;
  };
  if (part.size() != 4 || !((isAxis(0, 'X') && isAxis(2, 'Y')) || (isAxis(0, 'Y') && isAxis(2, 'X'))))
    throw Error("found the resolution line '" + plainText(resolution.substr(0, 60)) +
                "' in a Radiance HDR image, expected one such as '-Y HEIGHT +X WIDTH'");
  return {axisOf(part[0], part[1]), axisOf(part[2], part[3])};
}

using Rgbe = std::array<std::uint8_t, 4>;

/// Reads the lines of pixels one after another.
class HdrLines {
 public:
  HdrLines(std::span<const std::byte> bytes, std::size_t at) : bytes_(bytes), at_(at) {}

  void read(std::vector<Rgbe>& line) {
    constexpr std::size_t shortest = 8, longest = 0x7fff;
    const std::uint8_t* start = take(4, false);
    const bool isCoded = line.size() >= shortest && line.size() <= longest && start[0] == 2 && start[1] == 2 &&
                         std::size_t(start[2]) * 256 + start[3] == line.size();
    isCoded ? readRuns(line) : readOldRuns(line);
  }

 private:
  /// The next bytes; they are passed over where `passes`.
  const std::uint8_t* take(std::size_t count, bool passes = true) {
    if (count > bytes_.size() - at_)
      throw Error("the Radiance HDR image ends at byte " + std::to_string(bytes_.size()) + ", before its last line");
    const auto* result = reinterpret_cast<const std::uint8_t*>(bytes_.data()) + at_;
    if (passes) at_ += count;
    return result;
  }
  [[noreturn]] void fail(const char* found) const {
    throw Error(std::string("found ") + found + " before byte " + std::to_string(at_) +
                " of a Radiance HDR image, expected as many pixels as the line has");
  }

  /// The four components one after another, each in runs.
  void readRuns(std::vector<Rgbe>& line) {
    take(4);
    for (std::size_t component = 0; component < 4; ++component)
      for (std::size_t x = 0; x < line.size();) {
        const std::uint8_t code = *take(1);
        const bool isRun = code > 128;
        const std::size_t count = isRun ? code - 128 : code;
        if (count == 0 || count > line.size() - x) fail("a run of the wrong length");
        const std::uint8_t* values = take(isRun ? 1 : count);
        for (std::size_t i = 0; i < count; ++i) line[x++][component] = values[isRun ? 0 : i];
      }
  }

  /// Pixels, and (1, 1, 1, n) to repeat the last one n times; a repetition right after another counts 256 times.
  void readOldRuns(std::vector<Rgbe>& line) {
    int shift = 0;
    for (std::size_t x = 0; x < line.size();) {
      const std::uint8_t* pixel = take(4);
      if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
        std::copy_n(pixel, 4, line[x++].begin());
        shift = 0;
        continue;
      }
      const std::size_t count = std::size_t(pixel[3]) << shift;
      if (x == 0 || shift > 16 || count > line.size() - x) fail("a run of the wrong length");
      for (std::size_t i = 0; i < count; ++i, ++x) line[x] = line[x - 1];
      shift += 8;
    }
  }

  std::span<const std::byte> bytes_;
  std::size_t at_;
};

}  // namespace

bool isHdr(std::span<const std::byte> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return text.starts_with("#?RADIANCE\n") || text.starts_with("#?RGBE\n") || text.starts_with("#?RADIANCE\r\n") ||
         text.starts_with("#?RGBE\r\n");
}

ImageFile decodeHdr(std::span<const std::byte> bytes) {
  HdrHeader header = readHeader(bytes);
  const auto [rows, columns] = axesOf(header.resolution);
  const int width = rows.isX ? rows.length : columns.length, height = rows.isX ? columns.length : rows.length;
  checkImageSize(width, height, bytes.size(), maxHdrPixelsPerByte);
  glm::dmat3 matrix(1);
  if (header.isXyz) {
    matrix = *toSrgbMatrix({{1, 0}, {0, 1}, {0, 0}});
    header.notes.push_back("X, Y, Z were converted to sRGB");
  } else if (header.primaries && !header.primaries->areSrgb()) {
    const auto found = toSrgbMatrix(*header.primaries);
    if (!found) throw Error("found PRIMARIES " + header.primaries->text() + ", expected three colours and a white");
    matrix = *found;
    header.notes.push_back("colours were converted to sRGB from the primaries " + header.primaries->text());
  }
  // The columns are the weights of the file's channels, which the program that wrote it has multiplied.
  const glm::dvec3 factor = header.exposure * header.correction;
  if (factor != glm::dvec3(1))
    header.notes.push_back("values were divided by EXPOSURE and COLORCORR: " + numberText(float(factor.x)) + ", " +
                           numberText(float(factor.y)) + ", " + numberText(float(factor.z)));
  for (int i = 0; i < 3; ++i) matrix[i] /= factor[i];

  ImageFile picture{.image = Image(width, height), .notes = std::move(header.notes), .layout = {}};
  std::array<double, 256> scales{};  // of each exponent; 0 stands for black
  for (int exponent = 1; exponent < 256; ++exponent)
    scales[std::size_t(exponent)] = std::ldexp(1.0, exponent - (128 + 8));
  HdrLines lines(bytes, header.end);
  std::vector<Rgbe> line(std::size_t(columns.length));
  for (int row = 0; row < rows.length; ++row) {
    lines.read(line);
    for (int column = 0; column < columns.length; ++column) {
      const Rgbe& pixel = line[std::size_t(column)];
      const int across = columns.at(column), down = rows.at(row);
      picture.image.at(rows.isX ? down : across, rows.isX ? across : down) =
          matrix * (scales[pixel[3]] * glm::dvec3(pixel[0], pixel[1], pixel[2]));
    }
  }
  return picture;
}

}  // namespace gonio::io
