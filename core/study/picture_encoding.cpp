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
constexpr double firstTried = 8;
/// Share of the progress that finding an upper bound takes.
constexpr double upwardShare = 0.7;

struct Search {
  const dictionary::Encoder& encoder;
  const TabulatedBrdf& table;
  const RenderedComparison& comparison;
  double renderedSnr;
  TaskControl control;

  PictureEncoding encodedWith(std::size_t coefficients, dictionary::EncodeOptions options) const {
    const TaskControl stop{.stop = control.stop, .progress = {}};
    options.coefficients = coefficients;
    PictureEncoding result{.encoded = encoder.encode(table, options, stop)};
    const auto decoded = dictionary::decode(encoder.ensemble(), result.encoded.code);
    result.renderedSnr = comparison.signalToNoiseRatio(comparison.render(*decoded, stop));
    return result;
  }

  /// Doubles the count until it is enough: more coefficients may choose a dictionary that is worse in pictures, so the
  /// most do not tell whether fewer are enough.
  PictureEncoding fewest(const dictionary::EncodeOptions& options) const {
    const double most = double(options.coefficients);
    double low = 0, high = std::min(firstTried, most);
    PictureEncoding best = encodedWith(std::size_t(high), options);
    while (best.renderedSnr < renderedSnr && high < most) {
      low = high;
      high = std::min(2 * high, most);
      if (PictureEncoding tried = encodedWith(std::size_t(high), options); tried.renderedSnr > best.renderedSnr)
        best = std::move(tried);
      control.report(upwardShare * std::log(high / firstTried) / std::log(most / firstTried));
    }
    while (best.renderedSnr >= renderedSnr && low > 0 && high > closeEnough * low) {
      const double middle = std::sqrt(low * high);
      PictureEncoding tried = encodedWith(std::size_t(middle), options);
      if (tried.renderedSnr >= renderedSnr) {
        best = std::move(tried);
        high = middle;
      } else {
        low = middle;
      }
      control.report(1 - (1 - upwardShare) * std::log2(high / low));
    }
    control.report(1);
    return best;
  }
};

/// Of two that reach the SNR the one with fewer coefficients, else the one with the higher SNR.
bool isBetter(const PictureEncoding& a, const PictureEncoding& b, double renderedSnr) {
  if (a.renderedSnr >= renderedSnr && b.renderedSnr >= renderedSnr)
    return a.encoded.code.coefficients() < b.encoded.code.coefficients();
  return a.renderedSnr > b.renderedSnr;
}

}  // namespace

PictureEncoding encodeForPictures(const dictionary::Encoder& encoder, const TabulatedBrdf& table, double renderedSnr,
                                  const dictionary::EncodeOptions& options, const TaskControl& control,
                                  const SphereRenderOptions& picture) {
  const RenderedComparison comparison(table, picture, {.stop = control.stop, .progress = {}});
  PictureEncoding best;
  std::vector<dictionary::EncodedCandidate> candidates;
  for (std::size_t i = 0; i < options.transforms.size(); ++i) {
    dictionary::EncodeOptions one = options;
    one.transforms = {options.transforms[i]};
    const double begin = double(i) / double(options.transforms.size());
    const double end = double(i + 1) / double(options.transforms.size());
    const Search search{encoder, table, comparison, renderedSnr, control.between(begin, end)};
    PictureEncoding tried = search.fewest(one);
    candidates.push_back(tried.encoded.candidates.front());
    if (i == 0 || isBetter(tried, best, renderedSnr)) best = std::move(tried);
  }
  best.encoded.candidates = std::move(candidates);
  return best;
}

}  // namespace gonio::study
