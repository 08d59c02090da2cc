// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/brdf/utia_brdf.h"
#include "core/io/byte_source.h"

/// Files of the UTIA BRDF database (Filip and Vávra 2014, "Template-Based Sampling of Anisotropic BRDFs"). Two layouts:
/// - `.bin`: little-endian float64 [3][288][288], the planes of red, green and blue, 1,990,656 bytes without a header;
/// - `.exr`: an OpenEXR picture of 288 x 288 pixels.
/// A row is an incident direction, a column a viewing direction, each polar angle index * 48 + azimuth index; 15 and
/// 7.5 degrees per step. Values are taken as BRDF values in 1/sr, as the code that the database publishes returns them.
/// The absolute scale of the database is not documented beyond that: other readers rescale it (dj_brdf by Dupuy).
namespace gonio::io {

/// @throws FormatMismatch where neither the size and first values of a `.bin` file nor an EXR picture of 288 x 288
/// pixels are found. Reads an EXR picture whole, if it has at most 16 MiB.
void expectUtia(const ByteSource& source);

/// @throws FormatMismatch; Error naming the first value that is not finite or beyond the range of float.
std::shared_ptr<const UtiaBrdf> readUtia(const ByteSource& source);

/// The bytes of a `.bin` file. @param values as UtiaBrdf::values().
std::vector<std::byte> encodeUtia(std::span<const glm::vec3> values);

}  // namespace gonio::io
