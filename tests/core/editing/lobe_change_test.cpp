// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/lobe_change.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/editing/edit.h"
#include "core/models/registry.h"
#include "tests/core/editing/direction_pairs.h"
#include "tests/support/function_brdf.h"
#include "tests/support/ring_albedo.h"
#include "tests/support/test_program.h"

namespace lobe_change_test {
using namespace gonio;
using namespace gonio::editing;
using gonio::test::FunctionBrdf;
using gonio::test::pairs;

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

std::vector<const models::Model*> modelsWithGrain() {
  std::vector<const models::Model*> result;
  for (const models::Model* model : models::allModels())
    if (model->hasLobes() && model->spec().find("rotation")) result.push_back(model);
  return result;
}

/// Another rotation, and widths of `alpha` and three times that by a factor.
DifferentialEdit ofGrain(const models::Model& model, double alpha, double factor) {
  DifferentialEdit edit{.model = &model,
                        .fitted = models::defaultParameters(model.spec()),
                        .edited = {},
                        .composition = Composition::lobes};
  const auto set = [&](models::ParameterValues& values, const char* roughness, const char* exponent, double width) {
    if (const auto i = model.spec().find(roughness)) values.values[*i] = Rgb(width);
    if (const auto i = model.spec().find(exponent)) values.values[*i] = Rgb(2 / (width * width));
  };
  edit.edited = edit.fitted;
  for (const auto& [values, scale, rotation] : {std::tuple{&edit.fitted, 1.0, 0.2}, {&edit.edited, factor, 0.9}}) {
    set(*values, "roughness-x", "exponent-x", scale * alpha);
    set(*values, "roughness-y", "exponent-y", scale * alpha / 3);
    values->values[index(model, "rotation")] = Rgb(rotation);
  }
  return edit;
}

/// A width and a colour, by lobes.
Edit widened(double factor, const Rgb& tint) {
  const models::Model& model = models::findModel("ggx");
  DifferentialEdit edit{.model = &model,
                        .fitted = models::defaultParameters(model.spec()),
                        .edited = {},
                        .composition = Composition::lobes};
  edit.edited = edit.fitted;
  edit.edited.values[index(model, "roughness")] *= factor;
  edit.edited.values[index(model, "diffuse")] *= tint;
  return {edit};
}

Direction direction(double degrees) {
  const double theta = degrees * pi / 180;
  return {std::sin(theta), 0, std::cos(theta)};
}

double albedo(const Brdf& brdf, double degrees) { return test::ringAlbedo(brdf, degrees, 400, 64).y; }

/// The fit of an edit of GGX, and a lobe of width `peak` that it misses (0: none).
std::shared_ptr<const Brdf> measuredWithPeak(Edit& edit, double peak) {
  auto& change = std::get<DifferentialEdit>(edit.content);
  change.fitted.values[index(*change.model, "diffuse")] = Rgb(0.05, 0.04, 0.02);
  change.fitted.values[index(*change.model, "roughness")] = Rgb(0.2);
  change.edited = change.fitted;
  models::ParameterValues missed = change.fitted;
  missed.values[index(*change.model, "diffuse")] = Rgb(0);
  missed.values[index(*change.model, "specular")] *= peak > 0 ? 0.2 : 0;
  missed.values[index(*change.model, "roughness")] = Rgb(peak > 0 ? peak : 0.2);
  const std::shared_ptr<const Brdf> fitted = change.model->instantiate(change.fitted),
                                    added = change.model->instantiate(missed);
  return std::make_shared<const FunctionBrdf>(
      [=](const Direction& wi, const Direction& wo) { return fitted->evaluate(wi, wo) + added->evaluate(wi, wo); });
}

class LobeChangeTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// A list is what its edits are one after the other, bit for bit.
  void aListIsOneEditAfterTheOther() {
    const auto base = std::make_shared<const FunctionBrdf>([](const Direction& wi, const Direction& wo) {
      const Direction h = glm::normalize(wi + wo);
      return Rgb(0.1, 0.2, 0.05) + Rgb(0.5) * std::pow(h.z, 40.0);
    });
    Edit additive = widened(2, Rgb(0.5, 1, 1));
    std::get<DifferentialEdit>(additive.content).composition = Composition::additive;
    const EditList edits{widened(2, Rgb(1)), additive, widened(1, Rgb(1, 0.5, 0.5)), widened(0.7, Rgb(1)), additive};
    std::shared_ptr<const Brdf> nested = base;
    for (const Edit& edit : edits) nested = applyEdits(nested, std::span(&edit, 1));
    const auto all = applyEdits(base, edits);
    const std::vector<DirectionPair> directions = pairs(500);
    std::vector<Rgb> one(directions.size()), other(directions.size()), unedited(directions.size());
    all->evaluate(directions, one);
    nested->evaluate(directions, other);
    base->evaluate(directions, unedited);
    QVERIFY(one == other);
    QVERIFY(one != unedited);
  }

  /// The cost is counted, not the length alone: eleven changes of width evaluate the base 2048 times.
  void listsAreLimited() {
    const auto error = [](std::size_t count, const Edit& edit) {
      try {
        checkLimits(EditList(count, edit));
        return std::string();
      } catch (const Error& limit) {
        return std::string(limit.what());
      }
    };
    const Edit width = widened(2, Rgb(1)), colour = widened(1, Rgb(0.5));
    QCOMPARE(error(10, width), "");
    QVERIFY(error(11, width).find("2048 times") != std::string::npos);
    QCOMPARE(error(maxEdits, colour), "");
    QVERIFY(error(maxEdits + 1, colour).find("more than 100 edits") != std::string::npos);
    Edit without = width;
    without.enabled = false;
    QCOMPARE(error(maxEdits, without), "");
    // What is counted is what happens.
    int calls = 0;
    const auto base = std::make_shared<const FunctionBrdf>([&](const Direction&, const Direction&) {
      ++calls;
      return Rgb(0.2);
    });
    (void)applyEdits(base, EditList(10, width))->evaluate(glm::normalize(Direction(0.3, 0.1, 1)), {0, 0, 1});
    QCOMPARE(calls, 1024);
  }

  /// A list of any length is evaluated and destroyed without recursion; no limit applies to callers of the library.
  void longListsNeedNoStack() {
    const auto base = std::make_shared<const FunctionBrdf>([](const Direction&, const Direction&) { return Rgb(0.2); });
    const auto edited = applyEdits(base, EditList(100'000, widened(1, Rgb(0.5))));
    const Rgb value = edited->evaluate({0, 0, 1}, {0, 0, 1});
    QVERIFY(value.x >= 0 && std::isfinite(value.x));
    QVERIFY(edited->isIsotropic() && edited->isReciprocal());
  }

  /// A colour outside sRGB, with a channel below 0, stays so while its highlight widens, and no sharp peak remains in
  /// it.
  void negativeChannelsWidenWithTheHighlight() {
    const models::Model& model = models::ggx();
    DifferentialEdit edit{.model = &model,
                          .fitted = models::defaultParameters(model.spec()),
                          .edited = {},
                          .composition = Composition::lobes};
    edit.fitted.values[index(model, "diffuse")] = Rgb(0);
    edit.fitted.values[index(model, "roughness")] = Rgb(0.05);
    edit.edited = edit.fitted;
    edit.edited.values[index(model, "roughness")] = Rgb(0.2);
    const Rgb colour(-0.2, 1, 0.7);
    const auto coloured = [&](const models::ParameterValues& values) {
      const std::shared_ptr<const Brdf> lobe = model.instantiate(values);
      return std::make_shared<const FunctionBrdf>(
          [=](const Direction& wi, const Direction& wo) { return colour * lobe->evaluate(wi, wo); });
    };
    const Edit step{.content = edit};
    const auto found = applyEdits(coloured(edit.fitted), std::span(&step, 1));
    const auto wanted = coloured(edit.edited);
    for (const double theta : {0.1, 0.6, 1.1})
      for (const double off : {0.0, 0.01, 0.03}) {
        const Direction wi = fromSpherical(theta, 0), wo = fromSpherical(theta + off, pi);
        const Rgb value = wanted->evaluate(wi, wo), difference = found->evaluate(wi, wo) - value;
        QVERIFY(value.x < 0 && glm::length(difference) < 0.02 * glm::length(value));
      }
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

  /// A coat that is added is clear, whatever the fit missed of a body that is dark in a channel.
  void aNewLobeCarriesNoRatio() {
    const models::Model& model = models::layered();
    DifferentialEdit content{.model = &model,
                             .fitted = models::defaultParameters(model.spec()),
                             .edited = {},
                             .composition = Composition::lobes};
    content.fitted.values[index(model, "diffuse")] = Rgb(0.3, 0.05, 0.01);
    content.fitted.values[index(model, "coat-lobe")] = Rgb(0);
    content.edited = content.fitted;
    content.edited.values[index(model, "coat-lobe")] = Rgb(1);
    content.edited.values[index(model, "coat-roughness")] = Rgb(0.3);
    const std::shared_ptr<const Brdf> base = test::ggx(Rgb(0.3, 0.05, 0.05), Rgb(0.5), 0.3, 0.5);
    const Edit step{.content = content};
    const auto found = applyEdits(base, std::span(&step, 1));
    const auto coat = std::move(model.lobes(content.edited)[3].brdf);
    for (const DirectionPair& pair : pairs(500)) {
      const Rgb expected = base->evaluate(pair.wi, pair.wo) + coat->evaluate(pair.wi, pair.wo);
      QVERIFY(glm::length(found->evaluate(pair.wi, pair.wo) - expected) <= 1e-9 * (1 + glm::length(expected)));
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

  /// The same with two widths and a rotation, where the base has a grain too.
  void ofAnAnisotropicModelItselfItIsTheEditedModel() {
    for (const models::Model* model : modelsWithGrain()) {
      const Edit edit{ofGrain(*model, 0.4, 2)};
      const auto& content = std::get<DifferentialEdit>(edit.content);
      QVERIFY(isAnisotropic(edit));
      const std::shared_ptr<const Brdf> base = model->instantiate(content.fitted);
      const auto found = applyEdits(base, std::span(&edit, 1));
      const auto expected = model->instantiate(content.edited);
      for (const DirectionPair& pair : pairs(500)) {
        const Rgb a = found->evaluate(pair.wi, pair.wo), b = expected->evaluate(pair.wi, pair.wo);
        for (int c = 0; c < 3; ++c)
          QVERIFY2(std::abs(a[c] - b[c]) <= 1e-9 * (1 + b[c]), std::string(model->spec().id).c_str());
      }
    }
  }

  /// An anisotropic model with equal widths carries the ratio as the isotropic one does.
  void equalWidthsAreTheIsotropicEdit() {
    const models::Model &grain = models::findModel("ggx-anisotropic"), &plain = models::ggx();
    const auto edit = [](const models::Model& model, std::initializer_list<const char*> widths) {
      DifferentialEdit result{.model = &model,
                              .fitted = models::defaultParameters(model.spec()),
                              .edited = {},
                              .composition = Composition::lobes};
      result.edited = result.fitted;
      for (const char* width : widths) {
        result.fitted.values[index(model, width)] = Rgb(0.2);
        result.edited.values[index(model, width)] = Rgb(0.1);
      }
      return Edit{result};
    };
    const Edit a = edit(grain, {"roughness-x", "roughness-y"}), b = edit(plain, {"roughness"});
    const FunctionBrdf measured([](const Direction& wi, const Direction& wo) {
      return Rgb(0.1 + wi.z * wo.z, std::exp(-20 * toHalfDifference(wi, wo).thetaH), 0.1 + 0.05 * wi.x * wo.x);
    });
    const std::shared_ptr<const Brdf> base(std::shared_ptr<void>(), &measured);
    const auto first = applyEdits(base, std::span(&a, 1)), second = applyEdits(base, std::span(&b, 1));
    for (const DirectionPair& pair : pairs(500)) {
      const Rgb one = first->evaluate(pair.wi, pair.wo), other = second->evaluate(pair.wi, pair.wo);
      for (int c = 0; c < 3; ++c) QVERIFY(std::abs(one[c] - other[c]) < 1e-9 * (1 + other[c]));
    }
  }

  /// A bright stripe of the measurement goes where the same slopes of the wider lobe are, and turns with its grain.
  void theRatioMovesAlongTheGrain() {
    const models::Model& model = models::findModel("ggx-anisotropic");
    DifferentialEdit edit = ofGrain(model, 0.1, 3);
    edit.fitted.values[index(model, "diffuse")] = edit.edited.values[index(model, "diffuse")] = Rgb(0);
    const auto angle = [&](const models::ParameterValues& p) { return p.values[index(model, "rotation")].x; };
    const std::shared_ptr<const Brdf> fitted = model.instantiate(edit.fitted), wider = model.instantiate(edit.edited);
    const auto slopeAlong = [](const Direction& wi, const Direction& wo, double grain) {
      const Direction sum = wi + wo;
      return (sum.x * std::cos(grain) + sum.y * std::sin(grain)) / sum.z;
    };
    const double edge = 0.05;  // beyond it the measurement is the fit
    const FunctionBrdf measured([&](const Direction& wi, const Direction& wo) {
      return fitted->evaluate(wi, wo) * (std::abs(slopeAlong(wi, wo, angle(edit.fitted))) < edge ? 2.0 : 1.0);
    });
    const Edit one{edit};
    const auto edited = applyEdits(std::shared_ptr<const Brdf>(std::shared_ptr<void>(), &measured), std::span(&one, 1));
    for (const DirectionPair& pair : pairs(2000, 3)) {
      const double slope = std::abs(slopeAlong(pair.wi, pair.wo, angle(edit.edited))) / 3;
      const double value = wider->evaluate(pair.wi, pair.wo).x, found = edited->evaluate(pair.wi, pair.wo).x / value;
      if (value < 1 || std::abs(slope - edge) < 0.005 || std::min(pair.wi.z, pair.wo.z) < 0.4) continue;
      QVERIFY2(slope < edge ? found > 1.9 : found < 1.1, qPrintable(QString("%1 at %2").arg(found).arg(slope)));
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
      LobeChange(edit, measured).evaluate(measured, std::span(&pair, 1), std::span(&value, 1), std::span(&change, 1));
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
      LobeChange(edit, measured).evaluate(measured, std::span(&pair, 1), std::span(&value, 1), std::span(&change, 1));
      QVERIFY(change == Rgb(0));
    }
  }

  /// Over eleven angles and three factors, of a fit that explains the measurement and of one that misses a peak; the
  /// integral is dense and of its own.
  void highlightsKeepTheirAlbedo() {
    for (const double peak : {0.0, 0.02})
      for (const double factor : {0.25, 2.0, 4.0}) {
        Edit edit = widened(1, Rgb(1));
        const auto base = measuredWithPeak(edit, peak);
        auto& change = std::get<DifferentialEdit>(edit.content);
        change.controls.values[std::size_t(ArtistControl::roughness)] = Rgb(factor);
        const auto loses = applyEdits(base, std::span(&edit, 1));
        change.keepsAlbedo = true;
        const auto keeps = applyEdits(base, std::span(&edit, 1));
        double lost = 0;
        for (const double degrees : {0, 10, 20, 30, 40, 50, 60, 65, 70, 75, 80}) {
          const double before = albedo(*base, degrees), after = albedo(*keeps, degrees);
          QVERIFY2(std::abs(after / before - 1) < 0.02,
                   qPrintable(QString("peak %1, factor %2, %3 degrees: %4 became %5")
                                  .arg(peak)
                                  .arg(factor)
                                  .arg(degrees)
                                  .arg(before)
                                  .arg(after)));
          lost = std::max(lost, std::abs(albedo(*loses, degrees) / before - 1));
        }
        QVERIFY(factor < 1 || lost > 0.1);
      }
  }

  /// A peak that one fitted lobe misses leaves a sharp copy, which the switch removes.
  void peaksWidenWithTheHighlight() {
    Edit edit = widened(1, Rgb(1));
    const auto base = measuredWithPeak(edit, 0.02);
    auto& change = std::get<DifferentialEdit>(edit.content);
    change.controls.values[std::size_t(ArtistControl::roughness)] = Rgb(4);
    const auto contrast = [&] {
      const auto edited = applyEdits(base, std::span(&edit, 1));
      const auto at = [&](double degrees) { return edited->evaluate(direction(40), direction(-40 - degrees)).y; };
      return at(0) / at(6);
    };
    QVERIFY(base->evaluate(direction(40), direction(-40)).y / base->evaluate(direction(40), direction(-46)).y > 10);
    QVERIFY(contrast() > 3);
    change.keepsAlbedo = true;
    QVERIFY(contrast() < 1.2);
  }

  /// The switch alone, without a change of width, changes no strength and no colour of an exact fit.
  void theSwitchIsAboutWidths() {
    Edit edit = widened(1, Rgb(1));
    const auto base = measuredWithPeak(edit, 0);
    auto& change = std::get<DifferentialEdit>(edit.content);
    change.controls.values[std::size_t(ArtistControl::specularStrength)] = Rgb(2);
    const auto off = applyEdits(base, std::span(&edit, 1));
    change.keepsAlbedo = true;
    const auto on = applyEdits(base, std::span(&edit, 1));
    for (const DirectionPair& pair : pairs(200)) {
      const Rgb one = off->evaluate(pair.wi, pair.wo), other = on->evaluate(pair.wi, pair.wo);
      QVERIFY(glm::length(one - other) <= 1e-9 + 1e-6 * glm::length(one));
    }
  }

  void anyEditIsFiniteAndNotNegative() {
    for (const models::Model* model : models::allModels())
      if (model->hasLobes()) anyEditOf(*model);
  }

 private:
  void anyEditOf(const models::Model& model) {
    const FunctionBrdf measured([](const Direction& wi, const Direction& wo) {
      const double h = toHalfDifference(wi, wo).thetaH;
      return Rgb(3000 * std::exp(-h * h / 2e-4), h < 0.2 ? 0 : 0.02, 1e-9);
    });
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit;
    for (int trial = 0; trial < 200; ++trial) {
      DifferentialEdit edit{.model = &model, .fitted = {}, .edited = {}, .composition = Composition::lobes};
      edit.keepsAlbedo = trial % 4 == 3;
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

 private Q_SLOTS:
  void modelsThatAreNoSumOfLobesAreRefused() {
    DifferentialEdit edit{.model = &models::findModel("phong"), .fitted = {}, .edited = {}};
    edit.fitted = edit.edited = models::defaultParameters(edit.model->spec());
    const FunctionBrdf measured([](const Direction&, const Direction&) { return Rgb(1); });
    try {
      LobeChange{edit, measured};
      QFAIL("accepted");
    } catch (const Error& error) {
      QVERIFY(std::string(error.what()).find("additive or log-plus") != std::string::npos);
    }
  }
};

GONIO_TEST(LobeChangeTest)
}  // namespace lobe_change_test

#include "lobe_change_test.moc"
