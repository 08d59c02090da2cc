// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/training_files.h"

#include <QTest>
#include <cmath>

#include "core/support/error.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace material_class_test {
using namespace gonio;
using namespace gonio::study;

class MaterialClassTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// 1 for a Lambertian material; of a constant c and a term that is 1 in the mirror direction alone, (c + 1) / c.
  void contrastsByTheirDefinition() {
    const test::FunctionBrdf matte([](const Direction&, const Direction&) { return Rgb(0.3); });
    QVERIFY(std::abs(highlightContrast(matte) - 1) < 1e-12);
    const test::FunctionBrdf shiny([](const Direction& wi, const Direction& wo) {
      return Rgb(0.25 + (std::abs(wi.x + wo.x) + std::abs(wi.y + wo.y) < 1e-9 ? 1 : 0));
    });
    QVERIFY(std::abs(highlightContrast(shiny) - 5) < 1e-12);
    const test::FunctionBrdf mirror([](const Direction& wi, const Direction& wo) {
      return Rgb(std::abs(wi.x + wo.x) + std::abs(wi.y + wo.y) < 1e-9 ? 1 : 0);
    });
    QVERIFY(std::isinf(highlightContrast(mirror)));
    QCOMPARE(highlightContrast(test::FunctionBrdf([](auto&, auto&) { return Rgb(0); })), 0.0);
  }

  /// Every file is of one class; felt is diffuse, chrome is glossy.
  void filesAreDivided() {
    const std::vector<std::string> files{"library:merl-copy/chrome", "library:rgl/acrylic_felt_pink",
                                         "library:merl-copy/gold-paint", "library:merl-copy/pink-fabric"};
    QCOMPARE(filesOfClass(files, MaterialClass::all), files);
    QCOMPARE(filesOfClass(files, MaterialClass::glossy), (std::vector{files[0], files[2]}));
    QCOMPARE(filesOfClass(files, MaterialClass::diffuse), (std::vector{files[1], files[3]}));
    QVERIFY_EXCEPTION_THROWN(filesOfClass({files[0]}, MaterialClass::diffuse), Error);
    QVERIFY(materialClassNamed("glossy") == MaterialClass::glossy);
    QVERIFY_EXCEPTION_THROWN(materialClassNamed("matte"), Error);
  }
};

GONIO_TEST(MaterialClassTest)
}  // namespace material_class_test

#include "material_class_test.moc"
