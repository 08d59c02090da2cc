// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/sampling.h"

#include <QTest>
#include <cmath>
#include <set>
#include <vector>

#include "tests/support/test_program.h"

namespace sampling_test {
using namespace gonio;

class SamplingTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// A (0, 2)-sequence: of 2^k points from a multiple of 2^k each elementary interval of area 2^-k holds exactly one.
  void everyElementaryIntervalHoldsOnePoint() {
    for (const std::uint32_t seed : {0u, 1u, 77u, 0xdeadbeefu})
      for (int k = 0; k <= 10; ++k)
        for (const std::uint32_t block : {0u, 1u, 5u})
          for (int across = 0; across <= k; ++across) {
            const std::uint32_t columns = 1u << across, rows = 1u << (k - across);
            std::set<std::uint32_t> cells;
            for (std::uint32_t i = 0; i < (1u << k); ++i) {
              const glm::dvec2 p = scrambledSobol((block << k) + i, seed);
              QVERIFY(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
              cells.insert(std::uint32_t(p.x * columns) * rows + std::uint32_t(p.y * rows));
            }
            QCOMPARE(cells.size(), std::size_t(1) << k);
          }
  }

  /// A (1, 3)-sequence: of 2^k points from a multiple of 2^k each elementary box of volume 2^(1 - k) holds exactly two.
  void everyElementaryBoxHoldsTwoPoints() {
    for (const std::uint32_t seed : {0u, 5u, 0xdeadbeefu})
      for (int k = 1; k <= 9; ++k)
        for (int across = 0; across < k; ++across)
          for (int along = 0; across + along < k; ++along) {
            const std::uint32_t columns = 1u << across, rows = 1u << along, layers = 1u << (k - 1 - across - along);
            std::vector<int> counts(std::size_t(1) << (k - 1), 0);
            const SobolPoints points(seed);
            for (std::uint32_t i = 0; i < (1u << k); ++i) {
              const glm::dvec3 p = points.triple((3u << k) + i);
              ++counts[(std::uint32_t(p.x * columns) * rows + std::uint32_t(p.y * rows)) * layers +
                       std::uint32_t(p.z * layers)];
            }
            for (const int count : counts) QCOMPARE(count, 2);
          }
  }

  /// Each number alone has one point in each of 2^k intervals, in all five dimensions.
  void everyDimensionIsStratified() {
    for (const std::uint32_t seed : {2u, 0xdeadbeefu}) {
      const SobolPoints points(seed);
      for (int dimension = 0; dimension < 5; ++dimension) {
        std::set<int> cells;
        for (std::uint32_t i = 0; i < 256; ++i) {
          const glm::dvec3 first = points.triple(512 + i);
          const glm::dvec2 last = points.fourthAndFifth(512 + i);
          cells.insert(int(256 * (dimension < 3 ? first[dimension] : last[dimension - 3])));
        }
        QCOMPARE(cells.size(), std::size_t(256));
      }
    }
  }

  /// Products of two numbers of one point integrate to 1/4, over many seeds: no dimension follows another.
  void dimensionsAreIndependent() {
    double sums[5][5] = {};
    constexpr std::uint32_t seeds = 4000, perSeed = 4;
    for (std::uint32_t seed = 0; seed < seeds; ++seed)
      for (std::uint32_t i = 0; i < perSeed; ++i) {
        const SobolPoints points(hashCombine(seed, 1));
        const glm::dvec3 first = points.triple(i);
        const glm::dvec2 last = points.fourthAndFifth(i);
        const double p[] = {first.x, first.y, first.z, last.x, last.y};
        for (int a = 0; a < 5; ++a)
          for (int b = 0; b < 5; ++b) sums[a][b] += p[a] * p[b] / (seeds * perSeed);
      }
    for (int a = 0; a < 5; ++a)
      for (int b = 0; b < 5; ++b) QVERIFY(std::abs(sums[a][b] - (a == b ? 1 / 3. : 0.25)) < 0.01);
  }

  void pointsOfASeedAreThoseOfTheFunctions() {
    for (const std::uint32_t seed : {0u, 9u}) {
      const SobolPoints points(seed);
      for (const std::uint32_t i : {0u, 1u, 63u, 0xffffffffu}) {
        QCOMPARE(points[i], scrambledSobol(i, seed));
        QCOMPARE(points.first(i), scrambledVanDerCorput(i, seed));
        QCOMPARE(points.first(i), points[i].x);
        QCOMPARE(glm::dvec2(points.triple(i)), points[i]);
      }
    }
  }

  void vanDerCorputIsStratified() {
    for (const std::uint32_t seed : {3u, 4u}) {
      std::set<int> cells;
      for (std::uint32_t i = 0; i < 64; ++i) cells.insert(int(scrambledVanDerCorput(i, seed) * 64));
      QCOMPARE(cells.size(), std::size_t(64));
    }
  }

  /// The product of the two numbers of different seeds integrates to 1/4: no seed follows another.
  void seedsAreIndependent() {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
      double sum = 0;
      for (std::uint32_t i = 0; i < 4096; ++i)
        sum += scrambledVanDerCorput(i, seed) * scrambledVanDerCorput(i, seed + 1);
      QVERIFY(std::abs(sum / 4096 - 0.25) < 0.01);
    }
  }

  /// The first point of many pixels is uniform: the hash of neighbouring counters is well mixed.
  void firstPointsOfPixelsAreUniform() {
    std::vector<double> counts(64, 0.0);
    constexpr int pixels = 1 << 16;
    for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
      const glm::dvec2 p = scrambledSobol(0, hashCombine(pixel, 2));
      counts[std::size_t(p.x * 8) * 8 + std::size_t(p.y * 8)] += 1;
    }
    double chiSquared = 0;
    for (const double count : counts) chiSquared += (count - pixels / 64.0) * (count - pixels / 64.0) / (pixels / 64.0);
    QVERIFY(chiSquared < 104);  // 63 degrees of freedom, 0.1 %
  }
};

GONIO_TEST(SamplingTest)
}  // namespace sampling_test

#include "sampling_test.moc"
