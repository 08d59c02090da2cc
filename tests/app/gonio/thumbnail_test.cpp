// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/library/thumbnail.h"

#include <QTemporaryDir>
#include <QTest>

#include "core/documents/edit_document.h"
#include "core/materials/bundled_library.h"
#include "tests/support/test_program.h"

namespace thumbnail_test {
using namespace gonio;
using namespace gonio::app;

class ThumbnailTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The first start shows the whole library without rendering a sphere.
  void allBundledMaterialsHaveOne() {
    for (const materials::LibraryEntry& entry : materials::bundledLibrary()) {
      const auto shipped = bundledThumbnail(materials::librarySha256("library:" + entry.id));
      QVERIFY2(shipped, entry.id.c_str());
      QCOMPARE(shipped->image.size(), QSize(128, 128));
      QVERIFY(shipped->roughness > 0 && shipped->hue >= -1 && shipped->hue <= 360);
      const widgets::LibraryThumbnail made = materialThumbnail(QString::fromStdString("library:" + entry.id), {}, {});
      QCOMPARE(made.image, shipped->image);
    }
    QVERIFY(!bundledThumbnail("0000"));
  }

  /// A material that takes too long says so, instead of holding up the others; a stop is no failure.
  void theTimeIsLimited() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("edited.gonio");
    const models::Model& model = models::findModel("lambert");
    documents::writeDocument({.sourcePath = "library:sgd/brass",
                              .sourceSha256 = materials::librarySha256("library:sgd/brass"),
                              .edits = {{editing::DifferentialEdit{&model, {{Rgb(0.2)}}, {{Rgb(0.3)}}}}}},
                             path.toStdString());
    std::string failure;
    try {
      (void)materialThumbnail(path, folder.filePath("cache"), {}, std::chrono::milliseconds(1));
    } catch (const TooSlow& error) {
      failure = error.what();
    }
    QCOMPARE(failure, "no thumbnail: it takes longer than 0.001 s to render");
    std::stop_source stop;
    stop.request_stop();
    QVERIFY_EXCEPTION_THROWN(materialThumbnail(path, folder.filePath("cache"), {stop.get_token(), {}}), Cancelled);
    QVERIFY(!materialThumbnail(path, folder.filePath("cache"), {}).image.isNull());
  }

  /// They are what the renderer draws now, but for the loss of JPEG; if not, scripts/thumbnails.sh renders them again.
  void theyAreUpToDate_data() {
    QTest::addColumn<QString>("id");
    for (const char* id : {"rgl/satin_purple", "merl-copy/chrome", "sgd/red-fabric"}) QTest::newRow(id) << id;
  }
  void theyAreUpToDate() {
    QFETCH(QString, id);
    const materials::Material material = materials::readMaterial("library:" + id.toStdString());
    const QImage now = spherePicture(*material.brdf, 128, 64);
    const QImage shipped = bundledThumbnail(material.source.sha256)->image;
    double sum = 0;
    int covered = 0;
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 128; ++x) {
        const QColor a = now.pixelColor(x, y), b = shipped.pixelColor(x, y);
        QVERIFY2(a.alpha() == b.alpha(),
                 qPrintable(QString("%1 %2: %3 %4").arg(x).arg(y).arg(a.alpha()).arg(b.alpha())));
        if (a.alpha() < 255) continue;
        sum += std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
        covered += 3;
      }
    QVERIFY2(sum / covered < 2, qPrintable(QString("mean difference of %1 levels").arg(sum / covered)));
  }
};

GONIO_TEST(ThumbnailTest)
}  // namespace thumbnail_test

#include "thumbnail_test.moc"
