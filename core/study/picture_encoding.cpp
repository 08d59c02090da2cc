// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/picture_encoding.h"

#include <algorithm>
#include <cmath>

#include "core/dictionary/decode.h"
#include "core/rendering/rendered_comparison.h"

namespace gonio::study {

namespace {

constexpr double closeEnough = 1.03;
constexpr double fewest = 8;

}  // namespace

PictureEncoding encodeForPictures(const dictionary::Encoder& encoder, const TabulatedBrdf& table, double renderedSnr,
                                  const dictionary::EncodeOptions& options, const TaskControl& control,
                                  const SphereRenderOptions& picture) {
  const TaskControl stop{.stop = control.stop, .progress = {}};
  const RenderedComparison comparison(table, picture, stop);
  const auto encodedWith = [&](std::size_t coefficients) {
    dictionary::EncodeOptions some = options;
    some.coefficients = coefficients;
    PictureEncoding result{.encoded = encoder.encode(table, some, stop)};
    const auto decoded = dictionary::decode(encoder.ensemble(), result.encoded.code);
    result.renderedSnr = comparison.signalToNoiseRatio(comparison.render(*decoded, stop));
    return result;
  };
  PictureEncoding best = encodedWith(options.coefficients);
  double low = std::min(fewest, double(options.coefficients)), high = double(options.coefficients);
  const double range = std::log(high / low);
  while (best.renderedSnr >= renderedSnr && high > closeEnough * low) {
    const double middle = std::sqrt(low * high);
    PictureEncoding tried = encodedWith(std::size_t(middle));
    if (tried.renderedSnr >= renderedSnr) {
      best = std::move(tried);
      high = middle;
    } else {
      low = middle;
    }
    control.report(1 - std::log(high / low) / range);
  }
  return best;
}

}  // namespace gonio::study
