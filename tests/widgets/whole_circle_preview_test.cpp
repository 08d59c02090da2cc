// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>

#include "core/brdf/brdf.h"
#include "core/models/registry.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_spheres.h"

namespace whole_circle_preview_test {
using namespace gonio;
using namespace gonio::rendering;

/// Another value where light and viewer are exchanged, and on the other side of the plane of incidence.
std::shared_ptr<const Brdf> notReciprocal() {
  return makePairwiseBrdf(
      [](const Direction& wi, const Direction& wo) {
        const double side = wi.x * wo.y - wi.y * wo.x;
        return Rgb(0.2 + 0.3 * wi.z * wi.z, 0.3 + 0.2 * side, 0.1 + 0.2 * wo.z);
      },
      false);
}

/// Tables over the whole circle of phi_d in the shader are those of the core, with and without edits.
class WholeCirclePreviewTest : public test::SphereTest {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { openSpheres(); }

  void sameAsCpu() {
    const auto brdf = notReciprocal();
    const auto table = bakeTable(*brdf, {.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 180, .reciprocal = false});
    const editing::Edit edit = test::rougherEdit("ggx", "roughness", 0.5);
    for (const editing::EditList& edits : {editing::EditList{}, editing::EditList{edit}}) {
      const widgets::PreviewSubject subject{widgets::EditedMaterial{table, edits}};
      QVERIFY(spheres_->agreement(subject, *editing::applyEdits(table, edits), sphereScene(), 50) > 50);
      // The table holds the material itself; one that folds phi_d would not.
      QVERIFY(spheres_->agreement(subject, *editing::applyEdits(brdf, edits), sphereScene(), 35) > 35);
    }
    const auto folded = bakeTable(*brdf, {.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 90});
    QVERIFY(spheres_->agreement({widgets::EditedMaterial{folded}}, *brdf, sphereScene(), 25) < 25);
  }
};

GONIO_TEST(WholeCirclePreviewTest)
}  // namespace whole_circle_preview_test

#include "whole_circle_preview_test.moc"
