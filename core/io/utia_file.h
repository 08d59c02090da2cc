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
/// - `.exr`: an OpenEXR image of 288 x 288 pixels.
/// Rows are incident directions, columns viewing directions; the index of a direction is
///   (index of the polar angle) * 48 + index of the azimuth, in steps of 15 and 7.5 degrees.
/// Values are read as BRDF values in 1/sr, as the database's published code returns them.
/// The absolute scale is not documented beyond that; other readers rescale it (dj_brdf by Dupuy).
namespace gonio::io {

/// @throws FormatMismatch if the source neither has the size and plausible first values of a `.bin` file nor is an EXR
/// image of 288 x 288 pixels. EXR images of up to 16 MiB are read completely.
void expectUtia(const ByteSource& source);

/// @throws FormatMismatch; Error that names the first value that is not finite or beyond the range of float.
std::shared_ptr<const UtiaBrdf> readUtia(const ByteSource& source);

/// A `.bin` file. @param values as UtiaBrdf::values().
std::vector<std::byte> encodeUtia(std::span<const glm::vec3> values);

}  // namespace gonio::io
