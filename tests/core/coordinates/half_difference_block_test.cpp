// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/coordinates/half_difference.h"

#include <QTest>
#include <cmath>
#include <vector>

#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace half_difference_block_test {
using namespace gonio;

/// The definition in its plain form (algorithms of Rusinkiewicz's paper with the library's functions), as the oracle.
HalfDifference plain(const Direction& wi, const Direction& wo) {
  const Direction sum = wi + wo, difference = wi - wo, h = glm::normalize(sum);
  const double r = std::hypot(h.x, h.y);
  const Direction tangent = r > 1e-12 ? Direction{h.z * h.x / r, h.z * h.y / r, -r} : Direction{1, 0, 0};
  const Direction bitangent = r > 1e-12 ? Direction{-h.y / r, h.x / r, 0} : Direction{0, 1, 0};
  return {std::atan2(r, h.z), std::atan2(glm::length(difference), glm::length(sum)),
          std::atan2(glm::dot(wi, bitangent), glm::dot(wi, tangent)), true};
}
class HalfDifferenceBlockTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void agreesWithThePlainForm() {
    std::mt19937_64 random(1);
    for (int n = 0; n < 200000; ++n) {
      const Direction wi = test::randomUpper(random), wo = test::randomUpper(random);
      const HalfDifference a = toHalfDifference(wi, wo), b = plain(wi, wo);
      QVERIFY(std::abs(a.thetaH - b.thetaH) < 1e-14);
      QVERIFY(std::abs(a.thetaD - b.thetaD) < 1e-14);
      QVERIFY(std::abs(std::remainder(a.phiD - b.phiD, 2 * pi)) * std::sin(b.thetaD) * std::sin(b.thetaH) < 1e-14);
    }
  }

  /// Whatever a pair's place in a block, and vector code or its remainder: the same bits as alone.
  void blocksAndSinglePairsHaveTheSameBits() {
    std::mt19937_64 random(2);
    std::vector<DirectionPair> pairs;
    for (int n = 0; n < 61; ++n) pairs.push_back({test::randomUpper(random), test::randomUpper(random)});
    pairs[7] = {{1, 0, 0}, {-1, 0, 0}};
    pairs[8].wo = pairs[8].wi;
    pairs[9] = {{0.6, 0, 0.8}, {-0.6, 0, 0.8}};
    for (const std::size_t size : {std::size_t(1), std::size_t(5), std::size_t(8), pairs.size()}) {
      HalfDifferenceBlock block;
      toHalfDifference(std::span(pairs).last(size), block);
      for (std::size_t i = 0; i < size; ++i) {
        const auto& [wi, wo] = pairs[pairs.size() - size + i];
        const HalfDifference one = toHalfDifference(wi, wo);
        QVERIFY(block.thetaH[i] == one.thetaH && block.thetaD[i] == one.thetaD && block.phiD[i] == one.phiD);
        QVERIFY((block.valid[i] != 0) == one.valid);
      }
    }
    HalfDifferenceBlock all;
    toHalfDifference(pairs, all);
    QVERIFY(!all.valid[7] && all.thetaH[7] == 0);
    QVERIFY(all.valid[8] && all.thetaD[8] == 0 && all.phiD[8] == 0);
    QVERIFY(all.valid[9] && all.thetaH[9] == 0 && all.phiD[9] == 0);
  }
};

GONIO_TEST(HalfDifferenceBlockTest)
}  // namespace half_difference_block_test

#include "half_difference_block_test.moc"
