// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/fitting/fit.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/rendered_comparison.h"

namespace gonio::study {

struct GammaTrial {
  double gamma;
  fitting::FitResult fit;
  double renderedSnr;  ///< dB in comparisonScene()
};

/// The two stages of Bieron and Peers 2020: a fit by the gamma metric for each of several gammas (1 to 3 in steps of a
/// quarter), of which the one whose picture matches best is taken; here the one of the highest rendered SNR, the first
/// among equals. Nine fits of the model, and pictures.
/// @param options all but the metric and its gamma.
/// @param base what is fitted, as fitting::fit() takes it.
/// @param reference what the pictures are compared with: the base, or the material that it samples.
/// @return the best first, the others in the order of their gammas. A stop request leaves the trials that are done;
/// none are left when it came before the first. It never throws Cancelled.
std::vector<GammaTrial> selectGamma(const Brdf& base, const Brdf& reference, const models::Model& model,
                                    const fitting::FitOptions& options = {},
                                    const RenderOptions& picture = smallComparisonPicture(),
                                    const TaskControl& control = {});

}  // namespace gonio::study
