// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/bounded_least_squares.h"

#include <QTest>
#include <cmath>

#include "tests/support/test_program.h"

namespace bounded_least_squares_test {
using namespace gonio;

/// Rosenbrock's valley, with its minimum 0 at (1, 1).
void valley(std::span<const double> x, std::span<double> residuals) {
  residuals[0] = 10 * (x[1] - x[0] * x[0]);
  residuals[1] = 1 - x[0];
}

class BoundedLeastSquaresTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theMinimumIsFound() {
    const auto x = fitting::boundedLeastSquares(valley, 2, {{-1.2, 1}, {-5, -5}, {5, 5}}, 200);
    QVERIFY(std::abs(x[0] - 1) < 1e-3 && std::abs(x[1] - 1) < 1e-3);
  }

  /// The function is never asked beyond the bounds, though differences are taken at them; on the line x = 0.5 the
  /// minimum is at y = 0.25.
  void boundsHold() {
    const auto guarded = [](std::span<const double> x, std::span<double> residuals) {
      QVERIFY(x[0] >= -2 && x[0] <= 0.5 && x[1] >= -2 && x[1] <= 2);
      valley(x, residuals);
    };
    const auto x = fitting::boundedLeastSquares(guarded, 2, {{0.5, 2}, {-2, -2}, {0.5, 2}}, 200);
    QVERIFY(std::abs(x[0] - 0.5) < 1e-6 && std::abs(x[1] - 0.25) < 1e-3);
  }

  void aStartOutsideIsMovedInside() {
    const auto x = fitting::boundedLeastSquares(valley, 2, {{9, 9}, {-2, -2}, {2, 2}}, 0);
    QCOMPARE(x, (std::vector<double>{2, 2}));
  }

  void nothingToFindAndStops() {
    QVERIFY(fitting::boundedLeastSquares(valley, 2, {}, 10).empty());
    std::stop_source stop;
    stop.request_stop();
    const auto x = fitting::boundedLeastSquares(valley, 2, {{-1.2, 1}, {-5, -5}, {5, 5}}, 200, stop.get_token());
    QVERIFY(x[0] < 0);
  }
};

GONIO_TEST(BoundedLeastSquaresTest)
}  // namespace bounded_least_squares_test

#include "bounded_least_squares_test.moc"
