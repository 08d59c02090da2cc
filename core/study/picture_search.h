// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/dictionary/encode.h"
#include "core/fitting/fit.h"
#include "core/rendering/render_picture.h"

/// Searches for the setting of a fit or a code by its rendered pictures.
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
                                    const rendering::RenderOptions& picture = rendering::smallComparisonPicture(),
                                    const TaskControl& control = {});

struct PictureEncoding {
  dictionary::EncodeResult encoded;  ///< with one candidate per transform: its best code
  double renderedSnr = 0;            ///< in comparisonScene(), dB
};

/// Encodes with the smallest number of coefficients that reaches a rendered SNR: starts with 8, doubles until one of
/// the transforms reaches it, then bisects the last interval to within 3 %; selects the transform that needs fewer. If
/// `options.coefficients` are not sufficient, returns the code with the highest SNR found. About 20 encodings and
/// pictures, about a minute on two cores.
/// @param measurement in its native form, which the SNR is of. @param table of it on the encoder's grid.
/// @param renderedSnr to reach: decoded table against the measurement in comparisonScene(), dB.
/// @throws Error as Encoder::encode(); Cancelled.
PictureEncoding encodeForPictures(const dictionary::Encoder& encoder, const Brdf& measurement,
                                  const TabulatedBrdf& table, double renderedSnr,
                                  const dictionary::EncodeOptions& options, const TaskControl& control = {},
                                  const rendering::RenderOptions& picture = rendering::smallComparisonPicture());

}  // namespace gonio::study
