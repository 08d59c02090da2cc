// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "core/export/shaders/shading_models.h"
#include "tests/core/export/sun_picture.h"
#include "tests/support/test_program.h"

namespace three_test {
using namespace gonio;
using exports::SurfaceValues;

/// three.js shows glTF materials as the formula predicts.
class ThreeTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    m_modules = qEnvironmentVariable("GONIO_EXPORT_CLIENTS");
    m_chromium = QStandardPaths::findExecutable("chromium");
    if (m_modules.isEmpty() || m_chromium.isEmpty() || QStandardPaths::findExecutable("node").isEmpty())
      QSKIP("node, chromium or three.js are not installed (scripts/install_export_clients.sh)");
  }

  void threeShowsThePrediction_data() {
    QTest::addColumn<SurfaceValues>("values");
    QTest::addColumn<double>("least");
    // three.js makes up for multiple scattering, which the formula leaves out: metals are narrow here, where it is
    // weak.
    QTest::newRow("plastic") << SurfaceValues{.baseColour = Rgb(0.6, 0.3, 0.1), .roughness = 0.4} << 40.0;
    QTest::newRow("tinted") << SurfaceValues{.baseColour = Rgb(0.3, 0.3, 0.1),
                                             .metalness = 0.3,
                                             .roughness = 0.4,
                                             .specularColour = Rgb(3, 2, 1),
                                             .specular = 0.7}
                            << 30.0;
    QTest::newRow("metal") << SurfaceValues{.baseColour = Rgb(0.9, 0.6, 0.2), .metalness = 1, .roughness = 0.3} << 30.0;
    QTest::newRow("coat")
        << SurfaceValues{.baseColour = Rgb(0.6, 0.3, 0.1), .roughness = 0.7, .coat = 0.8, .coatRoughness = 0.4} << 40.0;
    QTest::newRow("sheen") << SurfaceValues{.baseColour = Rgb(0.4, 0.1, 0.1),
                                            .roughness = 0.8,
                                            .sheenColour = Rgb(0.5),
                                            .sheenRoughness = 0.6}
                           << 25.0;
    QTest::newRow("grain") << SurfaceValues{.baseColour = Rgb(0.9, 0.6, 0.2),
                                            .metalness = 1,
                                            .roughness = 0.4,
                                            .anisotropy = 0.5,
                                            .rotation = 0.6}
                           << 20.0;
  }
  void threeShowsThePrediction() {
    QFETCH(SurfaceValues, values);
    QFETCH(double, least);
    QTemporaryDir folder;
    const std::string text = exports::gltfDocument(values, "test", "A test.");
    QFile model(folder.filePath("model.gltf"));
    QVERIFY(model.open(QIODevice::WriteOnly) && model.write(text.data(), qint64(text.size())) > 0);
    model.close();
    QProcess node;
    node.start("node", {RENDER_IN_THREE_SCRIPT, m_modules, m_chromium, model.fileName(), folder.filePath("out.raw"),
                        QString::number(test::sunPictureSide), QString::number(test::sunAngle)});
    QVERIFY(node.waitForFinished(120000));
    QVERIFY2(node.exitCode() == 0, node.readAllStandardError());
    QFile raw(folder.filePath("out.raw"));
    QVERIFY(raw.open(QIODevice::ReadOnly));
    const QByteArray bytes = raw.readAll();
    QVector<float> pixels(bytes.size() / qsizetype(sizeof(float)));
    std::memcpy(pixels.data(), bytes.data(), std::size_t(bytes.size()));
    const double snr = test::sunPictureSnr(pixels, *exports::gltfShader().brdf(values), test::TangentAxis::up);
    qInfo() << "three.js against the prediction:" << snr << "dB";
    QVERIFY(snr > least);
  }

 private:
  QString m_modules, m_chromium;
};

GONIO_TEST(ThreeTest)
}  // namespace three_test

#include "three_test.moc"
