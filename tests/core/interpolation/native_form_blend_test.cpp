// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/interpolation/native_form_blend.h"

#include <QTest>
#include <random>

#include "core/brdf/rgl_brdf.h"
#include "core/brdf/utia_brdf.h"
#include "core/brdf/weighted_sum.h"
#include "core/materials/material.h"
#include "tests/core/interpolation/interpolation_test_support.h"
#include "tests/support/test_program.h"

namespace native_form_blend_test {
using namespace gonio;
using namespace gonio::interpolation;
using namespace gonio::editing;
using namespace gonio::editing::test_support;

/// Anisotropic and not reciprocal; some values from numbers by chance.
std::shared_ptr<const Brdf> utia(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> value(0, 1);
  std::vector<glm::vec3> values(UtiaBrdf::directionCount * UtiaBrdf::directionCount);
  for (glm::vec3& one : values) one = {value(random), value(random), value(random)};
  return std::make_shared<const UtiaBrdf>(std::move(values));
}

std::shared_ptr<const Brdf> bundled(const char* name) {
  return materials::readMaterial(std::string("library:rgl/") + name).brdf;
}

/// Their tables do not matter where materials are mixed in their native form.
std::vector<InterpolationMaterial> ownForms(const std::vector<std::shared_ptr<const Brdf>>& forms) {
  static const Table table = measured(0.3, 0.2, 1);
  std::vector<InterpolationMaterial> ends;
  for (const auto& form : forms) ends.push_back({.table = table, .base = form});
  return ends;
}

std::optional<NativeFormBlend> blendOf(const std::vector<InterpolationMaterial>& ends,
                                       const std::vector<double>& weights,
                                       InterpolationSpace space = InterpolationSpace::linear) {
  return nativeFormBlend(*prepareInterpolation(space, ends, options()), weights);
}

/// The largest |a - b| / (1 + |b|) over directions between the nodes too.
double maxDifference(const Brdf& a, const Brdf& b, double maxTheta) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  double largest = 0;
  for (int i = 0; i < 2000; ++i) {
    const Direction wi = fromSpherical(maxTheta * uniform(random), 2 * pi * uniform(random)),
                    wo = fromSpherical(maxTheta * uniform(random), 2 * pi * uniform(random));
    const Rgb x = a.evaluate(wi, wo), y = b.evaluate(wi, wo);
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(x[c] - y[c]) / (1 + std::abs(y[c])));
  }
  return largest;
}

class OwnFormBlendTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// UTIA files are interpolated linearly over one grid: so are their blends.
  void utiaFilesBlendExactly() {
    const std::vector<std::shared_ptr<const Brdf>> files{utia(1), utia(2)};
    const std::vector<double> weights{0.3, 0.7};
    const auto blend = blendOf(ownForms(files), weights);
    QVERIFY(blend && formOf<UtiaBrdf>(*blend->brdf));
    QVERIFY(maxDifference(*blend->brdf, *weightedSum(files, weights), radians(75)) < 1e-6);
  }

  /// Of files with equal nodes too, negative colours and all, but where a node's light lies below the horizon: it
  /// changes as its neighbour does.
  void rglFilesWithTheSameNodesBlendExactly() {
    const auto file = bundled("leaf_maple");
    SliceStack<glm::vec3> dimmed = formOf<RglBrdf>(*file)->tables()->data.rgb;
    for (glm::vec3& value : dimmed.values) value *= glm::vec3(0.5f, 0.2f, 0.9f);
    const std::vector<std::shared_ptr<const Brdf>> files{
        file, formOf<RglBrdf>(*file)->withColours(dimmed, formOf<RglBrdf>(*file)->tables()->luminance.cellDensity())};
    const std::vector<double> weights{0.4, 0.6};
    const auto blend = blendOf(ownForms(files), weights);
    QVERIFY(blend && formOf<RglBrdf>(*blend->brdf));
    QVERIFY2(blend->accuracy > 45, qPrintable(QString::number(blend->accuracy)));
    const double difference = maxDifference(*blend->brdf, *weightedSum(files, weights), radians(50));
    QVERIFY2(difference < 1e-3, qPrintable(QString::number(difference)));
  }

  /// The nodes are those of the narrower highlight, whatever the order of the files.
  void theNodesAreThoseThatFollowTheBlend() {
    const auto wide = bundled("acrylic_felt_green"), narrow = bundled("satin_purple");
    const std::vector<double> weights{0.5, 0.5};
    const auto first = blendOf(ownForms({wide, narrow}), weights), second = blendOf(ownForms({narrow, wide}), weights);
    QCOMPARE(first->nodesOf, 1 - second->nodesOf);
    QCOMPARE(first->accuracy, second->accuracy);
    const auto nodes = first->nodesOf == 0 ? wide : narrow;
    QCOMPARE(formOf<RglBrdf>(*first->brdf)->tables()->data.rgb.width,
             formOf<RglBrdf>(*nodes)->tables()->data.rgb.width);
    QVERIFY2(first->accuracy > 35, qPrintable(QString::number(first->accuracy)));
    QVERIFY(maxDifference(*first->brdf, *second->brdf, radians(85)) < 1e-6);
  }

  void aWholeWeightIsTheFile() {
    const auto file = bundled("paper_blue");
    const auto blend = blendOf(ownForms({file, utia(1)}), {1, 0});
    QVERIFY(blend && formOf<RglBrdf>(*blend->brdf)->tables()->data.rgb.values ==
                         formOf<RglBrdf>(*file)->tables()->data.rgb.values);
  }

  /// No form holds what is made of tables, and what is mixed of two forms.
  void otherBlendsHaveNone() {
    const auto file = bundled("paper_blue");
    const std::vector<double> half{0.5, 0.5};
    QVERIFY(!blendOf(ownForms({file, utia(1)}), half));
    auto ends = ownForms({file, file});
    QVERIFY(blendOf(ends, half));
    for (const InterpolationSpace space : {InterpolationSpace::parameters, InterpolationSpace::factors})
      QVERIFY(!blendOf(ends, half, space));
    ends[1].base = nullptr;
    QVERIFY(!blendOf(ends, half));
    // No nodes serve a mirror's highlight and a felt's.
    QVERIFY(!blendOf(ownForms({bundled("chm_mint"), bundled("acrylic_felt_green")}), half));
  }
};

GONIO_TEST(OwnFormBlendTest)
}  // namespace native_form_blend_test

#include "native_form_blend_test.moc"
