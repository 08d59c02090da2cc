// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/library/thumbnail.h"

#include <QTest>

#include "core/materials/material.h"
#include "tests/support/test_program.h"

using namespace gonio;
using namespace gonio::app;

class ThumbnailTest : public QObject {
  Q_OBJECT
 private:
  static QString shipped(const materials::Material& material) {
    return ":/thumbnails/" + QString::fromStdString(material.source.sha256) + ".png";
  }

 private Q_SLOTS:
  /// The first start shows the whole library without drawing a sphere.
  void allBundledMaterialsHaveOne() {
    for (const materials::LibraryEntry& entry : materials::bundledLibrary()) {
      const materials::Material material = materials::readMaterial("library:" + entry.id);
      const QImage image(shipped(material));
      QVERIFY2(image.width() == 128 && image.height() == 128, entry.id.c_str());
      QVERIFY(image.text("roughness").toDouble() > 0 && !image.text("hue").isEmpty());
      const widgets::LibraryLook look = materialLook(QString::fromStdString("library:" + entry.id), {}, {});
      QCOMPARE(look.thumbnail, image);
    }
  }

  /// They are what the renderer draws now; if not, scripts/thumbnails.sh draws them anew.
  void theyAreUpToDate() {
    const materials::Material material = materials::readMaterial("library:sgd/gold-metallic-paint");
    const QImage now = spherePicture(*material.brdf, 128, 64), then(shipped(material));
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 128; ++x) {
        const QColor a = now.pixelColor(x, y), b = then.pixelColor(x, y);
        QVERIFY(std::abs(a.red() - b.red()) <= 2 && std::abs(a.green() - b.green()) <= 2 &&
                std::abs(a.blue() - b.blue()) <= 2 && a.alpha() == b.alpha());
      }
  }
};

GONIO_TEST(ThumbnailTest)
#include "thumbnail_test.moc"
