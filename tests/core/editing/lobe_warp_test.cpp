// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/lobe_change.h"

#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/coordinates/half_difference.h"
#include "tests/core/editing/direction_pairs.h"
#include "tests/support/test_program.h"

namespace lobe_warp_test {
using namespace gonio;
using namespace gonio::editing;
using gonio::test::pairs;

class LobeWarpTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theWarpScalesTheTangentAlone() {
    for (const DirectionPair& pair : pairs(2000)) {
      const HalfDifference from = toHalfDifference(pair.wi, pair.wo);
      for (const double scale : {0.1, 0.5, 1.0, 1.3}) {
        const DirectionPair moved = withScaledHalfSlopes(pair, glm::dvec2(scale));
        const HalfDifference to = toHalfDifference(moved.wi, moved.wo);
        QVERIFY(moved.wi.z > 0 && moved.wo.z > 0);
        QVERIFY(std::abs(to.thetaD - from.thetaD) < 1e-9);
        const double wanted = std::atan(scale * std::tan(from.thetaH));
        const double before = std::min(pair.wi.z, pair.wo.z), after = std::min(moved.wi.z, moved.wo.z);
        QVERIFY(after >= std::min(before, minWarpCosine) - 1e-9);
        // A rotation that is cut ends exactly at the horizon of the warp.
        if (before > minWarpCosine && std::abs(to.thetaH - wanted) > 1e-6)
          QVERIFY(std::abs(after - minWarpCosine) < 1e-9);
        const auto [least, most] = std::minmax(from.thetaH, wanted);
        QVERIFY(after < minWarpCosine + 1e-9 ? to.thetaH >= least - 1e-9 && to.thetaH <= most + 1e-9
                                             : std::abs(to.thetaH - wanted) < 1e-9);
        if (from.thetaH > 1e-3 && from.thetaD > 1e-3)
          QVERIFY(std::abs(std::remainder(to.phiD - from.phiD, 2 * pi)) < 1e-6);
      }
    }
    const DirectionPair mirror{fromSpherical(0.7, 0), fromSpherical(0.7, pi)};
    QVERIFY(withScaledHalfSlopes(mirror, {3, 2}).wi == mirror.wi);
  }

  /// Two scales along a grain: the slopes of the half vector are scaled, theta_d stays, nothing goes below the horizon.
  void theWarpScalesSlopesAlongTheGrain() {
    const double edited = 0.7, fitted = -0.3;
    const glm::dvec2 scale(0.4, 1.5);
    std::vector<DirectionPair> from = pairs(2000), to(from.size());
    warp({scale, edited, fitted}, from, to);
    int unclamped = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      QVERIFY(to[i].wi.z > 0 && to[i].wo.z > 0);
      QVERIFY(std::abs(glm::length(to[i].wi) - 1) < 1e-9 && std::abs(glm::length(to[i].wo) - 1) < 1e-9);
      QVERIFY(std::abs(glm::dot(to[i].wi, to[i].wo) - glm::dot(from[i].wi, from[i].wo)) < 1e-9);
      if (std::min(to[i].wi.z, to[i].wo.z) < minWarpCosine + 1e-9) continue;
      ++unclamped;
      const auto slopes = [](const DirectionPair& pair, double grain) {
        const Direction sum = pair.wi + pair.wo;
        return glm::dvec2(sum.x * std::cos(grain) + sum.y * std::sin(grain),
                          sum.y * std::cos(grain) - sum.x * std::sin(grain)) /
               sum.z;
      };
      const glm::dvec2 wanted = scale * slopes(from[i], edited), found = slopes(to[i], fitted);
      QVERIFY(glm::length(found - wanted) < 1e-9 * (1 + glm::length(wanted)));
    }
    QVERIFY(unclamped > 1500);
    for (std::size_t i = 0; i < from.size(); ++i) {
      const DirectionPair same = withScaledHalfSlopes(from[i], glm::dvec2(1));
      QVERIFY(same.wi == from[i].wi && same.wo == from[i].wo);
    }
  }
};

GONIO_TEST(LobeWarpTest)
}  // namespace lobe_warp_test

#include "lobe_warp_test.moc"
