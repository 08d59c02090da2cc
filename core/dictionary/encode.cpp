// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/encode.h"

#include <chrono>
#include <cmath>

#include "core/coordinates/grid_directions.h"
#include "core/dictionary/code_packing.h"
#include "core/dictionary/decode.h"
#include "core/dictionary/gram.h"
#include "core/dictionary/mode_products.h"
#include "core/math/decompositions.h"
#include "core/math/parallel.h"

namespace gonio::dictionary {

namespace {

/// Share of a signal's energy that its own subspace may leave out while dictionaries are compared.
constexpr double choiceLoss = 1e-7;
constexpr double grazing = radians(85);

/// A signal as a small block: its own truncated higher-order SVD.
struct CompactSignal {
  ModeMatrices<float> bases;  ///< size of the mode x rank
  Sizes ranks{};
  std::vector<float> block;
};

CompactSignal compact(const Eigen::ArrayXf& signal, const Sizes& sizes) {
  CompactSignal result;
  for (int mode = 0; mode < 3; ++mode) {
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(sizes[std::size_t(mode)], sizes[std::size_t(mode)]);
    addGram(signal.data(), sizes, mode, gram);
    const EigenBasis basis = eigenBasis(gram);
    const int rank = rankFor(basis.values, choiceLoss / 3);
    result.bases[std::size_t(mode)] = basis.vectors.leftCols(rank).cast<float>();
    result.ranks[std::size_t(mode)] = rank;
  }
  Workspace<float> workspace;
  const float* block = transposedModeProducts(signal.data(), sizes, result.bases, workspace);
  result.block.assign(block, block + count(result.ranks));
  return result;
}

/// The least count of coefficients (larger in size first) that leaves at most `mostLeft` of the energy.
std::size_t countForError(const std::vector<Coefficient<float>>& coefficients, double energy, double mostLeft) {
  std::size_t n = 0;
  for (double left = energy; n < coefficients.size() && left > mostLeft * energy; ++n)
    left -= double(coefficients[n].value) * double(coefficients[n].value);
  return n;
}

/// The largest transformed value of the valid cells of a signal.
float highestOf(const Eigen::ArrayXf& signal, const TabulatedBrdf& table, const GridGeometry& geometry) {
  const Sizes sizes = modeSizes(table.grid());
  double highest = 0;
  Eigen::Index cell = 0;
  for (int h = 0; h < sizes[2]; ++h)
    for (int d = 0; d < sizes[1]; ++d) {
      float most = 0;
      for (int phi = 0; phi < sizes[0]; ++phi, ++cell)
        if (table.valid()[std::size_t(cell)] != 0) most = std::max(most, signal[cell]);
      highest = std::max(highest, double(most) / (geometry.importance[1][d] * geometry.importance[2][h]));
    }
  return float(highest);
}

void measure(EncodedCandidate& candidate, const TabulatedBrdf& table, const TabulatedBrdf& decoded, double gamma) {
  const GridDirections directions(table.grid());
  const double cosGrazing = std::cos(grazing);
  struct Sums {
    double gammaError = 0, squaredError = 0, weight = 0;
  };
  constexpr std::size_t block = 1 << 14;
  std::vector<Sums> sums((table.grid().size() + block - 1) / block);
  parallelForBlocks(table.grid().size(), block, [&](std::size_t begin, std::size_t end) {
    Sums& sum = sums[begin / block];
    for (std::size_t cell = begin; cell < end; ++cell) {
      if (table.valid()[cell] == 0 || decoded.valid()[cell] == 0) continue;
      const DirectionPair pair = directions.at(cell).pair;
      if (std::min(pair.wi.z, pair.wo.z) < cosGrazing) continue;
      const double weight = table.grid().cellMeasure(cell) * pair.wi.z * pair.wo.z;
      for (int c = 0; c < 3; ++c) {
        const double a = table.values()[cell][c], b = decoded.values()[cell][c];
        const double d = gammaTransformed(a, gamma) - gammaTransformed(b, gamma);
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

Encoder::Encoder(const Ensemble& ensemble) : ensemble_(ensemble) {
  for (const Dictionary& d : ensemble.dictionaries)
    matrices_.push_back({d.modes[0].cast<float>(), d.modes[1].cast<float>(), d.modes[2].cast<float>()});
}

int Encoder::chooseDictionary(const Eigen::ArrayXf& signal, std::size_t coefficients) const {
  const CompactSignal small = compact(signal, modeSizes(ensemble_.grid));
  std::vector<double> captured(matrices_.size());
  parallelForBlocks(matrices_.size(), 1, [&](std::size_t d, std::size_t) {
    thread_local Workspace<float> workspace;
    thread_local std::vector<Coefficient<float>> kept;
    ModeMatrices<float> rotations;  // of the signal's bases into the dictionary's
    for (std::size_t mode = 0; mode < 3; ++mode) rotations[mode] = small.bases[mode].transpose() * matrices_[d][mode];
    const float* projection = transposedModeProducts(small.block.data(), small.ranks, rotations, workspace);
    keepLargest(std::span(projection, ensemble_.grid.size()), coefficients, kept);
    captured[d] = energy<float>(kept);
  });
  return int(std::max_element(captured.begin(), captured.end()) - captured.begin());
}

ChannelCode Encoder::encodeSignal(Eigen::ArrayXf& signal, std::span<const std::uint8_t> valid,
                                  const EncodeOptions& options) const {
  const Sizes sizes = modeSizes(ensemble_.grid);
  ChannelCode code;
  code.dictionary = chooseDictionary(signal, options.coefficients);
  const ModeMatrices<float>& matrices = matrices_[std::size_t(code.dictionary)];
  Workspace<float> workspace;
  Eigen::ArrayXf decoded(signal.size());
  for (int round = 0;; ++round) {
    const float* projection = transposedModeProducts(signal.data(), sizes, matrices, workspace);
    keepLargest(std::span(projection, count(sizes)), options.coefficients, code.coefficients);
    if (round == options.refinements) break;
    compose(matrices, code.coefficients, decoded.data());
    for (Eigen::Index cell = 0; cell < signal.size(); ++cell)
      if (valid[std::size_t(cell)] == 0) signal[cell] = decoded[cell];
  }
  std::sort(code.coefficients.begin(), code.coefficients.end(), isLarger<float>);
  if (options.relativeError)
    code.coefficients.resize(
        countForError(code.coefficients, signal.cast<double>().square().sum(), *options.relativeError));
  return code;
}

Encoded Encoder::encode(const TabulatedBrdf& table, const EncodeOptions& options, const TaskControl& control) const {
  const auto start = std::chrono::steady_clock::now();
  if (!(table.grid() == ensemble_.grid)) throw Error("the material's grid is not that of the dictionary");
  const auto geometry = GridGeometry::of(table.grid());
  Encoded result;
  for (std::size_t t = 0; t < options.transforms.size(); ++t) {
    std::array<Eigen::ArrayXf, 3> signals = signalsOf(table, options.transforms[t], *geometry, options.fill);
    EncodedCandidate& candidate = result.candidates.emplace_back();
    candidate.code.grid = table.grid();
    candidate.code.transform = options.transforms[t];
    parallelForBlocks(3, 1,
                      [&](std::size_t c, std::size_t) {
                        const float highest = highestOf(signals[c], table, *geometry);
                        candidate.code.channels[c] = encodeSignal(signals[c], table.valid(), options);
                        candidate.code.channels[c].highest = highest;
                      },
                      {.stop = control.stop});
    if (options.bytes) candidate.code = truncatedToBytes(candidate.code, *options.bytes);
    measure(candidate, table, *decode(ensemble_, candidate.code), options.gamma);
    control.report(double(t + 1) / double(options.transforms.size()));
  }
  const auto best = std::min_element(result.candidates.begin(), result.candidates.end(),
                                     [](const auto& a, const auto& b) { return a.gammaError < b.gammaError; });
  result.code = best->code;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace gonio::dictionary
