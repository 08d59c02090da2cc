// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/preview_side.h"

#include <QSignalSpy>
#include <QTest>
#include <atomic>

#include "core/rendering/scene_file.h"
#include "tests/support/test_program.h"

namespace scene_tracer_test {
using namespace gonio;
using namespace gonio::rendering;
using widgets::SceneTracer;

/// Lambert, until it is switched to fail.
class FailingBrdf final : public Brdf {
 public:
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    if (fails) throw Error("the material cannot be evaluated");
    std::fill_n(values.begin(), pairs.size(), Rgb(0.1));
  }
  mutable std::atomic<bool> fails = false;
};

struct Traced {
  Scene scene = openScene("sphere");
  std::shared_ptr<const FailingBrdf> brdf = std::make_shared<FailingBrdf>();
  RenderMaterials materials = materialsInSlots(scene, std::make_shared<const RenderMaterial>(brdf, SamplingDensity{}));
  EffectPlan plan = planEffects(scene, bindMaterials(scene, materials));

  void start(SceneTracer& tracer, int samples) const { tracer.trace(scene, materials, plan, {32, 32}, samples); }
};

class SceneTracerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void comesToAllItsSamples() {
    const Traced traced;
    SceneTracer tracer;
    QSignalSpy failures(&tracer, &SceneTracer::failed);
    traced.start(tracer, 4);
    QVERIFY(!tracer.isDone());
    QTRY_VERIFY_WITH_TIMEOUT(tracer.isDone(), 20000);
    QCOMPARE(tracer.film()->samples, 4);
    QCOMPARE(failures.count(), 0);
  }

  /// What the material throws is reported, once; the next request gets its chance.
  void aFailureIsTold() {
    const Traced traced;
    SceneTracer tracer;
    QSignalSpy failures(&tracer, &SceneTracer::failed);
    traced.brdf->fails = true;
    traced.start(tracer, 4);
    QTRY_COMPARE_WITH_TIMEOUT(failures.count(), 1, 20000);
    QCOMPARE(failures[0][0].toString(), "the material cannot be evaluated");
    QVERIFY(!tracer.isDone() && !tracer.film());
    traced.brdf->fails = false;
    traced.start(tracer, 1);
    QTRY_VERIFY_WITH_TIMEOUT(tracer.isDone(), 20000);
    QCOMPARE(failures.count(), 1);
  }

  /// Nobody waits any more for a request that was replaced.
  void aFailureOfAnOldRequestIsNotTold() {
    const Traced failing, other;
    failing.brdf->fails = true;
    SceneTracer tracer;
    QSignalSpy failures(&tracer, &SceneTracer::failed);
    failing.start(tracer, 4);
    other.start(tracer, 1);
    QTRY_VERIFY_WITH_TIMEOUT(tracer.isDone(), 20000);
    QCOMPARE(failures.count(), 0);
  }

  /// Destroyed while it works and after it failed: it throws nothing and reports nothing.
  void mayBeDestroyedWithAFailure() {
    for (int i = 0; i < 20; ++i) {
      const Traced traced;
      SceneTracer tracer;
      traced.start(tracer, 1 << 20);
      QTest::qSleep(i);
      traced.brdf->fails = true;
    }
    const Traced traced;
    traced.brdf->fails = true;
    SceneTracer tracer;
    traced.start(tracer, 4);
    QTest::qSleep(100);
  }
};

GONIO_TEST(SceneTracerTest)
}  // namespace scene_tracer_test

#include "scene_tracer_test.moc"
