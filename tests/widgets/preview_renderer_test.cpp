// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/preview_renderer.h"

#include <QTest>

#include "tests/support/test_program.h"
#include "tests/widgets/filter_step.h"
#include "tests/widgets/offscreen_spheres.h"

namespace preview_renderer_test {
using namespace gonio;
using namespace gonio::rendering;
using test::agreement;
using test::bakedModel;

constexpr int side = test::OffscreenSpheres::side;

class PreviewRendererTest : public test::SphereTest {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { openSpheres(); }

  /// The model alone, without its table, is the model of the core: under one light every model, under an environment
  /// one.
  void modelAlone() {
    for (const models::Model* model : models::allModels()) {
      const double snr = agreement(
          *spheres_, {widgets::StandaloneModel{model, models::defaultParameters(model->spec())}}, sphereScene(), 40);
      QVERIFY2(snr > 40, qPrintable(QString("%1: %2 dB").arg(model->spec().id.data()).arg(snr)));
    }
    const models::Model& ggx = models::findModel("ggx");
    const double snr = agreement(*spheres_, {widgets::StandaloneModel{&ggx, models::defaultParameters(ggx.spec())}},
                                 comparisonScene(), 30);
    QVERIFY2(snr > 30, qPrintable(QString("%1 dB").arg(snr)));
  }

  /// A model alone is the same picture whatever table was shown before it.
  void modelAloneIgnoresTheTable() {
    const models::Model& ggx = models::findModel("ggx");
    const widgets::PreviewSubject subject{widgets::StandaloneModel{&ggx, models::defaultParameters(ggx.spec())}};
    test::showSphere(renderer(), sphereScene());
    renderer().setSize({side, side});
    renderer().setSubject(subject);
    renderer().accumulate(8);
    const Image alone = renderer().readPicture();
    renderer().setSubject(widgets::measuredSubject(bakedModel("lambert", {})));
    renderer().accumulate(8);
    QVERIFY(renderer().readPicture().pixels != alone.pixels);
    renderer().setSubject(subject);
    renderer().accumulate(8);
    QVERIFY(renderer().readPicture().pixels == alone.pixels);
  }

  /// Two pictures of one context share a table's texture and keep their own accumulations.
  void twoPicturesShareResources() {
    const auto table = bakedModel("ggx", {{"roughness", 0.3}});
    const auto resources = std::make_shared<widgets::PreviewResources>();
    widgets::PreviewRenderer first(resources), second(resources);
    first.initialize();
    second.initialize();
    const auto texture = resources->table(table);
    QCOMPARE(resources->table(table), texture);
    for (widgets::PreviewRenderer* picture : {&first, &second}) {
      picture->setSubject(widgets::measuredSubject(table));
      test::showSphere(*picture, sphereScene());
      picture->setSize({side, side});
    }
    first.accumulate(4);
    first.accumulate(4);
    second.accumulate(4);
    QCOMPARE(first.samples(), 8);
    QCOMPARE(second.samples(), 4);
    second.accumulate(4);
    QVERIFY(first.readPicture().pixels == second.readPicture().pixels);
    first.release();
    second.release();
    resources->release();
  }

  /// Cells without data around the valid ones are NaN-free and do not darken them: a constant table with holes renders
  /// like the constant table wherever an interpolation corner is valid. A filter that rounds its weights to a step
  /// finds none beside an invalid node, within half a step: a pixel may show that for a sample of its own.
  void invalidCellsDoNotBleed() {
    const HalfDifferenceGrid grid;
    std::vector<glm::vec3> values(grid.size(), glm::vec3(0.25f));
    std::vector<std::uint8_t> all(grid.size(), 1), holes(grid.size(), 1);
    for (std::size_t i = 0; i < holes.size(); ++i) holes[i] = i % 2 == 0;  // every second phi_d
    const auto full = std::make_shared<const TabulatedBrdf>(grid, values, all);
    const auto sparse = std::make_shared<const TabulatedBrdf>(grid, values, holes);
    test::showSphere(renderer(), sphereScene());
    renderer().setSize({side, side});
    renderer().setSubject(widgets::measuredSubject(full));
    renderer().accumulate(4);
    const Image expected = renderer().readPicture();
    renderer().setSubject(widgets::measuredSubject(sparse));
    renderer().accumulate(4);
    const Image actual = renderer().readPicture();
    std::size_t different = 0;
    for (std::size_t i = 0; i < expected.pixels.size(); ++i)
      if (!(glm::length(expected.pixels[i] - actual.pixels[i]) <= 1e-5f * (1 + glm::length(expected.pixels[i]))))
        ++different;
    // Half of the nodes are invalid, each with half a step on both sides. Four standard deviations more for chance.
    widgets::PreviewResources resources;
    resources.initialize();
    const double most = 4 * double(expected.pixels.size()) * test::filterStep(resources) / 2;
    resources.release();
    QVERIFY2(double(different) <= most + 4 * std::sqrt(most),
             qPrintable(QString("%1 pixels differ, expected at most %2").arg(different).arg(most)));
  }
};

GONIO_TEST(PreviewRendererTest)
}  // namespace preview_renderer_test

#include "preview_renderer_test.moc"
