// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/material_form.h"

#include <QTest>
#include <cmath>

#include "core/editing/edit.h"
#include "core/io/merl_file.h"
#include "core/io/utia_file.h"
#include "core/materials/material_file.h"
#include "tests/core/io/instrument_files.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace material_form_test {
using namespace gonio;
using exports::ExportSource;
using exports::MaterialForm;

/// Neither reciprocal nor isotropic.
Rgb grained(const Direction& wi, const Direction& wo) { return {0.2 + 0.1 * wi.x * wi.x, 0.3 + 0.2 * wo.z, 0.4}; }

materials::Material utia() {
  materials::Material material{.name = "cloth"};
  material.source.format = "UTIA";
  material.source.path = "cloth.exr";
  const test::Bytes bytes = test::utiaFile(test::utiaValues(grained));
  material.brdf = io::readUtia(io::MemorySource(bytes));
  return material;
}

std::shared_ptr<const Brdf> halved(const std::shared_ptr<const Brdf>& base) {
  return std::make_shared<test::FunctionBrdf>(
      [base](const Direction& wi, const Direction& wo) { return base->evaluate(wi, wo) * (wo.y < 0 ? 0.5 : 1.0); },
      false, false);
}

class MaterialFormTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theFormThatKeepsMostComesFirst() {
    QVERIFY(exports::formsOf(*utia().brdf).front() == MaterialForm::utia);
    const auto measured = materials::readMaterial("library:rgl/paper_blue");
    QVERIFY(exports::formsOf(*measured.brdf).front() == MaterialForm::rgl);
    const auto glossy = test::ggx(Rgb(0.2), Rgb(0.8), 0.3, 0.5);
    QVERIFY(exports::formsOf(*bakeTable(*glossy)).front() == MaterialForm::foldedTable);
    const HalfDifferenceGrid circle{.thetaHCount = 6, .thetaDCount = 6, .phiDCount = 24, .reciprocal = false};
    QVERIFY(exports::formsOf(*bakeTable(*glossy, circle)).front() == MaterialForm::wholeCircleTable);
    QVERIFY(exports::formBySuffix("a.binary", *glossy, MaterialForm::wholeCircleTable) ==
            MaterialForm::wholeCircleTable);
    const std::string refused = test::errorOf([&] { exports::formBySuffix("a.bin", *glossy); });
    QVERIFY2(refused.find("a.bin") == 0 && refused.find("'.bsdf'") != std::string::npos, refused.c_str());
  }

  void otherSuffixesAreRefused() {
    for (const char* name : {"a.binary", "a.bsdf", "a.bin", "a.Binary"}) exports::checkFormSuffix(name);
    QCOMPARE(test::errorOf([] { exports::checkFormSuffix("a.txt"); }),
             std::string("a.txt: found the suffix '.txt', expected .binary or .bsdf (for UTIA files also .bin)"));
    QCOMPARE(test::errorOf([] { exports::checkFormSuffix("a", ".gonio"); }),
             std::string("a: found the suffix '', expected .binary, .bsdf or .gonio (for UTIA files also .bin)"));
  }

  /// Each node has its own value or the edited one, exactly: the file's values are not interpolated.
  void utiaNodesStay() {
    const materials::Material base = utia();
    ExportSource source{.name = "cloth", .brdf = base.brdf};
    const auto& values = *dynamic_cast<const UtiaBrdf&>(*base.brdf).values();
    const auto written = [&] {
      const exports::FormFile file = exports::encodeMaterial(source, base, MaterialForm::utia);
      return *io::readUtia(io::MemorySource(file.bytes))->values();
    };
    QVERIFY(written() == values);
    source.brdf = halved(base.brdf);
    const auto after = written();
    for (std::size_t incident = 0; incident < UtiaBrdf::directionCount; ++incident)
      for (std::size_t viewing = 0; viewing < UtiaBrdf::directionCount; ++viewing) {
        const std::size_t i = incident * UtiaBrdf::directionCount + viewing;
        const Direction viewer = test::utiaDirection(incident);  // as the incident direction
        const float factor = viewer.y < 0 ? 0.5f : 1;
        for (int c = 0; c < 3; ++c)
          QVERIFY2(std::abs(after[i][c] - factor * values[i][c]) < (factor == 1 ? 1e-30f : 1e-6f),
                   qPrintable(QString("%1 %2: %3").arg(incident).arg(viewing).arg(after[i][c] / values[i][c])));
      }
    const auto other = materials::readMaterial("library:rgl/paper_blue");
    QVERIFY(!test::errorOf([&] {
               exports::encodeMaterial({.name = "p", .brdf = other.brdf}, other, MaterialForm::utia);
             }).empty());
  }

  /// A whole circle keeps what is not reciprocal.
  void tablesReportWhatTheyLose() {
    const auto base = materials::readMaterial("library:rgl/paper_blue");
    const ExportSource source{.name = "paper", .brdf = base.brdf};
    const auto folded = exports::encodeMaterial(source, base, MaterialForm::foldedTable);
    QCOMPARE(folded.losses.size(), std::size_t(2));
    const auto circle = exports::encodeMaterial(source, base, MaterialForm::wholeCircleTable);
    QCOMPARE(circle.losses.size(), std::size_t(1));
    QCOMPARE(io::readMerlHeader(io::MemorySource(circle.bytes)).phiDCount, 360);
    QVERIFY(exports::formSnr(circle, *base.brdf) > 40);
  }

  /// An edited file keeps its nodes and loses nothing.
  void rglStaysRgl() {
    const auto base = materials::readMaterial("library:rgl/paper_blue");
    ExportSource source{.name = "paper", .brdf = base.brdf};
    source.rgl = std::shared_ptr<const RglBrdf>(base.brdf, base.brdf->asRgl());
    source.rglFile = materials::materialFile(base.source);
    source.brdf = std::make_shared<test::FunctionBrdf>(
        [base](const Direction& wi, const Direction& wo) { return base.brdf->evaluate(wi, wo) + 0.1 * wo.z; }, true,
        false);
    const exports::FormFile edited = exports::encodeMaterial(source, base, MaterialForm::rgl);
    QVERIFY(edited.losses.empty());
    const materials::Material again = materials::readMaterial(io::MemorySource(edited.bytes));
    const RglData &before = source.rgl->tables()->data, &after = again.brdf->asRgl()->tables()->data;
    QVERIFY(after.incident.thetas() == before.incident.thetas() && after.ndf.values == before.ndf.values);
    QVERIFY(after.rgb.values != before.rgb.values);
  }
};

GONIO_TEST(MaterialFormTest)

}  // namespace material_form_test

#include "material_form_test.moc"
