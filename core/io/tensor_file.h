// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/byte_source.h"

namespace gonio::io {

/// The first bytes of a tensor file, before two bytes of the version and a uint32 number of fields.
inline constexpr std::string_view tensorMagic{"tensor_file\0", 12};
inline constexpr std::size_t tensorHeaderBytes = tensorMagic.size() + 2 + sizeof(std::uint32_t);

/// The type numbers of `tensor_file`.
enum class TensorType : std::uint8_t {
  uint8 = 1,
  int8,
  uint16,
  int16,
  uint32,
  int32,
  uint64,
  int64,
  float16,
  float32,
  float64
};

/// One named array of a tensor file: row-major, the last dimension fastest.
struct TensorView {
  TensorType type{};
  std::vector<std::uint64_t> shape;
  std::span<const std::byte> bytes;  ///< inside the TensorFile, which must outlive this object

  std::uint64_t count() const;
  /// The values of a float16 or float32 tensor, also if not finite; zeros for other types.
  std::vector<float> floats() const;
  /// Type and shape, e.g. "float32 1 x 8 x 128 x 128".
  std::string describe() const;
};

/// @throws FormatMismatch if the bytes do not begin like a tensor file of version 1.0.
void expectTensorFile(const ByteSource& source);

/// A container of named arrays, format `tensor_file` 1.0, little-endian (the EPFL RGL database uses it): the magic
/// "tensor_file\0", two version bytes, a uint32 count, then for each field a uint16 name length, the name, a uint16
/// number of dimensions, a type byte, a uint64 offset of the data and uint64 sizes.
class TensorFile {
 public:
  /// Reads the file into memory and checks its directory against the file's size. @throws FormatMismatch.
  explicit TensorFile(const ByteSource& source);

  /// All fields by name.
  const std::map<std::string, TensorView, std::less<>>& fields() const { return fields_; }
  bool contains(std::string_view name) const { return fields_.find(name) != fields_.end(); }
  /// The field of this name, type and number of dimensions. @throws FormatMismatch that states what the file has
  /// instead.
  const TensorView& field(std::string_view name, TensorType type, std::size_t dimensions) const;
  /// A field of type float32 or float16. @throws FormatMismatch as field().
  const TensorView& floatField(std::string_view name, std::size_t dimensions) const;
  /// The values of floatField(). @throws Error that names the first one that is not finite.
  std::vector<float> floats(std::string_view name, std::size_t dimensions) const;
  /// A uint8 field as text.
  std::string text(std::string_view name) const;

 private:
  std::vector<std::byte> bytes_;
  std::map<std::string, TensorView, std::less<>> fields_;
};

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
