// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/photograph/photograph_fit.h"

#include <QTest>

#include "core/metrics/image_metrics.h"
#include "core/photograph/photograph_solution.h"
#include "core/rendering/render_picture.h"
#include "core/support/error.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace photograph_fit_test {
using namespace gonio;
using namespace gonio::photograph;

constexpr HalfDifferenceGrid grid{45, 15, 18, true};

/// Materials of which the prior is learned: GGX of several widths, colours and strengths.
const std::vector<std::shared_ptr<const TabulatedBrdf>>& tables() {
  static const auto all = [] {
    std::vector<std::shared_ptr<const TabulatedBrdf>> result;
    for (const double roughness : {0.15, 0.25, 0.4, 0.6})
      for (const double f0 : {0.03, 0.08, 0.3})
        for (const Rgb diffuse : {Rgb(0.05, 0.1, 0.3), Rgb(0.5, 0.3, 0.1)})
          result.push_back(bakeTable(*test::ggx(diffuse, Rgb(1), roughness, f0), grid));
    return result;
  }();
  return all;
}

const dictionary::PrincipalComponents& basis() {
  static const auto learned =
      dictionary::learnPrincipalComponents(tables().size(), [](std::size_t m) { return tables()[m]; });
  return learned;
}

const PhotographPrior& prior() {
  static const PhotographPrior result = photographPrior(basis(), 40);
  return result;
}

/// A picture by the path tracer.
PhotographSet photographOf(const Brdf& material, float factor = 1, const Surface& surface = {}) {
  Photograph photograph{.name = "test",
                        .image = {},
                        .disc = {},
                        .camera = {.pitch = 0.1},
                        .surface = surface,
                        .size = {64, 64},
                        .light = {.environment = rendering::studioEnvironment(), .rotation = 0.4}};
  photograph.disc = discOf(photograph.camera, 64, 64);
  photograph.image = rendering::renderPicture(material, sceneOf(photograph, 64, 64),
                                              {.width = 64, .height = 64, .samples = 64, .density = {}});
  for (glm::vec3& pixel : photograph.image.pixels) pixel *= factor;
  return {.photographs = {photograph}, .warnings = {}};
}

double snrUnderOtherLight(const Brdf& reference, const Brdf& found) {
  const rendering::Scene scene = rendering::sphereScene();
  const rendering::RenderOptions options{.width = 64, .height = 64, .samples = 4, .density = {}};
  return metrics::signalToNoiseRatio(rendering::renderPicture(reference, scene, options),
                                     rendering::renderPicture(found, scene, options));
}

constexpr std::size_t quick = 250;  // regions

/// The check that a warning is about: of the suspicious ones, that which explains the photographs best.
const InputCheck* reported(const PhotographFit& fit) {
  const InputCheck* best = nullptr;
  for (const InputCheck& check : fit.checks)
    if (check.isSuspicious && (!best || check.unexplainedSnr > best->unexplainedSnr)) best = &check;
  return best;
}

QByteArray textOf(const PhotographFit& fit) {
  QByteArray text = QByteArray::number(fit.unexplainedSnr) + " dB; ";
  for (const InputCheck& check : fit.checks)
    text += QByteArray::fromStdString(check.property) + " " + QByteArray::number(check.estimate) + " +- " +
            QByteArray::number(check.deviation) + ", " + QByteArray::number(check.unexplainedSnr) + " dB; ";
  for (const std::string& warning : fit.warnings) text += QByteArray::fromStdString(warning) + "; ";
  return text;
}

class PhotographFitTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// A material in the span of the prior comes back from its picture, and looks the same under other light.
  void recoversATrainingMaterial() {
    for (const std::size_t m : {std::size_t(2), std::size_t(9)}) {
      const PhotographFit fit = fitPhotographs(prior(), photographOf(*tables()[m]), quick);
      const auto found = dictionary::decode(basis(), fit.code);
      const double snr = snrUnderOtherLight(*tables()[m], *found);
      QVERIFY2(fit.residualSnr[0] > 30, QByteArray::number(fit.residualSnr[0]));
      QVERIFY2(snr > 25, QByteArray::number(snr));
      QCOMPARE(fit.exposure, 1.0);
      for (const auto& value : found->values()) QVERIFY(value.x >= 0 && value.y >= 0 && value.z >= 0);
    }
  }

  /// The same from a cylinder, and from four images of a flat sample that is turned. Only spheres have outlines that
  /// can be checked.
  void recoversFromOtherSurfaces() {
    const TabulatedBrdf& material = *tables()[9];
    const PhotographSet cylinder = photographOf(material, 1, Cylinder{glm::normalize(Direction(0.2, 1, 0)), 1.8});
    PhotographSet flat = photographOf(material, 1, FlatSample{{0, 0, 1}, 1.8, 1.4});
    for (const double angle : {radians(-50.0), radians(-20.0), radians(40.0)}) {
      const Direction normal(std::sin(angle), 0, std::cos(angle));
      flat.photographs.push_back(photographOf(material, 1, FlatSample{normal, 1.8, 1.4, true}).photographs[0]);
    }
    for (const PhotographSet& set : {cylinder, flat}) {
      const PhotographFit fit = fitPhotographs(prior(), set, quick);
      const double snr = snrUnderOtherLight(material, *dictionary::decode(basis(), fit.code));
      for (const double residual : fit.residualSnr) QVERIFY2(residual > 30, QByteArray::number(residual));
      QVERIFY2(snr > 20, QByteArray::number(snr));
      QCOMPARE(fit.checks.size(), std::size_t(3));  // exposure, gamma, rotation
      for (const InputCheck& check : fit.checks) QVERIFY(!check.isSuspicious);
    }
  }

  /// A common factor of all pixels is found if it is unknown. The light does not show it: it is as uncertain as the
  /// albedo of the training materials.
  void findsTheExposure() {
    const PhotographSet known = photographOf(*tables()[8]);
    PhotographSet unknown = photographOf(*tables()[8], 7);
    unknown.exposureKnown = false;
    const PhotographFit fit = fitPhotographs(prior(), unknown, quick);
    QVERIFY2(std::abs(std::log(fit.exposure / 7)) < 3 * fit.exposureDeviation, QByteArray::number(fit.exposure));
    QVERIFY2(std::abs(std::log(fit.exposure / 7)) < 0.5, QByteArray::number(fit.exposure));
    const PhotographFit reference = fitPhotographs(prior(), known, quick);
    QVERIFY(fit.residualSnr[0] > reference.residualSnr[0] - 3);
  }

  /// On average over the cells, a photograph leaves less uncertainty than the training set has.
  void photographsReduceTheUncertainty() {
    const PhotographFit fit = fitPhotographs(prior(), photographOf(*tables()[5]), quick);
    const auto deviation = deviations(basis(), fit);
    const auto training = dictionary::leftOutVariance(basis(), 0, 0, basis().mapping.cells.size());
    QCOMPARE(deviation.size(), training.size());
    double posterior = 0, before = 0;
    for (std::size_t i = 0; i < training.size(); ++i)
      for (int channel = 0; channel < 3; ++channel) {
        QVERIFY(std::isfinite(deviation[i][channel]) && deviation[i][channel] >= 0);
        posterior += deviation[i][channel] * deviation[i][channel];
        before += training[i];
      }
    QVERIFY2(posterior < 0.25 * before, QByteArray::number(posterior / before));
    QCOMPARE(fit.widening, widening(fit.unexplainedSnr, 1));
    QVERIFY(fit.unexplainedSnr >= fit.residualSnr[0]);
  }

  /// The checks name the fault.
  void recognisesAShiftedOutline() {
    PhotographSet set = photographOf(*tables()[0]);
    set.photographs[0].disc.x += 1;
    const PhotographFit fit = fitPhotographs(prior(), set, quick);
    const InputCheck* check = reported(fit);
    QVERIFY2(check && check->property == "outline x", textOf(fit));
    QVERIFY2(std::abs(check->estimate + 1) < 0.5, textOf(fit));
    QCOMPARE(fit.warnings.size(), std::size_t(1));
  }

  /// The other checks hold for all surfaces.
  void recognisesARotatedEnvironment() {
    PhotographSet set = photographOf(*tables()[0], 1, Cylinder{{0, 1, 0}, 1.8});
    set.photographs[0].light.rotation += radians(4);
    const PhotographFit fit = fitPhotographs(prior(), set, quick);
    const InputCheck* check = reported(fit);
    QVERIFY2(check && check->property == "rotation", textOf(fit));
    QVERIFY2(std::abs(check->estimate + radians(4)) < radians(1.5), textOf(fit));
  }

  /// A stated exposure that is wrong: found by the solution with an unknown one.
  void recognisesAWrongExposure() {
    const PhotographFit fit = fitPhotographs(prior(), photographOf(*tables()[8], 20), quick);
    const InputCheck* check = reported(fit);
    QVERIFY2(check && check->property == "exposure", textOf(fit));
    QVERIFY2(std::abs(check->estimate - std::log(20)) < 0.5, textOf(fit));
    QVERIFY2(check->estimate > 3 * check->deviation, textOf(fit));
    QVERIFY2(fit.warnings.size() == 1 && fit.warnings[0].find("exposure") != std::string::npos, textOf(fit));
    QCOMPARE(fit.exposure, 1.0);
  }

  /// A material unlike all training materials is reported as such, and not as a fault of the input.
  void reportsAMaterialThatThePriorLacks() {
    const test::FunctionBrdf retroreflector([](const Direction& wi, const Direction& wo) {
      return Rgb(20 * std::pow(std::max(0.0, glm::dot(wi, wo)), 100));
    });
    const PhotographFit fit = fitPhotographs(prior(), photographOf(retroreflector), quick);
    QVERIFY2(!reported(fit), textOf(fit));
    QVERIFY2(fit.warnings.size() == 1 && fit.warnings[0].find("no training material") != std::string::npos,
             textOf(fit));
  }

  /// What a material leaves unexplained widens its uncertainty, within limits.
  void deviationsWidenWithTheResidual() {
    double last = widening(-10, 1);
    QCOMPARE(widening(0, 1), last);
    QVERIFY(widening(20, 4) > widening(20, 1));
    for (const double snr : {12.0, 20.0, 30.0, 40.0}) {
      QVERIFY(widening(snr, 1) < last);
      last = widening(snr, 1);
    }
    QCOMPARE(widening(60, 1), last);
  }

  void canBeCancelled() {
    std::stop_source source;
    source.request_stop();
    const PhotographSet set = photographOf(*tables()[5]);
    QVERIFY_THROWS_EXCEPTION(Cancelled, fitPhotographs(prior(), set, quick, {source.get_token(), {}}));
  }
};

GONIO_TEST(PhotographFitTest)

}  // namespace photograph_fit_test

#include "photograph_fit_test.moc"
