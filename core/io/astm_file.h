// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/io/byte_source.h"
#include "core/io/scattered_samples.h"

/// Text files similar to ASTM E1392 (Standard Practice for Angle Resolved Optical Scatter Measurements, 1996), such as
/// the reflectance data of Cornell University's Program of Computer Graphics: lines with a key and text, among them
/// NUM_POINTS, up to VARS with the names of the columns; then one line per point, values separated by commas.
///
///     NUM_POINTS 2
///     VARS theta_i,phi_i,theta_s,phi_s,R,G,B
///     0.5,0,0.5,3.14159,0.31,0.30,0.28
///
/// Angles: polar angle from the normal and azimuth, of the direction to the light (theta_i, phi_i; phi_i is 0 if
/// missing) and of the scattered light (theta_s, phi_s; also _r, _o, _v). They are radians if none exceeds 2 pi, as at
/// Cornell, else degrees. Values: BRDF in 1/sr, without the cosine: R, G, B (linear sRGB); X, Y, Z (D65 white at Y =
/// 1); three or more wavelengths ("550nm", spectrumWeights()); or one other column, read as grey.
namespace gonio::io {

/// @throws FormatMismatch if the lines NUM_POINTS and VARS are not in the first 64 KiB of text.
void expectAstm(const ByteSource& source);

/// @throws FormatMismatch; Error that names the line, for a missing column, a field that is not a finite number, or a
/// number of points other than NUM_POINTS.
ScatteredSamples readAstm(const ByteSource& source);

}  // namespace gonio::io
