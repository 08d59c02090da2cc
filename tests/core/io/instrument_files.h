// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <span>
#include <string>

#include "core/brdf/utia_brdf.h"
#include "core/io/image_io.h"
#include "tests/core/io/test_files.h"

/// Files of measuring instruments as tests write them: of closed forms, never of anybody's data.
namespace gonio::test {

using Reflectance = std::function<Rgb(const Direction& wi, const Direction& wo)>;

inline Bytes bytesOf(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

/// A direction of the UTIA grid, from 0 to 287.
inline Direction utiaDirection(std::size_t index) {
  return fromSpherical(double(index / UtiaBrdf::azimuthCount) * UtiaBrdf::polarStep,
                       double(index % UtiaBrdf::azimuthCount) * UtiaBrdf::azimuthStep);
}

/// [incident][viewing].
inline std::vector<Rgb> utiaValues(const Reflectance& reflectance) {
  std::vector<Rgb> values;
  for (std::size_t i = 0; i < UtiaBrdf::directionCount; ++i)
    for (std::size_t v = 0; v < UtiaBrdf::directionCount; ++v)
      values.push_back(reflectance(utiaDirection(i), utiaDirection(v)));
  return values;
}

/// A UTIA `.bin` file.
inline Bytes utiaFile(const std::vector<Rgb>& values) {
  Bytes bytes;
  bytes.reserve(values.size() * 24);
  for (int channel = 0; channel < 3; ++channel)
    for (const Rgb& value : values) append(bytes, value[channel]);
  return bytes;
}

/// A UTIA `.exr` file.
inline Bytes utiaPicture(const std::vector<Rgb>& values) {
  Image image(int(UtiaBrdf::directionCount), int(UtiaBrdf::directionCount));
  for (std::size_t i = 0; i < values.size(); ++i) image.pixels[i] = values[i];
  const auto path = outputPath("io/utia.exr");
  io::writeExr(image, path);
  return readFile(path);
}

}  // namespace gonio::test
