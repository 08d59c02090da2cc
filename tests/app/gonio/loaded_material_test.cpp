// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/loaded_material.h"

#include <QTest>

#include "app/gonio/document/document.h"
#include "app/gonio/inspector/source_facts.h"
#include "core/models/registry.h"
#include "tests/fuzz/reader_seeds.h"
#include "tests/support/test_program.h"

namespace loaded_material_test {
using namespace gonio;
using namespace gonio::app;

/// What the document of each file is about.
class LoadedMaterialTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theBaseIsTheMeasurementInItsOwnForm_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<bool>("isTable");
    const auto add = [](const char* name, const test::Bytes& bytes, bool isTable) {
      QTest::newRow(name) << QByteArray(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size()))
                          << isTable;
    };
    add("MERL", fuzz::merlSeed(), true);
    add("RGL", fuzz::rglSeed(), false);
    add("UTIA", fuzz::utiaSeed(), false);
    add("Zemax", fuzz::zemaxSeed(), false);
    add("Zemax with sample rotations", fuzz::rotatedZemaxSeed(), false);
    add("LightTools", fuzz::lightToolsSeed(), false);
    add("PDV factors", fuzz::pdvSeed(), false);
  }
  void theBaseIsTheMeasurementInItsOwnForm() {
    QFETCH(QByteArray, bytes);
    QFETCH(bool, isTable);
    const auto span = std::as_bytes(std::span(bytes.constData(), std::size_t(bytes.size())));
    const auto path = test::writeFile("app/own_form", {span.begin(), span.end()});
    const LoadedMaterialPtr loaded = loadMaterial(path);
    QVERIFY(loaded->base == loaded->material.brdf && !loaded->isSampled());
    QCOMPARE(loaded->isTable(), isTable);
  }

  /// Of what the preview cannot evaluate, the facts state what is shown instead.
  void aTableWithoutTheAnisotropyIsStated() {
    const auto shownAs = [](const LoadedMaterial& loaded) {
      for (const widgets::Fact& fact : sourceFacts(loaded, {}, false))
        if (fact.name == "Shown as") return fact.value;
      return QString();
    };
    const LoadedMaterialPtr radiance = loadMaterial(test::writeFile("app/klems.xml", fuzz::radianceSeed()));
    QVERIFY(radiance->isSampled() && !radiance->material.brdf->isIsotropic());
    QCOMPARE(shownAs(*radiance), QString("mean over the azimuths of the light"));
    QCOMPARE(shownAs(*loadMaterial(test::writeFile("app/rotated.bsdf", fuzz::rotatedZemaxSeed()))),
             QString("native form, without a table"));
    QCOMPARE(shownAs(*loadMaterial(test::writeFile("app/merl.binary", fuzz::merlSeed()))), QString());
  }

  void aPublishedFitIsItsModel() {
    const LoadedMaterialPtr loaded = loadMaterial("library:sgd/chrome");
    QVERIFY(loaded->base == loaded->material.brdf && !loaded->isSampled() && !loaded->isTable());
  }

  /// The order of the directions is an undo step that changes what is shown, of a UTIA file too.
  void theOrderOfDirectionsIsAChoice() {
    Document document;
    document.setMaterial(loadMaterial(test::writeFile("app/order.bin", fuzz::utiaSeed())));
    const auto viewer = document.base();
    QCOMPARE(document.base(), viewer);
    document.setIncident(IncidentDirection::light);
    const Direction wi = fromSpherical(0.5, 1), wo = fromSpherical(1.1, -2);
    QVERIFY(document.base()->evaluate(wi, wo) == viewer->evaluate(wo, wi));
    QVERIFY(document.base()->evaluate(wi, wo) != viewer->evaluate(wi, wo));
    document.history().undo();
    QVERIFY(document.base()->evaluate(wi, wo) == viewer->evaluate(wi, wo));
  }
};

GONIO_TEST(LoadedMaterialTest)
}  // namespace loaded_material_test

#include "loaded_material_test.moc"
