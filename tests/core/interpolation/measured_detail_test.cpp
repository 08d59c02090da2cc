// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/interpolation/measured_detail.h"

#include <QTest>
#include <cmath>
#include <cstring>
#include <random>

#include "core/dictionary/decode.h"
#include "core/materials/material.h"
#include "core/math/parallel.h"
#include "core/rendering/render_picture.h"
#include "core/support/error.h"
#include "tests/core/interpolation/interpolation_test_support.h"
#include "tests/support/test_program.h"

namespace measured_detail_test {
using namespace gonio;
using namespace gonio::interpolation;
using namespace gonio::editing;
using namespace gonio::editing::test_support;
using BrdfPointer = std::shared_ptr<const Brdf>;

constexpr InterpolationSpace lossySpaces[] = {InterpolationSpace::parameters, InterpolationSpace::factors,
                                              InterpolationSpace::dictionary};

InterpolationOptions preserving() {
  InterpolationOptions result = options();
  result.preserveDetail = true;
  return result;
}

/// Measured in two orders that differ, with colours outside sRGB: negative in blue near the horizon.
BrdfPointer notReciprocal(double level) {
  return makePairwiseBrdf(
      [level](const Direction& wi, const Direction& wo) {
        return Rgb(level + wo.z, level * wi.z * wi.z, 0.3 * wi.z - 0.1 * wo.z);
      },
      false);
}

std::vector<DirectionPair> somePairs(int count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<DirectionPair> pairs;
  for (int i = 0; i < count; ++i)
    pairs.push_back({fromSpherical(1.5 * uniform(random), 2 * pi * uniform(random)),
                     fromSpherical(1.5 * uniform(random), 2 * pi * uniform(random))});
  return pairs;
}

std::vector<Rgb> valuesOf(const Brdf& brdf, const std::vector<DirectionPair>& pairs) {
  std::vector<Rgb> values(pairs.size());
  brdf.evaluate(pairs, values);
  return values;
}

double largestDifference(const Brdf& a, const Brdf& b, const std::vector<DirectionPair>& pairs) {
  const std::vector<Rgb> x = valuesOf(a, pairs), y = valuesOf(b, pairs);
  double largest = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(x[i][c] - y[i][c]) / (1 + std::abs(y[i][c])));
  return largest;
}

class MeasuredDetailTest : public QObject, private ThreeMaterials {
  Q_OBJECT
 private:
  /// A file that is not reciprocal, a table, and another file.
  std::vector<InterpolationMaterial> files() const {
    std::vector<InterpolationMaterial> ends = ends_;
    ends[0].base = notReciprocal(0.4);
    ends[2].base = notReciprocal(0.2);
    return ends;
  }

  /// The representation of a blend alone, by what the space itself reports.
  static BrdfPointer representation(const Interpolation& between, const InterpolationOptions& made,
                                    const std::vector<double>& weights) {
    if (const auto parameters = between.parameters(weights)) return made.model->instantiate(*parameters);
    if (const auto factors = between.factors(weights)) return factorization::makePdvBrdf(*factors);
    return dictionary::makeCodeBrdf(*made.ensemble, *between.code(weights));
  }

  static Rgb mean(const Brdf& brdf, const DirectionPair& pair) {
    return 0.5 * (brdf.evaluate(pair.wi, pair.wo) + brdf.evaluate(pair.wo, pair.wi));
  }

 private Q_SLOTS:
  /// By hand: the representation of the blend, and of each material what its own misses; not below the lowest. The
  /// materials are reciprocal, and so is what is added: the mean of both orders.
  void theDetailIsAddedByTheWeights() {
    InterpolationOptions made = preserving();
    made.encode = {.coefficients = 60, .transforms = {DataTransform::logPlus}};
    made.codeCoefficients = smallGrid.size();
    for (const InterpolationSpace space : lossySpaces) {
      const auto between = prepareInterpolation(space, ends_, made);
      QVERIFY(between->preservesDetail() && between->mixesNativeForms());
      const BrdfPointer blend = between->brdf(weights_), alone = representation(*between, made, weights_);
      std::vector<BrdfPointer> each;
      for (std::size_t i = 0; i < 3; ++i) {
        std::vector<double> whole(3, 0.0);
        whole[i] = 1;
        each.push_back(representation(*between, made, whole));
      }
      int compared = 0;
      for (const DirectionPair& pair : somePairs(200, 1)) {
        // A blended code is limited by its own largest value, the mixture by those of the materials.
        Rgb expected = mean(*alone, pair), lowest(1e300);
        for (std::size_t i = 0; i < 3; ++i) {
          const Rgb value = tables_[i]->evaluate(pair.wi, pair.wo);
          expected += weights_[i] * (value - mean(*each[i], pair));
          lowest = glm::min(lowest, value);
        }
        expected = glm::max(expected, lowest);
        const Rgb found = blend->evaluate(pair.wi, pair.wo);
        for (int c = 0; c < 3; ++c) {
          if (space == InterpolationSpace::dictionary && mean(*alone, pair)[c] > 2) continue;
          ++compared;
          QVERIFY2(std::abs(found[c] - expected[c]) < 2e-4 * (1 + std::abs(expected[c])),
                   qPrintable(QString("space %1: %2, expected %3").arg(int(space)).arg(found[c]).arg(expected[c])));
        }
      }
      QVERIFY(compared > 300);
    }
  }

  /// Off, it is the representation alone, bit for bit.
  void theRepresentationAlone() {
    for (const InterpolationSpace space : lossySpaces) {
      const InterpolationOptions made = options();
      const auto between = prepareInterpolation(space, files(), made);
      QVERIFY(!between->preservesDetail() && !between->mixesNativeForms());
      const auto pairs = somePairs(100, 2);
      QVERIFY(valuesOf(*between->brdf(weights_), pairs) == valuesOf(*representation(*between, made, weights_), pairs));
    }
    for (const auto space : {InterpolationSpace::linear, InterpolationSpace::differential})
      QVERIFY(!prepareInterpolation(space, ends_, preserving())->preservesDetail());
  }

  /// Toward a weight of 1 the blend nears the file in its native form, in both orders, where it is negative, too; at 1
  /// it is the file.
  void blendsEndAtTheMaterials() {
    const std::vector<InterpolationMaterial> ends = files();
    const auto pairs = somePairs(300, 3);
    for (const InterpolationSpace space : lossySpaces) {
      const auto between = prepareInterpolation(space, ends, preserving());
      for (std::size_t end = 0; end < 3; ++end) {
        std::vector<double> weights(3, 0.0);
        weights[end] = 1;
        const BrdfPointer material = between->brdf(weights);
        QVERIFY(material == (ends[end].base ? ends[end].base : ends[end].table));
        double before = 1e300;
        for (const double other : {1e-2, 1e-4, 1e-6}) {
          std::ranges::fill(weights, other / 2);
          weights[end] = 1 - other;
          const double difference = largestDifference(*between->brdf(weights), *material, pairs);
          QVERIFY(difference < before);
          before = difference;
        }
        QVERIFY2(before < 2e-5, qPrintable(QString("space %1: %2").arg(int(space)).arg(before)));
      }
    }
  }

  /// What is seen as a blend begins: a sphere of a file that is not reciprocal, at a weight of 0.995.
  void theImageDoesNotJump() {
    const materials::Material file = materials::readMaterial("library:rgl/satin_purple");
    const std::vector<InterpolationMaterial> ends{{.table = file.tabulated(), .base = file.brdf},
                                                  {.table = bakeTable(*test::ggx(Rgb(0.3), Rgb(0.4), 0.3, 0.1))}};
    const rendering::RenderedComparison truth(*file.brdf, {.width = 64, .height = 64, .samples = 16, .density = {}});
    const std::vector<double> begun{0.995, 0.005};
    for (const InterpolationSpace space : lossySpaces) {
      const auto snr = [&](const InterpolationOptions& made) {
        return truth.signalToNoiseRatio(truth.render(*prepareInterpolation(space, ends, made)->brdf(begun)));
      };
      const double kept = snr(preserving()), alone = snr(options());
      qInfo("space %d: %.1f dB, without detail %.1f dB", int(space), kept, alone);
      QVERIFY2(kept > 35 && alone < kept - 12,
               qPrintable(QString("space %1: %2, %3").arg(int(space)).arg(kept).arg(alone)));
    }
  }

  /// Where the weight of one of three materials reaches 0, the blend is that of the other two.
  void blendsBeginAtThoseOfFewerMaterials() {
    const std::vector<InterpolationMaterial> ends = files();
    const auto pairs = somePairs(300, 4);
    for (const InterpolationSpace space : {InterpolationSpace::parameters, InterpolationSpace::dictionary}) {
      const auto between = prepareInterpolation(space, ends, preserving());
      const BrdfPointer two = between->brdf(std::vector{0.4, 0.6, 0.0});
      const double difference = largestDifference(*between->brdf(std::vector{0.4, 0.6 - 1e-7, 1e-7}), *two, pairs);
      QVERIFY2(difference < 1e-4, qPrintable(QString("space %1: %2").arg(int(space)).arg(difference)));
    }
  }

  /// Not below the lowest of the materials that have a weight, for any weights and directions; the bound acts.
  void neverBelowTheLowest() {
    const std::vector<InterpolationMaterial> ends = files();
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto pairs = somePairs(300, 6);
    InterpolationOptions made = preserving();
    made.model = &models::ggx();  // the change of a linear model is 0
    for (const InterpolationSpace space : lossySpaces) {
      const auto between = prepareInterpolation(space, ends, made);
      int bounded = 0;
      for (int trial = 0; trial < 20; ++trial) {
        const double first = uniform(random), second = trial % 2 == 0 ? (1 - first) * uniform(random) : 1 - first;
        const std::vector<double> weights{first, second, std::max(0.0, 1 - first - second)};
        const std::vector<Rgb> values = valuesOf(*between->brdf(weights), pairs);
        for (std::size_t i = 0; i < pairs.size(); ++i) {
          Rgb lowest(1e300);
          for (std::size_t m = 0; m < 3; ++m)
            if (weights[m] > 0) lowest = glm::min(lowest, ends[m].material()->evaluate(pairs[i].wi, pairs[i].wo));
          for (int c = 0; c < 3; ++c) {
            QVERIFY(values[i][c] >= lowest[c] - 1e-12 * (1 + std::abs(lowest[c])));
            bounded += values[i][c] == lowest[c];
          }
        }
      }
      QVERIFY2(bounded > 0, qPrintable(QString::number(int(space))));
    }
  }

  /// Of reciprocal materials in every space, though factors are not reciprocal; beside a file that is not, the blend is
  /// not.
  void reciprocalMaterialsStayReciprocal() {
    const auto pairs = somePairs(200, 7);
    for (const InterpolationSpace space : lossySpaces) {
      const BrdfPointer blend = prepareInterpolation(space, ends_, preserving())->brdf(weights_);
      QVERIFY(blend->isReciprocal() && blend->isIsotropic());
      for (const auto& [wi, wo] : pairs)
        QVERIFY(glm::length(blend->evaluate(wi, wo) - blend->evaluate(wo, wi)) <
                1e-5 * (1 + glm::length(blend->evaluate(wi, wo))));
      const auto between = prepareInterpolation(space, files(), preserving());
      QVERIFY(!between->brdf(weights_)->isReciprocal());
      // A file of weight 0 does not count.
      QVERIFY(!between->brdf(std::vector{0.5, 0.5, 0.0})->isReciprocal());
    }
  }

  /// The table of tables is the blend at the nodes, valid where all of them are.
  void tablesAreTheBlendAtTheNodes() {
    for (const InterpolationSpace space : lossySpaces) {
      const auto between = prepareInterpolation(space, ends_, preserving());
      const Table table = between->table(weights_), baked = bakeTable(*between->brdf(weights_), smallGrid);
      for (std::size_t cell = 0; cell < smallGrid.size(); ++cell) {
        const bool valid = std::ranges::all_of(tables_, [&](const Table& one) { return one->valid()[cell] != 0; });
        QCOMPARE(table->valid()[cell] != 0, valid);
        // At theta_d = 0, phi_d means nothing: cells of other values share their directions.
        const bool isUnique = cell / std::size_t(smallGrid.phiDCount) % std::size_t(smallGrid.thetaDCount) != 0;
        for (int c = 0; c < 3 && valid && isUnique; ++c) {
          const double found = table->values()[cell][c], expected = baked->values()[cell][c];
          QVERIFY2(std::abs(found - expected) < 1e-4 * (1 + expected),
                   qPrintable(QString("space %1: %2, expected %3").arg(int(space)).arg(found).arg(expected)));
        }
      }
    }
    // All lie on the grid of the first.
    constexpr HalfDifferenceGrid otherGrid{.thetaHCount = 18, .thetaDCount = 14, .phiDCount = 20};
    const std::vector<Table> tables{measured(0.3, 0.3, 1, otherGrid), measured(0.1, 0.5, 2)};
    for (const InterpolationSpace space : lossySpaces)
      QVERIFY(prepareInterpolation(space, endsOf(tables), preserving())->table(std::vector{0.5, 0.5})->grid() ==
              otherGrid);
  }

  /// An anisotropic model: its table is the mean over the azimuth, as that of any anisotropic BRDF.
  void anisotropicModelsAreAveraged() {
    InterpolationOptions ward = preserving();
    ward.model = &models::findModel("ward-anisotropic");
    const std::span<const InterpolationMaterial> two(ends_.data(), 2);
    const auto between = prepareInterpolation(InterpolationSpace::parameters, two, ward);
    const std::vector<double> half{0.5, 0.5};
    const Table table = between->table(half), baked = bakeTable(*between->brdf(half), smallGrid);
    for (std::size_t cell = 0; cell < smallGrid.size(); ++cell)
      for (int c = 0; c < 3 && table->valid()[cell] != 0 && cell / 16 % 12 != 0; ++c)
        QVERIFY(std::abs(table->values()[cell][c] - baked->values()[cell][c]) < 0.05 * (1 + baked->values()[cell][c]));
  }

  void hardCase12BlackMaterials() {
    const Table black = bakeTable(test::lambert(Rgb(0)), smallGrid);
    const std::vector<double> half{0.5, 0.5};
    for (const InterpolationSpace space : lossySpaces) {
      const auto none = prepareInterpolation(space, endsOf({black, black}), preserving());
      const Table table = none->table(half);
      for (const TabulatedBrdf::Value& value : table->values())
        QVERIFY2(value == TabulatedBrdf::Value(0), qPrintable(QString("space %1: %2").arg(int(space)).arg(value.x)));
      for (const Rgb& value : valuesOf(*none->brdf(half), somePairs(100, 8))) QVERIFY(value == Rgb(0));
    }
  }

  /// The largest floats, and a spike beside black: finite.
  void hardCase39OverflowOfFloat() {
    const Table largest = bakeTable(test::lambert(Rgb(1e300)), smallGrid),
                black = bakeTable(test::lambert(Rgb(0)), smallGrid);
    std::vector<TabulatedBrdf::Value> spike(smallGrid.size(), TabulatedBrdf::Value(0));
    spike[smallGrid.index(0, 3, 5)] = TabulatedBrdf::Value(1e6f);
    const auto spiked = std::make_shared<const TabulatedBrdf>(
        smallGrid, spike, std::vector<std::uint8_t>(black->valid().begin(), black->valid().end()));
    for (const InterpolationSpace space : {InterpolationSpace::factors, InterpolationSpace::dictionary})
      for (const std::vector<Table>& tables : {std::vector{largest, largest}, {largest, spiked}, {spiked, black}}) {
        const auto between = prepareInterpolation(space, endsOf(tables), preserving());
        const std::vector<double> weights{0.3, 0.7};
        const Table table = between->table(weights);
        for (const TabulatedBrdf::Value& value : table->values())
          for (int c = 0; c < 3; ++c)
            QVERIFY2(std::isfinite(value[c]) && value[c] >= 0,
                     qPrintable(QString("space %1: %2").arg(int(space)).arg(value[c])));
        for (const Rgb& value : valuesOf(*between->brdf(weights), somePairs(200, 9)))
          for (int c = 0; c < 3; ++c) QVERIFY(std::isfinite(value[c]));
      }
  }

  /// The densities of the samples are those that pdf() states: their mean inverse is the solid angle of the hemisphere.
  void samplesHaveTheirDensity() {
    std::mt19937_64 random(10);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<InterpolationMaterial> ends{ends_[0], ends_[1]};
    ends[0].base = test::ggx(Rgb(0.3), Rgb(0.5), 0.3, 0.4);
    ends[1].base = test::ggx(Rgb(0.1), Rgb(0.5), 0.6, 0.4);
    InterpolationOptions ggx = preserving();
    ggx.model = &models::ggx();
    const BrdfPointer blend =
        prepareInterpolation(InterpolationSpace::parameters, ends, ggx)->brdf(std::vector{0.5, 0.5});
    QVERIFY(blend->hasImportanceSampling());
    const Direction wo = fromSpherical(0.6, 1);
    constexpr int samples = 200000;
    double area = 0;
    for (int i = 0; i < samples; ++i) {
      const DirectionSample sample = blend->sample(wo, {uniform(random), uniform(random), uniform(random)});
      if (!(sample.pdf > 0)) continue;
      QVERIFY(std::abs(sample.pdf - blend->pdf(sample.wi, wo)) <= 1e-9 * sample.pdf);
      if (sample.wi.z > 0.1) area += 1 / sample.pdf / samples;
    }
    QVERIFY2(std::abs(area / (2 * pi * 0.9) - 1) < 0.03, qPrintable(QString::number(area)));
  }

  void hardCase50SameBitsForAnyThreads() {
    for (const InterpolationSpace space : lossySpaces) {
      std::vector<Table> results;
      for (const int threads : {1, 16}) {
        const ThreadLimit limit(threads);
        results.push_back(prepareInterpolation(space, ends_, preserving())->table(weights_));
      }
      QCOMPARE(std::memcmp(results[0]->values().data(), results[1]->values().data(), results[0]->values().size_bytes()),
               0);
    }
  }

  void canBeCancelled() {
    std::stop_source stop;
    stop.request_stop();
    for (const InterpolationSpace space : lossySpaces) {
      const auto between = prepareInterpolation(space, ends_, preserving());
      QVERIFY_EXCEPTION_THROWN(between->table(weights_, {stop.get_token(), {}}), Cancelled);
    }
  }
};

GONIO_TEST(MeasuredDetailTest)
}  // namespace measured_detail_test

#include "measured_detail_test.moc"
