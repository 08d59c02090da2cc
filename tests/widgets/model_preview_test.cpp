// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>

#include "core/factorization/pdv_operations.h"
#include "core/materials/bundled_library.h"
#include "core/models/model.h"
#include "core/models/registry.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_spheres.h"
#include "widgets/preview/gl/shader_base.h"

namespace model_preview_test {
using namespace gonio;
using namespace gonio::rendering;
using editing::Composition;

editing::Edit edit(const char* id, Composition composition) {
  return test::rougherEdit(id, "roughness", 0.5, composition);
}

/// Factors of two terms.
factorization::PdvFactors factorsOf(factorization::PdvForm form) {
  const models::Model& model = models::findModel("abc");
  const auto table = bakeTable(*model.instantiate(models::defaultParameters(model.spec())));
  return factorization::factorizePdv(*table, {.form = form, .terms = 2}).factors;
}

/// Materials that are a model or factors are shown by these, not by a table of them.
class ModelPreviewTest : public test::SphereTest {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { openSpheres(); }

  /// Also the picture of the model alone, to the bit. Chrome's highlight is narrower than a pixel: by chance alone its
  /// picture differs from the CPU's.
  void publishedFits() {
    for (const materials::SgdFit& fit : materials::sgdFits()) {
      if (fit.name != "chrome" && fit.name != "blue-fabric" && fit.name != "alum-bronze") continue;
      const auto base = materials::sgdMaterial(fit).brdf;
      if (fit.name != "chrome") verify(base, {});
      const widgets::StandaloneModel alone{&models::findModel("sgd"), fit.parameters};
      const Image picture = spheres_->drawn({alone}, sphereScene(), 64);
      QVERIFY(spheres_->drawn({widgets::EditedMaterial{base}}, sphereScene(), 64).pixels == picture.pixels);
    }
  }

  /// The edit's model may be the base's, and factor curves may come after.
  void editsOfModels() {
    const models::Model& ggx = models::findModel("ggx");
    const auto base = std::make_shared<const models::ModelBrdf>(ggx, models::defaultParameters(ggx.spec()));
    const auto original =
        std::make_shared<const factorization::PdvFactors>(factorsOf(factorization::PdvForm::twoFactors));
    const auto wider = std::make_shared<const factorization::PdvFactors>(factorization::widenF2(*original, 1.5));
    const editing::Edit curves{editing::FactorEdit{.original = original, .edited = wider}};
    verify(base, {edit("ggx", Composition::logPlus), edit("ward", Composition::additive)});
    verify(base, {edit("ggx", Composition::lobes), curves});
  }

  /// With factor edits before and behind: each has its own curves.
  void factors() {
    for (const auto form : {factorization::PdvForm::twoFactors, factorization::PdvForm::threeFactors}) {
      const factorization::PdvFactors own = factorsOf(form);
      const auto base = factorization::makePdvBrdf(own);
      verify(base, {});
      factorization::PdvFactors negative = own;
      negative.lowest = -0.2;
      for (double& value : negative.channels[0][0].f2) value -= 0.4;
      verify(factorization::makePdvBrdf(negative), {});
      const auto original = std::make_shared<const factorization::PdvFactors>(own.truncated(1));
      const auto wider = std::make_shared<const factorization::PdvFactors>(factorization::widenF2(*original, 1.5));
      const editing::Edit curves{editing::FactorEdit{.original = original, .edited = wider}};
      verify(base, {curves, edit("ggx", Composition::logPlus)});
    }
  }

 private:
  void verify(const std::shared_ptr<const Brdf>& base, const editing::EditList& edits) {
    QVERIFY(!formOf<TabulatedBrdf>(*base) && widgets::isShownNatively(*base));
    SphereTest::verify({widgets::EditedMaterial{base, edits}});
  }
};

GONIO_TEST(ModelPreviewTest)
}  // namespace model_preview_test

#include "model_preview_test.moc"
