// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/encode.h"

#include <chrono>
#include <cmath>

#include "core/coordinates/grid_directions.h"
#include "core/dictionary/basis_pursuit.h"
#include "core/dictionary/code_packing.h"
#include "core/dictionary/compact_signal.h"
#include "core/dictionary/decode.h"
#include "core/dictionary/invalid_cells.h"
#include "core/dictionary/largest_projections.h"
#include "core/dictionary/mode_products.h"
#include "core/dictionary/quantised_code.h"
#include "core/math/parallel.h"

namespace gonio::dictionary {

namespace {

/// Fraction of a signal's energy that its block may omit while dictionaries are compared: little beside the error of a
/// code, which falls about as 1 / coefficients.
double choiceLoss(std::size_t coefficients) {
  return std::clamp(2.5e-3 / double(std::max<std::size_t>(coefficients, 1)), 1e-7, 1e-5);
}
/// Error of one dictionary for all channels, in errors of a separate one for each, up to which it is used: its files
/// are about a fourth smaller, and as many more coefficients lower the error by such a factor.
constexpr double acceptedLoss = 1.35;
constexpr double grazing = radians(85);

/// The least count of coefficients (larger in size first) that leaves at most `mostLeft` of the energy.
std::size_t countForError(const std::vector<Coefficient<float>>& coefficients, double energy, double mostLeft) {
  std::size_t n = 0;
  for (double left = energy; n < coefficients.size() && left > mostLeft * energy; ++n)
    left -= double(coefficients[n].value) * double(coefficients[n].value);
  return n;
}

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

EncodeOptions publishedEncodeOptions(std::size_t coefficients) {
  return {.coefficients = coefficients, .refinements = 0, .scaled = false, .solidAngles = false};
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

std::array<int, 3> Encoder::chooseDictionaries(const std::array<Eigen::ArrayXf, 3>& signals, std::size_t coefficients,
                                               const TaskControl& control) const {
  std::array<std::vector<double>, 3> errors;
  parallelForBlocks(3, 1, [&](std::size_t c, std::size_t) { errors[c] = dictionaryErrors(signals[c], coefficients); },
                    {.stop = control.stop, .progress = {}});
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
  const int shared = smallest(common);
  return common[std::size_t(shared)] <= acceptedLoss * separateError ? std::array{shared, shared, shared} : separate;
}

/// One transform of a material while it is encoded.
struct Encoder::Attempt {
  const TabulatedBrdf& table;
  const EncodeOptions& options;
  DataTransform transform = DataTransform::logPlus;
  std::array<Eigen::ArrayXf, 3> signals = {};  ///< in the invalid cells what the rounds put there
  std::array<ChannelCode, 3> channels = {};    ///< as they were found, in no order
  std::array<std::optional<InvalidCellRefinement>, 3> channelRounds = {};  ///< from the choice of the dictionaries on
  int rounds = 0;
};

void Encoder::start(Attempt& attempt, DataTransform transform, const TaskControl& control) const {
  const auto geometry = GridGeometry::of(ensemble_.grid);
  attempt.transform = transform;
  const bool scaled = isScaled(attempt.options);
  attempt.signals = signalsOf(attempt.table, transform, *geometry, scaled);
  parallelForBlocks(3, 1,
                    [&](std::size_t c, std::size_t) {
                      attempt.channels[c].highest = highestOf(attempt.signals[c], attempt.table, *geometry, scaled);
                    },
                    {.stop = control.stop, .progress = {}});
  const std::array<int, 3> chosen = chooseDictionaries(attempt.signals, attempt.options.coefficients, control);
  for (std::size_t c = 0; c < 3; ++c) attempt.channels[c].dictionary = chosen[c];
  refine(attempt, 0, control);
}

/// Each channel's coefficients, after so many more rounds.
void Encoder::refine(Attempt& attempt, int rounds, const TaskControl& control) const {
  const Sizes sizes = modeSizes(ensemble_.grid);
  const TaskControl silent{.stop = control.stop, .progress = {}};
  parallelForBlocks(3, 1,
                    [&](std::size_t c, std::size_t) {
                      ChannelCode& code = attempt.channels[c];
                      std::optional<InvalidCellRefinement>& channel = attempt.channelRounds[c];
                      if (!channel) {
                        channel.emplace(attempt.signals[c], attempt.table.valid(), sizes,
                                        matrices_[std::size_t(code.dictionary)]);
                        channel->selectLargest(attempt.options.coefficients, code.coefficients);
                      }
                      if (attempt.options.method == CodingMethod::basisPursuit && rounds > 0) {
                        pursueBasis(*channel, attempt.options.coefficients, rounds, code.coefficients, silent);
                        refitValues(*channel, rounds, code.coefficients, silent);
                        return;
                      }
                      for (int round = attempt.rounds; round < attempt.rounds + rounds; ++round) {
                        control.throwIfStopped();
                        channel->update(code.coefficients, float(round) / float(round + 3));
                        channel->selectLargest(attempt.options.coefficients, code.coefficients);
                      }
                    },
                    {.stop = control.stop, .progress = {}});
  attempt.rounds += rounds;
}

EncodedCandidate Encoder::finished(const Attempt& attempt) const {
  const EncodeOptions& options = attempt.options;
  EncodedCandidate candidate;
  candidate.code = {.grid = ensemble_.grid,
                    .transform = attempt.transform,
                    .scaled = isScaled(options),
                    .channels = attempt.channels};
  for (std::size_t c = 0; c < 3; ++c) {
    auto& coefficients = candidate.code.channels[c].coefficients;
    std::sort(coefficients.begin(), coefficients.end(), isLarger<float>);
    const double energy = attempt.signals[c].cast<double>().square().sum();
    if (options.relativeError) coefficients.resize(countForError(coefficients, energy, *options.relativeError));
  }
  if (options.bytes) candidate.code = truncatedToBytes(candidate.code, *options.bytes);
  if (options.quantised) candidate.code = quantised(std::move(candidate.code));
  measure(candidate, attempt.table, *decode(ensemble_, candidate.code), options);
  return candidate;
}

EncodeResult Encoder::encode(const TabulatedBrdf& table, const EncodeOptions& options,
                             const TaskControl& control) const {
  const auto start = std::chrono::steady_clock::now();
  if (!(table.grid() == ensemble_.grid)) throw Error("the material and the dictionary have different grids");
  EncodeResult result;
  std::vector<Attempt> attempts;
  const int trialRounds = std::min(options.trialRefinements, options.refinements);
  for (std::size_t t = 0; t < options.transforms.size(); ++t) attempts.push_back({.table = table, .options = options});
  result.candidates.resize(attempts.size());
  const double trialShare = double(attempts.size()) / double(attempts.size() + 1);
  parallelForBlocks(
      attempts.size(), 1,
      [&](std::size_t t, std::size_t) {
        const TaskControl silent{.stop = control.stop, .progress = {}};
        this->start(attempts[t], options.transforms[t], silent);
        refine(attempts[t], trialRounds, silent);
        result.candidates[t] = finished(attempts[t]);
      },
      control.between(0, trialShare));
  const auto best = std::min_element(result.candidates.begin(), result.candidates.end(),
                                     [](const auto& a, const auto& b) { return a.gammaError < b.gammaError; });
  if (options.refinements > trialRounds) {
    Attempt& chosen = attempts[std::size_t(best - result.candidates.begin())];
    refine(chosen, options.refinements - trialRounds, control);
    if (EncodedCandidate refined = finished(chosen); refined.gammaError < best->gammaError) *best = std::move(refined);
  }
  result.code = best->code;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  control.report(1);
  return result;
}

}  // namespace gonio::dictionary
