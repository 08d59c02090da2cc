// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "core/io/byte_source.h"

/// Files of many numbers under a short description: eight characters that name the format, uint32 version, uint32
/// length of the description, the description as JSON, then the numbers, little-endian. The frame of dictionaries and
/// of checkpoints.
namespace gonio::io {

struct DescribedNumbers {
  nlohmann::json description;
  std::vector<std::byte> numbers;
};

/// @param magic eight characters.
std::vector<std::byte> encodeDescribedNumbers(std::string_view magic, std::uint32_t version,
                                              const DescribedNumbers& content);
/// @param what for the errors: "dictionary".
/// @throws Error telling what was found and what was expected. Nothing is allocated that the source's size does not
/// bear out.
DescribedNumbers decodeDescribedNumbers(std::string_view magic, std::uint32_t version, std::string_view what,
                                        const ByteSource& source);

/// Whether a source begins with the magic.
bool beginsWith(const ByteSource& source, std::string_view magic);

}  // namespace gonio::io
