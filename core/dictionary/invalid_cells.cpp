// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/invalid_cells.h"

#include <algorithm>

#include "core/dictionary/decode.h"
#include "core/dictionary/largest_projections.h"

namespace gonio::dictionary {

namespace {

/// Rows of mode 1 in a band: few, so that little is computed that has no invalid cell, but enough for a matrix product.
constexpr int bandRows = 6;

}  // namespace

std::vector<InvalidBand> invalidBands(std::span<const std::uint8_t> valid, const Sizes& sizes) {
  const Eigen::Index n0 = sizes[0], rowsOfSlice = n0 * sizes[1], sliceCount = sizes[2];
  std::vector<InvalidBand> bands;
  for (Eigen::Index first = 0; first < rowsOfSlice; first += bandRows * n0) {
    const Eigen::Index rows = std::min(bandRows * n0, rowsOfSlice - first);
    Eigen::Index slice = 0;
    const auto isComplete = [&](Eigen::Index s) {
      const auto begin = valid.begin() + (first + rowsOfSlice * s);
      return std::find(begin, begin + rows, std::uint8_t(0)) == begin + rows;
    };
    while (slice < sliceCount && isComplete(slice)) ++slice;
    if (slice < sliceCount) bands.push_back({first, rows, slice, sliceCount - slice});
  }
  return bands;
}

template <typename Scalar>
InvalidCellRefinement<Scalar>::InvalidCellRefinement(Eigen::Array<Scalar, Eigen::Dynamic, 1>& signal,
                                                     std::span<const std::uint8_t> valid, const Sizes& sizes,
                                                     const ModeMatrices<Scalar>& matrices)
    : signal_(signal.data()),
      valid_(valid),
      sizes_(sizes),
      matrices_(matrices),
      bands_(invalidBands(valid, sizes)),
      slices_(std::size_t(sizes[0]) * std::size_t(sizes[1]) * std::size_t(matrices[2].cols())) {
  transposedModeProduct(signal_, sizes, 2, matrices[2], slices_.data());
}

template <typename Scalar>
void InvalidCellRefinement<Scalar>::selectLargest(std::size_t count, std::vector<Coefficient<Scalar>>& selected) const {
  selectLargestOfSlices(slices_.data(), sizes_, matrices_, count, selected);
}

template <typename Scalar>
void InvalidCellRefinement<Scalar>::project(std::vector<Coefficient<Scalar>>& code) const {
  const Eigen::Index n0 = sizes_[0], n1 = sizes_[1], fibres = matrices_[1].cols(), atoms0 = matrices_[0].cols();
  std::sort(code.begin(), code.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
  Eigen::Matrix<Scalar, Eigen::Dynamic, 1> fibre(n0);
  Eigen::Index known = -1;
  for (Coefficient<Scalar>& c : code) {
    const Eigen::Index pair = Eigen::Index(c.index) / atoms0;
    if (pair != known) {
      const Eigen::Map<const Matrix<Scalar>> slice(slices_.data() + n0 * n1 * (pair / fibres), n0, n1);
      fibre.noalias() = slice * matrices_[1].col(pair % fibres);
      known = pair;
    }
    c.value = matrices_[0].col(Eigen::Index(c.index) % atoms0).dot(fibre);
  }
}

template <typename Scalar>
void InvalidCellRefinement<Scalar>::update(const std::vector<Coefficient<Scalar>>& code, Scalar momentum) {
  const Eigen::Index rowsOfSlice = Eigen::Index(sizes_[0]) * sizes_[1];
  const ComposedSlabs<Scalar> composed = composeSlabs(matrices_, code);
  Eigen::Map<Matrix<Scalar>> projected(slices_.data(), rowsOfSlice, matrices_[2].cols());
  const bool isFirst = decoded_.empty();
  decoded_.resize(bands_.size());
  Matrix<Scalar> now, change;
  for (std::size_t b = 0; b < bands_.size(); ++b) {
    const InvalidBand& band = bands_[b];
    now.noalias() = composed.slabs.middleRows(band.firstRow, band.rows) * composed.atoms.rightCols(band.slices);
    if (isFirst) decoded_[b] = now;
    change.resize(band.rows, band.slices);
    for (Eigen::Index s = 0; s < band.slices; ++s) {
      const Eigen::Index begin = band.firstRow + rowsOfSlice * (band.firstSlice + s);
      for (Eigen::Index row = 0; row < band.rows; ++row) {
        Scalar& value = signal_[begin + row];
        const Scalar next = now(row, s) + momentum * (now(row, s) - decoded_[b](row, s));
        const bool isValid = valid_[std::size_t(begin + row)] != 0;
        change(row, s) = isValid ? 0 : next - value;
        value = isValid ? value : next;
      }
    }
    decoded_[b].swap(now);
    projected.middleRows(band.firstRow, band.rows).noalias() += change * matrices_[2].bottomRows(band.slices);
  }
}

template class InvalidCellRefinement<float>;
template class InvalidCellRefinement<double>;

}  // namespace gonio::dictionary
