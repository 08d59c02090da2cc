// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/interpolation/interpolation.h"

#include <QTest>
#include <cmath>
#include <limits>
#include <random>

#include "core/dictionary/decode.h"
#include "core/factorization/pdv_blend.h"
#include "core/models/parameter_blend.h"
#include "core/models/registry.h"
#include "core/support/error.h"
#include "tests/core/dictionary/dictionary_test_support.h"

using namespace gonio;
using namespace gonio::editing;
using dictionary::test::smallGrid;

namespace {

using Table = Interpolation::Table;
constexpr std::array allSpaces{InterpolationSpace::linear, InterpolationSpace::parameters,
                               InterpolationSpace::differential, InterpolationSpace::factors,
                               InterpolationSpace::dictionary};

/// GGX with noise that no model explains, and a few cells without data.
Table measured(double diffuse, double roughness, unsigned seed, const HalfDifferenceGrid& grid = smallGrid) {
  const auto clean = bakeTable(*testing::ggx(Rgb(diffuse, 0.1, 0.2), Rgb(0.8), roughness, 0.3), grid);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> factor(0.8f, 1.2f);
  std::vector<TabulatedBrdf::Value> values(clean->values().begin(), clean->values().end());
  std::vector<std::uint8_t> valid(clean->valid().begin(), clean->valid().end());
  for (std::size_t cell = 0; cell < values.size(); ++cell) {
    values[cell] *= factor(random);
    if (random() % 50 == 0) valid[cell] = 0;
  }
  return std::make_shared<const TabulatedBrdf>(grid, std::move(values), std::move(valid));
}

InterpolationOptions options() {
  InterpolationOptions result;
  result.ensemble = std::make_shared<const dictionary::Ensemble>(dictionary::test::randomEnsemble(3));
  result.pdv.terms = 2;
  result.model = &models::findModel("lambert");  // fits at once; what is told of fits is tested with others
  return result;
}

std::vector<InterpolationEnd> endsOf(const std::vector<Table>& tables) {
  std::vector<InterpolationEnd> ends;
  for (const Table& table : tables) ends.push_back({.table = table});
  return ends;
}

/// Largest |a - b| / (1 + b) over cells valid in both, which must be all that are valid in either when `sameCells`.
double largestDifference(const TabulatedBrdf& a, const TabulatedBrdf& b, bool sameCells = true) {
  double largest = a.grid() == b.grid() ? 0 : 1e300;
  for (std::size_t cell = 0; cell < b.values().size(); ++cell) {
    if (sameCells && a.valid()[cell] != b.valid()[cell]) return 1e300;
    if (a.valid()[cell] == 0 || b.valid()[cell] == 0) continue;
    for (int c = 0; c < 3; ++c) {
      const double x = a.values()[cell][c], y = b.values()[cell][c];
      largest = std::max(largest, std::abs(x - y) / (1 + y));
    }
  }
  return largest;
}

/// The mixture as a picture computes it.
Table mixed(const TransformedMixture& mixture, std::span<const double> weights) {
  const auto& first = mixture.tables[0];
  std::vector<TabulatedBrdf::Value> values(first.grid.size());
  std::vector<std::uint8_t> valid(first.grid.size(), 1);
  for (std::size_t cell = 0; cell < values.size(); ++cell) {
    if (first.grid.nodeAboveHorizon(cell)) {
      const DirectionPair pair = first.grid.directions(cell);
      for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * double(mixture.tables[i].values[cell][c]);
        values[cell][c] = float(inverseTransformed(mixture.transform, sum, cosineWeight(pair.wi.z, pair.wo.z)));
      }
    }
    for (std::size_t i = 0; i < weights.size(); ++i) valid[cell] &= mixture.tables[i].valid[cell];
  }
  return std::make_shared<const TabulatedBrdf>(first.grid, std::move(values), std::move(valid));
}

/// A BRDF at the nodes, valid where a table is.
Table onNodesOf(const Brdf& brdf, const TabulatedBrdf& nodes) {
  const auto baked = bakeTable(brdf, nodes.grid());
  return std::make_shared<const TabulatedBrdf>(
      nodes.grid(), std::vector<TabulatedBrdf::Value>(baked->values().begin(), baked->values().end()),
      std::vector<std::uint8_t>(nodes.valid().begin(), nodes.valid().end()));
}

}  // namespace

class InterpolationTest : public QObject {
  Q_OBJECT
 private:
  const std::vector<Table> tables_{measured(0.3, 0.2, 1), measured(0.1, 0.45, 2), measured(0.2, 0.3, 3)};
  const std::vector<InterpolationEnd> ends_ = endsOf(tables_);
  const std::vector<double> weights_{0.5, 0.2, 0.3};

 private Q_SLOTS:
  void hardCase30WholeWeightsGiveTheMaterialsThemselves() {
    for (const InterpolationSpace space : allSpaces) {
      const auto between = prepareInterpolation(space, ends_, options());
      QCOMPARE(between->materials(), std::size_t(3));
      for (std::size_t end = 0; end < 3; ++end) {
        std::vector<double> weights(3, 0.0);
        weights[end] = 1;
        QVERIFY(between->table(weights) == tables_[end]);
        QVERIFY(between->brdf(weights) == tables_[end]);
      }
    }
  }

  void hardCase30WeightsThatAreNone() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const InterpolationSpace space : allSpaces) {
      const auto between = prepareInterpolation(space, std::span(ends_).first(2), options());
      for (const std::vector<double>& weights :
           {std::vector{1.5, -0.5}, {nan, 1.0}, {0.5, 0.4}, {1.0}, {0.2, 0.3, 0.5}, std::vector<double>{}}) {
        QVERIFY_EXCEPTION_THROWN(between->brdf(weights), Error);
        QVERIFY_EXCEPTION_THROWN(between->table(weights), Error);
        QVERIFY_EXCEPTION_THROWN(between->parameters(weights), Error);
        QVERIFY_EXCEPTION_THROWN(between->moves(weights), Error);
        QVERIFY_EXCEPTION_THROWN(between->factors(weights), Error);
        QVERIFY_EXCEPTION_THROWN(between->code(weights), Error);
      }
    }
  }

  void nothingToBlendIsTold() {
    for (const InterpolationSpace space : allSpaces)
      QVERIFY_EXCEPTION_THROWN(prepareInterpolation(space, {}, options()), Error);
    QVERIFY_EXCEPTION_THROWN(prepareInterpolation(InterpolationSpace::dictionary, ends_), Error);
  }

  void linearIsTheMixture() {
    const auto between = prepareInterpolation(InterpolationSpace::linear, ends_);
    const Table table = between->table(weights_);
    for (std::size_t cell = 0; cell < smallGrid.size(); ++cell) {
      Rgb expected(0);
      bool valid = true;
      for (std::size_t i = 0; i < 3; ++i) {
        expected += weights_[i] * Rgb(tables_[i]->values()[cell]);
        valid = valid && tables_[i]->valid()[cell];
      }
      QCOMPARE(table->valid()[cell] != 0, valid);
      if (valid) QVERIFY(glm::length(Rgb(table->values()[cell]) - expected) <= 1e-6 * glm::length(expected));
    }
    QVERIFY(largestDifference(*mixed(between->mixture().value(), weights_), *table) < 1e-6);
    const Direction wi = fromSpherical(0.4, 0.1), wo = fromSpherical(0.7, 2);
    Rgb expected(0);
    for (std::size_t i = 0; i < 3; ++i) expected += weights_[i] * tables_[i]->evaluate(wi, wo);
    QVERIFY(glm::length(between->brdf(weights_)->evaluate(wi, wo) - expected) < 1e-14);
    QVERIFY(!between->parameters(weights_) && !between->factors(weights_) && !between->code(weights_));
    QVERIFY(between->moves(weights_).empty());
  }

  /// Clean tables of a model: the truth in between is the model at the parameters in between.
  void parametersMeetTheModelInBetween() {
    const std::vector<Table> clean{bakeTable(*testing::ggx(Rgb(0.3), Rgb(0.8), 0.15, 0.3), smallGrid),
                                   bakeTable(*testing::ggx(Rgb(0.1), Rgb(0.8), 0.6, 0.3), smallGrid)};
    const auto truth = bakeTable(*testing::ggx(Rgb(0.2), Rgb(0.8), 0.3, 0.3), smallGrid);
    const std::vector<double> half{0.5, 0.5};
    for (const auto space : {InterpolationSpace::parameters, InterpolationSpace::differential}) {
      const auto between = prepareInterpolation(space, endsOf(clean));
      QVERIFY(largestDifference(*between->table(half), *truth) < 0.02);
      const std::size_t roughness = *models::ggx().spec().find("roughness");
      QVERIFY(std::abs(between->parameters(half)->values[roughness].x - 0.3) < 0.005);
    }
    // The mixture of the two is far from it.
    const auto linear = prepareInterpolation(InterpolationSpace::linear, endsOf(clean));
    QVERIFY(largestDifference(*linear->table(half), *truth) > 0.3);
  }

  void parametersAreThoseOfTheFits() {
    const models::Model& model = models::findModel("ward");
    InterpolationOptions ward;
    ward.model = &model;
    const auto between = prepareInterpolation(InterpolationSpace::parameters, ends_, ward);
    std::vector<models::ParameterValues> fitted;
    for (const Table& table : tables_) fitted.push_back(fitting::fit(*table, model).parameters);
    const models::ParameterValues expected = models::blended(model.spec(), fitted, weights_);
    QVERIFY(between->parameters(weights_) == expected);
    QVERIFY(between->parameters(std::vector{0.0, 1.0, 0.0}) == fitted[1]);
    QCOMPARE(between->brdf(weights_)->evaluate(fromSpherical(0.4, 0), fromSpherical(0.5, 3)),
             model.instantiate(expected)->evaluate(fromSpherical(0.4, 0), fromSpherical(0.5, 3)));
  }

  /// By hand: each measurement with the change of the model added, weighted.
  void differentialIsTheMeanOfTheMovedMaterials() {
    const auto between = prepareInterpolation(InterpolationSpace::differential, ends_);
    const auto target = models::ggx().instantiate(between->parameters(weights_).value());
    std::vector<std::unique_ptr<const Brdf>> fitted;
    for (const DifferentialEdit& edit : between->moves(weights_)) {
      QVERIFY(edit.edited == between->parameters(weights_));
      fitted.push_back(models::ggx().instantiate(edit.fitted));
    }
    const Table table = between->table(weights_);
    const auto brdf = between->brdf(weights_);
    for (std::size_t cell = 0; cell < smallGrid.size(); ++cell) {
      const bool valid = tables_[0]->valid()[cell] && tables_[1]->valid()[cell] && tables_[2]->valid()[cell];
      QCOMPARE(table->valid()[cell] != 0, valid);
      if (!valid) continue;
      const auto [wi, wo] = smallGrid.directions(cell);
      Rgb expected(0);
      for (std::size_t i = 0; i < 3; ++i)
        expected += weights_[i] * glm::max(Rgb(0), Rgb(tables_[i]->values()[cell]) + target->evaluate(wi, wo) -
                                                       fitted[i]->evaluate(wi, wo));
      QVERIFY(glm::length(Rgb(table->values()[cell]) - expected) <= 1e-6 * (1 + glm::length(expected)));
    }
    const Direction wi = fromSpherical(0.4, 0.1), wo = fromSpherical(0.7, 2);
    Rgb expected(0);
    for (std::size_t i = 0; i < 3; ++i)
      expected += weights_[i] * glm::max(Rgb(0), tables_[i]->evaluate(wi, wo) + target->evaluate(wi, wo) -
                                                     fitted[i]->evaluate(wi, wo));
    QVERIFY(glm::length(brdf->evaluate(wi, wo) - expected) < 1e-12);
  }

  void factorsAreBlendedCurves() {
    const auto between = prepareInterpolation(InterpolationSpace::factors, ends_, options());
    const auto blend = between->factors(weights_).value();
    const auto brdf = factorization::makePdvBrdf(blend);
    const Direction wi = fromSpherical(0.4, 0.1), wo = fromSpherical(0.7, 2);
    QCOMPARE(between->brdf(weights_)->evaluate(wi, wo), brdf->evaluate(wi, wo));
    QCOMPARE(largestDifference(*between->table(weights_), *bakeTable(*brdf, smallGrid)), 0.0);
    // All lie on the nodes of the set.
    std::vector<factorization::PdvFactors> each;
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<double> whole(3, 0.0);
      whole[i] = 1;
      each.push_back(between->factors(whole).value());
      QVERIFY(each.back().deviationNodes == each.front().deviationNodes);
    }
    const factorization::PdvFactors* pointers[] = {&each[0], &each[1], &each[2]};
    QVERIFY(factorization::blended(pointers, weights_) == blend);
  }

  /// A table beside a material that is factors is factorised as that is.
  void factorsThatAreGivenAreKept() {
    const factorization::PdvOptions given{
        .form = factorization::PdvForm::twoFactors, .transform = DataTransform::cosineLog, .terms = 3};
    const auto factors = std::make_shared<const factorization::PdvFactors>(factorizePdv(*tables_[1], given).factors);
    const std::vector<InterpolationEnd> ends{{.table = tables_[0]}, {.table = tables_[1], .factors = factors}};
    const auto between = prepareInterpolation(InterpolationSpace::factors, ends, options());
    QVERIFY(between->factors(std::vector{0.0, 1.0}) == *factors);
    const auto other = between->factors(std::vector{1.0, 0.0}).value();
    QVERIFY(other.transform == DataTransform::cosineLog && other.form == factorization::PdvForm::twoFactors);
    QCOMPARE(other.terms(), 3);
    QVERIFY(other.deviationNodes == factors->deviationNodes);
  }

  void hardCase31FactorsOfDifferentTransforms() {
    std::vector<InterpolationEnd> ends{ends_[0], ends_[1]};
    for (const std::size_t i : {0, 1}) {
      const factorization::PdvOptions given{.transform = i == 0 ? DataTransform::logPlus : DataTransform::cosineLog,
                                            .terms = 1};
      ends[i].factors = std::make_shared<const factorization::PdvFactors>(factorizePdv(*tables_[i], given).factors);
    }
    QVERIFY_EXCEPTION_THROWN(prepareInterpolation(InterpolationSpace::factors, ends, options()), Error);
  }

  /// With all coefficients nothing is cut: the code, its table and the mixture of decoded tables are one.
  void dictionaryIsTheMixtureOfTransformedTables() {
    InterpolationOptions all = options();
    all.codeCoefficients = smallGrid.size();
    all.encode.coefficients = 200;
    for (const DataTransform transform : {DataTransform::logPlus, DataTransform::cosineLog}) {
      all.encode.transforms = {transform};
      const auto between = prepareInterpolation(InterpolationSpace::dictionary, ends_, all);
      const auto code = between->code(weights_).value();
      QVERIFY(code.transform == transform);
      const Table table = between->table(weights_);
      QCOMPARE(largestDifference(*dictionary::decode(*all.ensemble, code), *table), 0.0);
      QVERIFY(largestDifference(*mixed(between->mixture().value(), weights_), *table) < 1e-3);
      QVERIFY(between->mixture()->transform == transform);
    }
    all.codeCoefficients = 50;
    const auto few = prepareInterpolation(InterpolationSpace::dictionary, ends_, all);
    QCOMPARE(few->code(weights_)->coefficients(), std::size_t(50));
  }

  /// With all coefficients a code is its material: the blend is that of the transformed reflectances.
  void dictionaryBlendsTransformedReflectances() {
    InterpolationOptions all = options();
    all.encode = {.coefficients = smallGrid.size(), .transforms = {DataTransform::logPlus}};
    all.codeCoefficients = smallGrid.size();
    const auto between = prepareInterpolation(InterpolationSpace::dictionary, ends_, all);
    const Table table = between->table(weights_);
    for (std::size_t cell = 0; cell < smallGrid.size(); ++cell) {
      if (!(tables_[0]->valid()[cell] && tables_[1]->valid()[cell] && tables_[2]->valid()[cell])) continue;
      for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i) sum += weights_[i] * std::log1p(double(tables_[i]->values()[cell][c]));
        QVERIFY(std::abs(double(table->values()[cell][c]) - std::expm1(sum)) < 1e-3 * (1 + std::expm1(sum)));
      }
    }
  }

  /// Codes are taken as they are; what has none, or one of another transform, is encoded in that of the first.
  void hardCase31MixedTransformsAreEncodedAgain() {
    const InterpolationOptions all = options();
    const dictionary::Encoder encoder(*all.ensemble);
    const auto encoded = [&](std::size_t i, DataTransform transform) {
      return std::make_shared<const dictionary::SparseCode>(
          encoder.encode(*tables_[i], {.coefficients = 30, .transforms = {transform}}).code);
    };
    std::vector<InterpolationEnd> ends = ends_;
    ends[1].code = encoded(1, DataTransform::cosineLog);
    ends[2].code = encoded(2, DataTransform::logPlus);
    const auto between = prepareInterpolation(InterpolationSpace::dictionary, ends, all);
    const auto first = between->code(std::vector{1.0, 0.0, 0.0}).value(),
               second = between->code(std::vector{0.0, 1.0, 0.0}).value(),
               third = between->code(std::vector{0.0, 0.0, 1.0}).value();
    for (const auto& code : {first, second, third}) QVERIFY(code.transform == DataTransform::cosineLog);
    QCOMPARE(second.coefficients(), std::size_t(30));
    QVERIFY(first.coefficients() > 30 && third.coefficients() > 30);
  }

  /// Without codes the transform is the one in which the materials together are nearest.
  void theTransformServesAllMaterials() {
    InterpolationOptions all = options();
    all.encode.coefficients = 60;
    const auto between = prepareInterpolation(InterpolationSpace::dictionary, ends_, all);
    std::array<double, 2> errors{};
    for (const Table& table : tables_) {
      const auto encoded = dictionary::Encoder(*all.ensemble).encode(*table, all.encode);
      for (std::size_t t = 0; t < 2; ++t) errors[t] += encoded.candidates[t].gammaError;
    }
    QVERIFY(between->code(weights_)->transform == all.encode.transforms[errors[1] < errors[0] ? 1 : 0]);
  }

  void codesOfAnotherEnsembleAreRefused() {
    std::vector<InterpolationEnd> ends = ends_;
    dictionary::SparseCode foreign{.grid = smallGrid, .transform = DataTransform::logPlus, .channels = {}};
    foreign.channels[2].dictionary = 3;
    ends[1].code = std::make_shared<const dictionary::SparseCode>(foreign);
    QVERIFY_EXCEPTION_THROWN(prepareInterpolation(InterpolationSpace::dictionary, ends, options()), Error);
  }

  /// Everything lands on the grid of the first material.
  void gridsThatDiffer() {
    constexpr HalfDifferenceGrid otherGrid{.thetaHCount = 18, .thetaDCount = 14, .phiDCount = 20};
    const std::vector<Table> tables{measured(0.3, 0.3, 1, otherGrid), measured(0.1, 0.5, 2)};
    const std::vector<double> half{0.5, 0.5};
    for (const InterpolationSpace space : allSpaces) {
      const auto between = prepareInterpolation(space, endsOf(tables), options());
      const Table table = between->table(half);
      QVERIFY(table->grid() == otherGrid);
      // Of the same values as the BRDF: exactly where that is evaluated at the nodes, nearly where tables are
      // resampled.
      if (space == InterpolationSpace::linear || space == InterpolationSpace::differential)
        QVERIFY(largestDifference(*onNodesOf(*between->brdf(half), *table), *table) < 0.3);
      else
        QCOMPARE(largestDifference(*bakeTable(*between->brdf(half), otherGrid), *table), 0.0);
    }
  }

  void oneMaterialIsItself() {
    for (const InterpolationSpace space : allSpaces)
      QVERIFY(prepareInterpolation(space, std::span(ends_).first(1), options())->table(std::vector{1.0}) == tables_[0]);
  }

  void canBeCancelled() {
    std::stop_source stop;
    stop.request_stop();
    const TaskControl control{stop.get_token(), {}};
    for (const InterpolationSpace space : allSpaces) {
      if (space != InterpolationSpace::linear)
        QVERIFY_EXCEPTION_THROWN(prepareInterpolation(space, ends_, options(), control), Cancelled);
      const auto between = prepareInterpolation(space, ends_, options());
      QVERIFY_EXCEPTION_THROWN(between->table(weights_, control), Cancelled);
    }
  }

  void progressRisesToTheEnd() {
    for (const InterpolationSpace space : allSpaces) {
      if (space == InterpolationSpace::linear) continue;
      double last = 0;
      bool falls = false;
      const TaskControl control{{}, [&](double share) {
                                  falls = falls || share < last;
                                  last = share;
                                }};
      prepareInterpolation(space, ends_, options(), control);
      QVERIFY(!falls);
      QVERIFY(std::abs(last - 1) < 1e-9);
    }
  }
};

QTEST_APPLESS_MAIN(InterpolationTest)
#include "interpolation_test.moc"
