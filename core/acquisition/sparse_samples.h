// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/acquisition/sample_rows.h"

namespace gonio::acquisition {

/// Coefficients of few components, each channel by itself: chosen by orthogonal matching pursuit on the rows of D,
/// solved by least squares.
/// @param atoms that are chosen at most; 0: as many as predict each sample best from all others, 1 to half the samples.
/// @return components x channels. Cost: O(samples^3 components) with atoms 0.
Eigen::MatrixXd sparseCoefficients(const SampleRows& samples, int atoms);

}  // namespace gonio::acquisition
