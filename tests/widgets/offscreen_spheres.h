// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QTest>

#include "core/metrics/image_metrics.h"
#include "core/models/registry.h"
#include "core/rendering/render_picture.h"
#include "tests/support/sphere_preview.h"
#include "tests/widgets/offscreen_context.h"

namespace gonio::test {

/// Pictures of a sphere by the preview's shader, beside those of the CPU. Tests skip when isValid() is false.
class OffscreenSpheres {
 public:
  static constexpr int side = 32;

  OffscreenSpheres() {
    if (isValid()) renderer_.initialize();
  }
  ~OffscreenSpheres() {
    if (isValid()) renderer_.release();
  }
  bool isValid() const { return context_.isValid(); }
  widgets::PreviewRenderer& renderer() { return renderer_; }

  Image drawn(const widgets::PreviewSubject& subject, const rendering::Scene& scene, int samples) {
    renderer_.setSubject(subject);
    showSphere(renderer_, scene);
    renderer_.setSize({side, side});
    for (int i = 0; i < samples / 64; ++i) renderer_.accumulate(64);
    return renderer_.readPicture();
  }

  /// SNR of the shader's picture against that of `brdf` on the CPU, dB: of 64 samples where that is above `enough`,
  /// else of 256 or of 512, which few pictures need. The CPU's noise does not count (metrics::PicturePair), the
  /// shader's does.
  double agreement(const widgets::PreviewSubject& subject, const Brdf& brdf, const rendering::Scene& scene,
                   double enough) {
    double snr = 0;
    const auto material = rendering::pictureMaterial(brdf, {});
    for (const int samples : {64, 256, 512, 2048}) {
      metrics::PicturePair reference;
      for (std::size_t i = 0; i < 2; ++i)
        reference[i] = rendering::renderPicture(material, scene,
                                                {.width = side, .height = side, .samples = samples / 2, .seed = 7 + i});
      const Image shown = drawn(subject, scene, samples);
      snr = metrics::signalToNoiseRatio(reference, {shown, shown});
      if (snr > enough) break;
    }
    return snr;
  }

 private:
  OffscreenContext context_;
  widgets::PreviewRenderer renderer_;
};

/// Base class of tests that compare the preview's pictures of a sphere with those of the CPU.
class SphereTest : public QObject {
 protected:
  /// Call it in initTestCase(): skips the tests if there is no OpenGL 4.1.
  void openSpheres() {
    spheres_ = std::make_unique<OffscreenSpheres>();
    if (!spheres_->isValid()) QSKIP("no OpenGL 4.1 core context on this machine");
  }
  widgets::PreviewRenderer& renderer() { return spheres_->renderer(); }
  /// Fails unless the pictures of a subject agree to more than `least` dB.
  void verify(const widgets::PreviewSubject& subject, const rendering::Scene& scene = rendering::sphereScene(),
              double least = 40) {
    const double snr = spheres_->agreement(subject, *widgets::subjectBrdf(subject), scene, least);
    qInfo("%.1f dB", snr);
    QVERIFY2(snr > least, qPrintable(QString("%1 dB").arg(snr)));
  }

  std::unique_ptr<OffscreenSpheres> spheres_;
};

/// The table of a model, coarser than MERL's as no picture here needs more; of its parameters those of `set` have other
/// values than the default ones.
inline std::shared_ptr<const TabulatedBrdf> bakedModel(const char* id,
                                                       const std::vector<std::pair<const char*, double>>& set) {
  const models::Model& model = models::findModel(id);
  models::ParameterValues values = models::defaultParameters(model.spec());
  for (const auto& [name, value] : set) values.values[*model.spec().find(name)] = Rgb(value);
  return bakeTable(*model.instantiate(values), {60, 60, 60});
}

/// A model's edit of its roughness.
inline editing::Edit rougherEdit(const char* id, const char* parameter, double roughness,
                                 editing::Composition composition = editing::Composition::additive) {
  const models::Model& model = models::findModel(id);
  editing::DifferentialEdit edit{
      .model = &model, .fitted = models::defaultParameters(model.spec()), .composition = composition};
  edit.edited = edit.fitted;
  edit.edited.values[*model.spec().find(parameter)] = Rgb(roughness);
  return {edit};
}

/// The density of a material; that of the last one is kept, since many edits of one base are drawn in turn.
inline std::shared_ptr<const TabulatedDensity> densityOf(const std::shared_ptr<const Brdf>& brdf) {
  static std::shared_ptr<const Brdf> last;
  static std::shared_ptr<const TabulatedDensity> density;
  if (brdf != last) density = std::make_shared<const TabulatedDensity>(*brdf);
  last = brdf;
  return density;
}

/// SNR of the shader's picture of a subject against the CPU's, dB, as OffscreenSpheres::agreement().
inline double agreement(OffscreenSpheres& spheres, widgets::PreviewSubject subject, const rendering::Scene& scene,
                        double enough) {
  const std::shared_ptr<const Brdf> brdf = widgets::subjectBrdf(subject);
  const auto base = subject.base();
  subject.density = densityOf(base ? base : brdf);
  return spheres.agreement(subject, *brdf, scene, enough);
}

inline double agreement(OffscreenSpheres& spheres, const std::shared_ptr<const TabulatedBrdf>& table,
                        const editing::EditList& edits, const rendering::Scene& scene, double enough) {
  return agreement(spheres, {widgets::EditedMaterial{table, edits}}, scene, enough);
}

}  // namespace gonio::test
