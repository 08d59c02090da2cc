// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/artist_controls.h"

#include <QTest>
#include <cmath>

#include "core/models/fresnel.h"
#include "core/models/registry.h"
#include "tests/support/test_program.h"

namespace artist_controls_test {
using namespace gonio;
using namespace gonio::editing;
using models::ParameterRole;
using models::ParameterValues;

ParameterValues neutral() { return models::defaultParameters(artistControls()); }
ParameterValues with(ArtistControl control, const Rgb& value) {
  ParameterValues values = neutral();
  values.values[std::size_t(control)] = value;
  return values;
}
ParameterValues changed(const models::Model& model, const ParameterValues& parameters, ArtistControl control,
                        const Rgb& value) {
  return withControls(model.spec(), parameters, with(control, value));
}
std::size_t index(const models::Model& model, const char* id) { return *model.spec().find(id); }

/// Defaults with a grey body and highlights of a colour.
ParameterValues coloured(const models::Model& model) {
  ParameterValues values = models::defaultParameters(model.spec());
  for (std::size_t i = 0; i < values.values.size(); ++i)
    if (model.spec().parameters[i].perChannel && model.spec().parameters[i].linear)
      values.values[i] *= Rgb(0.9, 0.6, 0.3);
  return values;
}

/// The highlight of a model at a width that is narrow for it, without its body.
ParameterValues narrowHighlight(const models::Model& model) {
  ParameterValues values = models::defaultParameters(model.spec());
  for (std::size_t i = 0; i < values.values.size(); ++i)
    if (model.spec().parameters[i].role == ParameterRole::diffuse) values.values[i] = Rgb(0);
  return changed(model, values, ArtistControl::roughness, Rgb(0.125));
}

/// The polar angle of wi = wo = h at which the highlight has half its value at the pole.
double halfWidth(const Brdf& brdf) {
  const auto value = [&](double theta) {
    const Direction w = fromSpherical(theta, 0);
    return brdf.evaluate(w, w).y;
  };
  double low = 0, high = 1.5;
  const double half = value(0) / 2;
  for (int i = 0; i < 60; ++i) (value((low + high) / 2) > half ? low : high) = (low + high) / 2;
  return low;
}

class ArtistControlsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void atTheirDefaultsTheyChangeNoBit() {
    for (const models::Model* model : models::allModels()) {
      const ParameterValues values = coloured(*model);
      QVERIFY(withControls(model->spec(), values, neutral()) == values);
    }
  }

  void layeredLobesHaveAParameterForEveryControl() {
    for (std::size_t i = 0; i < artistControls().parameters.size(); ++i)
      QVERIFY(actsOn(ArtistControl(i), models::layered().spec()));
  }

  /// actsOn() is what changesBy() finds, for every model.
  void aControlChangesSomethingWhereItActs() {
    for (const models::Model* model : models::allModels())
      for (std::size_t i = 0; i < artistControls().parameters.size(); ++i) {
        const auto control = ArtistControl(i);
        const Rgb value = control == ArtistControl::tint ? Rgb(0.5, 0.7, 0.2) : Rgb(1.5);
        QCOMPARE(!changesBy(control, model->spec(), coloured(*model), with(control, value)).empty(),
                 actsOn(control, model->spec()) && !actsOnValues(control));
      }
  }

  /// The changes of all controls in their order are what withControls() does.
  void changesAddUp() {
    const models::Model& model = models::layered();
    ParameterValues before = coloured(model);
    for (const char* lobe : {"sheen-lobe", "retro-lobe"}) before.values[index(model, lobe)] = Rgb(1);
    ParameterValues controls = neutral();
    controls.values = {Rgb(2), Rgb(1.5), Rgb(1, 0.5, 0.2), Rgb(0.5), Rgb(3), Rgb(2), Rgb(0.5)};
    ParameterValues after = before;
    for (std::size_t i = 0; i < controls.values.size(); ++i)
      for (const ControlledParameter& one : changesBy(ArtistControl(i), model.spec(), before, controls)) {
        QVERIFY(after.values[one.parameter] == one.before);
        after.values[one.parameter] = one.after;
      }
    QVERIFY(after == withControls(model.spec(), before, controls));
  }

  /// Every model's highlight becomes twice as wide.
  void roughnessIsAFactorOfTheWidth() {
    for (const models::Model* model : models::allModels()) {
      if (!actsOn(ArtistControl::roughness, model->spec()) || !actsOn(ArtistControl::specularStrength, model->spec()))
        continue;
      const ParameterValues narrow = narrowHighlight(*model);
      const double before = halfWidth(*model->instantiate(narrow));
      const double after = halfWidth(*model->instantiate(changed(*model, narrow, ArtistControl::roughness, Rgb(2))));
      // SGD: between the widths of its core (2) and of its exponential tail (the root of 2).
      const double low = model == &models::findModel("sgd") ? 1.35 : 1.8;
      QVERIFY2(
          after / before > low && after / before < 2.2,
          qPrintable(
              QStringLiteral("%1: %2 to %3").arg(QString::fromUtf8(model->spec().id.data())).arg(before).arg(after)));
    }
  }

  /// 2 pi k_s / (n + 2) head-on: k_s and n have to fall together.
  void roughnessKeepsTheEnergyOfAPeak() {
    const models::Model& phong = models::findModel("phong");
    ParameterValues values = models::defaultParameters(phong.spec());
    values.values[index(phong, "exponent")] = Rgb(1e4);
    const auto energy = [&](const ParameterValues& p) {
      return 2 * pi * p.values[index(phong, "specular")].x / (p.values[index(phong, "exponent")].x + 2);
    };
    const double ratio = energy(changed(phong, values, ArtistControl::roughness, Rgb(2))) / energy(values);
    QVERIFY(std::abs(ratio - 1) < 1e-3);
  }

  void strengthAndContrastAreFactors() {
    const models::Model& model = models::ggx();
    const ParameterValues before = coloured(model);
    const auto specular = index(model, "specular"), diffuse = index(model, "diffuse");
    const ParameterValues stronger = changed(model, before, ArtistControl::specularStrength, Rgb(3));
    QVERIFY(stronger.values[specular] == 3.0 * before.values[specular]);
    QVERIFY(stronger.values[diffuse] == before.values[diffuse]);
    const ParameterValues harder = changed(model, before, ArtistControl::contrast, Rgb(4));
    QVERIFY(harder.values[specular] == 2.0 * before.values[specular]);
    QVERIFY(harder.values[diffuse] == before.values[diffuse] / 2.0);
  }

  void tintAndSaturationAreMatrices() {
    QVERIFY(colourMatrix(neutral()) == glm::dmat3(1));
    const Rgb colour(0.7, 0.2, 0.05), tint(1, 0.5, 0);
    QVERIFY(colourMatrix(with(ArtistControl::tint, tint)) * colour == tint * colour);
    const Rgb grey = colourMatrix(with(ArtistControl::saturation, Rgb(0))) * colour;
    QVERIFY(glm::length(grey - Rgb(luminance(colour))) < 1e-15);
    const Rgb strong = colourMatrix(with(ArtistControl::saturation, Rgb(2))) * colour;
    QVERIFY(std::abs(luminance(strong) - luminance(colour)) < 1e-15);
    QVERIFY(glm::length((strong - grey) - 2.0 * (colour - grey)) < 1e-15);
    // The tint comes first.
    ParameterValues both = with(ArtistControl::tint, tint);
    both.values[std::size_t(ArtistControl::saturation)] = Rgb(0);
    QVERIFY(glm::length(colourMatrix(both) * colour - Rgb(luminance(tint * colour))) < 1e-15);
  }

  void theCoatIsTakenAwayOrAdded() {
    const models::Model& model = models::layered();
    const ParameterValues before = coloured(model);
    const auto coat = index(model, "coat"), edge = index(model, "coat-edge"), base = index(model, "base");
    const ParameterValues bare = changed(model, before, ArtistControl::coatStrength, Rgb(0));
    QVERIFY(bare.values[coat] == Rgb(0) && bare.values[edge] == Rgb(0));
    QVERIFY(bare.values[base] == before.values[base]);
    ParameterValues without = before;
    without.values[coat] = without.values[edge] = Rgb(0);
    const ParameterValues coated = changed(model, without, ArtistControl::coatStrength, Rgb(2));
    QVERIFY(coated.values[coat] == Rgb(0.04) && coated.values[edge] == Rgb(1));

    // A fit without a coat gets one; what a lobe that stays off would have is not mentioned.
    const auto lobe = index(model, "coat-lobe");
    without.values[lobe] = Rgb(0);
    QVERIFY(changed(model, without, ArtistControl::coatStrength, Rgb(2)).values[lobe] == Rgb(1));
    QVERIFY(changed(model, without, ArtistControl::coatStrength, Rgb(0.5)).values[lobe] == Rgb(0));
    for (const ControlledParameter& one :
         changesBy(ArtistControl::roughness, model.spec(), without, with(ArtistControl::roughness, Rgb(2))))
      QVERIFY(one.parameter != index(model, "coat-roughness"));
  }

  /// The strength head-on, k F_0, stays; the strength of the edge, k, is multiplied.
  void edgeBrightnessKeepsTheHighlightHeadOn() {
    struct Parameters {
      const char *id, *reflectance, *strength;
    };
    for (const Parameters& names : {Parameters{"ggx", "f0", "specular"},
                                    {"abc", "index-of-refraction", "a"},
                                    {"car-paint", "flakes-f0", "flakes"}}) {
      const models::Model& model = models::findModel(names.id);
      const std::size_t reflectance = index(model, names.reflectance), strength = index(model, names.strength);
      const ParameterValues before = coloured(model);
      const auto headOn = [&](const ParameterValues& p) {
        const double value = p.values[reflectance].x;
        return p.values[strength] * (std::string_view(names.reflectance) == "index-of-refraction"
                                         ? models::normalReflectanceFromIndex(value)
                                         : value);
      };
      for (const double x : {0.5, 2.0}) {
        const ParameterValues after = changed(model, before, ArtistControl::edgeBrightness, Rgb(x));
        QVERIFY(glm::length(headOn(after) - headOn(before)) < 1e-12 * glm::length(headOn(before)));
        const Rgb edge = after.values[strength] / before.values[strength];
        QVERIFY(std::abs(edge.x - x) < 1e-9 * x);
      }
      // No darker than head-on: then the reflectance is the same everywhere.
      const ParameterValues dark = changed(model, before, ArtistControl::edgeBrightness, Rgb(0));
      const Rgb flat = headOn(dark) / dark.values[strength];
      QVERIFY(flat.x > 0.99 && flat.x <= 1);
    }
    const models::Model& layered = models::layered();
    const ParameterValues before = coloured(layered);
    const ParameterValues after = changed(layered, before, ArtistControl::edgeBrightness, Rgb(2));
    QVERIFY(after.values[index(layered, "flakes-edge")] == 2.0 * before.values[index(layered, "flakes-edge")]);
    QVERIFY(after.values[index(layered, "flakes")] == before.values[index(layered, "flakes")]);
  }

  /// Whatever the sliders say: the parameters stay within what the model takes.
  void extremesStayInTheHardRanges() {
    ParameterValues low = neutral(), high = neutral();
    for (std::size_t i = 0; i < low.values.size(); ++i) {
      low.values[i] = Rgb(artistControls().parameters[i].hardMin);
      high.values[i] = Rgb(artistControls().parameters[i].hardMax);
    }
    for (const models::Model* model : models::allModels())
      for (const ParameterValues& controls : {low, high}) {
        ParameterValues values = withControls(model->spec(), coloured(*model), controls);
        QVERIFY(models::clampToHardRange(model->spec(), values).empty());
      }
  }
};

GONIO_TEST(ArtistControlsTest)
}  // namespace artist_controls_test

#include "artist_controls_test.moc"
