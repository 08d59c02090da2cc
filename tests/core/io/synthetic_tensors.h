// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/io/tensor_file.h"
#include "core/math/types.h"
#include "tests/core/io/test_files.h"

namespace gonio::test {

/// A field of a tensor file that a test makes.
struct TensorField {
  std::string name;
  io::TensorType type;
  std::vector<std::uint64_t> shape;
  Bytes data;
};

inline TensorField floatField(const std::string& name, const std::vector<std::uint64_t>& shape,
                              const std::vector<float>& values) {
  TensorField field{name, io::TensorType::float32, shape, {}};
  for (const float value : values) append(field.data, value);
  return field;
}

inline TensorField byteField(const std::string& name, const std::string& text) {
  TensorField field{name, io::TensorType::uint8, {text.size()}, {}};
  for (const char c : text) field.data.push_back(std::byte(c));
  return field;
}

inline Bytes tensorFile(const std::vector<TensorField>& fields) {
  std::uint64_t offset = 18;
  for (const TensorField& field : fields) offset += 13 + field.name.size() + 8 * field.shape.size();
  Bytes bytes;
  for (const char c : std::string("tensor_file\0\1\0", 14)) bytes.push_back(std::byte(c));
  append(bytes, std::uint32_t(fields.size()));
  for (const TensorField& field : fields) {
    append(bytes, std::uint16_t(field.name.size()));
    for (const char c : field.name) bytes.push_back(std::byte(c));
    append(bytes, std::uint16_t(field.shape.size()));
    append(bytes, std::uint8_t(field.type));
    append(bytes, offset);
    for (const std::uint64_t size : field.shape) append(bytes, size);
    offset += field.data.size();
  }
  for (const TensorField& field : fields)
    for (const std::byte byte : field.data) bytes.push_back(byte);
  return bytes;
}

/// A small RGL material: 2 polar angles (0 and 90 degrees), vndf 3 x 3 and rgb 2 x 2 nodes, as given. `rgb` is
/// [phi][theta][channel][row][column].
struct SyntheticRgl {
  std::vector<float> phis{0};
  std::vector<float> thetas{0, float(halfPi)};
  std::vector<float> rgb = std::vector<float>(24, 1);
  std::vector<float> vndf = std::vector<float>(18, 1);
  float ndf = 2, sigma = 0.5f;
  char jacobian = 1;

  std::vector<TensorField> fields() const {
    const std::uint64_t p = phis.size(), t = thetas.size();
    return {byteField("description", "made by a test"),
            floatField("phi_i", {p}, phis),
            floatField("theta_i", {t}, thetas),
            floatField("sigma", {2, 2}, std::vector<float>(4, sigma)),
            floatField("ndf", {2, 2}, std::vector<float>(4, ndf)),
            floatField("vndf", {p, t, 3, 3}, vndf),
            floatField("rgb", {p, t, 3, 2, 2}, rgb),
            byteField("jacobian", std::string(1, jacobian))};
  }
  Bytes file() const { return tensorFile(fields()); }
};

}  // namespace gonio::test
