// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/dictionary/encode.h"
#include "core/rendering/render_picture.h"

namespace gonio::study {

struct PictureEncoding {
  dictionary::EncodeResult encoded;  ///< with one candidate per transform: its best code
  double renderedSnr = 0;            ///< in comparisonScene(), dB
};

/// Encodes with the smallest number of coefficients that reaches a rendered SNR: starts with 8, doubles until one of
/// the transforms reaches it, then bisects the last interval to within 3 %; selects the transform that needs fewer. If
/// `options.coefficients` are not sufficient, returns the code with the highest SNR found. About 20 encodings and
/// pictures, about a minute on two cores.
/// @param renderedSnr to reach: decoded table against the table in comparisonScene(), dB.
/// @param picture options of the pictures; use those of other comparisons, because smaller pictures give a higher SNR.
/// @throws Error as Encoder::encode(); Cancelled.
PictureEncoding encodeForPictures(const dictionary::Encoder& encoder, const TabulatedBrdf& table, double renderedSnr,
                                  const dictionary::EncodeOptions& options, const TaskControl& control = {},
                                  const RenderOptions& picture = {});

}  // namespace gonio::study
