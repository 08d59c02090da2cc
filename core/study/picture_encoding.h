// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/dictionary/encode.h"
#include "core/rendering/sphere_renderer.h"

namespace gonio::study {

struct PictureEncoding {
  dictionary::Encoded encoded;  ///< a candidate for each transform: its best code
  double renderedSnr = 0;       ///< dB in comparisonScene()
};

/// As few coefficients as give pictures an SNR, in the transform that needs fewest: 8, doubled until they are enough,
/// then between the last two counts until they are 3 % apart. About ten encodings and pictures a transform, 10 to 30 s
/// on two cores. Where `options.coefficients` reach it in no transform, the code with the highest SNR that was found.
/// @param renderedSnr dB of the decoded table against the table in comparisonScene().
/// @throws Error as Encoder::encode; Cancelled.
PictureEncoding encodeForPictures(const dictionary::Encoder& encoder, const TabulatedBrdf& table, double renderedSnr,
                                  const dictionary::EncodeOptions& options, const TaskControl& control = {},
                                  const SphereRenderOptions& picture = {
                                      .width = 128, .height = 128, .samples = 128, .lobe = {}});

}  // namespace gonio::study
