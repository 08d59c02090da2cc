// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "core/export/blender_target.h"
#include "core/export/principled_model.h"
#include "core/export/principled_target.h"
#include "tests/core/export/sun_picture.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace blender_test {
using namespace gonio;

constexpr int samples = 64;

/// What Cycles shows of a material (render_in_blender.py), the bottom row first.
QVector<float> rendered(const QString& folder, const std::string& script) {
  QFile file(folder + "/material.py");
  if (!file.open(QIODevice::WriteOnly)) return {};
  file.write(script.data(), qint64(script.size()));
  file.close();
  QProcess blender;
  blender.start("blender", {"--background", "--python-exit-code", "1", "--python", BLENDER_TEST_SCRIPT, "--",
                            file.fileName(), folder + "/out.raw", QString::number(test::sunPictureSide),
                            QString::number(samples), QString::number(test::sunAngle)});
  if (!blender.waitForFinished(240000) || blender.exitCode() != 0) {
    qWarning() << blender.readAll() << blender.readAllStandardError();
    return {};
  }
  QFile raw(folder + "/out.raw");
  if (!raw.open(QIODevice::ReadOnly)) return {};
  const QByteArray bytes = raw.readAll();
  QVector<float> values(bytes.size() / qsizetype(sizeof(float)));
  std::memcpy(values.data(), bytes.data(), std::size_t(bytes.size()));
  return values;
}

/// dB of Cycles' picture of the script against the prediction.
double snrInBlender(const QString& folder, const std::string& script, const Brdf& brdf) {
  return test::sunPictureSnr(rendered(folder, script), brdf, test::TangentAxis::view);
}

class BlenderTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    if (QStandardPaths::findExecutable("blender").isEmpty())
      QSKIP("blender is not installed (scripts/install_export_clients.sh)");
  }

  /// Cycles shows the node graph as Gonio predicts it.
  void cyclesShowsThePrediction() {
    const auto material = test::ggx(Rgb(0.3, 0.12, 0.05), Rgb(0.9), 0.25, 0.06);
    const exports::ViewLobes lobes = exports::fitViewLobes(*material, {.lobes = 3, .knots = 16});
    const double snr =
        snrInBlender(m_folder.path(), exports::blenderScript(lobes, "test", "A test."), *exports::viewLobesBrdf(lobes));
    qInfo() << "Cycles against the prediction:" << snr << "dB";
    QVERIFY(snr > 40);
  }

  /// The same of the Principled BSDF, with all that the formula has: body, tinted highlight, part metal, coat.
  void cyclesShowsThePrincipledBsdf() {
    const exports::SurfaceValues values{.baseColour = Rgb(0.6, 0.3, 0.1),
                                        .metalness = 0.3,
                                        .roughness = 0.5,
                                        .specular = 0.7,
                                        .specularTint = 0.5,
                                        .coat = 0.8,
                                        .coatRoughness = 0.4};
    const double snr = snrInBlender(m_folder.path(), exports::principledScript(values, "test", "A test."),
                                    *exports::principledShader().brdf(values));
    qInfo() << "Cycles against the prediction:" << snr << "dB";
    QVERIFY(snr > 60);
  }

  /// A turned grain: the mapping of anisotropy to widths, the direction of the rotation, the tangent.
  void cyclesShowsTheGrain() {
    const exports::SurfaceValues values{.baseColour = Rgb(0.8, 0.6, 0.3),
                                        .metalness = 1,
                                        .roughness = 0.5,
                                        .anisotropy = 0.7,
                                        .rotation = 0.6,
                                        .specular = 0.5,
                                        .coatRoughness = 0.03};
    const double snr = snrInBlender(m_folder.path(), exports::principledScript(values, "test", "A test."),
                                    *exports::principledShader().brdf(values));
    qInfo() << "Cycles against the prediction:" << snr << "dB";
    QVERIFY(snr > 50);
  }

 private:
  QTemporaryDir m_folder;
};

GONIO_TEST(BlenderTest)
}  // namespace blender_test

#include "blender_test.moc"
