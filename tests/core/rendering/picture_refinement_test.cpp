// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/picture_refinement.h"

#include <QTest>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "core/models/registry.h"
#include "core/rendering/render_material.h"
#include "tests/support/test_program.h"

namespace picture_refinement_test {
using namespace gonio;
using namespace gonio::rendering;

struct Picture {
  Scene scene = sphereScene(skyEnvironment());
  RenderMaterials materials;
  EffectPlan plan;

  Picture() {
    const models::Model& model = models::findModel("ggx");
    const auto brdf = std::shared_ptr<const Brdf>(model.instantiate(models::defaultParameters(model.spec())));
    const RenderMaterials given{std::make_shared<const RenderMaterial>(brdf)};
    materials = bindMaterials(scene, given);
    plan = planEffects(scene, materials, {});
  }
  PathTracer tracer(std::uint64_t seed = 1) const { return {scene, materials, plan, seed}; }
};

class PictureRefinementTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Passes do not show: the same bits as at one stroke.
  void passesAreThePicture() {
    const Picture picture;
    for (const int samples : {1, 3, 21, 40}) {
      Film whole(24, 16), refined(24, 16);
      picture.tracer().accumulate(whole, samples);
      refinePicture(picture.tracer(), refined, {.samples = samples});
      QCOMPARE(refined.samples, samples);
      QVERIFY(refined.radiance == whole.radiance && refined.coverage == whole.coverage);
    }
  }

  /// Without time there is one sample; with little, more than one but not all.
  void endsByTime() {
    const Picture picture;
    Film film(16, 16);
    refinePicture(picture.tracer(), film, {.samples = 1000, .seconds = 0});
    QCOMPARE(film.samples, 1);
    Film some(64, 64);
    refinePicture(picture.tracer(), some, {.samples = 100'000'000, .seconds = 0.2});
    QVERIFY(some.samples > 1 && some.samples < 100'000'000);
  }

  void progressNeverFalls() {
    const Picture picture;
    Film film(16, 16);
    double last = 0;
    bool rises = true;
    refinePicture(picture.tracer(), film, {.samples = 50, .seconds = 100}, {{}, [&](double fraction) {
                                                                              rises &=
                                                                                  fraction >= last && fraction <= 1;
                                                                              last = fraction;
                                                                            }});
    QVERIFY(rises);
    QCOMPARE(last, 1.0);
  }

  /// While it is paused nothing is traced; then it goes on to the same picture. A stop ends a pause.
  void waitsWhilePaused() {
    const Picture picture;
    Film film(16, 16), whole(16, 16);
    Pause pause;
    pause.set(true);
    std::atomic<bool> done = false;
    std::thread worker([&] {
      refinePicture(picture.tracer(), film, {.samples = 8}, {}, &pause);
      done = true;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    QVERIFY(!done && film.samples == 0);
    pause.set(false);
    worker.join();
    picture.tracer().accumulate(whole, 8);
    QVERIFY(film.radiance == whole.radiance);

    pause.set(true);
    std::stop_source stop;
    std::atomic<bool> cancelled = false;
    std::thread stopped([&] {
      try {
        refinePicture(picture.tracer(), film, {.samples = 16}, {stop.get_token(), {}}, &pause);
      } catch (const Cancelled&) {
        cancelled = true;
      }
    });
    stop.request_stop();
    stopped.join();
    QVERIFY(cancelled && film.samples == 8);
  }

  /// The predicted noise against that of two independent pictures.
  void predictsTheNoise() {
    const Picture picture;
    constexpr int samples = 64;
    Image pictures[2];
    for (std::uint64_t i = 0; i < 2; ++i) {
      Film film(96, 96);
      picture.tracer(10 + i).accumulate(film, samples);
      pictures[i] = film.image();
    }
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < pictures[0].pixels.size(); ++i) {
      const double a = luminance(Rgb(pictures[0].pixels[i])), b = luminance(Rgb(pictures[1].pixels[i]));
      sum += (a + b) / 2;
      squares += (a - b) * (a - b) / 2;
    }
    const double count = 96 * 96, measured = std::sqrt(squares / count) / (sum / count);
    const PictureEstimate estimate = estimatePicture(picture.scene, picture.materials, picture.plan, 96, 96);
    QVERIFY(estimate.secondsPerSample > 0);
    QVERIFY2(estimate.noise(samples) > 0.7 * measured && estimate.noise(samples) < 1.6 * measured,
             qPrintable(QString("%1 predicted, %2 measured").arg(estimate.noise(samples)).arg(measured)));
    QVERIFY(estimate.order >= 0.5 && estimate.noise(4 * samples) <= estimate.noise(samples) / 2);
  }
};

GONIO_TEST(PictureRefinementTest)

}  // namespace picture_refinement_test

#include "picture_refinement_test.moc"
