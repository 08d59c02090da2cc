// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/reconstruction.h"

#include <QTest>
#include <cmath>
#include <limits>
#include <random>

#include "core/math/parallel.h"
#include "tests/core/acquisition/reconstruction_oracles.h"
#include "tests/core/io/test_files.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/smooth_materials.h"
#include "tests/support/test_program.h"

namespace reconstruction_test {
using namespace gonio;
using namespace gonio::acquisition;
using namespace gonio::dictionary;
using Eigen::VectorXd;

constexpr double infinite = std::numeric_limits<double>::infinity();

ReconstructionOptions ridgeOf(std::optional<double> ridge, int components = 0) {
  return {.ridge = ridge, .components = components};
}

class ReconstructionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    basis_ = test::learnFrom(test::smoothMaterials(6));
    plan_ = everyCell(basis_, 9);
    QVERIFY(plan_.samples.size() > 30);
    values_ = measure(*test::smoothMaterial(77), plan_);
  }

  /// A material of the training set lies in the span of all components: without a ridge it comes back whole.
  void exactInTheSpan() {
    for (const unsigned seed : {1u, 4u}) {
      const auto table = test::smoothMaterial(seed);
      const MeasuredValues values = measure(*table, plan_);
      const Reconstruction found = reconstruct(basis_, plan_, values, ridgeOf(1e-9, basis_.count()));
      QCOMPARE(found.components, basis_.count());
      QVERIFY2(difference(basis_, *found.table, *table) < 2e-4,
               qPrintable(QString::number(difference(basis_, *found.table, *table))));
      QCOMPARE(found.table->validCount(), table->validCount());
      QCOMPARE(found.cappedCount, std::size_t(0));
      QVERIFY(found.leaveOneOutError < 1e-4);
      // The published ridge does not reach it.
      QVERIFY(difference(basis_, *reconstruct(basis_, plan_, values, ridgeOf(publishedRidge)).table, *table) > 1e-2);
    }
  }

  /// 20 readings of one direction count as one: nothing is left to predict it from, and the result, its uncertainty and
  /// the ridge are those of one reading; a few other directions beside them are not outvoted.
  void hardCase58RepeatedReadings() {
    const auto repeated = [](const SamplingPlan& plan, int times) {
      SamplingPlan result = plan;
      for (int n = 1; n < times; ++n) {
        result.samples.push_back(plan.samples.front());
        result.samples.back().index = int(result.samples.size());
      }
      return result;
    };
    SamplingPlan one = plan_, few = everyCell(basis_, 97);
    one.samples.resize(1);
    for (const SamplingPlan& plan : {one, few})
      for (const auto method : {ReconstructionMethod::ridge, ReconstructionMethod::localRidge}) {
        const SamplingPlan copies = repeated(plan, 20);
        const auto material = test::smoothMaterial(77);
        const Reconstruction expected = reconstruct(basis_, plan, measure(*material, plan), {.method = method}),
                             found = reconstruct(basis_, copies, measure(*material, copies), {.method = method});
        QVERIFY((coefficients(basis_, found) - coefficients(basis_, expected)).norm() < 1e-9);
        QCOMPARE(std::isnan(found.leaveOneOutError), plan.samples.size() == 1);
        if (plan.samples.size() > 1) QVERIFY(std::abs(found.leaveOneOutError / expected.leaveOneOutError - 1) < 1e-9);
        QCOMPARE(found.standardDeviation.size(), expected.standardDeviation.size());
        for (std::size_t i = 0; i < found.standardDeviation.size(); ++i)
          QVERIFY(std::abs(found.standardDeviation[i] - expected.standardDeviation[i]) < 1e-5f);
        QVERIFY(!found.warnings.empty() && found.warnings[0].find("count as one") != std::string::npos);
      }
  }

  /// More readings of one direction lower their noise, as a mean does.
  void hardCase58NoiseOfRepeatedReadings() {
    SamplingPlan one = plan_, four = plan_;
    one.samples.resize(1), four.samples.resize(1);
    for (int n = 1; n < 4; ++n) four.samples.push_back(plan_.samples[0]), four.samples.back().index = 100 + n;
    const MeasuredValues reading{.rgb = {Rgb(0.4)}, .noise = {Rgb(0.05)}};
    const MeasuredValues readings{.rgb = std::vector<Rgb>(4, Rgb(0.4)), .noise = std::vector<Rgb>(4, Rgb(0.1))};
    const Reconstruction expected = reconstruct(basis_, one, reading, ridgeOf(1.0)),
                         found = reconstruct(basis_, four, readings, ridgeOf(1.0));
    QVERIFY((coefficients(basis_, found) - coefficients(basis_, expected)).norm() < 1e-6);
  }

  /// Nearly dependent directions: no value explodes with the method `sparse`, and a warning states the condition
  /// number.
  void hardCase58NearlyDependentDirections() {
    const auto material = test::smoothMaterial(77);
    for (const int atoms : {0, 5, 30}) {
      MeasuredValues values = values_;
      for (std::size_t i = 0; i < values.rgb.size(); ++i) values.rgb[i] *= i % 2 == 0 ? 1.3 : 0.7;
      const Reconstruction found =
          reconstruct(basis_, plan_, values, {.method = ReconstructionMethod::sparse, .atoms = atoms});
      for (const TabulatedBrdf::Value& value : found.table->values())
        QVERIFY2(value.x < 1e4f, qPrintable(QString("%1 with %2 atoms").arg(value.x).arg(atoms)));
    }
  }

  /// A reading beyond the range of a BRDF value is refused with its sample.
  void hardCase58ReadingTooLarge() {
    MeasuredValues values = values_;
    values.rgb[3].y = 1e300;
    try {
      reconstruct(basis_, plan_, values);
      QFAIL("no error");
    } catch (const Error& error) {
      const QString message = error.what();
      QVERIFY2(message.contains("found a value of 1e+300, expected a number from 0 to 3.4"), error.what());
    }
  }

  void equalsNormalEquations() {
    for (const int components : {4, 12}) {
      const MatrixXd q = rowsAt(basis_, plan_, components), y = mappedAt(basis_, plan_, values_);
      for (const double ridge : {1.0, 40.0, 1000.0}) {
        const MatrixXd expected = q.transpose() * test::inverse(covarianceAt(basis_, plan_, components, ridge)) * y;
        const Reconstruction found = reconstruct(basis_, plan_, values_, ridgeOf(ridge, components));
        QCOMPARE(found.ridge, ridge);
        QVERIFY((coefficients(basis_, found) - expected).norm() < 1e-5 * expected.norm());
        const auto decoded = decode(basis_, found.code);
        QVERIFY(std::ranges::equal(decoded->values(), found.table->values()));
      }
    }
  }

  /// Eq. 5.14 as printed, c = (Q^T Q + eta I)^-1 Q^T (y - mean), for any known noise. Without `equalNoise`, the
  /// coefficients are different.
  void equationAsPrinted() {
    const SamplingPlan few = everyCell(basis_, 31);
    const MeasuredValues noisy = measure(*test::smoothMaterial(77), few, {.relative = 0.1});
    QVERIFY(!noisy.noise.empty() && int(few.samples.size()) < basis_.count());
    for (const int components : {3, int(few.samples.size()), basis_.count()}) {
      const MatrixXd q = rowsAt(basis_, few, components), y = mappedAt(basis_, few, noisy);
      for (const double ridge : {1.0, 40.0}) {
        const MatrixXd normal = q.transpose() * q + ridge * MatrixXd::Identity(components, components);
        const MatrixXd expected = test::inverse(normal) * q.transpose() * y;
        const Reconstruction found =
            reconstruct(basis_, few, noisy, {.ridge = ridge, .components = components, .equalNoise = true});
        QVERIFY((coefficients(basis_, found) - expected).norm() < 1e-5 * expected.norm());
        const MatrixXd weighted = coefficients(basis_, reconstruct(basis_, few, noisy, ridgeOf(ridge, components)));
        QVERIFY((weighted - expected).norm() > 1e-3 * expected.norm());
      }
    }
    const Reconstruction found = reconstruct(basis_, few, noisy, publishedReconstruction());
    QCOMPARE(found.ridge, publishedRidge);
    QCOMPARE(found.components, int(few.samples.size()));
  }

  /// Fewer samples than components: without a ridge the coefficients of least norm that agree with every sample; an
  /// infinite ridge gives the mean of the training set.
  void limitsOfTheRidge() {
    const SamplingPlan few = everyCell(basis_, 97);
    QVERIFY(few.samples.size() < 6);
    const MeasuredValues values = measure(*test::smoothMaterial(77), few);
    const int components = basis_.count();
    const Reconstruction found = reconstruct(basis_, few, values, ridgeOf(0, components));
    const MatrixXd q = rowsAt(basis_, few, components), y = mappedAt(basis_, few, values);
    const MatrixXd c = coefficients(basis_, found);
    QVERIFY((q * c - y).norm() < 1e-4 * y.norm());
    const MatrixXd least = test::leastSquares(q, y);
    QVERIFY((c - least).norm() < 1e-5 * least.norm());
    for (const double ridge : {infinite, 1e300}) {
      const Reconstruction mean = reconstruct(basis_, few, values, ridgeOf(ridge, components));
      QVERIFY(coefficients(basis_, mean).norm() < 1e-30);
      ComponentCode none;
      const auto expected = decode(basis_, none);
      QVERIFY(difference(basis_, *mean.table, *expected) < 1e-6);
    }
  }

  /// All components where none are asked for, never more than there are.
  void components() {
    const SamplingPlan few = everyCell(basis_, 97);
    QCOMPARE(reconstruct(basis_, few, measure(*test::smoothMaterial(7), few)).components, basis_.count());
    QCOMPARE(reconstruct(basis_, plan_, values_).components, basis_.count());
    QCOMPARE(reconstruct(basis_, plan_, values_, ridgeOf(1, 1000)).components, basis_.count());
  }

  /// The ridge by cross-validation predicts the cells that were not measured better than ridges far from it.
  void chosenRidge() {
    const MeasuredValues noisy = measure(*test::smoothMaterial(77), plan_, {.relative = 0.2});
    const MeasuredValues unknown{noisy.rgb, {}};
    const Reconstruction found = reconstruct(basis_, plan_, unknown, ridgeOf(std::nullopt, basis_.count()));
    QVERIFY(found.ridge > 0 && std::isfinite(found.ridge));
    const auto truth = test::smoothMaterial(77);
    const double error = rootMeanSquareDifference(basis_, *found.table, *truth);
    for (const double other : {1e-4, 1e4}) {
      const Reconstruction far = reconstruct(basis_, plan_, unknown, ridgeOf(other * found.ridge, basis_.count()));
      QVERIFY(found.leaveOneOutError < far.leaveOneOutError);
      const double farError = rootMeanSquareDifference(basis_, *far.table, *truth);
      QVERIFY2(error < farError, qPrintable(QString("%1 %2").arg(error).arg(farError)));
    }
  }

  /// Without noise nothing changes; a sample of endless noise is as good as none; equal noise is a larger ridge.
  void weightsByNoise() {
    const ReconstructionOptions options = ridgeOf(40);
    MeasuredValues noisy = values_;
    noisy.noise.assign(noisy.rgb.size(), Rgb(0));
    const MatrixXd plain = coefficients(basis_, reconstruct(basis_, plan_, values_, options));
    QVERIFY((coefficients(basis_, reconstruct(basis_, plan_, noisy, options)) - plain).norm() < 1e-6 * plain.norm());

    noisy.noise[4] = Rgb(1e12);
    noisy.rgb[4] = Rgb(5000);
    SamplingPlan without = plan_;
    without.samples.erase(without.samples.begin() + 4);
    MeasuredValues others = values_;
    others.rgb.erase(others.rgb.begin() + 4);
    const MatrixXd expected = coefficients(basis_, reconstruct(basis_, without, others, options));
    QVERIFY((coefficients(basis_, reconstruct(basis_, plan_, noisy, options)) - expected).norm() <
            1e-4 * expected.norm());

    // s of the mapped value the same everywhere: t s^2 more of the ridge.
    const double t = 18, s = 2;
    for (std::size_t i = 0; i < values_.rgb.size(); ++i) {
      const double weight = basis_.mapping.weights[positionOf(basis_, plan_.samples[i])];
      noisy.rgb[i] = values_.rgb[i];
      for (int channel = 0; channel < 3; ++channel)
        noisy.noise[i][channel] = s * (values_.rgb[i][channel] * weight + 1e-3) / weight;
    }
    const Reconstruction larger = reconstruct(basis_, plan_, values_, ridgeOf(40 + s * s * t));
    const MatrixXd shrunk = coefficients(basis_, larger);
    QVERIFY((coefficients(basis_, reconstruct(basis_, plan_, noisy, options)) - shrunk).norm() < 1e-5 * shrunk.norm());
  }

  /// Two components alone, which pursuit finds among all from fewer samples than there are components.
  void sparse() {
    const SamplingPlan few = everyCell(basis_, 40);
    const int count = int(few.samples.size());
    QVERIFY(count < basis_.count() && count > 6);
    ComponentCode code;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      code.channels[channel].setZero(basis_.count());
      code.channels[channel][1] = 2 + float(channel);
      code.channels[channel][5] = -1;
    }
    const auto table = decode(basis_, code);
    const MeasuredValues values = measure(*table, few);
    for (const int atoms : {0, 2}) {
      const Reconstruction found = reconstruct(
          basis_, few, values, {.method = ReconstructionMethod::sparse, .components = basis_.count(), .atoms = atoms});
      QVERIFY2(difference(basis_, *found.table, *table) < 1e-3,
               qPrintable(QString::number(difference(basis_, *found.table, *table))));
      QVERIFY(found.standardDeviation.empty() && found.ridge == 0 && std::isnan(found.leaveOneOutError));
    }
    const Reconstruction one = reconstruct(
        basis_, few, values, {.method = ReconstructionMethod::sparse, .components = basis_.count(), .atoms = 1});
    for (const Eigen::VectorXf& channel : one.code.channels) QCOMPARE((channel.array() != 0).count(), Eigen::Index(1));
  }

  /// One sample, repeated samples, a training set of one constant material, in which nothing varies.
  void degenerate() {
    SamplingPlan one;
    one.samples = {plan_.samples[0]};
    const Reconstruction found = reconstruct(basis_, one, {{values_.rgb[0]}, {}});
    QCOMPARE(found.components, basis_.count());
    QVERIFY(std::isnan(found.leaveOneOutError));
    QCOMPARE(found.ridge, publishedRidge);
    QCOMPARE(reconstruct(basis_, one, {{values_.rgb[0]}, {}}, {.method = ReconstructionMethod::sparse}).components,
             basis_.count());

    SamplingPlan twice;
    MeasuredValues values;
    for (const std::size_t i : {0u, 0u, 0u, 1u}) {
      twice.samples.push_back(plan_.samples[i]);
      values.rgb.push_back(values_.rgb[i]);
    }
    for (const double ridge : {0.0, 40.0})
      for (const float deviation : reconstruct(basis_, twice, values, ridgeOf(ridge)).standardDeviation)
        QVERIFY(std::isfinite(deviation) && deviation >= 0);

    const PrincipalComponents still = test::learnFrom({greyTable()});
    QCOMPARE(still.count(), 0);
    const Reconstruction mean = reconstruct(still, one, {{Rgb(9)}, {}});
    QVERIFY(difference(still, *mean.table, *greyTable()) < 1e-5);
  }

  /// The assumption that is stated (assumedOrders): light and viewer exchanged, the readings give the same material.
  void bothOrdersAreOne() {
    SamplingPlan exchanged = plan_;
    for (auto& sample : exchanged.samples) std::swap(sample.directions.wi, sample.directions.wo);
    const Reconstruction one = reconstruct(basis_, plan_, values_), other = reconstruct(basis_, exchanged, values_);
    QVERIFY(one.table->isReciprocal());
    QVERIFY(std::ranges::equal(one.table->values(), other.table->values()));
  }

  void hardCase50SameBitsForAnyThreads() {
    const Reconstruction many = reconstruct(basis_, plan_, values_);
    const ThreadLimit limit(1);
    const Reconstruction one = reconstruct(basis_, plan_, values_);
    QVERIFY(one.standardDeviation == many.standardDeviation && one.code.channels == many.code.channels);
    QVERIFY(std::ranges::equal(one.table->values(), many.table->values()));
    // Nor does it matter where in memory the results lie.
    std::vector<std::vector<char>> between;
    for (std::size_t bytes = 8; bytes < 400; bytes += 24) {
      between.emplace_back(bytes);
      QVERIFY(reconstruct(basis_, plan_, values_).standardDeviation == many.standardDeviation);
    }
  }

  /// Values that are negative, NaN or infinite, and wrong options: the error names the sample by its index.
  void refusals() {
    const auto errorOf = [&](const MeasuredValues& values, const ReconstructionOptions& options = {}) {
      return test::errorOf([&] { reconstruct(basis_, plan_, values, options); });
    };
    for (const double bad : {-1e-9, std::nan(""), infinite}) {
      MeasuredValues values = values_;
      values.rgb[2].y = bad;
      QVERIFY(test::contains(errorOf(values), "sample 3"));
      values = values_;
      values.noise.assign(values.rgb.size(), Rgb(0.1));
      values.noise[5].z = bad;
      QVERIFY(test::contains(errorOf(values), "sample 6"));
    }
    MeasuredValues endless = values_;
    const auto brightening = [&](const PlannedSample& sample) {
      const std::size_t i = positionOf(basis_, sample);
      return basis_.mapping.weights[i] / (basis_.mapping.reference[i] + 1e-3);
    };
    const auto brightest = std::ranges::max_element(plan_.samples, {}, brightening);
    QVERIFY(brightening(*brightest) > 1.1);
    endless.rgb[std::size_t(brightest - plan_.samples.begin())].x = 1.7e308;
    QVERIFY(test::contains(errorOf(endless), "sample " + std::to_string(brightest->index) + ":"));
    MeasuredValues negativeZero = values_;
    negativeZero.rgb[2].y = -0.0;
    QVERIFY(errorOf(negativeZero).empty());
    MeasuredValues fewer = values_;
    fewer.rgb.pop_back();
    QVERIFY(test::contains(errorOf(fewer), "values for a plan of"));
    QVERIFY(test::contains(test::errorOf([&] { reconstruct(basis_, {}, {}); }), "contains no samples"));
    QVERIFY(!errorOf(values_, ridgeOf(-1)).empty());
    QVERIFY(!errorOf(values_, ridgeOf(std::nan(""))).empty());
    QVERIFY(!errorOf(values_, ridgeOf(1, -1)).empty());
    PrincipalComponents holed = basis_;
    const std::size_t hole = positionOf(basis_, plan_.samples[7]);
    holed.mapping.cells[hole] += 1;  // the next cell is known too: what matters is that this one is not
    QVERIFY(test::contains(test::errorOf([&] { reconstruct(holed, plan_, values_); }), "sample 8"));
    TaskControl stopped;
    std::stop_source source;
    source.request_stop();
    stopped.stop = source.get_token();
    QVERIFY_EXCEPTION_THROWN(reconstruct(basis_, plan_, values_, {}, stopped), Cancelled);
  }

 private:
  static std::shared_ptr<const TabulatedBrdf> greyTable() {
    const HalfDifferenceGrid grid = test::smoothGrid;
    std::vector<std::uint8_t> valid(grid.size());
    for (std::size_t cell = 0; cell < grid.size(); ++cell) valid[cell] = grid.nodeAboveHorizon(cell);
    return std::make_shared<const TabulatedBrdf>(
        grid, std::vector<TabulatedBrdf::Value>(grid.size(), TabulatedBrdf::Value(0.2f)), valid);
  }

  PrincipalComponents basis_;
  SamplingPlan plan_;
  MeasuredValues values_;
};

GONIO_TEST(ReconstructionTest)
}  // namespace reconstruction_test

#include "reconstruction_test.moc"
