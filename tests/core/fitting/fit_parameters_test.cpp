// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/fit_parameters.h"

#include <QTest>

#include "core/fitting/fit.h"
#include "core/models/fresnel.h"
#include "tests/support/test_program.h"

namespace fit_parameters_test {
using namespace gonio;
using namespace gonio::fitting;

constexpr HalfDifferenceGrid smallGrid{.thetaHCount = 30, .thetaDCount = 20, .phiDCount = 24};

std::size_t indexOf(const models::Model& model, const char* id) { return model.spec().find(id).value(); }

class FitParametersTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void everyParameterHasOneRole() {
    for (const models::Model* model : models::allModels()) {
      const models::ModelSpec& spec = model->spec();
      const models::ParameterValues base = models::defaultParameters(spec);
      for (const DataSymmetry symmetry : {DataSymmetry::isotropic, DataSymmetry::anisotropic}) {
        std::size_t sum = 0;
        for (const FitRole role : {FitRole::linear, FitRole::nonlinear, FitRole::twin, FitRole::fixed})
          sum += parametersOf(spec, base, role, symmetry).size();
        QCOMPARE(sum, spec.parameters.size());
      }
      for (const std::size_t i : parametersOf(spec, base, FitRole::nonlinear))
        QVERIFY(spec.parameters[i].choices.empty());
    }
  }

  void countsChannels() {
    QCOMPARE(fittedParameterCount(models::findModel("lambert").spec()), std::size_t(3));
    // Two colours, one roughness: the one along y follows.
    QCOMPARE(fittedParameterCount(models::findModel("ward-anisotropic").spec()), std::size_t(7));
    // Of anisotropic data both roughnesses and the rotation.
    QCOMPARE(fittedParameterCount(models::findModel("ward-anisotropic").spec(), DataSymmetry::anisotropic),
             std::size_t(9));
    QCOMPARE(fittedParameterCount(models::findModel("sgd").spec()), std::size_t(30));
  }

  /// Isotropic data: both roughnesses are equal, and the fit is that of the isotropic model.
  void anisotropicModelsAreFittedIsotropic() {
    const models::Model& isotropic = models::findModel("ward");
    const models::Model& anisotropic = models::findModel("ward-anisotropic");
    models::ParameterValues known = models::defaultParameters(isotropic.spec());
    known.values[indexOf(isotropic, "roughness")] = Rgb(0.12);
    const auto table = bakeTable(*isotropic.instantiate(known), smallGrid);
    const FitResult result = fit(*table, anisotropic);
    const Rgb x = result.parameters.values[indexOf(anisotropic, "roughness-x")];
    QVERIFY(x == result.parameters.values[indexOf(anisotropic, "roughness-y")]);
    QVERIFY(std::abs(x.x / 0.12 - 1) < 1e-3);
    QVERIFY(result.errors[0] < 1e-5);
  }

  /// The tint of a conductor's edge: fitted with that Fresnel term, at its default with another.
  void conventionsAreKeptAndDecideWhatIsFitted() {
    const models::Model& ggx = models::findModel("ggx");
    const std::size_t fresnel = indexOf(ggx, "fresnel"), tint = indexOf(ggx, "edge-tint");
    models::ParameterValues known = models::defaultParameters(ggx.spec());
    known.values[fresnel] = Rgb(double(models::FresnelChoice::conductor));
    known.values[tint] = Rgb(0.9);
    known.values[indexOf(ggx, "f0")] = Rgb(0.6);
    const auto table = bakeTable(*ggx.instantiate(known), smallGrid);
    QVERIFY(fitRole(ggx.spec(), known, tint) == FitRole::nonlinear);
    const FitResult conductor = fit(*table, ggx, {}, {}, known);
    QCOMPARE(conductor.parameters.values[fresnel].x, known.values[fresnel].x);
    QVERIFY(conductor.parameters.values[tint].x != ggx.spec().parameters[tint].defaultValue);
    const FitResult dielectric = fit(*table, ggx);
    QVERIFY(fitRole(ggx.spec(), dielectric.parameters, tint) == FitRole::fixed);
    QCOMPARE(dielectric.parameters.values[fresnel].x, ggx.spec().parameters[fresnel].defaultValue);
    QCOMPARE(dielectric.parameters.values[tint].x, ggx.spec().parameters[tint].defaultValue);
    QVERIFY(conductor.errors[0] < 0.1 * dielectric.errors[0]);
  }
};

GONIO_TEST(FitParametersTest)
}  // namespace fit_parameters_test

#include "fit_parameters_test.moc"
