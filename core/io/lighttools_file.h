// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/io/byte_source.h"
#include "core/io/scatter_table_text.h"

/// BSDF text files of LightTools (Synopsys), `.bsdf`, in the layout that libbsdf (Kimura 2015) reads:
///
///     Symmetry Asymmetric
///     SpectralContent Monochrome
///     ScatterAzimuth 4
///     0 90 180 270
///     ScatterRadial 3
///     0 30 60
///     DataBegin
///     AOI 10
///     POI 0
///     Side Front
///     Wavelength 550
///     ScatterType BRDF
///     TIS 0.5
///     ..
///     DataEnd
///
/// Angles in degrees. Unlike in Zemax files, the scattered direction is given about the normal: ScatterRadial is its
/// polar angle, ScatterAzimuth its azimuth; the light is at the azimuth POI + 90 degrees. With the symmetry
/// PlaneSymmetrical one side of the plane of incidence is sufficient. There is a block per angle of incidence (AOI; at
/// most 90 degrees), with one row per azimuth and one column per polar angle: BRDF in 1/sr, without the cosine. With
/// SpectralContent XYZ a block states its TristimulusValue TrisX, TrisY or TrisZ. Blocks of the back and of
/// transmission are ignored; several wavelengths are averaged. Lines that begin with # are comments.
namespace gonio::io {

/// @throws FormatMismatch if the keys ScatterRadial and AOI are not in the first 64 KiB of text.
void expectLightTools(const ByteSource& source);

/// @throws FormatMismatch for a file without reflection of the front, or with several planes of incidence
/// (anisotropic); Error that names the line.
IncidenceFile readLightTools(const ByteSource& source);

}  // namespace gonio::io
