// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/io/byte_source.h"
#include "core/io/scattered_samples.h"

/// One sample of the CUReT BRDF database (Dana, van Ginneken, Nayar and Koenderink 1999, "Reflectance and Texture of
/// Real-World Surfaces"): ASCII, 205 rows, one a measurement, each with two polar angles and azimuths and its values,
///
///     theta phi theta phi R G B        or        theta phi theta phi value
///
/// in either order of light and viewer, which is one to a reciprocal material; in radians where no angle exceeds 2 pi,
/// else in degrees. The database itself has the values of all 61 samples in one file a channel (rbrdf.dat, gbrdf.dat,
/// bbrdf.dat: a row per sample, its number and 205 values) and the directions in a table of their own. No one file is a
/// material there; such a file is refused with an explanation of what to join. Lines that begin with # are comments.
namespace gonio::io {

/// @throws FormatMismatch unless the text is such rows, of all 205 measurements.
void expectCuret(const ByteSource& source);

/// @throws FormatMismatch naming the line that is no row of finite numbers.
ScatteredSamples readCuret(const ByteSource& source);

}  // namespace gonio::io
