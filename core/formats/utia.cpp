// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

#include "core/brdf/utia_brdf.h"
#include "core/formats/formats.h"
#include "core/io/byte_source.h"
#include "core/io/exr_codec.h"
#include "core/io/image_io.h"
#include "core/materials/encode.h"

/// Files of the UTIA BRDF database (Filip and Vávra 2014, "Template-Based Sampling of Anisotropic BRDFs"). Two layouts:
/// - `.bin`: little-endian float64 [3][288][288], the planes of red, green and blue, 1,990,656 bytes without a header;
/// - `.exr`: an OpenEXR image of 288 x 288 pixels.
/// Rows are incident directions, columns viewing directions; the index of a direction is
///   (index of the polar angle) * 48 + index of the azimuth, in steps of 15 and 7.5 degrees.
/// Values are read as BRDF values in 1/sr, as the database's published code returns them.
/// The absolute scale is not documented beyond that; other readers rescale it (dj_brdf by Dupuy).
namespace gonio::formats {

using materials::EditedMaterial, materials::Encoded, materials::EncodeOptions, materials::Material;

namespace {

static_assert(std::endian::native == std::endian::little, "the formats are little-endian and are read as they lie");

constexpr std::size_t side = UtiaBrdf::directionCount;
constexpr std::uint64_t binBytes = 3 * side * side * sizeof(double);
/// Maximum size of a picture with 288 x 288 pixels: ten times what it has without compression.
constexpr std::uint64_t maxExrBytes = 1 << 24;
/// No BRDF value comes near it: bytes of another format, read as float64, mostly lie beyond.
constexpr double maxValue = 1e9;

const std::string expectedUtia =
    std::to_string(binBytes) + " bytes of float64 (3 planes of 288 x 288), or an EXR image of 288 x 288 pixels";

bool hasExrSignature(const io::ByteSource& source) {
  std::array<std::byte, 4> start{};
  if (source.size() < start.size()) return false;
  source.readAt(0, start);
  return io::isExr(start);
}

/// The first row of the red plane.
void expectValues(const io::ByteSource& source) {
  std::array<double, side> row{};
  source.readAt(0, std::as_writable_bytes(std::span(row)));
  if (std::ranges::any_of(row, [](double value) { return !(std::abs(value) <= maxValue); }))
    throw io::FormatMismatch(std::to_string(binBytes) + " bytes that are not BRDF values", expectedUtia);
}

Image readPicture(const io::ByteSource& source) {
  if (source.size() > maxExrBytes)
    throw io::FormatMismatch("an EXR image of " + std::to_string(source.size()) + " bytes", expectedUtia);
  try {
    Image image = io::readImage(source.readAll(maxExrBytes));
    if (image.width == int(side) && image.height == int(side)) return image;
    throw io::FormatMismatch(
        "an EXR image of " + std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels",
        expectedUtia);
  } catch (const io::FormatMismatch&) {
    throw;
  } catch (const Error& error) {
    throw io::FormatMismatch(std::string("an EXR image that cannot be read (") + error.what() + ")", expectedUtia);
  }
}

std::vector<glm::vec3> readPlanes(const io::ByteSource& source) {
  if (source.size() != binBytes) throw io::FormatMismatch(std::to_string(source.size()) + " bytes", expectedUtia);
  std::vector<double> raw(3 * side * side);
  source.readAt(0, std::as_writable_bytes(std::span(raw)));
  std::vector<glm::vec3> values(side * side);
  for (std::size_t i = 0; i < raw.size(); ++i) values[i % values.size()][int(i / values.size())] = float(raw[i]);
  return values;
}

/// @throws io::FormatMismatch if the source neither has the size and plausible first values of a `.bin` file nor is an
/// EXR image of 288 x 288 pixels. EXR images of up to 16 MiB are read completely.
void sniffUtia(const io::ByteSource& source) {
  if (hasExrSignature(source))
    readPicture(source);
  else if (source.size() != binBytes)
    throw io::FormatMismatch(std::to_string(source.size()) + " bytes", expectedUtia);
  else
    expectValues(source);
}

void readUtia(const io::ByteSource& source, const TaskControl& control, Material& material) {
  control.throwIfStopped();
  const auto utia = std::make_shared<const UtiaBrdf>(hasExrSignature(source) ? std::move(readPicture(source).pixels)
                                                                             : readPlanes(source));
  material.brdf = utia;
  material.source.grid = {int(UtiaBrdf::polarCount), int(UtiaBrdf::azimuthCount), int(UtiaBrdf::polarCount),
                          int(UtiaBrdf::azimuthCount)};
  material.source.notes.push_back(
      "measured up to 75 degrees from the normal; beyond that, the value at 75 degrees is used");
  if (utia->clampedCount() > 0)
    material.source.notes.push_back(std::to_string(utia->clampedCount()) + " negative values were set to 0");
}

/// The values at the nodes of UTIA files. Those of a UTIA file change by the difference that the edits make there.
std::vector<glm::vec3> utiaValues(const EditedMaterial& material, const TaskControl& control) {
  const auto* file = formOf<UtiaBrdf>(*material.base.brdf);
  const auto own = file ? file->withIncident(IncidentDirection::viewer) : nullptr;
  std::vector<glm::vec3> values(side * side);
  std::vector<Rgb> before(side, Rgb(0)), after(side);
  for (std::size_t incident = 0; incident < side; ++incident) {
    control.throwIfStopped();
    const std::vector<DirectionPair> pairs = UtiaBrdf::nodes(incident);
    material.shown.brdf->evaluate(pairs, after);
    if (own) own->evaluate(pairs, before);
    for (std::size_t i = 0; i < side; ++i) {
      const std::size_t node = incident * side + i;
      const Rgb start = own ? Rgb((*file->values())[node]) : Rgb(0);
      values[node] = glm::vec3(before[i] == after[i] ? start : start + after[i] - before[i]);
    }
    control.report(double(incident) / side);
  }
  return values;
}

std::vector<std::byte> binFile(std::span<const glm::vec3> values) {
  std::vector<double> planes(3 * values.size());
  for (std::size_t i = 0; i < planes.size(); ++i) planes[i] = values[i % values.size()][int(i / values.size())];
  const auto bytes = std::as_bytes(std::span(planes));
  return {bytes.begin(), bytes.end()};
}

/// A `.bin` file. Of a UTIA file, the change of the edits is added to the values at its nodes.
Encoded encodeUtia(const EditedMaterial& material, const EncodeOptions&, const TaskControl& control) {
  if (auto copy = copyOfFile(material, utiaFormat)) return std::move(*copy);
  std::vector<glm::vec3> values = utiaValues(material, control);
  Encoded made;
  std::size_t clipped = 0;
  for (glm::vec3& value : values) {
    clipped += std::size_t((value.x < 0) + (value.y < 0) + (value.z < 0));
    value = glm::max(value, glm::vec3(0));
  }
  made.bytes = binFile(values);
  if (!formOf<UtiaBrdf>(*material.base.brdf))
    made.losses.push_back("the values were sampled at 288 x 288 directions, every 15 by 7.5 degrees");
  if (clipped > 0) made.losses.push_back(std::to_string(clipped) + " negative values were set to 0");
  made.readBack = std::make_shared<const UtiaBrdf>(std::move(values));
  return made;
}

constexpr std::string_view utiaSuffixes[] = {".bin", ".exr"};

}  // namespace

constinit const MaterialFormat utiaFormat{
    .name = "UTIA",
    .label = "UTIA file",
    .suffixes = utiaSuffixes,
    .isSuffixAmbiguous = true,
    .isMeasurement = true,
    .holds = {.nonReciprocal = true, .anisotropic = true},
    .sniff = sniffUtia,
    .read = readUtia,
    .encode = encodeUtia,
    .isOwnForm = [](const Brdf& brdf) { return formOf<UtiaBrdf>(brdf) != nullptr; }};

}  // namespace gonio::formats
