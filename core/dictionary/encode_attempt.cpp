// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/encode_attempt.h"

#include <algorithm>

#include "core/dictionary/basis_pursuit.h"
#include "core/math/parallel.h"

namespace gonio::dictionary {

namespace {

/// The least count of coefficients (larger in size first) that leaves at most `mostLeft` of the energy.
template <typename Scalar>
std::size_t countForError(const std::vector<Coefficient<Scalar>>& coefficients, double energy, double mostLeft) {
  std::size_t n = 0;
  for (double left = energy; n < coefficients.size() && left > mostLeft * energy; ++n)
    left -= double(coefficients[n].value) * double(coefficients[n].value);
  return n;
}

}  // namespace

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

template class EncodeAttempt<float>;
template class EncodeAttempt<double>;

}  // namespace gonio::dictionary
