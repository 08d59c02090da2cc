// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/acquisition/sample_rows.h"
#include "core/support/task_control.h"

namespace gonio::acquisition {

/// Coefficients of few components, each channel by itself: chosen by orthogonal matching pursuit on the rows of D,
/// solved by least squares.
/// @param atoms that are chosen at most; 0: as many as predict each sample best from all others, 1 to half the samples.
/// @return components x channels. Cost: O(samples components) an atom and channel; with atoms 0 a pursuit of half the
/// samples for each sample and channel, O(samples^3 components). @throws Cancelled between two pursuits.
Eigen::MatrixXd sparseCoefficients(const SampleRows& samples, int atoms, const TaskControl& control = {});

}  // namespace gonio::acquisition
