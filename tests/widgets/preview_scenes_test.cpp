// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>

#include "core/rendering/path_tracer.h"
#include "core/rendering/scene_file.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_spheres.h"

namespace preview_scenes_test {
using namespace gonio;
using namespace gonio::rendering;
using test::agreement;
using test::bakedModel;
using test::rougherEdit;

constexpr int side = test::OffscreenSpheres::side;

class PreviewScenesTest : public test::SphereTest {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { openSpheres(); }

  /// Under one light both pictures are sums over the same sphere with different edge samples and float tables: they
  /// agree to 40 dB at least (the edge pixels' coverage differs by some percent).
  void pictureUnderADirectionalLight() {
    const auto table = bakedModel("ggx", {{"roughness", 0.2}});
    QVERIFY2(agreement(*spheres_, table, {}, sphereScene(), 40) > 40, "shader and CPU differ");
  }

  /// Under an environment both are Monte Carlo estimates of the same integral.
  void pictureUnderTheStudio() {
    Scene scene = sphereScene(studioEnvironment(), {.yaw = 0.4, .pitch = 0.2});
    scene.environmentRotation = 0.6;
    for (const double roughness : {0.03, 0.2, 0.7}) {
      const auto table = bakedModel("ggx", {{"roughness", roughness}, {"f0", 0.5}});
      const double snr = agreement(*spheres_, table, {}, scene, 30);
      qInfo("roughness %g: %.1f dB", roughness, snr);
      QVERIFY2(snr > 30, qPrintable(QString("roughness %1: %2 dB").arg(roughness).arg(snr)));
    }
  }

  /// Scenes of spheres and rectangles: the shader's shadows, lamps and reflections are those of the reference renderer,
  /// followed as far as the shader follows them.
  void scenesAreThoseOfThePathTracer() {
    const auto table = bakedModel("ggx", {{"roughness", 0.3}, {"f0", 0.6}});
    const auto material = std::make_shared<const RenderMaterial>(table);
    const auto subject = widgets::measuredSubject(table, std::make_shared<const TabulatedDensity>(*table));
    for (const std::string& name : bundledSceneNames()) {
      const Scene scene = openScene(name, 2);
      if (!widgets::SceneUniforms::canDraw(scene)) continue;
      EffectPlan plan = widgets::previewPlan(scene, material);
      plan.reflections = std::min(plan.reflections, widgets::SceneUniforms::maxReflections);
      renderer().setSubject(subject);
      renderer().setScene(scene, plan);
      constexpr int small = 12;
      renderer().setSize({side, side});  // so that each target is a new one: none may unbind a texture
      renderer().setSize({small, small});
      const std::vector slotMaterials(2, material);
      const double snr = snrOf(scene, bindMaterials(scene, slotMaterials), plan, small, 768);
      qInfo("%s: %.1f dB", name.c_str(), snr);
      QVERIFY2(snr > 31, qPrintable(QString("%1: %2 dB").arg(name.c_str()).arg(snr)));
    }
  }

  /// Each material has a pass of its own: light that is reflected once is all there.
  void severalMaterials() {
    const auto other = bakedModel("ggx", {{"roughness", 0.6}, {"f0", 0.2}});
    const widgets::PreviewSubject edited{widgets::EditedMaterial{other, {rougherEdit("ggx", "roughness", 0.4)}},
                                         std::make_shared<const TabulatedDensity>(*other)};
    const auto traced = std::make_shared<const RenderMaterial>(widgets::subjectBrdf(edited), edited.density);
    for (const char* name : {"two-spheres", "row"}) checkTwoMaterials(name, edited, traced, 1);
  }

  /// So is light between objects of one material and those that have no material of the slots; what a black one sends
  /// to others is none.
  void reflectionsBesideAnotherMaterial() {
    const auto black = bakedModel("lambert", {{"diffuse", 0}});
    checkTwoMaterials("row", widgets::measuredSubject(black), diffuseMaterial(Rgb(0)), 8);
  }

  void orthographicViewWithTheEnvironmentShown() {
    Scene scene = sphereScene(skyEnvironment(), {.fieldOfView = 0});
    scene.showEnvironment = true;
    const auto table = bakedModel("lambert", {});
    for (const bool blurred : {false, true}) {
      scene.blurBackground = blurred;
      const double snr = agreement(*spheres_, table, {}, scene, 30);
      QVERIFY2(snr > 30, qPrintable(QString("blurred %1: %2 dB").arg(blurred).arg(snr)));
    }
  }

 private:
  /// Of the renderer's scene against the path tracer, whose noise does not count.
  double snrOf(const Scene& scene, const RenderMaterials& materials, const EffectPlan& plan, int size, int samples) {
    for (int i = 0; i < samples / 64; ++i) renderer().accumulate(64);
    metrics::PicturePair traced;
    for (std::size_t i = 0; i < 2; ++i) {
      Film film(size, size);
      PathTracer(scene, materials, plan, 7 + i).accumulate(film, samples / 2);
      traced[i] = film.image();
    }
    const Image shown = renderer().readPicture();
    return metrics::signalToNoiseRatio(traced, {shown, shown});
  }

  /// A scene of two materials against the path tracer.
  void checkTwoMaterials(const char* name, const widgets::PreviewSubject& other,
                         const std::shared_ptr<const RenderMaterial>& tracedOther, int reflections) {
    const auto table = bakedModel("ggx", {{"roughness", 0.3}, {"f0", 0.6}});
    const Scene scene = openScene(name, 2);
    const RenderMaterials slots{std::make_shared<const RenderMaterial>(table), tracedOther};
    const RenderMaterials bound = bindMaterials(scene, slots);
    EffectPlan plan = planEffects(scene, bound);
    plan.reflections = std::min(plan.reflections, reflections);
    renderer().setSubject(widgets::measuredSubject(table, std::make_shared<const TabulatedDensity>(*table)));
    renderer().setScene(scene, plan, {other});
    constexpr int small = 24;
    renderer().setSize({small, small});
    const double snr = snrOf(scene, bound, plan, small, 512);
    qInfo("%s: %.1f dB", name, snr);
    QVERIFY2(snr > 31, qPrintable(QString("%1: %2 dB").arg(name).arg(snr)));
  }
};

GONIO_TEST(PreviewScenesTest)
}  // namespace preview_scenes_test

#include "preview_scenes_test.moc"
