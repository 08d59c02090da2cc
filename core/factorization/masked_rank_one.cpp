// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/masked_rank_one.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math/parallel.h"

namespace gonio::factorization {

namespace {

constexpr std::size_t rowsOfABlock = 6;

double ratio(double above, double below) { return below > 0 ? above / below : 0; }

/// One behind the last cell that counts, for each row along the last mode. Often these are short.
std::vector<std::size_t> rowEnds(const MaskedTensor& t) {
  const auto length = std::size_t(t.sizes[2]);
  std::vector<std::size_t> ends(std::size_t(t.sizes[0]) * std::size_t(t.sizes[1]), length);
  for (std::size_t row = 0; row < ends.size(); ++row)
    while (ends[row] > 0 && !(t.weights[row * length + ends[row] - 1] > 0)) --ends[row];
  return ends;
}

/// The data of the tensor that a sweep needs: sums over the last mode for all (i, j), then sums over the first two.
class Sweep {
 public:
  Sweep(const MaskedTensor& tensor, RankOne& term, bool nonnegative)
      : t_(tensor),
        term_(term),
        nonnegative_(nonnegative),
        m_(std::size_t(tensor.sizes[0])),
        n_(std::size_t(tensor.sizes[1])),
        p_(std::size_t(tensor.sizes[2])),
        above_(m_ * n_),
        below_(m_ * n_),
        c_(p_),
        ends_(rowEnds(tensor)) {}

  /// One round of updates; the fall of the squared norm that the term now explains.
  double run() {
    contractLast();
    // Both factors live on small matrices now: a few rounds cost nothing.
    for (int round = 0; round < 3; ++round) {
      updateA();
      updateB();
    }
    return updateC();
  }

 private:
  /// The minimum of a parabola; under the bound 0 where it would lie below.
  double entry(double above, double below) const { return nonnegative_ && above < 0 ? 0 : ratio(above, below); }

  void contractLast() {
    for (std::size_t k = 0; k < p_; ++k) c_[k] = float(term_.c[k]);
    parallelForBlocks(m_, rowsOfABlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin * n_; row < end * n_; ++row) contractRow(row);
    });
  }

  void contractRow(std::size_t row) {
    constexpr std::size_t lanes = 8;
    const float *values = t_.values.data() + row * p_, *weights = t_.weights.data() + row * p_;
    const std::size_t count = ends_[row];
    float sums[lanes] = {}, squares[lanes] = {};
    std::size_t k = 0;
    for (; k + lanes <= count; k += lanes)
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const float weighted = weights[k + lane] * c_[k + lane];
        sums[lane] += weighted * values[k + lane];
        squares[lane] += weighted * c_[k + lane];
      }
    double sum = 0, square = 0;
    for (std::size_t lane = 0; lane < lanes; ++lane) sum += sums[lane], square += squares[lane];
    for (; k < count; ++k) {
      const float weighted = weights[k] * c_[k];
      sum += weighted * values[k], square += weighted * c_[k];
    }
    above_[row] = sum;
    below_[row] = square;
  }

  void updateA() {
    for (std::size_t i = 0; i < m_; ++i) {
      double sum = 0, square = 0;
      for (std::size_t j = 0; j < n_; ++j) {
        sum += above_[i * n_ + j] * term_.b[j];
        square += below_[i * n_ + j] * term_.b[j] * term_.b[j];
      }
      term_.a[i] = entry(sum, square);
    }
  }

  void updateB() {
    std::vector<double> sum(n_, 0.0), square(n_, 0.0);
    for (std::size_t i = 0; i < m_; ++i)
      for (std::size_t j = 0; j < n_; ++j) {
        sum[j] += above_[i * n_ + j] * term_.a[i];
        square[j] += below_[i * n_ + j] * term_.a[i] * term_.a[i];
      }
    for (std::size_t j = 0; j < n_; ++j) term_.b[j] = entry(sum[j], square[j]);
  }

  double updateC() {
    const std::size_t blocks = (m_ + rowsOfABlock - 1) / rowsOfABlock;
    std::vector<double> sums(blocks * p_, 0.0), squares(blocks * p_, 0.0);
    parallelForBlocks(m_, rowsOfABlock, [&](std::size_t begin, std::size_t end) {
      double* sum = sums.data() + begin / rowsOfABlock * p_;
      double* square = squares.data() + begin / rowsOfABlock * p_;
      std::vector<float> rowSum(p_), rowSquare(p_);
      for (std::size_t i = begin; i < end; ++i) {
        std::fill(rowSum.begin(), rowSum.end(), 0.0f);
        std::fill(rowSquare.begin(), rowSquare.end(), 0.0f);
        for (std::size_t j = 0; j < n_; ++j) {
          const std::size_t row = i * n_ + j, count = ends_[row];
          const float product = float(term_.a[i] * term_.b[j]);
          const float *values = t_.values.data() + row * p_, *weights = t_.weights.data() + row * p_;
          for (std::size_t k = 0; k < count; ++k) {
            const float weighted = product * weights[k];
            rowSum[k] += weighted * values[k];
            rowSquare[k] += weighted * product;
          }
        }
        for (std::size_t k = 0; k < p_; ++k) sum[k] += rowSum[k], square[k] += rowSquare[k];
      }
    });
    double explained = 0;
    for (std::size_t k = 0; k < p_; ++k) {
      double sum = 0, square = 0;
      for (std::size_t block = 0; block < blocks; ++block) {
        sum += sums[block * p_ + k];
        square += squares[block * p_ + k];
      }
      term_.c[k] = entry(sum, square);
      explained += sum * term_.c[k];
    }
    return explained;
  }

  const MaskedTensor& t_;
  RankOne& term_;
  bool nonnegative_;
  std::size_t m_, n_, p_;
  std::vector<double> above_, below_;
  std::vector<float> c_;
  std::vector<std::size_t> ends_;
};

/// Means over the cells that count, at least 0, for a start inside of the positive factors.
RankOne marginalMeans(const MaskedTensor& t) {
  RankOne start;
  std::vector<double>* factors[] = {&start.a, &start.b, &start.c};
  for (int mode = 0; mode < 3; ++mode) {
    std::vector<double> sum(std::size_t(t.sizes[mode]), 0.0), count(sum.size(), 0.0);
    std::size_t at = 0;
    int index[3];
    for (index[0] = 0; index[0] < t.sizes[0]; ++index[0])
      for (index[1] = 0; index[1] < t.sizes[1]; ++index[1])
        for (index[2] = 0; index[2] < t.sizes[2]; ++index[2], ++at) {
          sum[std::size_t(index[mode])] += double(t.weights[at]) * double(t.values[at]);
          count[std::size_t(index[mode])] += double(t.weights[at]);
        }
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = std::max(0.0, ratio(sum[i], count[i]));
    *factors[mode] = sum;
  }
  return start;
}

/// The fibres through the entry of the largest part in the norm: exact where the tensor has rank one.
RankOne crossOfLargest(const MaskedTensor& t) {
  std::size_t largest = 0;
  float most = 0;
  for (std::size_t at = 0; at < t.values.size(); ++at) {
    const float part = t.weights[at] * t.values[at] * t.values[at];
    if (part > most) most = part, largest = at;
  }
  const int at = int(largest), n = t.sizes[1], p = t.sizes[2];
  const int i = at / (n * p), j = at / p % n, k = at % p;
  const auto entry = [&](int x, int y, int z) {
    const std::size_t cell = t.index(x, y, z);
    return t.weights[cell] > 0 ? double(t.values[cell]) : 0;
  };
  RankOne start;
  for (int x = 0; x < t.sizes[0]; ++x) start.a.push_back(entry(x, j, k));
  for (int x = 0; x < n; ++x) start.b.push_back(entry(i, x, k));
  for (int x = 0; x < p; ++x) start.c.push_back(entry(i, j, x));
  return start;
}

/// Moves the size of b and c into a.
void gatherStrength(RankOne& term) {
  for (std::vector<double>* factor : {&term.b, &term.c}) {
    double largest = 0;
    for (const double value : *factor)
      if (std::abs(value) > std::abs(largest)) largest = value;
    if (largest == 0) continue;
    for (double& value : *factor) value /= largest;
    for (double& value : term.a) value *= largest;
  }
}

/// A power of two that brings values of a size at which single precision loses their products to about 1; 1 for all
/// others.
double scaleToOne(const MaskedTensor& tensor) {
  constexpr int mostExponent = 50;
  float largest = 0;
  for (std::size_t i = 0; i < tensor.values.size(); ++i)
    if (tensor.weights[i] > 0) largest = std::max(largest, std::abs(tensor.values[i]));
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  return std::abs(exponent) > mostExponent ? std::ldexp(1.0, -exponent) : 1;
}

}  // namespace

double MaskedTensor::squaredNorm() const {
  constexpr std::size_t block = 1 << 14;
  return parallelSumBlocks(values.size(), block, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += double(weights[i]) * double(values[i]) * double(values[i]);
    return sum;
  });
}

RankOne bestRankOne(const MaskedTensor& tensor, const RankOneOptions& options) {
  if (const double scale = scaleToOne(tensor); scale != 1) {
    MaskedTensor scaled = tensor;
    for (float& value : scaled.values) value = float(double(value) * scale);
    RankOne term = bestRankOne(scaled, options);
    for (double& entry : term.a) entry /= scale;
    for (double& residual : term.residuals) residual /= scale * scale;
    return term;
  }
  RankOne term = options.nonnegative ? marginalMeans(tensor) : crossOfLargest(tensor);
  const double squaredNorm = tensor.squaredNorm();
  term.residuals.push_back(squaredNorm);
  Sweep sweep(tensor, term, options.nonnegative);
  for (int n = 0; n < options.maxSweeps && squaredNorm > 0; ++n) {
    const double before = term.residuals.back();
    // Single precision inside of the sums: a rise of its size is none.
    term.residuals.push_back(std::clamp(squaredNorm - sweep.run(), 0.0, before));
    if (before - term.residuals.back() <= options.tolerance * before) break;
  }
  gatherStrength(term);
  return term;
}

void subtract(MaskedTensor& tensor, const RankOne& term) {
  const std::size_t n = std::size_t(tensor.sizes[1]), p = std::size_t(tensor.sizes[2]);
  parallelForBlocks(std::size_t(tensor.sizes[0]), rowsOfABlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const double weight = term.a[i] * term.b[j];
        for (std::size_t k = 0, at = (i * n + j) * p; k < p; ++k, ++at) tensor.values[at] -= float(weight * term.c[k]);
      }
  });
}

}  // namespace gonio::factorization
