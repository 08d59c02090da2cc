// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/io/byte_source.h"
#include "core/io/scatter_table_text.h"

/// Tabular BSDF files of Zemax OpticStudio (Rykowski 2008, "BSDF Data Interchange File Format Specification"), `.bsdf`:
///
///     Source Measured
///     Symmetry PlaneSymmetrical
///     SpectralContent Monochrome
///     ScatterType BRDF
///     SampleRotation 1
///     0
///     AngleOfIncidence 2
///     0 30
///     ScatterAzimuth 3
///     0 90 180
///     ScatterRadial 2
///     0 10
///     Monochrome
///     DataBegin
///     TIS 0.5
///     ..
///     DataEnd
///
/// Angles in degrees. The scattered direction is relative to the mirror direction: radial angle from it, azimuth
/// counter-clockwise with 0 toward the normal. There is a block per sample rotation and angle of incidence: the total
/// integrated scatter (not used), then one row per azimuth and one column per radial angle, BRDF in 1/sr, without the
/// cosine. With SpectralContent XYZ the blocks TristimulusX, TristimulusY and TristimulusZ follow one another, with D65
/// white at Y = 1. Sample rotations are averaged: the BRDF is isotropic. Lines that begin with # are comments.
namespace gonio::io {

/// @throws FormatMismatch if the keys AngleOfIncidence and ScatterRadial are not in the first 64 KiB of text.
void expectZemax(const ByteSource& source);

/// @throws FormatMismatch for a file of transmission (BTDF); Error that names the line.
IncidenceFile readZemax(const ByteSource& source);

}  // namespace gonio::io
