// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_blend.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <string>

#include "core/factorization/pdv_operations.h"
#include "core/support/error.h"

namespace gonio::factorization {

namespace {

using Curve = std::vector<double>;

void checkForms(std::span<const PdvFactors* const> ends) {
  for (const PdvFactors* end : ends) {
    if (end->transform != ends[0]->transform)
      throw Error("the transforms of the factors are " +
                  std::string(dataTransformNames[std::size_t(ends[0]->transform)]) + " and " +
                  std::string(dataTransformNames[std::size_t(end->transform)]) + "; expected the same");
    if (end->form != ends[0]->form)
      throw Error("factors of two curves and of three cannot be blended; expected the same form");
  }
}

Curve onNodes(const Curve& nodes, const Curve& curve, const Curve& newNodes) {
  return nodes == newNodes ? curve : resampled(nodes, curve, newNodes);
}

/// A term of `end` on the nodes of `axes`.
PdvTerm termOn(const PdvFactors& axes, const PdvFactors& end, const PdvTerm& term) {
  return {onNodes(end.thetaNodes, term.f1, axes.thetaNodes), onNodes(end.deviationNodes, term.f2, axes.deviationNodes),
          onNodes(end.phiNodes, term.f3, axes.phiNodes)};
}

void negate(Curve& curve) {
  for (double& value : curve) value = -value;
}

/// Turns one curve of a term to the side of another, and F1 with it: the term stays.
void turnToward(const Curve& other, Curve& curve, Curve& f1) {
  if (std::inner_product(curve.begin(), curve.end(), other.begin(), 0.0) >= 0) return;
  negate(curve);
  negate(f1);
}

void add(Curve& sum, const Curve& curve, double weight) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * curve[i];
}

void scale(Curve& curve, double factor) {
  for (double& value : curve) value *= factor;
}

/// One term of one channel. Its F2 and F3 are means over the ends that have it.
PdvTerm blendedTerm(std::span<const PdvFactors* const> ends, std::span<const double> weights, std::size_t channel,
                    std::size_t index) {
  const PdvFactors& axes = *ends[0];
  PdvTerm sum, reference;
  double share = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const std::vector<PdvTerm>& terms = ends[i]->channels[channel];
    if (!(weights[i] > 0) || index >= terms.size()) continue;
    PdvTerm term = termOn(axes, *ends[i], terms[index]);
    if (share == 0) {
      reference = term;
      sum = {Curve(term.f1.size(), 0.0), Curve(term.f2.size(), 0.0), Curve(term.f3.size(), 0.0)};
    }
    turnToward(reference.f2, term.f2, term.f1);
    turnToward(reference.f3, term.f3, term.f1);
    add(sum.f1, term.f1, weights[i]);
    add(sum.f2, term.f2, weights[i]);
    add(sum.f3, term.f3, weights[i]);
    share += weights[i];
  }
  scale(sum.f2, 1 / share);
  scale(sum.f3, 1 / share);
  return sum;
}

}  // namespace

PdvFactors blended(std::span<const PdvFactors* const> ends, std::span<const double> weights) {
  assert(!ends.empty() && ends.size() == weights.size());
  checkForms(ends);
  const auto whole = std::find(weights.begin(), weights.end(), 1.0);
  if (whole != weights.end()) return *ends[std::size_t(whole - weights.begin())];
  PdvFactors result = *ends[0];
  result.highest = 0;
  int terms = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    result.highest += weights[i] * ends[i]->highest;
    if (weights[i] > 0) terms = std::max(terms, ends[i]->terms());
  }
  for (std::size_t channel = 0; channel < 3; ++channel) {
    result.channels[channel].clear();
    for (std::size_t index = 0; index < std::size_t(terms); ++index)
      result.channels[channel].push_back(blendedTerm(ends, weights, channel, index));
  }
  return withRoomForEdits(result);
}

}  // namespace gonio::factorization
