// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/dictionary/encode.h"
#include "core/rendering/sphere_renderer.h"

namespace gonio::study {

struct PictureEncoding {
  dictionary::Encoded encoded;
  double renderedSnr = 0;  ///< dB in comparisonScene()
};

/// As few coefficients as give pictures an SNR, by halving the ratio of counts until they are 3 % apart: about nine
/// encodings and pictures, 10 s on two cores. Where `options.coefficients` do not reach it, that many.
/// @param renderedSnr dB of the decoded table against the table in comparisonScene().
/// @throws Error as Encoder::encode; Cancelled.
PictureEncoding encodeForPictures(const dictionary::Encoder& encoder, const TabulatedBrdf& table, double renderedSnr,
                                  const dictionary::EncodeOptions& options, const TaskControl& control = {},
                                  const SphereRenderOptions& picture = {
                                      .width = 128, .height = 128, .samples = 32, .lobe = {}});

}  // namespace gonio::study
