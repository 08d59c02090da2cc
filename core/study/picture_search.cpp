// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/picture_search.h"

#include <algorithm>
#include <cmath>

#include "core/dictionary/decode.h"

namespace gonio::study {

namespace {

constexpr double gammaStep = 0.25;
constexpr int gammaCount = int((metrics::maxGamma - metrics::minGamma) / gammaStep) + 1;

constexpr double closeEnough = 1.03;
constexpr double firstTried = 8;
/// Fraction of the progress that finding an upper bound takes.
constexpr double upwardFraction = 0.7;

class Search {
 public:
  Search(const dictionary::Encoder& encoder, const Brdf& measurement, const TabulatedBrdf& table, double renderedSnr,
         const dictionary::EncodeOptions& options, const rendering::RenderOptions& picture, const TaskControl& control)
      : encoder_(encoder),
        table_(table),
        renderedSnr_(renderedSnr),
        options_(options),
        control_(control),
        comparison_(measurement, picture, stop()) {}

  /// The best of each transform.
  std::vector<PictureEncoding> run() {
    std::vector<PictureEncoding> best = doubled();
    for (std::size_t i = 0; i < best.size(); ++i) {
      if (reaches(best[i])) halve(best[i]);
      control_.report(upwardFraction + (1 - upwardFraction) * double(i + 1) / double(best.size()));
    }
    return best;
  }

  bool reaches(const PictureEncoding& tried) const { return tried.renderedSnr >= renderedSnr_; }

 private:
  TaskControl stop() const { return {.stop = control_.stop, .progress = {}}; }

  PictureEncoding encoded(double coefficients, DataTransform transform) const {
    dictionary::EncodeOptions options = options_;
    options.coefficients = std::size_t(coefficients);
    options.transforms = {transform};
    PictureEncoding result{.encoded = encoder_.encode(table_, options, stop())};
    const auto decoded = dictionary::decode(encoder_.ensemble(), result.encoded.code);
    result.renderedSnr = comparison_.signalToNoiseRatio(comparison_.render(*decoded, stop()));
    return result;
  }

  /// Of each transform the best of the counts that are doubled until they are enough for one of them: more coefficients
  /// may choose a dictionary that is worse in pictures, so the largest number does not show whether fewer are enough.
  std::vector<PictureEncoding> doubled() {
    const double most = double(options_.coefficients);
    std::vector<PictureEncoding> best;
    for (high_ = std::min(firstTried, most);; low_ = high_, high_ = std::min(2 * high_, most)) {
      for (std::size_t i = 0; i < options_.transforms.size(); ++i) {
        PictureEncoding tried = encoded(high_, options_.transforms[i]);
        if (i == best.size())
          best.push_back(std::move(tried));
        else if (tried.renderedSnr > best[i].renderedSnr)
          best[i] = std::move(tried);
      }
      if (high_ == most || std::ranges::any_of(best, [&](const auto& one) { return reaches(one); })) return best;
      control_.report(upwardFraction * std::log(high_ / firstTried) / std::log(most / firstTried));
    }
  }

  /// Fewer, down to the count that was not enough.
  void halve(PictureEncoding& best) const {
    double low = low_, high = high_;
    while (low > 0 && high > closeEnough * low) {
      const double middle = std::sqrt(low * high);
      PictureEncoding tried = encoded(middle, best.encoded.code.transform);
      if (reaches(tried)) {
        best = std::move(tried);
        high = middle;
      } else {
        low = middle;
      }
    }
  }

  const dictionary::Encoder& encoder_;
  const TabulatedBrdf& table_;
  double renderedSnr_;
  const dictionary::EncodeOptions& options_;
  TaskControl control_;
  rendering::RenderedComparison comparison_;
  double low_ = 0, high_ = 0;  ///< counts that are not enough, and enough for one
};

}  // namespace

std::vector<GammaTrial> selectGamma(const fitting::FitBase& base, const models::Model& model,
                                    const fitting::FitOptions& options, const rendering::RenderOptions& picture,
                                    const TaskControl& control) {
  std::vector<GammaTrial> trials;
  try {
    const rendering::RenderedComparison comparison(*base.measurement, picture, {control.stop, {}});
    for (int i = 0; i < gammaCount; ++i) {
      fitting::FitOptions gammaOptions = options;
      gammaOptions.metric = metrics::BrdfMetric::gamma;
      gammaOptions.gamma = metrics::minGamma + i * gammaStep;
      fitting::FitResult result = fitting::fit(base, model, gammaOptions, {control.stop, {}});
      control.throwIfStopped();
      const rendering::ComparisonPicture rendered =
          comparison.render(*model.instantiate(result.parameters), {control.stop, {}});
      trials.push_back({gammaOptions.gamma, std::move(result), comparison.signalToNoiseRatio(rendered)});
      control.report(double(i + 1) / gammaCount);
    }
  } catch (const Cancelled&) {
  }
  // Comparisons with a NaN (a black reference) are false: the first stays.
  const auto best = std::ranges::max_element(
      trials, [](const GammaTrial& a, const GammaTrial& b) { return a.renderedSnr < b.renderedSnr; });
  if (best != trials.end()) std::rotate(trials.begin(), best, best + 1);
  return trials;
}

PictureEncoding encodeForPictures(const dictionary::Encoder& encoder, const Brdf& measurement,
                                  const TabulatedBrdf& table, double renderedSnr,
                                  const dictionary::EncodeOptions& options, const TaskControl& control,
                                  const rendering::RenderOptions& picture) {
  Search search(encoder, measurement, table, renderedSnr, options, picture, control);
  std::vector<PictureEncoding> found = search.run();
  std::vector<dictionary::EncodedCandidate> candidates;
  for (const PictureEncoding& one : found) candidates.push_back(one.encoded.candidates.front());
  // Of two that reach the SNR the one with fewer coefficients, else the one with the higher SNR.
  const auto isBetter = [&](const PictureEncoding& a, const PictureEncoding& b) {
    if (search.reaches(a) && search.reaches(b)) return a.encoded.code.coefficients() < b.encoded.code.coefficients();
    return a.renderedSnr > b.renderedSnr;
  };
  PictureEncoding best = std::move(*std::ranges::min_element(found, isBetter));
  best.encoded.candidates = std::move(candidates);
  return best;
}

}  // namespace gonio::study
