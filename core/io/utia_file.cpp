// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/utia_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <string>

#include "core/io/exr_codec.h"
#include "core/io/format_mismatch.h"
#include "core/io/image_io.h"

namespace gonio::io {

namespace {

static_assert(std::endian::native == std::endian::little, "the formats are little-endian and are read as they lie");

constexpr std::size_t side = UtiaBrdf::directionCount;
constexpr std::uint64_t binBytes = 3 * side * side * sizeof(double);
/// Of a picture with 288 x 288 pixels; ten times what it has without compression.
constexpr std::uint64_t maxExrBytes = 1 << 24;
/// No BRDF value comes near it: bytes of another format, read as float64, mostly lie beyond.
constexpr double maxValue = 1e9;

const std::string expectedUtia =
    std::to_string(binBytes) + " bytes of float64 (3 planes of 288 x 288), or an EXR image of 288 x 288 pixels";

bool hasExrSignature(const ByteSource& source) {
  std::array<std::byte, 4> start{};
  if (source.size() < start.size()) return false;
  source.readAt(0, start);
  return isExr(start);
}

/// The first row of the red plane.
void expectValues(const ByteSource& source) {
  std::array<double, side> row{};
  source.readAt(0, std::as_writable_bytes(std::span(row)));
  if (std::ranges::any_of(row, [](double value) { return !(std::abs(value) <= maxValue); }))
    throw FormatMismatch(std::to_string(binBytes) + " bytes that are not BRDF values", expectedUtia);
}

Image readPicture(const ByteSource& source) {
  if (source.size() > maxExrBytes)
    throw FormatMismatch("an EXR image of " + std::to_string(source.size()) + " bytes", expectedUtia);
  try {
    Image image = readImage(source.readAll(maxExrBytes));
    if (image.width == int(side) && image.height == int(side)) return image;
    throw FormatMismatch(
        "an EXR image of " + std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels",
        expectedUtia);
  } catch (const FormatMismatch&) {
    throw;
  } catch (const Error& error) {
    throw FormatMismatch(std::string("an EXR image that cannot be read (") + error.what() + ")", expectedUtia);
  }
}

std::vector<glm::vec3> readPlanes(const ByteSource& source) {
  std::vector<double> raw(3 * side * side);
  source.readAt(0, std::as_writable_bytes(std::span(raw)));
  std::vector<glm::vec3> values(side * side);
  for (std::size_t i = 0; i < raw.size(); ++i) values[i % values.size()][int(i / values.size())] = float(raw[i]);
  return values;
}

}  // namespace

void expectUtia(const ByteSource& source) {
  if (hasExrSignature(source))
    readPicture(source);
  else if (source.size() != binBytes)
    throw FormatMismatch(std::to_string(source.size()) + " bytes", expectedUtia);
  else
    expectValues(source);
}

std::shared_ptr<const UtiaBrdf> readUtia(const ByteSource& source) {
  if (hasExrSignature(source)) return std::make_shared<const UtiaBrdf>(readPicture(source).pixels);
  if (source.size() != binBytes) throw FormatMismatch(std::to_string(source.size()) + " bytes", expectedUtia);
  return std::make_shared<const UtiaBrdf>(readPlanes(source));
}

std::vector<std::byte> encodeUtia(std::span<const glm::vec3> values) {
  assert(values.size() == side * side);
  std::vector<double> planes(3 * values.size());
  for (std::size_t i = 0; i < planes.size(); ++i) planes[i] = values[i % values.size()][int(i / values.size())];
  const auto bytes = std::as_bytes(std::span(planes));
  return {bytes.begin(), bytes.end()};
}

}  // namespace gonio::io
