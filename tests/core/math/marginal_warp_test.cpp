// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/marginal_warp.h"

#include <QTest>
#include <cmath>

#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace marginal_warp_test {
using namespace gonio;

constexpr SliceBlend firstSlice{1, {0}, {1}};

/// The two distributions of a bilinear density at a point, by brute force: Riemann sums of the interpolant.
glm::dvec2 bruteForce(const SliceStack<float>& density, const SliceBlend& blend, const std::vector<double>& scales,
                      const glm::dvec2& point) {
  constexpr int steps = 400;
  const auto at = [&](double x, double y) {
    double sum = 0;
    for (int i = 0; i < blend.count; ++i) {
      const SliceBlend one{1, {blend.slice[i]}, {1}};
      sum += blend.weight[i] / scales[blend.slice[i]] * interpolate<double>(density, one, {x, y});
    }
    return sum;
  };
  double before = 0, row = 0, below = 0, all = 0;
  for (int i = 0; i < steps; ++i) {
    const double x = (i + 0.5) / steps;
    before += at(point.x * x, point.y) * point.x;
    row += at(x, point.y);
    for (int j = 0; j < steps; ++j) {
      below += at(x, point.y * (j + 0.5) / steps) * point.y;
      all += at(x, (j + 0.5) / steps);
    }
  }
  return {before / row, below / all};
}

class MarginalWarpTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void uniformDensityIsTheIdentity() {
    const MarginalWarp warp({4, 3, std::vector<float>(12, 7)}, "d");
    for (const glm::dvec2 point : {glm::dvec2(0, 0), {0.3, 0.8}, {1, 1}, {0.5, 0}, {1.0 / 3, 0.5}})
      QVERIFY(glm::length(warp.invert(firstSlice, point).point - point) < 1e-6);
  }

  /// Density x y, closed form: both distributions are squares.
  void productOfRampsIsTheSquare() {
    SliceStack<float> density{5, 9, {}};
    for (int y = 0; y < 9; ++y)
      for (int x = 0; x < 5; ++x) density.values.push_back(float(x * y));
    const MarginalWarp warp(density, "d");
    for (double x = 0; x <= 1; x += 0.0625)
      for (double y = 0.0625; y <= 1; y += 0.0625)
        QVERIFY(glm::length(warp.invert(firstSlice, {x, y}).point - glm::dvec2(x * x, y * y)) < 1e-6);
    QVERIFY(warp.invert(firstSlice, {0.4, 0}).point == glm::dvec2(0.4, 0));  // a row without density
  }

  void blendOfSlicesAgainstBruteForce() {
    SliceStack<float> density{3, 4, {0.1f, 2, 0.5f, 1,    3,    1, 0, 0.2f, 4, 1, 1,    2,    // slice 0
                                     5,    1, 0,    0.3f, 0.3f, 2, 1, 7,    1, 0, 0.5f, 1}};  // slice 1
    const std::vector<double> ones{1, 1};
    const MarginalWarp warp(density, "d");
    std::vector<double> totals;
    for (int slice = 0; slice < 2; ++slice) {
      double total = 0;  // the integral of a bilinear interpolant: trapezoids both ways
      for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 3; ++x)
          total += density.values[std::size_t(slice * 12 + y * 3 + x)] * (x == 1 ? 1 : 0.5) * (y % 3 ? 1 : 0.5);
      totals.push_back(total);
    }
    const SliceBlend blend{2, {0, 1}, {0.3, 0.7}};
    for (const glm::dvec2 point : {glm::dvec2(0.2, 0.1), {0.5, 0.5}, {0.9, 0.33}, {0.7, 0.95}}) {
      const glm::dvec2 expected = bruteForce(density, blend, totals, point);
      QVERIFY2(glm::length(warp.invert(blend, point).point - expected) < 1e-4, std::to_string(point.x).c_str());
    }
  }

  /// Drawing is the inverse of invert(), with the same density; also where rows, columns and cells are empty.
  void samplesAreTheInverse() {
    const MarginalWarp warp({3, 4, {0.1f, 2, 0, 0,    3,    1, 0, 0.2f, 4, 1, 1,    2,    // slice 0
                                    5,    1, 0, 0.3f, 0.3f, 2, 0, 0,    0, 0, 0.5f, 1}},  // slice 1: an empty row
                            "d");
    for (const SliceBlend& blend : {SliceBlend{2, {0, 1}, {0.3, 0.7}}, firstSlice, SliceBlend{1, {1}, {1}}})
      for (double y = 0; y <= 1; y += 1.0 / 64)
        for (double x = 0; x <= 1; x += 1.0 / 64) {
          const auto drawn = warp.sample(blend, {x, y});
          QVERIFY(drawn.point.x >= 0 && drawn.point.x <= 1 && drawn.point.y >= 0 && drawn.point.y <= 1);
          const auto back = warp.invert(blend, drawn.point);
          QVERIFY(std::abs(back.density - drawn.density) < 1e-6 * (1 + drawn.density));
          QVERIFY(std::abs(back.density - warp.density(blend, drawn.point)) < 1e-9 * (1 + back.density));
          // The integrals are kept in float: where the density is small, many places have the same one.
          QVERIFY(drawn.density * glm::length(back.point - glm::dvec2(x, y)) < 1e-5);
        }
  }

  /// The density that invert() states is what the map stretches: brute-force difference quotients of it.
  void densityIsTheJacobian() {
    const MarginalWarp warp({3, 3, {0.1f, 2, 0.4f, 1, 3, 1, 2, 0.2f, 4}}, "d");
    const double h = 1e-5;
    for (const glm::dvec2 p : {glm::dvec2(0.2, 0.1), {0.7, 0.4}, {0.9, 0.8}}) {
      const glm::dvec2 dx = warp.invert(firstSlice, p + glm::dvec2(h, 0)).point - warp.invert(firstSlice, p).point;
      const glm::dvec2 dy = warp.invert(firstSlice, p + glm::dvec2(0, h)).point - warp.invert(firstSlice, p).point;
      const double area = std::abs(dx.x * dy.y - dx.y * dy.x) / (h * h);
      QVERIFY(std::abs(area / warp.invert(firstSlice, p).density - 1) < 1e-3);
    }
  }

  void emptySlicesMayBeUniform() {
    const MarginalWarp warp({2, 2, {0, 0, 0, 0, 1, 3, 1, 3}}, "d", MarginalWarp::EmptySlice::uniform);
    QVERIFY(glm::length(warp.sample(firstSlice, {0.3, 0.8}).point - glm::dvec2(0.3, 0.8)) < 1e-6);
    QVERIFY(std::abs(warp.density(firstSlice, {0.3, 0.8}) - 1) < 1e-6);
  }

  void parameterGridWeights() {
    const ParameterGrid grid({-1, 0, 2}, {0, 1});
    QCOMPARE(grid.slices(), std::size_t(6));
    const SliceBlend inside = grid.blend(0.5, 0.25);
    QCOMPARE(inside.count, 4);
    double phi = 0, theta = 0, sum = 0;
    for (int i = 0; i < 4; ++i) {
      const double nodes[] = {-1, 0, 2};
      phi += inside.weight[std::size_t(i)] * nodes[inside.slice[std::size_t(i)] / 2];
      theta += inside.weight[std::size_t(i)] * double(inside.slice[std::size_t(i)] % 2);
      sum += inside.weight[std::size_t(i)];
    }
    QCOMPARE(sum, 1.0);
    QCOMPARE(phi, 0.5);
    QCOMPARE(theta, 0.25);
    for (const auto& [p, t, slice] :
         std::vector<std::tuple<double, double, unsigned>>{{-9, -9, 0}, {9, 9, 5}, {-1, 1, 1}, {2, 0, 4}, {0, 1, 3}}) {
      QCOMPARE(grid.blend(p, t).count, 1);
      QCOMPARE(grid.blend(p, t).slice[0], slice);
      QCOMPARE(grid.blend(p, t).weight[0], 1.0);
    }
  }

  void whatIsNoDensityIsRefused() {
    SliceStack<float> density{2, 2, {1, 1, -1, 1, 0, 0, 0, 0}};
    QVERIFY(test::contains(test::errorOf([&] { MarginalWarp(density, "vndf"); }), "value 2 of 'vndf'"));
    density.values[2] = 1;
    QVERIFY(test::contains(test::errorOf([&] { MarginalWarp(density, "vndf"); }), "slice 1"));
  }
};

GONIO_TEST(MarginalWarpTest)
}  // namespace marginal_warp_test

#include "marginal_warp_test.moc"
