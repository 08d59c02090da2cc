// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/lobe_change.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/coordinates/half_difference.h"
#include "core/editing/edit.h"
#include "core/editing/lobe_warp.h"
#include "core/models/registry.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace lobe_change_test {
using namespace gonio;
using namespace gonio::editing;
using gonio::test::FunctionBrdf;

std::size_t index(const models::Model& model, const char* id) { return *model.spec().find(id); }

DifferentialEdit roughened(double factor) {
  const models::Model& model = models::layered();
  DifferentialEdit edit{.model = &model,
                        .fitted = models::defaultParameters(model.spec()),
                        .edited = {},
                        .composition = Composition::lobes};
  edit.edited = edit.fitted;
  edit.edited.values[index(model, "coat-roughness")] *= factor;
  return edit;
}

std::vector<DirectionPair> pairs(int count, int seed = 1) {
  std::mt19937_64 random{std::uint64_t(seed)};
  std::uniform_real_distribution<double> height(0.02, 1), around(-pi, pi);
  std::vector<DirectionPair> result;
  for (int i = 0; i < count; ++i)
    result.push_back({fromSpherical(std::acos(height(random)), around(random)),
                      fromSpherical(std::acos(height(random)), around(random))});
  return result;
}

class LobeChangeTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theWarpScalesTheTangentAlone() {
    for (const DirectionPair& pair : pairs(2000)) {
      const HalfDifference from = toHalfDifference(pair.wi, pair.wo);
      for (const double scale : {0.1, 0.5, 1.0, 1.3}) {
        const DirectionPair moved = withScaledHalfTangent(pair, scale);
        const HalfDifference to = toHalfDifference(moved.wi, moved.wo);
        QVERIFY(moved.wi.z > 0 && moved.wo.z > 0);
        QVERIFY(std::abs(to.thetaD - from.thetaD) < 1e-9);
        const double wanted = std::atan(scale * std::tan(from.thetaH));
        const bool isAtTheHorizon = std::min(moved.wi.z, moved.wo.z) < 0.011;
        QVERIFY(isAtTheHorizon ? to.thetaH <= wanted + 1e-9 && to.thetaH >= from.thetaH - 1e-9
                               : std::abs(to.thetaH - wanted) < 1e-9);
        if (from.thetaH > 1e-3 && from.thetaD > 1e-3)
          QVERIFY(std::abs(std::remainder(to.phiD - from.phiD, 2 * pi)) < 1e-6);
      }
    }
    const DirectionPair mirror{fromSpherical(0.7, 0), fromSpherical(0.7, pi)};
    QVERIFY(withScaledHalfTangent(mirror, 3).wi == mirror.wi);
  }

  /// A body that is made grey is grey, whatever the fit missed in a channel where it was dark.
  void aNewColourCarriesTheRatioOfLuminance() {
    const Rgb red(0.4, 0.02, 0.01), ratio(1.1, 3, 0.2);
    QVERIFY(recolouredRatio(ratio, red, red) == ratio);
    QVERIFY(glm::length(recolouredRatio(ratio, red, 0.25 * red) - ratio) < 1e-12);
    const double grey = luminance(red * ratio) / luminance(red);
    const Rgb found = recolouredRatio(ratio, red, Rgb(luminance(red)));
    QVERIFY(std::abs(found.x - ratio.x) < 1e-12);
    QVERIFY(std::abs(found.z - grey) < 0.1 * std::abs(ratio.z - grey));
    // Between: as far as the channel keeps its chromaticity.
    const Rgb half = recolouredRatio(Rgb(1, 1, 2), Rgb(0.5), Rgb(0.5, 0.5, 1));
    const double kept = luminance(Rgb(0.5, 0.5, 1)) / 1.0, mean = luminance(Rgb(1, 1, 2));
    QVERIFY(std::abs(half.z - (kept * 2 + (1 - kept) * mean)) < 1e-12);
    for (const Rgb& black : {Rgb(0), Rgb(1e-300)}) {
      QVERIFY(recolouredRatio(ratio, black, red) == ratio);
      QVERIFY(recolouredRatio(ratio, red, black) == ratio);
    }
  }

  /// Where the measurement is the fit the edit is the edited model.
  void ofTheModelItselfItIsTheEditedModel() {
    for (const double factor : {0.25, 0.5, 2.0, 8.0}) {
      const Edit edit{roughened(factor)};
      const auto& content = std::get<DifferentialEdit>(edit.content);
      const std::shared_ptr<const Brdf> base = content.model->instantiate(content.fitted);
      const auto found = applyEdits(base, std::span(&edit, 1));
      const auto expected = content.model->instantiate(content.edited);
      for (const DirectionPair& pair : pairs(500)) {
        const Rgb a = found->evaluate(pair.wi, pair.wo), b = expected->evaluate(pair.wi, pair.wo);
        for (int c = 0; c < 3; ++c) QVERIFY(std::abs(a[c] - b[c]) <= 1e-9 * (1 + b[c]));
      }
    }
  }

  /// A measurement that is twice the fit inside the lobe: the wider lobe is twice as bright at the same place of its
  /// own profile, not where the old one was.
  void theRatioMovesWithTheLobe() {
    DifferentialEdit edit = roughened(4);
    for (const char* other : {"diffuse", "base", "base-edge", "flakes", "flakes-edge"})
      edit.fitted.values[index(*edit.model, other)] = edit.edited.values[index(*edit.model, other)] = Rgb(0);
    const std::shared_ptr<const Brdf> model = edit.model->instantiate(edit.fitted);
    const double edge = 0.08;  // of tan theta_h: beyond it the measurement is the fit
    const FunctionBrdf measured([&](const Direction& wi, const Direction& wo) {
      const double tangent = std::tan(toHalfDifference(wi, wo).thetaH);
      return model->evaluate(wi, wo) * (tangent < edge ? 2.0 : 1.0);
    });
    const auto ratioAt = [&](double tangent) {
      const DirectionPair pair{fromSpherical(0.3 + std::atan(tangent), 0), fromSpherical(0.3 - std::atan(tangent), pi)};
      const Rgb value = measured.evaluate(pair.wi, pair.wo);
      Rgb change(0);
      LobeChange(edit).evaluate(measured, std::span(&pair, 1), std::span(&value, 1), std::span(&change, 1));
      return (value + change).x / edit.model->instantiate(edit.edited)->evaluate(pair.wi, pair.wo).x;
    };
    QVERIFY(ratioAt(0.02) > 1.95);
    QVERIFY(ratioAt(3.5 * edge) > 1.8);
    QVERIFY(ratioAt(4.5 * edge) < 1.05);
  }

  void anEditThatChangesNothingAddsNothing() {
    const DifferentialEdit edit = roughened(1);
    const FunctionBrdf measured([](const Direction& wi, const Direction& wo) { return Rgb(0.1 + wi.z * wo.z); });
    for (const DirectionPair& pair : pairs(50)) {
      const Rgb value = measured.evaluate(pair.wi, pair.wo);
      Rgb change(0);
      LobeChange(edit).evaluate(measured, std::span(&pair, 1), std::span(&value, 1), std::span(&change, 1));
      QVERIFY(change == Rgb(0));
    }
  }

  void anyEditIsFiniteAndNotNegative() {
    const models::Model& model = models::layered();
    const FunctionBrdf measured([](const Direction& wi, const Direction& wo) {
      const double h = toHalfDifference(wi, wo).thetaH;
      return Rgb(3000 * std::exp(-h * h / 2e-4), h < 0.2 ? 0 : 0.02, 1e-9);
    });
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit;
    for (int trial = 0; trial < 200; ++trial) {
      DifferentialEdit edit{.model = &model, .fitted = {}, .edited = {}, .composition = Composition::lobes};
      for (models::ParameterValues* values : {&edit.fitted, &edit.edited})
        for (const models::ParameterSpec& spec : model.spec().parameters)
          values->values.emplace_back(spec.softMin + (spec.softMax - spec.softMin) * std::pow(unit(random), 4));
      const Edit one{edit};
      const auto edited =
          applyEdits(std::shared_ptr<const Brdf>(std::shared_ptr<void>(), &measured), std::span(&one, 1));
      for (const DirectionPair& pair : pairs(100, trial)) {
        const Rgb value = edited->evaluate(pair.wi, pair.wo);
        for (int c = 0; c < 3; ++c) QVERIFY(std::isfinite(value[c]) && value[c] >= 0);
      }
    }
  }

  void modelsThatAreNoSumOfLobesAreRefused() {
    DifferentialEdit edit{.model = &models::findModel("phong"), .fitted = {}, .edited = {}};
    edit.fitted = edit.edited = models::defaultParameters(edit.model->spec());
    try {
      LobeChange{edit};
      QFAIL("accepted");
    } catch (const Error& error) {
      QVERIFY(std::string(error.what()).find("additive or log-plus") != std::string::npos);
    }
  }
};

GONIO_TEST(LobeChangeTest)
}  // namespace lobe_change_test

#include "lobe_change_test.moc"
