// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/container.h"

#include <array>
#include <bit>
#include <cassert>
#include <nlohmann/json.hpp>

#include "core/io/byte_source.h"
#include "core/io/json_text.h"

namespace gonio::io {

namespace {

static_assert(std::endian::native == std::endian::little, "the formats are little-endian and are read as they lie");

constexpr std::size_t signatureBytes = 8;
constexpr std::uint32_t maxDescription = 1 << 20;

std::vector<std::byte> readWhole(const ByteSource& source, const ContainerFormat& format) {
  expectSignature(source, format);
  return source.readAll(format.maxBytes);
}

}  // namespace

bool hasSignature(const ByteSource& source, const ContainerFormat& format) {
  std::array<std::byte, signatureBytes> start;
  if (source.size() < start.size()) return false;
  source.readAt(0, start);
  return std::memcmp(start.data(), format.signature.data(), start.size()) == 0;
}

void expectSignature(const ByteSource& source, const ContainerFormat& format) {
  if (!hasSignature(source, format))
    throw FormatMismatch("not a " + std::string(format.name) + " file (signature missing)");
}

ContainerWriter::ContainerWriter(const ContainerFormat& format) {
  assert(format.signature.size() == signatureBytes);
  append(std::as_bytes(std::span(format.signature)));
  append(std::as_bytes(std::span(&format.version, 1)).first(format.versionBytes));
}

void ContainerWriter::description(const nlohmann::json& json) {
  // Names of files, unlike JSON, may contain bytes that are not UTF-8.
  const std::string text = jsonText(json);
  number(std::uint32_t(text.size()));
  append(std::as_bytes(std::span(text)));
}

ContainerReader::ContainerReader(const ContainerFormat& format, const ByteSource& source)
    : name_(format.name), bytes_(readWhole(source, format)), left_(std::span(bytes_).subspan(signatureBytes)) {
  std::memcpy(&version_, take(format.versionBytes).data(), format.versionBytes);
  const std::uint32_t oldest = format.readVersion > 0 ? format.readVersion : format.version;
  if (version_ < oldest || version_ > format.version)
    fail("the version is " + std::to_string(version_) + ", expected " +
         (oldest < format.version ? std::to_string(oldest) + " to " : "") + std::to_string(format.version));
}

nlohmann::json ContainerReader::description() {
  const auto length = number<std::uint32_t>();
  if (length > maxDescription || length > left_.size())
    fail("the description has " + std::to_string(length) + " bytes, expected at most " +
         std::to_string(std::min<std::size_t>(maxDescription, left_.size())));
  const auto bytes = take(length);
  try {
    return parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  } catch (const Error& error) {
    fail(std::string("in the description ") + error.what());
  }
}

void ContainerReader::expectRemaining(std::uint64_t bytes) const {
  if (left_.size() != bytes)
    fail("the size of the file is " + std::to_string(bytes_.size()) + " bytes, expected " +
         std::to_string(bytes_.size() - left_.size() + bytes) + " according to its description");
}

void ContainerReader::fail(const std::string& fault) const { throw Error(name_ + " file: " + fault); }

std::span<const std::byte> ContainerReader::take(std::size_t bytes) {
  expectAtLeast(bytes);
  const auto taken = left_.first(bytes);
  left_ = left_.subspan(bytes);
  return taken;
}

void ContainerReader::expectAtLeast(std::size_t bytes) const {
  if (left_.size() < bytes)
    fail("the file ends at byte " + std::to_string(bytes_.size()) + ", expected " +
         std::to_string(bytes - left_.size()) + " more");
}

void ContainerReader::failNotFinite(std::string_view what, std::size_t index) const {
  fail("found a " + std::string(what) + " that is not finite (number " + std::to_string(index) + ")");
}

}  // namespace gonio::io
