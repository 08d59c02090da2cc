// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/io/tensor_file.h"
#include "core/math/types.h"

/// What the loaders of pbrt-v4 (BRDF::MeasuredBxDFData::Create), Mitsuba 3 (measured.cpp) and powitacq ask of an RGL
/// file, as far as our own reader does not.
namespace gonio::test {

using Shape = std::vector<std::uint64_t>;

inline bool ascending(const std::vector<float>& values) {
  return std::ranges::adjacent_find(values, std::greater_equal{}) == values.end();
}

/// Whether the data of each field lie at a multiple of 8, from the directory's own bytes.
inline bool isAligned(std::span<const std::byte> bytes) {
  std::size_t at = io::tensorHeaderBytes;
  const auto number = [&](auto value) {
    std::memcpy(&value, &bytes[at], sizeof value);
    at += sizeof value;
    return value;
  };
  std::uint32_t count = 0;
  std::memcpy(&count, &bytes[at - sizeof count], sizeof count);
  for (std::uint32_t field = 0; field < count; ++field) {
    at += number(std::uint16_t());
    const auto dimensions = number(std::uint16_t());
    at += sizeof(std::uint8_t);
    if (number(std::uint64_t()) % 8 != 0) return false;
    at += dimensions * sizeof(std::uint64_t);
  }
  return true;
}

/// The first rule that a file breaks; empty where it keeps all.
inline QString brokenRule(std::span<const std::byte> bytes, bool spectral) {
  const io::TensorFile file{io::MemorySource(bytes)};
  if (!isAligned(bytes)) return "alignment";
  if (file.text("description").empty()) return "description";
  if (file.field("jacobian", io::TensorType::uint8, 1).count() != 1) return "jacobian";
  const auto phis = file.floats("phi_i", 1), thetas = file.floats("theta_i", 1);
  if (!ascending(phis) || !ascending(thetas)) return "ascending angles";
  if (phis.size() > 2 && (phis.front() > -float(pi) || phis.back() < float(pi))) return "both ends of the azimuth";
  for (const char* name : {"ndf", "sigma"}) {
    const Shape& shape = file.field(name, io::TensorType::float32, 2).shape;
    if (shape[0] < 2) return QString(name) + ": two rows";
    const auto values = file.floats(name, 2);
    if (!std::ranges::all_of(values, [](float v) { return v > 0; })) return QString(name) + ": positive";
  }
  const std::uint64_t p = phis.size(), t = thetas.size();
  const Shape vndf = file.field("vndf", io::TensorType::float32, 4).shape;
  const Shape luminance = file.field("luminance", io::TensorType::float32, 4).shape;
  if (vndf[0] != p || vndf[1] != t) return "vndf: shape";
  if (luminance[0] != p || luminance[1] != t || luminance[2] != luminance[3]) return "luminance: shape";
  for (const char* name : {"vndf", "luminance"}) {
    const auto values = file.floats(name, 4);
    const std::size_t slice = values.size() / (p * t);
    for (std::size_t start = 0; start < values.size(); start += slice) {
      const std::span one(&values[start], slice);
      if (std::ranges::min(one) < 0 || !(std::ranges::max(one) > 0)) return QString(name) + ": a density";
    }
  }
  const std::uint64_t planes = spectral ? file.floats("wavelengths", 1).size() : 3;
  if (spectral && !ascending(file.floats("wavelengths", 1))) return "ascending wavelengths";
  if (!spectral && file.contains("wavelengths")) return "Mitsuba's RGB variants refuse wavelengths";
  const char* colours = spectral ? "spectra" : "rgb";
  if (file.field(colours, io::TensorType::float32, 5).shape != Shape{p, t, planes, luminance[2], luminance[3]})
    return "colours: shape";
  file.floats(colours, 5);
  return {};
}

}  // namespace gonio::test
