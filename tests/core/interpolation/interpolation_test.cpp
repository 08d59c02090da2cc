// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/interpolation/interpolation.h"
#include "core/editing/edit.h"

#include <QTest>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/math/parallel.h"
#include "core/models/model.h"
#include "core/support/error.h"
#include "tests/core/interpolation/interpolation_test_support.h"
#include "tests/support/test_program.h"

namespace interpolation_test {
using namespace gonio;
using namespace gonio::interpolation;
using namespace gonio::editing;
using namespace gonio::editing::test_support;

/// A BRDF at the nodes, valid where a table is.
Table onNodesOf(const Brdf& brdf, const TabulatedBrdf& nodes) {
  const auto baked = bakeTable(brdf, nodes.grid());
  return std::make_shared<const TabulatedBrdf>(
      nodes.grid(), std::vector<TabulatedBrdf::Value>(baked->values().begin(), baked->values().end()),
      std::vector<std::uint8_t>(nodes.valid().begin(), nodes.valid().end()));
}

class InterpolationTest : public QObject, private ThreeMaterials {
  Q_OBJECT
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

  /// Where a table was sampled from another form, that form is what is mixed where detail stays, and in all spaces what
  /// a whole weight gives.
  void materialsKeepTheirOwnForm() {
    std::vector<InterpolationMaterial> ends{ends_[0], ends_[1]};
    const std::shared_ptr<const Brdf> form = test::ggx(Rgb(0.7, 0.2, 0.4), Rgb(0.5), 0.3, 0.4);
    ends[0].base = form;
    const DirectionPair pair{fromSpherical(0.4, 0.1), fromSpherical(0.7, 2)};
    for (const InterpolationSpace space : allSpaces) {
      const auto between = prepareInterpolation(space, ends, options());
      QVERIFY(between->brdf(std::vector{1.0, 0.0}) == form);
      QVERIFY(between->brdf(std::vector{0.0, 1.0}) == tables_[1]);
      QVERIFY(between->table(std::vector{1.0, 0.0}) == tables_[0]);
    }
    const std::vector<double> weights{0.3, 0.7};
    const auto linear = prepareInterpolation(InterpolationSpace::linear, ends, options());
    const Rgb mixed = linear->brdf(weights)->evaluate(pair.wi, pair.wo),
              expected = 0.3 * form->evaluate(pair.wi, pair.wo) + 0.7 * tables_[1]->evaluate(pair.wi, pair.wo);
    QVERIFY(glm::length(mixed - expected) < 1e-12);
    // A form that is the table gives what the table gives.
    const auto differential = [&](std::shared_ptr<const Brdf> base) {
      ends[0].base = std::move(base);
      return prepareInterpolation(InterpolationSpace::differential, ends, options())
          ->brdf(weights)
          ->evaluate(pair.wi, pair.wo);
    };
    QCOMPARE(differential(tables_[0]), differential(nullptr));
    QVERIFY(differential(form) != differential(nullptr));
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
        QVERIFY_EXCEPTION_THROWN(between->differentialEdits(weights), Error);
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
    QVERIFY(maxDifference(*mixed(*between->mixture(), weights_), *table) < 1e-6);
    const Direction wi = fromSpherical(0.4, 0.1), wo = fromSpherical(0.7, 2);
    Rgb expected(0);
    for (std::size_t i = 0; i < 3; ++i) expected += weights_[i] * tables_[i]->evaluate(wi, wo);
    QVERIFY(glm::length(between->brdf(weights_)->evaluate(wi, wo) - expected) < 1e-14);
    QVERIFY(!between->parameters(weights_) && !between->factors(weights_) && !between->code(weights_));
    QVERIFY(between->differentialEdits(weights_).empty());
  }

  /// What a preview mixes of the differential space: the materials, each moved, then mixed, are the blend.
  void theMovedMixtureIsTheDifferentialBlend() {
    const std::vector<Table> tables{tables_[0], tables_[1], measured(0.2, 0.3, 3, {10, 14, 16})};
    const auto between = prepareInterpolation(InterpolationSpace::differential, endsOf(tables));
    TransformedMixture mixture = *between->mixture();
    QVERIFY(mixture.transform == DataTransform::none);
    const std::vector<DifferentialEdit> moves = between->differentialEdits(weights_);
    for (std::size_t i = 0; i < tables.size(); ++i) {
      TransformedTable& one = mixture.tables[i];
      QVERIFY(one.grid == smallGrid);
      const auto moved =
          bakeEdits(std::make_shared<const TabulatedBrdf>(one.grid, one.values, one.valid), EditList{{moves[i]}});
      one.values.assign(moved->values().begin(), moved->values().end());
    }
    QVERIFY(maxDifference(*mixed(mixture, weights_), *between->table(weights_), false) < 1e-6);
  }

  /// Clean tables of a model: the truth in between is the model at the parameters in between.
  void parametersMeetTheModelInBetween() {
    const std::vector<Table> clean{bakeTable(*test::ggx(Rgb(0.3), Rgb(0.8), 0.15, 0.3), smallGrid),
                                   bakeTable(*test::ggx(Rgb(0.1), Rgb(0.8), 0.6, 0.3), smallGrid)};
    const auto truth = bakeTable(*test::ggx(Rgb(0.2), Rgb(0.8), 0.3, 0.3), smallGrid);
    const std::vector<double> half{0.5, 0.5};
    for (const auto space : {InterpolationSpace::parameters, InterpolationSpace::differential}) {
      const auto between = prepareInterpolation(space, endsOf(clean));
      QVERIFY(maxDifference(*between->table(half), *truth) < 0.02);
      const std::size_t roughness = *models::ggx().spec().find("roughness");
      QVERIFY(std::abs(between->parameters(half)->values[roughness].x - 0.3) < 0.005);
    }
    // The mixture of the two is far from it.
    const auto linear = prepareInterpolation(InterpolationSpace::linear, endsOf(clean));
    QVERIFY(maxDifference(*linear->table(half), *truth) > 0.3);
  }

  void parametersAreThoseOfTheFits() {
    const models::Model& model = models::findModel("ward");
    InterpolationOptions ward;
    ward.model = &model;
    ward.preserveDetail = false;
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
    for (const DifferentialEdit& edit : between->differentialEdits(weights_)) {
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
        QVERIFY(maxDifference(*onNodesOf(*between->brdf(half), *table), *table) < 0.06);
      else
        QCOMPARE(maxDifference(*bakeTable(*between->brdf(half), otherGrid), *table), 0.0);
    }
    const Table linear = prepareInterpolation(InterpolationSpace::linear, endsOf(tables))->table(half);
    for (std::size_t cell = 0; cell < otherGrid.size(); ++cell) {
      if (linear->valid()[cell] == 0) continue;
      const Rgb second = tables[1]->lookup(otherGrid.node(cell), TableLookup::trilinear);
      const Rgb expected = (Rgb(tables[0]->values()[cell]) + second) / 2.0;
      QVERIFY(glm::length(Rgb(linear->values()[cell]) - expected) <= 1e-6 * (1 + glm::length(expected)));
    }
  }

  void oneMaterialIsItself() {
    for (const InterpolationSpace space : allSpaces)
      QVERIFY(prepareInterpolation(space, std::span(ends_).first(1), options())->table(std::vector{1.0}) == tables_[0]);
  }

  /// Between black and black lies black; beside another material black is as good as any.
  void hardCase12BlackMaterials() {
    const Table black = bakeTable(test::lambert(Rgb(0)), smallGrid);
    const std::vector<double> half{0.5, 0.5};
    for (const InterpolationSpace space : allSpaces) {
      const Table table = prepareInterpolation(space, endsOf({black, black}), options())->table(half);
      for (const TabulatedBrdf::Value& value : table->values()) QVERIFY(value == TabulatedBrdf::Value(0));
      const Table beside = prepareInterpolation(space, endsOf({black, tables_[0]}), options())->table(half);
      float largest = 0;
      for (const TabulatedBrdf::Value& value : beside->values()) {
        QVERIFY(std::isfinite(value.x) && value.x >= 0);
        largest = std::max(largest, value.x);
      }
      QVERIFY(largest > 0.01f);
    }
  }

  /// Tables of the largest floats; weights whose sum is 1 only up to rounding.
  void hardCase39OverflowOfFloat() {
    const Table largest = bakeTable(test::lambert(Rgb(1e300)), smallGrid);
    const std::vector<double> weights{0.3, 0.7 + 5e-10};
    for (const InterpolationSpace space :
         {InterpolationSpace::linear, InterpolationSpace::factors, InterpolationSpace::dictionary}) {
      const Table table = prepareInterpolation(space, endsOf({largest, largest}), options())->table(weights);
      for (const TabulatedBrdf::Value& value : table->values())
        for (int c = 0; c < 3; ++c) QVERIFY(std::isfinite(value[c]));
    }
  }

  void hardCase50SameBitsForAnyThreads() {
    for (const InterpolationSpace space : allSpaces) {
      std::vector<Table> results;
      for (const int threads : {1, 16}) {
        const ThreadLimit limit(threads);
        results.push_back(prepareInterpolation(space, ends_, options())->table(weights_));
      }
      QCOMPARE(std::memcmp(results[0]->values().data(), results[1]->values().data(), results[0]->values().size_bytes()),
               0);
    }
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
      const TaskControl control{{}, [&](double fraction) {
                                  falls = falls || fraction < last;
                                  last = fraction;
                                }};
      prepareInterpolation(space, ends_, options(), control);
      QVERIFY(!falls);
      QVERIFY(std::abs(last - 1) < 1e-9);
    }
  }
};

GONIO_TEST(InterpolationTest)
}  // namespace interpolation_test

#include "interpolation_test.moc"
