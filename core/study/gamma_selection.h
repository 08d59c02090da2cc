// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/fitting/fit.h"
#include "core/rendering/render_picture.h"

namespace gonio::study {

struct GammaTrial {
  double gamma;
  fitting::FitResult fit;
  double renderedSnr;  ///< in comparisonScene(), dB
};

/// The two-stage fit of Bieron and Peers 2020, "An Adaptive BRDF Fitting Metric": fits the model by the gamma metric
/// for several gammas (1 to 3 in steps of 1/4) and selects the one with the best picture; here the highest rendered
/// SNR, the first among equals. Nine fits and pictures.
/// @param options metric and gamma are ignored.
/// @param base as for fitting::fit(); the reference picture is that of the measurement.
/// @return the best trial first, the others in the order of gamma. A stop request returns the completed trials,
/// possibly none; selectGamma() never throws Cancelled.
std::vector<GammaTrial> selectGamma(const fitting::FitBase& base, const models::Model& model,
                                    const fitting::FitOptions& options = {},
                                    const RenderOptions& picture = smallComparisonPicture(),
                                    const TaskControl& control = {});

}  // namespace gonio::study
