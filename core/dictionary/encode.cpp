// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/encode.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "core/brdf/weighted_sum.h"
#include "core/coordinates/grid_directions.h"
#include "core/dictionary/alternatives/basis_pursuit.h"
#include "core/dictionary/code_packing.h"
#include "core/dictionary/decode.h"
#include "core/dictionary/invalid_cells.h"
#include "core/dictionary/largest_projections.h"
#include "core/math/parallel.h"

namespace gonio::dictionary {

namespace {

/// The three signals of one transform of a material while Encoder refines their coefficients.
template <typename Scalar>
class EncodeAttempt {
 public:
  using Signals = std::array<Eigen::Array<Scalar, Eigen::Dynamic, 1>, 3>;
  using Dictionaries = std::array<const ModeMatrices<Scalar>*, 3>;  ///< of the channels

  /// Chooses the coefficients by one projection. Table, options and dictionaries must outlive this object.
  EncodeAttempt(Signals signals, const TabulatedBrdf& table, const EncodeOptions& options,
                const Dictionaries& dictionaries, const TaskControl& control);
  EncodeAttempt(const EncodeAttempt&) = delete;
  EncodeAttempt& operator=(const EncodeAttempt&) = delete;

  /// As many more rounds.
  void refine(int rounds, const TaskControl& control);
  /// The coefficients of the channels by decreasing absolute value; only as many as EncodeOptions::relativeError needs.
  std::array<std::vector<Coefficient<float>>, 3> coefficients() const;

 private:
  std::vector<Coefficient<float>> coefficients(std::size_t channel) const;
  void refineChannel(std::size_t channel, int rounds, const TaskControl& control);

  const EncodeOptions& options_;
  Signals signals_;  ///< with the values that the rounds give to invalid cells
  std::array<std::optional<InvalidCellRefinement<Scalar>>, 3> cells_;
  std::array<std::vector<Coefficient<Scalar>>, 3> found_;  ///< in no order
  int rounds_ = 0;
};

/// The least count of coefficients (larger in size first) that leaves at most `mostLeft` of the energy.
template <typename Scalar>
std::size_t countForError(const std::vector<Coefficient<Scalar>>& coefficients, double energy, double mostLeft) {
  std::size_t n = 0;
  for (double left = energy; n < coefficients.size() && left > mostLeft * energy; ++n)
    left -= double(coefficients[n].value) * double(coefficients[n].value);
  return n;
}

template <typename Scalar>
EncodeAttempt<Scalar>::EncodeAttempt(Signals signals, const TabulatedBrdf& table, const EncodeOptions& options,
                                     const Dictionaries& dictionaries, const TaskControl& control)
    : options_(options), signals_(std::move(signals)) {
  const Sizes sizes = modeSizes(table.grid());
  parallelForBlocks(3, 1,
                    [&](std::size_t c, std::size_t) {
                      cells_[c].emplace(signals_[c], table.valid(), sizes, *dictionaries[c]);
                      cells_[c]->selectLargest(options_.coefficients, found_[c]);
                    },
                    {.stop = control.stop, .progress = {}});
}

template <typename Scalar>
void EncodeAttempt<Scalar>::refineChannel(std::size_t channel, int rounds, const TaskControl& control) {
  InvalidCellRefinement<Scalar>& cells = *cells_[channel];
  std::vector<Coefficient<Scalar>>& code = found_[channel];
  if (options_.method == CodingMethod::basisPursuit) {
    pursueBasis(cells, options_.coefficients, rounds, code, control);
    refitValues(cells, rounds, code, control);
    return;
  }
  for (int round = rounds_; round < rounds_ + rounds; ++round) {
    control.throwIfStopped();
    cells.update(code, Scalar(round) / Scalar(round + 3));
    cells.selectLargest(options_.coefficients, code);
  }
}

template <typename Scalar>
void EncodeAttempt<Scalar>::refine(int rounds, const TaskControl& control) {
  if (rounds <= 0) return;
  const TaskControl silent{.stop = control.stop, .progress = {}};
  parallelForBlocks(
      3, 1, [&](std::size_t c, std::size_t) { refineChannel(c, rounds, silent); }, silent);
  rounds_ += rounds;
}

template <typename Scalar>
std::vector<Coefficient<float>> EncodeAttempt<Scalar>::coefficients(std::size_t channel) const {
  std::vector<Coefficient<Scalar>> sorted = found_[channel];
  std::sort(sorted.begin(), sorted.end(), isLarger<Scalar>);
  if (options_.relativeError) {
    const double energy = signals_[channel].template cast<double>().square().sum();
    sorted.resize(countForError(sorted, energy, *options_.relativeError));
  }
  return coefficientsIn<float>(sorted);
}

template <typename Scalar>
std::array<std::vector<Coefficient<float>>, 3> EncodeAttempt<Scalar>::coefficients() const {
  return {coefficients(0), coefficients(1), coefficients(2)};
}

/// Fraction of a signal's energy that its block may omit while dictionaries are compared: little beside the error of a
/// code, which falls about as 1 / coefficients.
double choiceLoss(std::size_t coefficients) {
  return std::clamp(2.5e-3 / double(std::max<std::size_t>(coefficients, 1)), 1e-7, 1e-5);
}
/// Error of one dictionary for all channels, in errors of a separate one for each, up to which it is used: its files
/// are about a fourth smaller, and as many more coefficients lower the error by such a factor.
constexpr double acceptedLoss = 1.35;
constexpr double grazing = radians(85);

void measure(EncodedCandidate& candidate, const TabulatedBrdf& table, const TabulatedBrdf& decoded,
             const EncodeOptions& options) {
  const GridDirections directions(table.grid());
  const double cosGrazing = std::cos(grazing);
  struct Sums {
    double gammaError = 0, squaredError = 0, weight = 0;
  };
  constexpr std::size_t block = 1 << 14;
  std::vector<Sums> sums((table.grid().size() + block - 1) / block);
  parallelForBlocks(table.grid().size(), block, [&](std::size_t begin, std::size_t end) {
    Sums& sum = sums[begin / block];
    const auto rowLength = std::size_t(table.grid().phiDCount);
    double cellMeasure = 0;
    for (std::size_t cell = begin; cell < end; ++cell) {
      if (cell == begin || cell % rowLength == 0)
        cellMeasure = table.grid().cellMeasure(cell);  // the same for all phi_d
      if (table.valid()[cell] == 0 || decoded.valid()[cell] == 0) continue;
      const DirectionPair pair = directions.at(cell).pair;
      if (std::min(pair.wi.z, pair.wo.z) < cosGrazing) continue;
      const double weight = options.solidAngles ? cellMeasure * pair.wi.z * pair.wo.z : 1;
      for (int c = 0; c < 3; ++c) {
        const double a = table.values()[cell][c], b = decoded.values()[cell][c];
        const double d = gammaTransformed(a, options.gamma) - gammaTransformed(b, options.gamma);
        sum.gammaError += weight * d * d;
        sum.squaredError += weight * (a - b) * (a - b);
      }
      sum.weight += 3 * weight;
    }
  });
  Sums total;
  for (const Sums& sum : sums) {
    total.gammaError += sum.gammaError;
    total.squaredError += sum.squaredError;
    total.weight += sum.weight;
  }
  if (!(total.weight > 0)) return;
  candidate.gammaError = total.gammaError / total.weight;
  candidate.squaredError = total.squaredError / total.weight;
}

}  // namespace

std::shared_ptr<const TabulatedBrdf> onCodeGrid(const std::shared_ptr<const TabulatedBrdf>& table,
                                                const Ensemble& ensemble, const TaskControl& control) {
  return onGrid(table, table->isReciprocal() ? ensemble.grid : ensemble.grid.wholeCircle(), control);
}

namespace {

/// About as many coefficients as fit EncodeOptions::bytes: rounds for more would fit the invalid cells to those that
/// are then left out, which costs some decibels.
EncodeResult encodeWithin(const Encoder& encoder, const TabulatedBrdf& table, EncodeOptions options,
                          const TaskControl& control) {
  if (!options.bytes) return encoder.encode(table, options, control);
  constexpr double bytesPerCoefficient = 2.6, noticeable = 1.05;
  const std::size_t most = options.coefficients;
  const auto available = double(*options.bytes);
  options.coefficients = std::min(most, std::size_t(available / bytesPerCoefficient));
  EncodeResult first = encoder.encode(table, options, control.between(0, 0.5));
  const double used = double(compressChannels(quantised(first.code)).size());
  const auto more = std::min(most, std::size_t(double(options.coefficients) * available / used));
  if (double(more) < noticeable * double(options.coefficients)) return first;
  options.coefficients = more;
  EncodeResult second = encoder.encode(table, options, control.between(0.5, 1));
  second.seconds += first.seconds;
  return second;
}

}  // namespace

EncodeOptions publishedEncodeOptions(std::size_t coefficients) {
  return {.coefficients = coefficients,
          .refinements = 0,
          .scaled = false,
          .sharedDictionary = false,
          .bounded = false,
          .solidAngles = false};
}

Encoder::Encoder(const Ensemble& ensemble) : ensemble_(ensemble) {
  for (const Dictionary& d : ensemble.dictionaries)
    matrices_.push_back({d.modes[0].cast<float>(), d.modes[1].cast<float>(), d.modes[2].cast<float>()});
}

std::vector<double> Encoder::dictionaryErrors(const Eigen::ArrayXf& signal, std::size_t coefficients) const {
  const CompactSignal<float> small = compactSignal(signal.data(), modeSizes(ensemble_.grid), choiceLoss(coefficients));
  std::vector<double> errors(matrices_.size());
  parallelForBlocks(matrices_.size(), 1, [&](std::size_t d, std::size_t) {
    thread_local Workspace<float> workspace;
    thread_local std::vector<Coefficient<float>> kept;
    small.selectLargest(matrices_[d], coefficients, workspace, kept);
    errors[d] = std::max(0.0, small.energy - energy<float>(kept));
  });
  return errors;
}

std::array<int, 3> Encoder::chooseDictionaries(const EncodeAttempt<float>::Signals& signals,
                                               const EncodeOptions& options, int maxSparsity,
                                               const TaskControl& control) const {
  std::array<std::vector<double>, 3> errors;
  parallelForBlocks(3, 1,
                    [&](std::size_t c, std::size_t) { errors[c] = dictionaryErrors(signals[c], options.coefficients); },
                    {.stop = control.stop, .progress = {}});
  for (std::vector<double>& values : errors)
    for (std::size_t d = 0; d < values.size(); ++d)
      if (ensemble_.dictionaries[d].sparsity > maxSparsity) values[d] = std::numeric_limits<double>::infinity();
  const auto smallest = [](const std::vector<double>& values) {
    return int(std::min_element(values.begin(), values.end()) - values.begin());
  };
  std::array<int, 3> separate{};
  double separateError = 0;
  std::vector<double> common(errors[0].size());
  for (std::size_t c = 0; c < 3; ++c) {
    separate[c] = smallest(errors[c]);
    separateError += errors[c][std::size_t(separate[c])];
    for (std::size_t d = 0; d < common.size(); ++d) common[d] += errors[c][d];
  }
  if (!options.sharedDictionary) return separate;
  const int shared = smallest(common);
  return common[std::size_t(shared)] <= acceptedLoss * separateError ? std::array{shared, shared, shared} : separate;
}

namespace {

/// The largest absolute value of the valid cells of a channel.
float largestValue(const TabulatedBrdf& table, int channel) {
  float largest = 0;
  for (std::size_t cell = 0; cell < table.values().size(); ++cell)
    if (table.valid()[cell] != 0) largest = std::max(largest, std::abs(table.values()[cell][channel]));
  return largest;
}

}  // namespace

/// A transform, its signals, and what its trial chose.
struct Encoder::Trial {
  DataTransform transform = DataTransform::logPlus;
  EncodeAttempt<double>::Signals signals = {};
  std::array<ChannelCode, 3> channels = {};  ///< without coefficients
  EncodedCandidate candidate = {};
};

/// In single precision: faster, and precise enough for choices whose errors differ by more than rounding.
Encoder::Trial Encoder::tried(DataTransform transform, const TabulatedBrdf& table, const EncodeOptions& options,
                              int maxSparsity, const TaskControl& control) const {
  const auto geometry = GridGeometry::of(ensemble_.grid);
  Trial trial{.transform = transform, .signals = signalsOf(table, transform, *geometry, isScaled(options))};
  EncodeAttempt<float>::Signals signals;
  parallelForBlocks(3, 1,
                    [&](std::size_t c, std::size_t) {
                      signals[c] = trial.signals[c].cast<float>();
                      if (!options.bounded) return;
                      const SignalRange range = rangeOf(trial.signals[c], table, *geometry, isScaled(options));
                      trial.channels[c].highest = range.highest;
                      trial.channels[c].lowest = range.lowest;
                      if (transform == DataTransform::cosineLog)
                        trial.channels[c].largestValue = largestValue(table, int(c));
                    },
                    {.stop = control.stop, .progress = {}});
  const std::array<int, 3> chosen = chooseDictionaries(signals, options, maxSparsity, control);
  EncodeAttempt<float>::Dictionaries dictionaries;
  for (std::size_t c = 0; c < 3; ++c) {
    trial.channels[c].dictionary = chosen[c];
    dictionaries[c] = &matrices_[std::size_t(chosen[c])];
  }
  EncodeAttempt<float> attempt(std::move(signals), table, options, dictionaries, control);
  attempt.refine(std::min(options.trialRefinements, options.refinements), control);
  trial.candidate = candidate(trial, attempt.coefficients(), table, options);
  return trial;
}

/// All rounds in double precision, so that rounding does not decide between coefficients of nearly equal size. If the
/// trial's few rounds have less error, only these.
EncodedCandidate Encoder::refined(const Trial& trial, const TabulatedBrdf& table, const EncodeOptions& options,
                                  const TaskControl& control) const {
  EncodeAttempt<double>::Dictionaries dictionaries;
  for (std::size_t c = 0; c < 3; ++c)
    dictionaries[c] = &ensemble_.dictionaries[std::size_t(trial.channels[c].dictionary)].modes;
  EncodeAttempt<double> attempt(trial.signals, table, options, dictionaries, control);
  const int few = std::min(options.trialRefinements, options.refinements);
  attempt.refine(few, control);
  const ChannelCoefficients early = attempt.coefficients();
  attempt.refine(options.refinements - few, control);
  EncodedCandidate all = candidate(trial, attempt.coefficients(), table, options);
  if (few == options.refinements || all.gammaError <= trial.candidate.gammaError) return all;
  EncodedCandidate less = candidate(trial, early, table, options);
  return less.gammaError < all.gammaError ? less : all;
}

EncodedCandidate Encoder::candidate(const Trial& trial, const ChannelCoefficients& coefficients,
                                    const TabulatedBrdf& table, const EncodeOptions& options) const {
  EncodedCandidate candidate;
  candidate.code = {.grid = ensemble_.grid,
                    .transform = trial.transform,
                    .scaled = isScaled(options),
                    .hasLargestValues = options.bounded && trial.transform == DataTransform::cosineLog,
                    .channels = trial.channels};
  for (std::size_t c = 0; c < 3; ++c) candidate.code.channels[c].coefficients = coefficients[c];
  if (options.bytes) candidate.code = truncatedToBytes(candidate.code, *options.bytes);
  if (options.quantised) candidate.code = quantised(std::move(candidate.code));
  measure(candidate, table, *decode(ensemble_, candidate.code), options);
  return candidate;
}

std::vector<std::string> lostPeaks(const TabulatedBrdf& table, const TabulatedBrdf& decoded) {
  constexpr float keptFraction = 0.1f;
  std::vector<std::string> sentences;
  for (int channel = 0; channel < 3; ++channel) {
    std::size_t brightest = 0;
    for (std::size_t cell = 0; cell < table.values().size(); ++cell)
      if (table.values()[cell][channel] > table.values()[brightest][channel]) brightest = cell;
    const float value = table.values()[brightest][channel], kept = decoded.values()[brightest][channel];
    if (!(value > 0) || kept >= keptFraction * value) continue;
    const HalfDifference at = table.grid().node(brightest);
    char text[200];
    std::snprintf(text, sizeof text,
                  "the brightest cell in %s (theta_h %.4g, theta_d %.4g, phi_d %.4g degrees), %.3g 1/sr, is lost: the "
                  "code has %.3g 1/sr there",
                  channelNames[std::size_t(channel)], degrees(at.thetaH), degrees(at.thetaD), degrees(at.phiD),
                  double(value), double(kept));
    sentences.emplace_back(text);
  }
  return sentences;
}

EncodeResult Encoder::encodeOver(int maxSparsity, const TabulatedBrdf& table, const EncodeOptions& options,
                                 const TaskControl& control) const {
  const auto start = std::chrono::steady_clock::now();
  std::vector<Trial> trials(options.transforms.size());
  const double trialFraction = double(trials.size()) / double(trials.size() + 1);
  const TaskControl silent{.stop = control.stop, .progress = {}};
  parallelForBlocks(
      trials.size(), 1,
      [&](std::size_t t, std::size_t) {
        trials[t] = tried(options.transforms[t], table, options, maxSparsity, silent);
      },
      control.between(0, trialFraction));
  Trial& best = *std::min_element(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) {
    return a.candidate.gammaError < b.candidate.gammaError;
  });
  best.candidate = refined(best, table, options, silent);

  EncodeResult result;
  result.code = best.candidate.code;
  for (Trial& trial : trials) result.candidates.push_back(std::move(trial.candidate));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  control.report(1);
  return result;
}

namespace {

double smallestGammaError(const EncodeResult& result) {
  return std::ranges::min_element(result.candidates, {}, &EncodedCandidate::gammaError)->gammaError;
}

}  // namespace

EncodeResult Encoder::encode(const TabulatedBrdf& table, const EncodeOptions& options,
                             const TaskControl& control) const {
  if (table.grid() != ensemble_.grid && table.grid() == ensemble_.grid.wholeCircle()) {
    const Ensemble both = inBothOrders(ensemble_);
    return encodeWithin(Encoder(both), table, options, control);
  }
  if (!(table.grid() == ensemble_.grid)) throw Error("the material and the dictionary have different grids");
  const std::vector<Dictionary>& all = ensemble_.dictionaries;
  const auto isCommon = [](const Dictionary& dictionary) { return dictionary.sparsity <= commonSparsity; };
  const bool mayRepeat = options.refinements > 0 && table.isReciprocal() && std::ranges::any_of(all, isCommon) &&
                         !std::ranges::all_of(all, isCommon);
  EncodeResult result =
      encodeOver(std::numeric_limits<int>::max(), table, options, mayRepeat ? control.between(0, 0.5) : control);
  if (mayRepeat && std::ranges::any_of(result.code.channels, [&](const ChannelCode& channel) {
        return !isCommon(all[std::size_t(channel.dictionary)]);
      })) {
    EncodeResult common = encodeOver(commonSparsity, table, options, control.between(0.5, 1));
    common.seconds += result.seconds;
    if (smallestGammaError(common) < smallestGammaError(result)) return common;
    result.seconds = common.seconds;
  }
  control.report(1);
  return result;
}

}  // namespace gonio::dictionary
