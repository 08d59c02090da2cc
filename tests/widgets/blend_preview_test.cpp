// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/materials/material.h"
#include "core/metrics/image_metrics.h"
#include "core/models/registry.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_spheres.h"
#include "transformed_space.h"
#include "widgets/interpolation/prepared_blend.h"

namespace blend_preview_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::interpolation;
using interpolation::InterpolationSpace;

std::shared_ptr<const TabulatedBrdf> material(double roughness, const Rgb& colour, const HalfDifferenceGrid& grid) {
  const models::Model& model = models::ggx();
  models::ParameterValues values = models::defaultParameters(model.spec());
  values.values[*model.spec().find("roughness")] = Rgb(roughness);
  values.values[*model.spec().find("specular")] = colour;
  return bakeTable(*model.instantiate(values), grid);
}

/// Four materials that nobody takes for each other; the last on a grid of its own.
std::vector<interpolation::InterpolationMaterial> ends(int count) {
  static const std::vector<interpolation::InterpolationMaterial> all{{material(0.15, {0.9, 0.5, 0.2}, {30, 30, 36})},
                                                                     {material(0.5, {0.2, 0.6, 0.9}, {30, 30, 36})},
                                                                     {material(0.3, {0.8, 0.8, 0.8}, {30, 30, 36})},
                                                                     {material(0.4, {0.1, 0.9, 0.1}, {25, 28, 45})}};
  return {all.begin(), all.begin() + count};
}

/// With few curves: the shader sums them all alike.
widgets::PreparedBlendPtr prepared(InterpolationSpace space,
                                   const std::vector<interpolation::InterpolationMaterial>& materials,
                                   bool preserveDetail = true) {
  interpolation::InterpolationOptions options = documents::blendOptions(nullptr, preserveDetail);
  options.pdv.terms = 2;
  return widgets::prepareBlend(space, materials, options);
}

const std::vector<std::vector<double>> someWeights{{0.3, 0.7}, {0.2, 0.5, 0.3}, {0.1, 0.2, 0.3, 0.4}};

/// The shader's blends against the core's.
class BlendPreviewTest : public test::SphereTest {
  Q_OBJECT
 private:
  Image drawn(const widgets::PreviewSubject& subject, const Scene& scene, int samples) {
    return spheres_->drawn(subject, scene, samples);
  }
  void everySpaceIsThatOfCore(InterpolationSpace space, const std::vector<double>& weights, bool preserveDetail) {
    const auto blend = prepared(space, ends(int(weights.size())), preserveDetail);
    const auto subject = widgets::blendSubject(*blend, weights);
    const double snr = spheres_->agreement(subject, *blend->interpolation->brdf(weights), sphereScene(), 40);
    const QString what = QString("%1, %2 materials: %3 dB").arg(widgets::spaceName(space)).arg(weights.size()).arg(snr);
    qInfo("%s", qPrintable(what));
    QVERIFY2(snr > 40, qPrintable(what));
  }

 private Q_SLOTS:
  void initTestCase() { openSpheres(); }

  /// Tables that stand for another form: only in spaces whose values are mixed by the shader.
  void tablesOfOtherForms() {
    std::vector<interpolation::InterpolationMaterial> materials = ends(2);
    QVERIFY(!widgets::mixesTables(*prepared(InterpolationSpace::linear, materials)));
    materials[0].base = models::ggx().instantiate(models::defaultParameters(models::ggx().spec()));
    QVERIFY(widgets::mixesTables(*prepared(InterpolationSpace::linear, materials)));
    for (const auto space : {InterpolationSpace::parameters, InterpolationSpace::factors}) {
      QVERIFY(widgets::mixesTables(*prepared(space, materials)));
      QVERIFY(!widgets::mixesTables(*prepared(space, materials, false)));
    }
  }

  /// Every space, two to four materials: the frame under the hand is the interpolation of core.
  void everySpaceIsThatOfCore() {
    for (const auto space : {InterpolationSpace::linear, InterpolationSpace::parameters,
                             InterpolationSpace::differential, InterpolationSpace::factors})
      for (const std::vector<double>& weights : someWeights) everySpaceIsThatOfCore(space, weights, false);
  }

  /// With the measured detail, codes too; the last materials are on a grid of their own.
  void theMeasuredDetailIsThatOfCore() {
    for (const auto space :
         {InterpolationSpace::parameters, InterpolationSpace::factors, InterpolationSpace::dictionary})
      for (const std::vector<double>& weights : someWeights) everySpaceIsThatOfCore(space, weights, true);
  }

  /// A file that is not reciprocal, with negative colours: the picture nears it as its weight nears 1, in every space.
  void theMeasuredDetailEndsAtTheFile() {
    std::vector<interpolation::InterpolationMaterial> materials = ends(2);
    const materials::Material file = materials::readMaterial("library:rgl/satin_purple");
    materials[0] = {.table = file.tabulated(), .base = file.brdf};
    const Image alone = drawn(widgets::measuredSubject(file.brdf), sphereScene(), 64);
    for (const auto space :
         {InterpolationSpace::parameters, InterpolationSpace::factors, InterpolationSpace::dictionary}) {
      const auto blend = prepared(space, materials);
      const auto snr = [&](const std::vector<double>& weights) {
        auto subject = widgets::blendSubject(*blend, weights);
        subject.density = {};
        return metrics::signalToNoiseRatio(alone, drawn(subject, sphereScene(), 64));
      };
      const double near = snr({0.9999, 0.0001}), begun = snr({0.995, 0.005});
      qInfo("%s: %.1f dB at 99.99 %%, %.1f dB at 99.5 %%", qPrintable(widgets::spaceName(space)), near, begun);
      QVERIFY2(near > 60 && begun > 35, qPrintable(widgets::spaceName(space)));
    }
  }

  void theStudioToo() {
    const auto blend = widgets::prepareBlend(InterpolationSpace::linear, ends(2));
    const auto subject = widgets::blendSubject(*blend, someWeights[0]);
    const double snr =
        spheres_->agreement(subject, *blend->interpolation->brdf(someWeights[0]), sphereScene(studioEnvironment()), 30);
    QVERIFY2(snr > 30, qPrintable(QString("%1 dB").arg(snr)));
  }

  /// Mixed in a transformed domain and brought back, as sparse codes are.
  void transformedDomains() {
    for (const DataTransform transform :
         {DataTransform::logPlus, DataTransform::cosineLog, DataTransform::root, DataTransform::none}) {
      widgets::PreparedBlend blend{.space = InterpolationSpace::dictionary, .materials = ends(2), .lobes = {{}, {}}};
      blend.interpolation = std::make_shared<const test::TransformedSpace>(
          std::vector<interpolation::Interpolation::Table>{blend.materials[0].table, blend.materials[1].table},
          transform);
      blend.mixture = std::make_shared<const interpolation::TransformedMixture>(*blend.interpolation->mixture());
      const auto subject = widgets::blendSubject(blend, someWeights[0]);
      QVERIFY(std::holds_alternative<widgets::PreviewBlend>(subject.shown));
      const double snr = spheres_->agreement(subject, *widgets::subjectBrdf(subject), sphereScene(), 40);
      const QString what = QString("transform %1: %2 dB").arg(int(transform)).arg(snr);
      qInfo("%s", qPrintable(what));
      QVERIFY2(snr > 40, qPrintable(what));
    }
  }

  /// All of the weight on one material: the same bits as that material alone, in every space.
  void aCornerIsTheMaterial() {
    const Image alone = drawn(widgets::measuredSubject(ends(1)[0].table), sphereScene(), 64);
    for (const auto space : {InterpolationSpace::linear, InterpolationSpace::factors}) {
      auto subject = widgets::blendSubject(*prepared(space, ends(2)), {1, 0});
      subject.density = {};
      QVERIFY(drawn(subject, sphereScene(), 64).pixels == alone.pixels);
    }
  }

  /// A drag changes weights alone: the picture is that of a renderer which knows the last ones only.
  void aDragLeavesNothingBehind() {
    const auto blend = widgets::prepareBlend(InterpolationSpace::differential, ends(3));
    const auto last = widgets::blendSubject(*blend, {0.5, 0.25, 0.25});
    const Image expected = drawn(last, sphereScene(), 64);
    for (const auto& weights : {std::vector{0.1, 0.8, 0.1}, {1.0, 0.0, 0.0}, {0.0, 0.5, 0.5}})
      drawn(widgets::blendSubject(*blend, weights), sphereScene(), 64);
    QVERIFY(drawn(last, sphereScene(), 64).pixels == expected.pixels);
    // From two materials to three, and to a model alone.
    drawn(widgets::blendSubject(*widgets::prepareBlend(InterpolationSpace::linear, ends(2)), {0.5, 0.5}), sphereScene(),
          64);
    drawn(widgets::blendSubject(*widgets::prepareBlend(InterpolationSpace::parameters, ends(2)), {0.5, 0.5}),
          sphereScene(), 64);
    QVERIFY(drawn(last, sphereScene(), 64).pixels == expected.pixels);
  }

  /// Where one material has no data it adds nothing; what the others have stays.
  void invalidCellsAddNothing() {
    const HalfDifferenceGrid grid{8, 8, 8};
    std::vector<std::uint8_t> all(grid.size(), 1), none(grid.size(), 0);
    const std::vector<glm::vec3> values(grid.size(), glm::vec3(0.5f));
    const auto full = std::make_shared<const TabulatedBrdf>(grid, values, all);
    const auto empty = std::make_shared<const TabulatedBrdf>(grid, values, none);
    const auto blend = widgets::prepareBlend(InterpolationSpace::linear, {{full}, {empty}});
    const auto subject = widgets::blendSubject(*blend, {0.5, 0.5});
    const Image picture = drawn(subject, sphereScene(), 64);
    const Image expected = drawn(widgets::measuredSubject(full), sphereScene(), 64);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
      QVERIFY(glm::length(picture.pixels[i] - 0.5f * expected.pixels[i]) < 1e-6f);
  }

  /// A measured file beside a table: itself at the end, near the native forms' mixture before it, and no step where
  /// another material takes the lead.
  void filesInTheirOwnForm() {
    std::vector<interpolation::InterpolationMaterial> materials = ends(2);
    const materials::Material file = materials::readMaterial("library:rgl/satin_purple");
    materials[0] = {.table = file.tabulated(), .base = file.brdf};
    const Image alone = drawn(widgets::measuredSubject(file.brdf), sphereScene(), 64);
    for (const auto space : {InterpolationSpace::linear, InterpolationSpace::differential}) {
      const auto blend = widgets::prepareBlend(space, materials);
      auto whole = widgets::blendSubject(*blend, {1, 0});
      whole.density = {};
      QVERIFY(drawn(whole, sphereScene(), 64).pixels == alone.pixels);
      const auto snr = [&](const std::vector<double>& weights) {
        const auto subject = widgets::blendSubject(*blend, weights);
        return spheres_->agreement(subject, *blend->interpolation->brdf(weights), sphereScene(), 40);
      };
      const double near = snr({0.95, 0.05}), middle = snr({0.5, 0.5});
      qInfo("%s: %.1f dB at 95 %%, %.1f dB at 50 %%", qPrintable(widgets::spaceName(space)), near, middle);
      QVERIFY2(near > 40, qPrintable(QString::number(near)));
      QVERIFY(near > middle);
      const Image before = drawn(widgets::blendSubject(*blend, {0.501, 0.499}), sphereScene(), 64),
                  behind = drawn(widgets::blendSubject(*blend, {0.499, 0.501}), sphereScene(), 64);
      for (std::size_t i = 0; i < before.pixels.size(); ++i)
        QVERIFY(glm::length(before.pixels[i] - behind.pixels[i]) < 0.01f * (1 + glm::length(before.pixels[i])));
    }
  }

  /// Subjects differ in the materials that they blend and in the weights.
  void subjectsAreToldApart() {
    const auto blend = widgets::prepareBlend(InterpolationSpace::linear, ends(2));
    const auto half = widgets::blendSubject(*blend, {0.5, 0.5});
    QVERIFY(widgets::sameSubject(half, widgets::blendSubject(*blend, {0.5, 0.5})));
    QVERIFY(!widgets::sameSubject(half, widgets::blendSubject(*blend, {0.4, 0.6})));
    QVERIFY(!widgets::sameSubject(half, widgets::measuredSubject(ends(1)[0].table, half.density)));
    QVERIFY(!half.isEmpty() && !half.isMeasured());
  }
};

GONIO_TEST(BlendPreviewTest)
}  // namespace blend_preview_test

#include "blend_preview_test.moc"
