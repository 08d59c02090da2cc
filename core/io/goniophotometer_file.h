// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/io/byte_source.h"
#include "core/io/scattered_samples.h"

/// Text files of the pgII goniophotometer of pab (Apian-Bennewitz 2010, "New scanning gonio-photometer for extended
/// BRTF measurements"), also written by mgpp and read by Tekari: a header of lines that begin with #, then rows of
/// theta, phi (degrees) and values; one incident direction per file.
///
///     #sample_name "felt"
///     #format: theta phi BSDF
///     #intheta 30
///     #inphi 180
///     10.5 0 0.31
///
/// Keys that are read: `intheta` and `inphi`, or `incident_angle` with both; `format:` with the quantity, BSDF or BRDF
/// in 1/sr, or DSF, the BSDF times the cosine of the row's theta (the reader divides it by this cosine); `colorimetry:`
/// (for three values per row: CIE-XYZ, otherwise they are read as linear sRGB; one value is grey); `sample_name`. Keys
/// may have a colon. Directions point away from the surface; theta is the polar angle from its normal. A theta above 90
/// degrees is on the other side: rows on the side opposite to the light are transmission and are ignored.
namespace gonio::io {

/// @throws FormatMismatch if the first line does not begin with #, or format and incident direction are not in the
/// header's first 64 KiB.
void expectGoniophotometer(const ByteSource& source);

/// @throws FormatMismatch if `format:` has a quantity other than BSDF, BRDF or DSF, such as BTDF; Error that names the
/// line, for an incident direction at 90 degrees, angles or values
/// that are not finite numbers and rows of different length; Error if there is no row of reflection.
ScatteredSamples readGoniophotometer(const ByteSource& source);

}  // namespace gonio::io
