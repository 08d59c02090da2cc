// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/signals.h"

#include <QTest>
#include <cmath>
#include <limits>

#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/support/test_program.h"

namespace signals_test {
using namespace gonio;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;

constexpr DataTransform transforms[] = {
    DataTransform::logPlus, DataTransform::cosineLog,        DataTransform::root,
    DataTransform::none,    DataTransform::logPlusHundredth, DataTransform::gamma25};
constexpr float epsilon = std::numeric_limits<float>::epsilon();
constexpr double doubleEpsilon = std::numeric_limits<double>::epsilon();

/// A table with data in some of its cells.
TabulatedBrdf tableOf(const std::function<float(std::size_t cell)>& value,
                      const std::function<bool(std::size_t cell)>& valid) {
  std::vector<TabulatedBrdf::Value> values(smallGrid.size());
  std::vector<std::uint8_t> flags(smallGrid.size());
  for (std::size_t cell = 0; cell < values.size(); ++cell) {
    values[cell] = glm::vec3(value(cell));
    flags[cell] = valid(cell);
  }
  return {smallGrid, std::move(values), std::move(flags)};
}

Eigen::ArrayXd signalOf(const TabulatedBrdf& table, DataTransform transform) {
  return signalsOf(table, transform, *GridGeometry::of(smallGrid))[1];
}

class SignalsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The parts add up to one order and differ by the other, along phi_d, which runs fastest.
  void partsOfOrdersAreTheirMeanAndHalfTheirDifference() {
    const HalfDifferenceGrid circle = smallGrid.wholeCircle();
    const Eigen::ArrayXd signal = Eigen::ArrayXd::LinSpaced(Eigen::Index(circle.size()), 3, 40).square();
    const auto parts = partsOfOrders(signal, circle.phiDCount);
    for (const Eigen::ArrayXd& part : parts) QCOMPARE(part.size(), Eigen::Index(smallGrid.size()));
    for (const auto& [i, j, k] :
         {std::array{0, 0, 0}, std::array{0, 0, 15}, std::array{5, 3, 7}, std::array{11, 11, 15}}) {
      const auto cell = Eigen::Index(smallGrid.index(i, j, k));
      const double first = signal[Eigen::Index(circle.index(i, j, k))],
                   second = signal[Eigen::Index(circle.index(i, j, k + smallGrid.phiDCount))];
      QVERIFY(std::abs(parts[0][cell] + parts[1][cell] - first) < 1e-12 * first);
      QVERIFY(std::abs(parts[0][cell] - parts[1][cell] - second) < 1e-12 * second);
    }
  }

  /// Small values do not cancel, large ones do not overflow; back in double and in single precision.
  void hardCase16DynamicRange() {
    const int count = 151;
    Eigen::ArrayXf values(count), weights(count);
    for (int i = 0; i < count; ++i) {
      values[i] = std::pow(10.f, -9 + 0.1f * float(i));
      weights[i] = float(cosineWeight(double(i) / count, 0.9));
    }
    for (const DataTransform transform : transforms) {
      Eigen::ArrayXd forth = values.cast<double>();
      dictionary::transform(forth, transform, weights);
      Eigen::ArrayXd back = forth;
      invertTransform(back, transform, weights);
      Eigen::ArrayXf single = forth.cast<float>();
      invertTransform(single, transform, weights);
      for (int i = 0; i < count; ++i) {
        const double expected = transformed(transform, double(values[i]), double(weights[i]));
        QVERIFY(std::abs(forth[i] / expected - 1) < 4 * doubleEpsilon);
        // An error of y is one of exp(y).
        QVERIFY(std::abs(back[i] / double(values[i]) - 1) < 8 * doubleEpsilon * (1 + expected));
        QVERIFY(std::abs(double(single[i]) / double(values[i]) - 1) < 8 * epsilon * (1 + expected));
      }
    }
  }

  /// At the floor of the weight the inverse multiplies errors by (1 + rho w) / w and no more.
  void hardCase45FloorOfTheWeight() {
    const float floor = float(cosineWeight(0, 0));
    for (float rho = 1e-6f; rho < 1e6f; rho *= 3) {
      Eigen::ArrayXd transformed = Eigen::ArrayXd::Constant(1, double(rho));
      const Eigen::ArrayXf weight = Eigen::ArrayXf::Constant(1, floor);
      dictionary::transform(transformed, DataTransform::cosineLog, weight);
      const double y = transformed[0];
      Eigen::ArrayXf value = transformed.cast<float>();
      invertTransform(value, DataTransform::cosineLog, weight);
      const double bound = (1 + double(rho) * double(floor)) / double(floor) * 4 * epsilon * std::max(y, 1e-3);
      QVERIFY(std::abs(double(value[0]) - double(rho)) <= std::max(bound, 4.0 * epsilon * double(rho)));
    }
  }

  void hardCase39InversesStayFinite() {
    for (const DataTransform transform : transforms) {
      Eigen::ArrayXf values(5);
      values << 1e30f, 1000.f, std::numeric_limits<float>::max(), -5.f, -0.f;
      invertTransform(values, transform, Eigen::ArrayXf::Constant(5, 1e-3f));
      for (const float value : values) QVERIFY(std::isfinite(value) && value >= 0);
      QVERIFY(values[3] == 0 && values[4] == 0);
    }
  }

  /// Held values make no cliff: of a constant they are the constant, wherever data is missing.
  void invalidCellsHoldTheValueTowardTheHorizon() {
    const auto everywhere = [](std::size_t) { return true; };
    const auto inside = [](std::size_t cell) { return smallGrid.node(cell).thetaH < 0.6 && cell % 7 != 3; };
    const auto constant = [](std::size_t) { return 2.5f; };
    const std::size_t slab = std::size_t(smallGrid.thetaDCount) * std::size_t(smallGrid.phiDCount);
    const auto firstSlabToo = [&](std::size_t cell) { return cell < slab || inside(cell); };
    const Eigen::ArrayXd whole = signalOf(tableOf(constant, everywhere), DataTransform::logPlus);
    const TabulatedBrdf holed = tableOf(constant, firstSlabToo);
    QVERIFY((signalOf(holed, DataTransform::logPlus) == whole).all());
  }

  /// The value of the same theta_d and phi_d at the theta_h before, transformed: not the reflectance.
  void theTransformedValueIsHeld() {
    const auto everywhere = [](std::size_t) { return true; };
    const auto value = [](std::size_t cell) { return float(1 + cell % 13); };
    const std::size_t slab = std::size_t(smallGrid.thetaDCount) * std::size_t(smallGrid.phiDCount);
    const auto twoSlabs = [&](std::size_t cell) { return cell < 2 * slab; };
    // Scales of the cells, whatever they are.
    const Eigen::ArrayXd scales = signalOf(tableOf([](std::size_t) { return 1.f; }, everywhere), DataTransform::none);
    for (const DataTransform transform : transforms) {
      const Eigen::ArrayXd held = signalOf(tableOf(value, twoSlabs), transform) / scales;
      for (std::size_t cell = 2 * slab; cell < smallGrid.size(); ++cell) {
        const double expected = held[Eigen::Index(slab + cell % slab)];
        QVERIFY(std::abs(held[Eigen::Index(cell)] - expected) <= 4 * epsilon * expected);
      }
    }
  }
};

GONIO_TEST(SignalsTest)
}  // namespace signals_test

#include "signals_test.moc"
