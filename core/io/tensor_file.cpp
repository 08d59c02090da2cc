// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/tensor_file.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "core/io/byte_source.h"

namespace gonio::io {

namespace {

constexpr std::uint64_t maxFileBytes = std::uint64_t(1) << 31;
constexpr std::size_t typeBytes[] = {0, 1, 1, 2, 2, 4, 4, 8, 8, 2, 4, 8};
constexpr const char* typeNames[] = {"",      "uint8",  "int8",  "uint16",  "int16",   "uint32",
                                     "int32", "uint64", "int64", "float16", "float32", "float64"};

/// Reads numbers one after another and never beyond the end.
class TensorCursor {
 public:
  explicit TensorCursor(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::span<const std::byte> take(std::uint64_t count, const char* what) {
    if (count > bytes_.size() - position_)
      throw FormatMismatch("a field table that ends at byte " + std::to_string(position_), what);
    const auto taken = bytes_.subspan(position_, count);
    position_ += count;
    return taken;
  }
  template <typename T>
  T number(const char* what) {
    T value;
    std::memcpy(&value, take(sizeof(T), what).data(), sizeof(T));
    return value;
  }

 private:
  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
};

/// Bytes of a tensor, or more than `limit` where they would not fit.
std::uint64_t boundedBytes(const TensorView& tensor, std::uint64_t limit) {
  if (std::ranges::count(tensor.shape, 0u) > 0) return 0;
  std::uint64_t bytes = typeBytes[std::size_t(tensor.type)];
  for (const std::uint64_t size : tensor.shape) {
    if (size > limit / bytes) return limit + 1;
    bytes *= size;
  }
  return bytes;
}

std::vector<std::byte> readTensorFile(const ByteSource& source) {
  expectTensorFile(source);
  if (source.size() > maxFileBytes)
    throw FormatMismatch(std::to_string(source.size()) + " bytes", "at most " + std::to_string(maxFileBytes));
  return source.readAll();
}

TensorView readField(TensorCursor& cursor, std::span<const std::byte> file, const std::string& name) {
  TensorView tensor;
  const auto dimensions = cursor.number<std::uint16_t>("a number of dimensions");
  const auto type = cursor.number<std::uint8_t>("a type");
  if (type == 0 || type >= std::size(typeBytes))
    throw FormatMismatch("field '" + name + "' of type " + std::to_string(type), "a type from 1 to 11");
  tensor.type = TensorType(type);
  const auto offset = cursor.number<std::uint64_t>("an offset");
  const auto sizes = cursor.take(std::uint64_t(dimensions) * sizeof(std::uint64_t), "the sizes of a field");
  tensor.shape.resize(dimensions);
  if (dimensions > 0) std::memcpy(tensor.shape.data(), sizes.data(), sizes.size());
  const std::uint64_t left = offset > file.size() ? 0 : file.size() - offset;
  const std::uint64_t bytes = boundedBytes(tensor, file.size());
  if (offset > file.size() || bytes > left)
    throw FormatMismatch("field '" + name + "' (" + tensor.describe() + ") at byte " + std::to_string(offset) +
                             " of a file of " + std::to_string(file.size()),
                         "data inside the file");
  tensor.bytes = file.subspan(offset, bytes);
  return tensor;
}

}  // namespace

void expectTensorFile(const ByteSource& source) {
  std::byte start[tensorHeaderBytes];
  if (source.size() < tensorHeaderBytes)
    throw FormatMismatch(std::to_string(source.size()) + " bytes", "the signature 'tensor_file' and a table of fields");
  source.readAt(0, start);
  if (std::memcmp(start, tensorMagic.data(), tensorMagic.size()) != 0)
    throw FormatMismatch("no signature at the start", "the signature 'tensor_file'");
  if (start[tensorMagic.size()] != std::byte{1} || start[tensorMagic.size() + 1] != std::byte{0})
    throw FormatMismatch("tensor_file version " + std::to_string(int(start[tensorMagic.size()])) + "." +
                             std::to_string(int(start[tensorMagic.size() + 1])),
                         "version 1.0");
}

std::uint64_t TensorView::count() const { return bytes.size() / typeBytes[std::size_t(type)]; }

std::vector<float> TensorView::floats() const {
  std::vector<float> values(count());
  if (type == TensorType::float32 && !values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  if (type == TensorType::float16)
    for (std::size_t i = 0; i < values.size(); ++i) {
      std::uint16_t half;
      std::memcpy(&half, bytes.data() + i * sizeof half, sizeof half);
      values[i] = glm::unpackHalf1x16(half);
    }
  return values;
}

std::string TensorView::describe() const {
  std::string text = typeNames[std::size_t(type)];
  for (std::size_t i = 0; i < shape.size(); ++i) text += (i == 0 ? " " : " x ") + std::to_string(shape[i]);
  return text;
}

TensorFile::TensorFile(const ByteSource& source) : bytes_(readTensorFile(source)) {
  TensorCursor cursor(bytes_);
  cursor.take(tensorMagic.size() + 2, "a signature");
  const auto count = cursor.number<std::uint32_t>("a number of fields");
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto nameBytes = cursor.take(cursor.number<std::uint16_t>("the length of a name"), "the name of a field");
    const std::string name(reinterpret_cast<const char*>(nameBytes.data()), nameBytes.size());
    if (!fields_.emplace(name, readField(cursor, bytes_, name)).second)
      throw FormatMismatch("two fields '" + name + "'", "each name once");
  }
}

const TensorView& TensorFile::field(std::string_view name, TensorType type, std::size_t dimensions) const {
  const std::string expected = "a field '" + std::string(name) + "' of type " + typeNames[std::size_t(type)] +
                               " with " + std::to_string(dimensions) + " dimensions";
  const auto found = fields_.find(name);
  if (found == fields_.end()) {
    std::string names;
    for (const auto& [other, tensor] : fields_) names += (names.empty() ? "" : ", ") + other;
    throw FormatMismatch("the fields " + names, expected);
  }
  if (found->second.type != type || found->second.shape.size() != dimensions)
    throw FormatMismatch("'" + std::string(name) + "' " + found->second.describe(), expected);
  return found->second;
}

std::vector<float> TensorFile::floats(std::string_view name, std::size_t dimensions) const {
  const TensorView& tensor = floatField(name, dimensions);
  const std::vector<float> values = tensor.floats();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw Error("value " + std::to_string(i) + " of '" + std::string(name) + "' (" + tensor.describe() + ") is " +
                  std::to_string(values[i]) + ", expected a finite number");
  return values;
}

const TensorView& TensorFile::floatField(std::string_view name, std::size_t dimensions) const {
  const auto found = fields_.find(name);
  const bool isHalf = found != fields_.end() && found->second.type == TensorType::float16;
  return field(name, isHalf ? TensorType::float16 : TensorType::float32, dimensions);
}

std::string TensorFile::text(std::string_view name) const {
  const TensorView& tensor = field(name, TensorType::uint8, 1);
  return {reinterpret_cast<const char*>(tensor.bytes.data()), tensor.bytes.size()};
}

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
