// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/dictionary/encode.h"
#include "core/rendering/render_picture.h"

namespace gonio::study {

struct PictureEncoding {
  dictionary::Encoded encoded;  ///< a candidate for each transform: its best code
  double renderedSnr = 0;       ///< dB in comparisonScene()
};

/// As few coefficients as give pictures an SNR: 8, doubled until they are enough in one of the transforms, then between
/// the last two counts until they are 3 % apart; of the transforms that reach it the one that needs fewer. Some 20
/// encodings and pictures, about a minute on two cores. Where `options.coefficients` are not enough, the code with the
/// highest SNR that was found.
/// @param renderedSnr dB of the decoded table against the table in comparisonScene().
/// @param picture that by which every other comparison measures: an SNR is higher in smaller pictures.
/// @throws Error as Encoder::encode; Cancelled.
PictureEncoding encodeForPictures(const dictionary::Encoder& encoder, const TabulatedBrdf& table, double renderedSnr,
                                  const dictionary::EncodeOptions& options, const TaskControl& control = {},
                                  const RenderOptions& picture = {});

}  // namespace gonio::study
