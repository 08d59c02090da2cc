// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/tensor_writer.h"

#include <cassert>

#include "core/io/append_bytes.h"

namespace gonio::io {

namespace {

constexpr std::uint64_t alignment = 8;

std::uint64_t aligned(std::uint64_t offset) { return (offset + alignment - 1) / alignment * alignment; }

std::uint64_t directoryBytes(std::span<const TensorField> fields) {
  std::uint64_t bytes = tensorHeaderBytes;
  for (const TensorField& field : fields)
    bytes += sizeof(std::uint16_t) + field.name.size() + sizeof(std::uint16_t) + sizeof(std::uint8_t) +
             sizeof(std::uint64_t) * (1 + field.shape.size());
  return bytes;
}

}  // namespace

TensorField TensorField::floats(std::string name, std::vector<std::uint64_t> shape, std::span<const float> values) {
  const auto raw = std::as_bytes(values);
  return {std::move(name), TensorType::float32, std::move(shape), {raw.begin(), raw.end()}};
}

TensorField TensorField::text(std::string name, std::string_view text) {
  const auto raw = std::as_bytes(std::span(text));
  return {std::move(name), TensorType::uint8, {text.size()}, {raw.begin(), raw.end()}};
}

std::vector<std::byte> encodeTensorFile(std::span<const TensorField> fields) {
  std::vector<std::byte> bytes;
  append(bytes, tensorMagic);
  append(bytes, std::uint8_t(1));
  append(bytes, std::uint8_t(0));
  append(bytes, std::uint32_t(fields.size()));
  std::uint64_t offset = directoryBytes(fields);
  for (const TensorField& field : fields) {
    offset = aligned(offset);
    append(bytes, std::uint16_t(field.name.size()));
    append(bytes, std::string_view(field.name));
    append(bytes, std::uint16_t(field.shape.size()));
    append(bytes, std::uint8_t(field.type));
    append(bytes, offset);
    for (const std::uint64_t size : field.shape) append(bytes, size);
    offset += field.bytes.size();
  }
  assert(bytes.size() == directoryBytes(fields));
  for (const TensorField& field : fields) {
    bytes.resize(aligned(bytes.size()));
    bytes.insert(bytes.end(), field.bytes.begin(), field.bytes.end());
  }
  return bytes;
}

}  // namespace gonio::io
