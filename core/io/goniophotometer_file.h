// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/io/byte_source.h"
#include "core/io/scattered_samples.h"

/// Text files of the pgII goniophotometer of pab (Apian-Bennewitz 2010, "New scanning gonio-photometer for extended
/// BRTF measurements"), also written by mgpp and read by Tekari: a header of lines that begin with #, then rows of
/// theta, phi and values in degrees; one incident direction a file.
///
///     #sample_name "felt"
///     #format: theta phi BSDF
///     #intheta 30
///     #inphi 180
///     10.5 0 0.31
///
/// Keys that are read: `intheta` and `inphi`, or `incident_angle` with both; `format:` with the quantity, BSDF or BRDF
/// in 1/sr, or DSF, which is BSDF times the cosine of the row's theta and is divided by it; `colorimetry:` (of three
/// values per row, CIE-XYZ, else taken as linear sRGB; of one, grey); `sample_name`. Keys may have a colon. Directions
/// point away from the surface, theta from its normal. A theta above 90 degrees lies on the other side: rows on another
/// side than the light are transmission and are left out.
namespace gonio::io {

/// @throws FormatMismatch where the first line is no # line, or the format and the incident direction are not in the
/// header, its first 64 KiB.
void expectGoniophotometer(const ByteSource& source);

/// @throws FormatMismatch where the file holds transmission (BTDF); Error naming the line: angles or values that are
/// not finite numbers, rows of other lengths; or where there is no row of reflection.
ScatteredSamples readGoniophotometer(const ByteSource& source);

}  // namespace gonio::io
