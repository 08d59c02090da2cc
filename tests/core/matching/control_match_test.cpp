// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/matching/control_match.h"

#include <QElapsedTimer>
#include <QTest>
#include <cmath>

#include "core/documents/open_material.h"
#include "core/fitting/fit.h"
#include "core/metrics/image_metrics.h"
#include "core/rendering/render_picture.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace control_match_test {
using namespace gonio;
using namespace gonio::matching;
using editing::ArtistControl;
using models::ParameterValues;

struct Setting {
  ArtistControl control;
  Rgb value;
};
using Settings = std::vector<Setting>;

ParameterValues controlsOf(const Settings& settings) {
  ParameterValues controls = models::defaultParameters(editing::artistControls());
  for (const auto& [control, value] : settings) controls.values[std::size_t(control)] = value;
  return controls;
}

/// A bundled material with a fit that has no effect yet.
MatchedMaterial fitted(const std::string& name) {
  static std::map<std::string, MatchedMaterial> known;
  if (const auto found = known.find(name); found != known.end()) return found->second;
  const materials::Material material = documents::openMaterial(name);
  const fitting::FitResult fit =
      fitting::fit(fitting::fitBase(material.brdf, material.tabulated()), models::findModel("ggx"));
  const editing::DifferentialEdit edit{fit.model, fit.parameters, fit.parameters,
                                       editing::defaultComposition(*fit.model)};
  return known[name] = {material.brdf, {{edit}}, 0};
}

/// The picture of an independent renderer: other paths, other densities, other pixels.
Image rendered(const Brdf& brdf, const rendering::Scene& scene, int side = 200) {
  return rendering::renderPicture(brdf, scene,
                                  {.width = side, .height = side, .samples = 64, .seed = 4711, .density = {}});
}
ReferencePicture reference(const Brdf& brdf, const rendering::Scene& scene) {
  Image image = rendered(brdf, scene);
  const Disc disc = findSphere(image);
  return {std::move(image), disc};
}

struct Case {
  const char* material;
  Settings settings;
};

class ControlMatchTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void findsTheEdit_data() {
    QTest::addColumn<QString>("material");
    QTest::addColumn<Settings>("settings");
    using enum ArtistControl;
    const std::pair<const char*, Settings> edits[] = {
        {"unchanged", {}},
        {"sharper", {{roughness, Rgb(0.5)}}},
        {"rougher", {{roughness, Rgb(2)}}},
        {"stronger", {{specularStrength, Rgb(2)}}},
        {"tinted", {{tint, {0.9, 0.5, 0.3}}}},
        {"desaturated", {{saturation, Rgb(0.5)}}},
        {"rougher and weaker", {{roughness, Rgb(1.6)}, {specularStrength, Rgb(0.6)}}},
        {"all",
         {{roughness, Rgb(0.7)}, {specularStrength, Rgb(1.5)}, {tint, {0.6, 0.9, 0.8}}, {saturation, Rgb(1.3)}}}};
    // A sharper chrome is left out: its highlight is narrower than a pixel.
    const QStringList materials{"library:rgl/satin_purple", "library:sgd/chrome",
                                "library:sgd/red-plastic",  "library:sgd/gold-metallic-paint",
                                "library:rgl/aurora_white", "library:merl-copy/blue-metallic-paint"};
    const QStringList always{"library:rgl/satin_purple, unchanged", "library:rgl/satin_purple, all",
                             "library:sgd/chrome, tinted"};
    for (const QString& material : materials)
      for (const auto& [name, settings] : edits)
        if (const QString row = material + ", " + name;
            always.contains(row) || (test::longTests() && row != "library:sgd/chrome, sharper"))
          QTest::newRow(qPrintable(row)) << material << settings;
  }
  void findsTheEdit() {
    QFETCH(QString, material);
    QFETCH(Settings, settings);
    const MatchedMaterial edited = fitted(material.toStdString());
    const ParameterValues truth = controlsOf(settings);
    const rendering::Scene scene = rendering::comparisonScene();
    const ReferencePicture picture = reference(*edited.with(truth), scene);
    QElapsedTimer timer;
    timer.start();
    const ControlMatch match = matchControls(picture, edited, scene);
    const double seconds = double(timer.elapsed()) / 1000;
    const rendering::RenderedComparison comparison(*edited.with(truth), rendering::smallComparisonPicture());
    const double ratio = comparison.signalToNoiseRatio(comparison.render(*edited.with(match.controls)));
    double error = 0;
    QString text;
    for (const ArtistControl control : matchedControls(edited.edit())) {
      const Rgb found = match.controls.values[std::size_t(control)], wanted = truth.values[std::size_t(control)];
      error = std::max(error, maxChannel(glm::abs(found / wanted - Rgb(1))));
      text += QStringLiteral(" %1 %2 %3,").arg(found.x, 0, 'g', 4).arg(found.y, 0, 'g', 4).arg(found.z, 0, 'g', 4);
    }
    qInfo("error %.1f %%, %.1f dB (%.1f dB to the picture), %.2f s:%s", 100 * error, ratio, match.signalToNoiseRatio,
          seconds, qUtf8Printable(text));
    QVERIFY(error < 0.05);
    QVERIFY(ratio > 35);
  }

  /// A photograph three stops too bright, with its highlights clipped.
  void findsTheExposureOfClippedPictures() {
    const MatchedMaterial edited = fitted("library:rgl/satin_purple");
    const rendering::Scene scene = rendering::comparisonScene();
    ReferencePicture picture = reference(*edited.with(controlsOf({{ArtistControl::roughness, Rgb(2)}})), scene);
    double brightest = 0;
    for (glm::vec3& pixel : picture.image.pixels) {
      pixel *= 8.f;
      brightest = std::max(brightest, maxChannel(Rgb(pixel)));
    }
    picture.clip = brightest / 1.25;
    for (glm::vec3& pixel : picture.image.pixels) pixel = glm::min(pixel, glm::vec3(float(picture.clip)));
    const ControlMatch match = matchControls(picture, edited, scene, {.freeExposure = true});
    qInfo("exposure %.2f, roughness %.2f", match.exposure,
          match.controls.values[std::size_t(ArtistControl::roughness)].x);
    QVERIFY(std::abs(match.exposure - 3) < 0.15);
    QVERIFY(std::abs(std::log2(match.controls.values[std::size_t(ArtistControl::roughness)].x) - 1) < 0.15);
  }

  void stopsAndReports() {
    const MatchedMaterial edited = fitted("library:rgl/satin_purple");
    rendering::Scene scene = rendering::comparisonScene();
    const ReferencePicture picture = reference(*edited.with(controlsOf({})), scene);
    std::stop_source stop;
    stop.request_stop();
    QVERIFY_THROWS_EXCEPTION(Cancelled, matchControls(picture, edited, scene, {}, {stop.get_token(), {}}));
    scene.environment.reset();
    QVERIFY_THROWS_EXCEPTION(Error, matchControls(picture, edited, scene));
  }
};

GONIO_TEST(ControlMatchTest)
}  // namespace control_match_test

#include "control_match_test.moc"
