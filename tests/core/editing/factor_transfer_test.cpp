// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/factor_edit.h"

#include <QTest>
#include <cmath>

#include "core/factorization/pdv_operations.h"
#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace factor_transfer_test {
using namespace gonio;
using namespace gonio::editing;
using namespace gonio::test;
using factorization::PdvFactors;
using factorization::PdvForm;

/// Two terms: Gaussians of a width over |Dp| and F1 = strength (1 + theta), on nodes of its own.
PdvFactors gaussian(double strength, double width, int deviations = 90) {
  PdvFactors f{.form = PdvForm::threeFactors, .highest = 20};
  for (int i = 0; i < 40; ++i) f.thetaNodes.push_back(i / 26.0);
  for (int i = 0; i < deviations; ++i)
    f.deviationNodes.push_back(2.0 * i * i / ((deviations - 1.0) * (deviations - 1)));
  f.phiNodes = {0, 1, 2, pi};
  for (std::size_t c = 0; c < 3; ++c)
    for (const double fraction : {1.0, -0.1}) {
      factorization::PdvTerm term{.f1 = {}, .f2 = {}, .f3 = {1, 0.9, 0.8, 0.7}};
      for (const double theta : f.thetaNodes) term.f1.push_back(fraction * strength * double(c + 1) * (1 + theta));
      for (const double deviation : f.deviationNodes) term.f2.push_back(std::exp(-std::pow(deviation / width, 2)));
      f.channels[c].push_back(term);
    }
  return f;
}

FactorEdit::Curves shared(const PdvFactors& factors) { return std::make_shared<const PdvFactors>(factors); }

double maxDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference = std::max(difference, std::abs(a[i] - b[i]));
  return difference;
}

const PdvFactors source = gaussian(1, 0.2), target = gaussian(3, 0.5, 70);

class FactorTransferTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void ontoItsOwnCurvesItIsTheEditItself() {
    const FactorEdit edit{.original = shared(source), .edited = shared(gaussian(2, 0.7)), .preserveDetail = false};
    QVERIFY(transferredEdit(edit, shared(source)) == edit);
    const FactorEdit other = transferredEdit(edit, shared(target));
    QVERIFY(*other.original == target && !other.preserveDetail);
  }

  void anIdentityStaysOne() {
    const FactorEdit edit{.original = shared(source), .edited = shared(source)};
    const FactorEdit other = transferredEdit(edit, shared(target));
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t term = 0; term < 2; ++term) {
        const auto &a = other.edited->channels[c][term], &b = target.channels[c][term];
        QVERIFY(maxDifference(a.f1, b.f1) + maxDifference(a.f2, b.f2) + maxDifference(a.f3, b.f3) < 1e-12);
      }
  }

  /// Stronger by a function of the angle: the target's own curve times it, in every term and colour.
  void strengthGoesByRatio() {
    PdvFactors edited = source;
    for (auto& channel : edited.channels)
      for (auto& term : channel)
        term.f1 = factorization::tilted(source.thetaNodes, factorization::scaled(term.f1, 2), 0.5);
    const FactorEdit other = transferredEdit({.original = shared(source), .edited = shared(edited)}, shared(target));
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t term = 0; term < 2; ++term) {
        const auto& own = target.channels[c][term].f1;
        const auto expected = factorization::tilted(target.thetaNodes, factorization::scaled(own, 2), 0.5);
        QVERIFY(maxDifference(other.edited->channels[c][term].f1, expected) < 1e-9);
      }
    QVERIFY(other.edited->highest >= 20);
  }

  /// A Gaussian of width w widened by 1.5 is one of width 1.5 w: the same of another width, on other nodes.
  void widthGoesByStretch() {
    const FactorEdit edit{.original = shared(source), .edited = shared(factorization::widenF2(source, 1.5))};
    const PdvFactors expected = gaussian(3, 0.5 * 1.5, 70);
    const FactorEdit other = transferredEdit(edit, shared(target));
    for (std::size_t term = 0; term < 2; ++term)
      QVERIFY(maxDifference(other.edited->channels[1][term].f2, expected.channels[1][term].f2) < 0.01);
    QVERIFY(maxDifference(other.edited->channels[1][0].f1, target.channels[1][0].f1) < 1e-9);
  }

  /// A halo drawn at 2.5 widths appears at 2.5 widths, as high; only in the first term.
  void whatIsNoStretchIsAddedInUnitsOfTheWidth() {
    PdvFactors edited = source;
    const auto halo = [](double x, double width) {
      return 0.2 * std::exp(-std::pow((x - 2.5 * width) / (0.5 * width), 2));
    };
    auto& f2 = edited.channels[2][0].f2;
    for (std::size_t i = 0; i < f2.size(); ++i) f2[i] += halo(source.deviationNodes[i], 0.2);
    const FactorEdit other = transferredEdit({.original = shared(source), .edited = shared(edited)}, shared(target));
    std::vector<double> expected = target.channels[2][0].f2;
    for (std::size_t i = 0; i < expected.size(); ++i) expected[i] += halo(target.deviationNodes[i], 0.5);
    QVERIFY(maxDifference(other.edited->channels[2][0].f2, expected) < 0.02);
    QVERIFY(maxDifference(other.edited->channels[2][1].f2, target.channels[2][1].f2) < 1e-12);
    QVERIFY(maxDifference(other.edited->channels[1][0].f2, target.channels[1][0].f2) < 1e-12);
  }

  void termsThatTheEditDroppedAreDropped() {
    const FactorEdit edit{.original = shared(source), .edited = shared(source.truncated(1))};
    QCOMPARE(transferredEdit(edit, shared(target)).edited->terms(), 1);
    QCOMPARE(transferredEdit(edit, shared(target)).original->terms(), 2);
  }

  /// Nothing to compare with: a black channel, a curve of zeros, stays finite and as it is.
  void blackChannelsStayFinite() {
    PdvFactors black = source, edited = source;
    for (auto* one : {&black, &edited})
      for (auto& term : one->channels[0]) term.f1.assign(term.f1.size(), 0), term.f2.assign(term.f2.size(), 0);
    edited.channels[0][0].f1.assign(edited.channels[0][0].f1.size(), 0.5);
    const FactorEdit other = transferredEdit({.original = shared(black), .edited = shared(edited)}, shared(target));
    QVERIFY(maxDifference(other.edited->channels[0][0].f1, target.channels[0][0].f1) == 0);
    for (const auto& channel : other.edited->channels)
      for (const auto& term : channel)
        for (const auto* curve : {&term.f1, &term.f2, &term.f3})
          QVERIFY(std::all_of(curve->begin(), curve->end(), [](double value) { return std::isfinite(value); }));
  }

  void unlikeFactorsAreRefused() {
    PdvFactors flat = target, root = target;
    flat.form = PdvForm::twoFactors;
    root.transform = DataTransform::root;
    const FactorEdit edit{.original = shared(source), .edited = shared(source)};
    for (const PdvFactors& other : {flat, root})
      QVERIFY(!errorOf([&] { transferredEdit(edit, shared(other)); }).empty());
    QVERIFY(!errorOf([&] { transferredEdit(edit, nullptr); }).empty());
  }
};

GONIO_TEST(FactorTransferTest)
}  // namespace factor_transfer_test

#include "factor_transfer_test.moc"
