// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/described_numbers.h"

#include <cassert>
#include <cstring>
#include <string>

#include "core/support/error.h"

namespace gonio::io {

namespace {

constexpr std::size_t headerBytes = 8 + 2 * sizeof(std::uint32_t);
constexpr std::uint32_t mostDescription = 1 << 20;

[[noreturn]] void fail(std::string_view what, const std::string& fault) {
  throw Error(std::string(what) + ": " + fault);
}

}  // namespace

bool beginsWith(const ByteSource& source, std::string_view magic) {
  std::vector<std::byte> start(magic.size());
  if (source.size() < start.size()) return false;
  source.readAt(0, start);
  return std::memcmp(start.data(), magic.data(), magic.size()) == 0;
}

std::vector<std::byte> encodeDescribedNumbers(std::string_view magic, std::uint32_t version,
                                              const DescribedNumbers& content) {
  assert(magic.size() == 8);
  const std::string text = content.description.dump();
  const std::uint32_t header[] = {version, std::uint32_t(text.size())};
  std::vector<std::byte> bytes(headerBytes + text.size() + content.numbers.size());
  std::memcpy(bytes.data(), magic.data(), 8);
  std::memcpy(bytes.data() + 8, header, sizeof header);
  std::memcpy(bytes.data() + headerBytes, text.data(), text.size());
  if (!content.numbers.empty())
    std::memcpy(bytes.data() + headerBytes + text.size(), content.numbers.data(), content.numbers.size());
  return bytes;
}

DescribedNumbers decodeDescribedNumbers(std::string_view magic, std::uint32_t version, std::string_view what,
                                        const ByteSource& source) {
  if (!beginsWith(source, magic)) fail(what, "the file does not begin with " + std::string(magic));
  if (source.size() < headerBytes) fail(what, "the file ends within its header");
  std::byte start[headerBytes];
  source.readAt(0, start);
  std::uint32_t header[2];
  std::memcpy(header, start + 8, sizeof header);
  if (header[0] != version)
    fail(what, "the version is " + std::to_string(header[0]) + ", expected " + std::to_string(version));
  if (header[1] > mostDescription || headerBytes + header[1] > source.size())
    fail(what,
         "the description has " + std::to_string(header[1]) + " bytes, the file " + std::to_string(source.size()));
  std::string text(header[1], '\0');
  source.readAt(headerBytes, std::as_writable_bytes(std::span(text)));
  DescribedNumbers content;
  content.description = nlohmann::json::parse(text, nullptr, false);
  if (content.description.is_discarded()) fail(what, "the description is no JSON");
  content.numbers.resize(std::size_t(source.size()) - headerBytes - header[1]);
  source.readAt(headerBytes + header[1], content.numbers);
  return content;
}

}  // namespace gonio::io
