// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/io/byte_source.h"
#include "core/io/scattered_samples.h"

/// Text files in the manner of ASTM E1392 (Standard Practice for Angle Resolved Optical Scatter Measurements, 1996), as
/// the reflectance data of Cornell University's Program of Computer Graphics: lines of a key and its text, among them
/// NUM_POINTS, up to VARS with the names of the columns; then one line a point, values separated by commas.
///
///     NUM_POINTS 2
///     VARS theta_i,phi_i,theta_s,phi_s,R,G,B
///     0.5,0,0.5,3.14159,0.31,0.30,0.28
///
/// Angles: polar from the normal and azimuth, of the direction to the light (theta_i, phi_i; without phi_i it is 0) and
/// of the scattered light (theta_s, phi_s; also _r, _o, _v). Radians where none exceeds 2 pi, as at Cornell, else
/// degrees. Values: BRDF in 1/sr without the cosine, named R, G, B (taken as linear sRGB); X, Y, Z (white of D65 at
/// Y = 1); three or more wavelengths ("550nm", spectrumWeights()); or one other column, taken as grey.
namespace gonio::io {

/// @throws FormatMismatch where the lines NUM_POINTS and VARS are not found in the first 64 KiB of text.
void expectAstm(const ByteSource& source);

/// @throws FormatMismatch; Error naming the line: a column that is missing, a field that is not a finite number, or
/// another number of points than NUM_POINTS.
ScatteredSamples readAstm(const ByteSource& source);

}  // namespace gonio::io
