// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/io/byte_source.h"
#include "core/io/scattered_samples.h"

/// One sample of the CUReT BRDF database (Dana, van Ginneken, Nayar and Koenderink 1999, "Reflectance and Texture of
/// Real-World Surfaces"): ASCII, 205 rows, one per measurement, each with polar angle and azimuth of both directions
/// and its values,
///
///     theta phi theta phi R G B or theta phi theta phi value
///
/// with light and viewer in either order, which are equivalent for a reciprocal material. Angles are radians if none
/// exceeds 2 pi, else degrees. The database itself has one file per channel with the values of all 61 samples
/// (rbrdf.dat, gbrdf.dat, bbrdf.dat: one row per sample, its number and 205 values), and the directions in another
/// table. No single file of it is a material; such files are rejected with an explanation of what to combine. Lines
/// that begin with # are comments.
namespace gonio::io {

/// @throws FormatMismatch unless the text consists of such rows for all 205 measurements.
void expectCuret(const ByteSource& source);

/// @throws FormatMismatch that names a line which is not a row of finite numbers.
ScatteredSamples readCuret(const ByteSource& source);

}  // namespace gonio::io
