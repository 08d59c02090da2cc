// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

#include "core/io/tensor_file.h"

namespace gonio::io {

/// One field of a tensor file to write.
struct TensorField {
  std::string name;
  TensorType type{};
  std::vector<std::uint64_t> shape;
  std::vector<std::byte> bytes;

  static TensorField floats(std::string name, std::vector<std::uint64_t> shape, std::span<const float> values);
  static TensorField text(std::string name, std::string_view text);
};

/// A tensor file of version 1.0 with the fields in this order, each aligned to 8 bytes.
std::vector<std::byte> encodeTensorFile(std::span<const TensorField> fields);

}  // namespace gonio::io
