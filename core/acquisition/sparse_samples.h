// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/acquisition/sample_rows.h"
#include "core/support/task_control.h"

namespace gonio::acquisition {

/// Coefficients of a few components, per channel: orthogonal matching pursuit on the rows of D chooses the components,
/// least squares determines the coefficients.
/// @param atoms maximum number of components per channel; 0: the number, from 1 to half the samples, that predicts each
/// sample best from all others. @return components x channels. Cost: O(samples components) per atom and channel; with
/// atoms = 0 a pursuit of half the samples for each sample and channel, O(samples^3 components). @throws Cancelled
/// between two pursuits.
Eigen::MatrixXd sparseCoefficients(const SampleRows& samples, int atoms, const TaskControl& control = {});

}  // namespace gonio::acquisition
