// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/atom_scores.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/math/parallel.h"

namespace gonio::acquisition {

CellAtoms::CellAtoms(const dictionary::PrincipalComponents& basis, int components, std::vector<std::size_t> rows,
                     AtomLengths lengths)
    : basis_(basis),
      inverseSigma_(basis.svd.singularValues[components - 1] *
                    basis.svd.singularValues.head(components).cwiseInverse()),
      rows_(std::move(rows)) {
  if (lengths == AtomLengths::unit) return;
  double longest = 0;
  for (const std::size_t row : rows_) longest = std::max(longest, column(row).norm());
  scale_ = longest > 0 ? 1 / longest : 1;
}

Eigen::VectorXd CellAtoms::column(std::size_t row) const {
  return basis_.svd.u.view()
      .row(Eigen::Index(row))
      .head(length())
      .transpose()
      .cast<double>()
      .cwiseProduct(inverseSigma_);
}

Eigen::MatrixXf CellAtoms::inSinglePrecision(Eigen::Index begin, Eigen::Index end) const {
  const auto u = basis_.svd.u.view();
  constexpr float shortest = 1e-15f;
  Eigen::MatrixXf atoms(length(), end - begin);
  for (Eigen::Index k = 0; k < length(); ++k)
    for (Eigen::Index atom = begin; atom < end; ++atom)
      atoms(k, atom - begin) = float(u(Eigen::Index(row(atom)), k) * inverseSigma_[k]);
  for (Eigen::Index atom = begin; atom < end; ++atom) {
    auto column = atoms.col(atom - begin);
    const float norm = column.norm();
    // Below this digits are lost; 0 stays 0.
    if (norm > shortest)
      column *= scale_ > 0 ? float(scale_) : 1 / norm;
    else
      column = exact(atom).cast<float>();
  }
  return atoms;
}

PursuitSpace::PursuitSpace(const Eigen::MatrixXd& allSignals)
    : complement(Eigen::MatrixXd::Identity(allSignals.rows(), allSignals.rows())), signals(allSignals) {}

void PursuitSpace::remove(const Eigen::VectorXd& left) {
  const Eigen::VectorXd direction = left.stableNormalized();
  removed = complement * direction;
  reach = (signals.transpose() * direction).lpNorm<1>();
  // H = I - 2 v v^T takes `direction` to an axis, that of the sign without cancellation; the others then span the rest.
  Eigen::VectorXd v = direction;
  v[0] += std::copysign(1.0, direction[0]);
  v.normalize();
  const Eigen::VectorXd alongComplement = complement * v;
  const Eigen::RowVectorXd alongSignals = v.transpose() * signals;
  const Eigen::Index others = left.size() - 1;
  complement = (complement.rightCols(others) - 2 * alongComplement * v.tail(others).transpose()).eval();
  signals = (signals.bottomRows(others) - 2 * v.tail(others) * alongSignals).eval();
}

namespace {

constexpr Eigen::Index blockAtoms = 1024;  // of 60 components: 240 KB, which stay in a core's cache
constexpr Eigen::Index batchAtoms = 256;   // scored at once
/// Number of neighbours on the grid that are bounded together through the one in their middle where possible.
constexpr Eigen::Index groupAtoms = 8;
/// Number of choices after which the atoms are rewritten in the shorter coordinates of the remaining space.
constexpr Eigen::Index choicesBetweenBases = 8;
constexpr double unitRoundoff = 6e-8;
constexpr float huge = 1e30f;
constexpr float roundedUp = 1 + 1e-5f;

void raise(std::atomic<float>& best, float value) {
  float seen = best.load(std::memory_order_relaxed);
  while (value > seen && !best.compare_exchange_weak(seen, value, std::memory_order_relaxed)) {
  }
}

/// The atom in the middle of an atom's group.
Eigen::Index middleOf(Eigen::Index atom, Eigen::Index count) {
  const Eigen::Index begin = atom / groupAtoms * groupAtoms;
  return (begin + std::min(begin + groupAtoms, count)) / 2;
}

}  // namespace

/// The working data of one call of candidates().
struct AtomScores::Scan {
  Eigen::VectorXf removed;  ///< in coordinates of the basis; empty before the first choice
  float reach = 0;
  Eigen::MatrixXf towardsNew;          ///< (new basis)^T basis; empty when it stays
  Eigen::MatrixXf transposedResidual;  ///< t x d', in the basis after this step
  float gain = 0;
  float scoreError = 0;         ///< of an evaluated score
  float normError = 0;          ///< of a squared norm that choices were subtracted from
  std::atomic<float> best = 0;  ///< the largest score yet
};

/// The evaluation of one block.
struct AtomScores::BlockScan {
  Block& block;
  Scan& scan;
  std::vector<std::pair<float, Eigen::Index>>& found;
  Eigen::ArrayXf bound;  ///< of every atom's score
  std::vector<Eigen::Index> batch;
  Eigen::MatrixXf gathered, products;

  bool mayWin(Eigen::Index atom) const {
    return bound[atom] + 2 * scan.scoreError >= scan.best.load(std::memory_order_relaxed);
  }
  void add(Eigen::Index atom) {
    batch.push_back(atom);
    if (Eigen::Index(batch.size()) == batchAtoms) evaluate();
  }
  /// The scores of the batch.
  void evaluate() {
    gathered.resize(block.atoms.rows(), Eigen::Index(batch.size()));
    for (std::size_t k = 0; k < batch.size(); ++k) gathered.col(Eigen::Index(k)) = block.atoms.col(batch[k]);
    products.noalias() = scan.transposedResidual * gathered;
    for (std::size_t k = 0; k < batch.size(); ++k) {
      const Eigen::Index atom = batch[k];
      const float value = products.col(Eigen::Index(k)).lpNorm<1>();
      block.score[atom] = bound[atom] = value;
      block.growth[atom] = 0;
      block.squaredNormAtScore[atom] = block.squaredNorm[atom];
      found.emplace_back(value, atom);
      raise(scan.best, value);
    }
    batch.clear();
  }
  /// A score differs from that of the group's middle by at most gain times the distance.
  void boundByMiddle(Eigen::Index begin, Eigen::Index middle) {
    const Eigen::Index count = std::min(groupAtoms, bound.size() - begin);
    auto group = bound.segment(begin, count);
    group = group.min(bound[middle] + 2 * scan.scoreError + scan.gain * block.distance.segment(begin, count));
  }
  Eigen::Index winners(Eigen::Index begin) const {
    Eigen::Index count = 0;
    for (Eigen::Index atom = begin; atom < std::min(begin + groupAtoms, bound.size()); ++atom) count += mayWin(atom);
    return count;
  }
};

AtomScores::AtomScores(const CellAtoms& atoms, double gain)
    : blocks_(std::size_t((atoms.count() + blockAtoms - 1) / blockAtoms)),
      basis_(Eigen::MatrixXd::Identity(atoms.length(), atoms.length())),
      gain_(gain),
      coordinateError_(unitRoundoff * double(atoms.length() + 4)) {
  parallelForBlocks(std::size_t(atoms.count()), std::size_t(blockAtoms), [&](std::size_t begin, std::size_t end) {
    Block& block = blocks_[begin / std::size_t(blockAtoms)];
    block.atoms = atoms.inSinglePrecision(Eigen::Index(begin), Eigen::Index(end));
    const Eigen::Index count = block.atoms.cols();
    block.squaredNorm.setOnes(count);
    block.score.setConstant(count, huge);
    block.growth.setZero(count);
    block.squaredNormAtScore.setOnes(count);
    block.highest = huge;
    measureDistances(block);
  });
}

void AtomScores::measureDistances(Block& block) {
  block.distance.resize(block.atoms.cols());
  for (Eigen::Index atom = 0; atom < block.atoms.cols(); ++atom)
    block.distance[atom] =
        roundedUp * (block.atoms.col(atom) - block.atoms.col(middleOf(atom, block.atoms.cols()))).norm();
}

void AtomScores::exclude(Eigen::Index atom) {
  blocks_[std::size_t(atom / blockAtoms)].score[atom % blockAtoms] = -huge;
}

/// Takes account of the direction that was removed.
void AtomScores::update(Block& block, const Scan& scan) const {
  if (scan.removed.size() == 0) return;
  const Eigen::ArrayXf along = (scan.removed.transpose() * block.atoms).transpose().array();
  block.growth += along.abs() * scan.reach;
  if (scan.towardsNew.size() > 0) {
    block.atoms = (scan.towardsNew * block.atoms).eval();
    block.squaredNorm = block.atoms.colwise().squaredNorm().transpose().array();
    measureDistances(block);
  } else {
    block.squaredNorm = (block.squaredNorm - along.square()).max(0);
  }
}

/// Upper bounds of the atoms' scores.
Eigen::ArrayXf AtomScores::bounds(const Block& block, const Scan& scan) const {
  const Eigen::ArrayXf byLength = scan.gain * (block.squaredNorm + scan.normError).sqrt();
  const Eigen::ArrayXf lost = (block.squaredNormAtScore - block.squaredNorm).max(0) + 2 * scan.normError;
  const Eigen::ArrayXf byHistory = block.score + block.growth.min(scan.gain * lost.sqrt());
  return byLength.min(byHistory);
}

void AtomScores::scoreBlock(Block& block, Scan& scan, std::vector<std::pair<float, Eigen::Index>>& found) const {
  update(block, scan);
  BlockScan work{block, scan, found, bounds(block, scan), {}, {}, {}};
  const Eigen::Index count = work.bound.size();
  std::vector<Eigen::Index> open;  // the first atoms of groups that may have a winner
  for (Eigen::Index begin = 0; begin < count; begin += groupAtoms) {
    if (work.winners(begin) == 0) continue;
    const Eigen::Index middle = middleOf(begin, count);
    if (block.score[middle] < 0) {  // it is excluded and carries no information
      open.push_back(begin);
      continue;
    }
    work.boundByMiddle(begin, middle);
    if (work.winners(begin) == 0) continue;
    open.push_back(begin);
    work.add(middle);
  }
  if (!work.batch.empty()) work.evaluate();
  for (const Eigen::Index begin : open) {
    const Eigen::Index middle = middleOf(begin, count);
    const bool known = block.score[middle] >= 0;
    if (known) work.boundByMiddle(begin, middle);
    for (Eigen::Index atom = begin; atom < std::min(begin + groupAtoms, count); ++atom)
      if (!(known && atom == middle) && work.mayWin(atom)) work.add(atom);
  }
  if (!work.batch.empty()) work.evaluate();
  block.highest = work.bound.maxCoeff();
}

std::vector<Eigen::Index> AtomScores::candidates(const PursuitSpace& space, const TaskControl& control) {
  Scan scan;
  scan.gain = float(gain_);
  if (space.removed.size() > 0) {
    scan.removed = (basis_.transpose() * space.removed).cast<float>();
    scan.reach = float(space.reach);
  }
  if (basis_.cols() - space.complement.cols() >= choicesBetweenBases) {
    scan.towardsNew = (space.complement.transpose() * basis_).cast<float>();
    coordinateError_ += unitRoundoff * double(basis_.cols() + 2) * std::sqrt(double(space.complement.cols()));
    basis_ = space.complement;
  }
  scan.transposedResidual = (space.signals.transpose() * (space.complement.transpose() * basis_)).cast<float>();
  const double length = double(basis_.cols()), signals = double(space.signals.cols());
  scan.scoreError = float(gain_ * (coordinateError_ + unitRoundoff * (signals / 8 + 16)) +
                          unitRoundoff * (length + 4) * space.signals.colwise().norm().sum());
  scan.normError = float(2 * coordinateError_ + unitRoundoff * 8 * (length + 8));

  std::vector<std::size_t> order(blocks_.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return blocks_[a].highest > blocks_[b].highest; });
  std::vector<std::vector<std::pair<float, Eigen::Index>>> found(blocks_.size());
  parallelForBlocks(
      order.size(), 1, [&](std::size_t i, std::size_t) { scoreBlock(blocks_[order[i]], scan, found[order[i]]); },
      control);

  std::vector<Eigen::Index> result;
  const float least = scan.best - 2 * scan.scoreError;
  for (std::size_t block = 0; block < blocks_.size(); ++block)
    for (const auto& [score, atom] : found[block])
      if (score >= least) result.push_back(Eigen::Index(block) * blockAtoms + atom);
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace gonio::acquisition
