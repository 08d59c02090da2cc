// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/joint_terms.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/factorization/pdv_factors.h"
#include "core/factorization/pdv_samples.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace joint_terms_test {
using namespace gonio;
using namespace gonio::factorization;

/// Random factors of both signs.
std::vector<RankOne> randomTerms(int count, const int (&sizes)[3], unsigned seed) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<RankOne> terms;
  for (int l = 0; l < count; ++l) {
    RankOne term;
    for (auto [factor, size] : {std::pair(&term.a, sizes[0]), {&term.b, sizes[1]}, {&term.c, sizes[2]}})
      for (int i = 0; i < size; ++i) factor->push_back(uniform(generator));
    terms.push_back(std::move(term));
  }
  return terms;
}

/// The sum of terms with random weights, some of them 0.
MaskedTensor tensorOf(const std::vector<RankOne>& terms, const int (&sizes)[3], unsigned seed) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<float> uniform(0.1f, 2);
  MaskedTensor tensor;
  std::copy(sizes, sizes + 3, tensor.sizes);
  const std::size_t cells = std::size_t(sizes[0]) * std::size_t(sizes[1]) * std::size_t(sizes[2]);
  tensor.values.assign(cells, 0);
  for (RankOne term : terms) {
    for (double& value : term.a) value = -value;
    subtract(tensor, term);
  }
  for (std::size_t i = 0; i < cells; ++i) tensor.weights.push_back(i % 7 == 3 ? 0.f : uniform(generator));
  return tensor;
}

std::vector<RankOne> oneByOne(MaskedTensor tensor, int count) {
  std::vector<RankOne> terms;
  for (int l = 0; l < count; ++l) {
    terms.push_back(bestRankOne(tensor, {.nonnegative = false}));
    subtract(tensor, terms.back());
  }
  return terms;
}

double squaredNormLeft(MaskedTensor tensor, const std::vector<RankOne>& terms) {
  for (const RankOne& term : terms) subtract(tensor, term);
  return tensor.squaredNorm();
}

/// A table that no few terms represent exactly.
std::shared_ptr<const TabulatedBrdf> glossyTable() {
  return bakeTable(*test::ggx(Rgb(0.1, 0.2, 0.05), Rgb(0.9, 0.5, 0.6), 0.15, 0.05),
                   {.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 60});
}

class JointTermsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Three terms that are not orthogonal: one after the other does not find them, together they are exact.
  void plantedTermsAreFound() {
    constexpr int sizes[3] = {9, 8, 7};
    const MaskedTensor tensor = tensorOf(randomTerms(3, sizes, 2), sizes, 3);
    std::vector<RankOne> terms = oneByOne(tensor, 3);
    const double norm = tensor.squaredNorm(), before = squaredNormLeft(tensor, terms);
    QVERIFY(before > 1e-3 * norm);
    const auto residuals = refineJointly(tensor, terms, {.maxSweeps = 3000, .tolerance = 0});
    QVERIFY2(residuals.back() < 1e-8 * norm, QByteArray::number(residuals.back() / norm));
    QVERIFY(squaredNormLeft(tensor, terms) < 1e-8 * norm);
    for (const RankOne& term : terms) {
      QCOMPARE(*std::ranges::max_element(term.b, {}, [](double x) { return std::abs(x); }), 1.0);
      QCOMPARE(*std::ranges::max_element(term.c, {}, [](double x) { return std::abs(x); }), 1.0);
    }
  }

  /// At the end no entry of a factor can be changed to lower the error, by finite differences of the error.
  void theEndIsStationary() {
    constexpr int sizes[3] = {6, 5, 4};
    MaskedTensor tensor = tensorOf(randomTerms(6, sizes, 5), sizes, 6);
    std::vector<RankOne> terms = oneByOne(tensor, 2);
    const double end = refineJointly(tensor, terms, {.maxSweeps = 5000, .tolerance = 0}).back();
    QVERIFY(end > 1e-2 * tensor.squaredNorm());
    for (std::size_t l = 0; l < terms.size(); ++l)
      for (auto factor : {&RankOne::a, &RankOne::b, &RankOne::c})
        for (std::size_t i = 0; i < (terms[l].*factor).size(); ++i)
          for (const double step : {-0.02, 0.02}) {
            std::vector<RankOne> changed = terms;
            (changed[l].*factor)[i] += step;
            QVERIFY(squaredNormLeft(tensor, changed) > end * (1 - 1e-5));
          }
  }

  void neverWorseAndTheFirstTermStaysPositive() {
    constexpr int sizes[3] = {8, 7, 6};
    for (unsigned seed = 0; seed < 12; ++seed) {
      MaskedTensor tensor = tensorOf(randomTerms(5, sizes, seed), sizes, seed + 50);
      for (float& value : tensor.values) value = std::abs(value);
      std::vector<RankOne> terms;
      MaskedTensor left = tensor;
      for (int l = 0; l < 4; ++l) {
        terms.push_back(bestRankOne(left, {.nonnegative = l == 0}));
        subtract(left, terms.back());
      }
      const auto residuals = refineJointly(tensor, terms, {.firstNonnegative = true});
      QVERIFY(std::abs(residuals.front() / left.squaredNorm() - 1) < 1e-5);
      QVERIFY(std::ranges::is_sorted(residuals, std::greater<>()));
      QVERIFY(residuals.back() < 0.95 * residuals.front());
      QVERIFY(std::abs(squaredNormLeft(tensor, terms) / residuals.back() - 1) < 1e-6);
      for (const auto* factor : {&terms[0].a, &terms[0].b, &terms[0].c})
        for (const double value : *factor) QVERIFY(value >= 0);
    }
  }

  /// Black tensors, no terms and an index without any weight.
  void degenerateCases() {
    constexpr int sizes[3] = {5, 4, 3};
    MaskedTensor tensor = tensorOf(randomTerms(3, sizes, 8), sizes, 9);
    std::vector<RankOne> none;
    QCOMPARE(refineJointly(tensor, none).size(), std::size_t(1));
    for (int j = 0; j < sizes[1]; ++j)
      for (int k = 0; k < sizes[2]; ++k) tensor.weights[tensor.index(2, j, k)] = 0;
    std::vector<RankOne> terms = oneByOne(tensor, 2);
    refineJointly(tensor, terms);
    for (const RankOne& term : terms)
      for (const auto* factor : {&term.a, &term.b, &term.c})
        for (const double value : *factor) QVERIFY(std::isfinite(value));
    MaskedTensor black = tensor;
    std::fill(black.values.begin(), black.values.end(), 0.f);
    std::vector<RankOne> zero = oneByOne(black, 2);
    QCOMPARE(refineJointly(black, zero), std::vector<double>{0});
    std::stop_source source;
    source.request_stop();
    QVERIFY_EXCEPTION_THROWN(refineJointly(tensor, terms, {}, {.stop = source.get_token(), .progress = {}}), Cancelled);
  }

  /// Through the factorisation of a table: the residual is lower, and it is that of the factors, recomputed from the
  /// samples of the table.
  void jointFactorsOfATable() {
    const auto table = glossyTable();
    for (const PdvForm form : {PdvForm::twoFactors, PdvForm::threeFactors}) {
      const PdvFactorization one = factorizePdv(*table, {.form = form, .terms = 4});
      const PdvFactorization joint = factorizePdv(*table, {.form = form, .terms = 4, .joint = true});
      QCOMPARE(joint.residuals.size(), std::size_t(5));
      for (std::size_t l = 0; l < 4; ++l) QCOMPARE(joint.residuals[l], one.residuals[l]);
      QVERIFY2(joint.residuals[4] < (form == PdvForm::twoFactors ? 1 : 0.9) * one.residuals[4],
               QByteArray::number(joint.residuals[4] / one.residuals[4]));
      const PdvSamples samples = samplePdv(*table, joint.factors, PdvWeights::projectedSolidAngle);
      double left = 0, total = 0;
      for (std::size_t channel = 0; channel < 3; ++channel) {
        std::vector<RankOne> terms;
        for (const PdvTerm& term : joint.factors.channels[channel])
          terms.push_back({.a = term.f1, .b = term.f2, .c = term.f3, .residuals = {}});
        left += squaredNormLeft(samples.channels[channel], terms);
        total += samples.channels[channel].squaredNorm();
      }
      QVERIFY(std::abs(std::sqrt(left / total) / joint.residuals[4] - 1) < 1e-5);
      for (const auto& channel : joint.factors.channels)
        for (const auto* curve : {&channel[0].f1, &channel[0].f2, &channel[0].f3})
          for (const double value : *curve) QVERIFY(value >= 0);
    }
  }

  void hardCase12BlackStaysBlack() {
    const TabulatedBrdf black({.thetaHCount = 8, .thetaDCount = 8, .phiDCount = 8},
                              std::vector<TabulatedBrdf::Value>(512, TabulatedBrdf::Value(0)),
                              std::vector<std::uint8_t>(512, 1));
    const PdvFactorization joint = factorizePdv(black, {.terms = 2, .joint = true});
    QCOMPARE(joint.residuals, (std::vector<double>{0, 0, 0}));
  }
};

GONIO_TEST(JointTermsTest)
}  // namespace joint_terms_test

#include "joint_terms_test.moc"
