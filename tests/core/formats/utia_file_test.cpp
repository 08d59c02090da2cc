// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>
#include <limits>
#include <random>

#include "core/formats/formats.h"
#include "tests/core/formats/instrument_files.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace utia_file_test {
using namespace gonio;
using namespace gonio::test;

/// From 0 at azimuth 0 to 1 at half a turn, linear on both sides: its corners are nodes.
double tent(const Direction& w) { return std::abs(azimuth(w)) / pi; }
/// The same with the corners a quarter turn on.
double turnedTent(const Direction& w) { return std::abs(azimuth(rotateZ(w, -halfPi))) / pi; }

/// Linear in each angle between nodes, without an azimuth at the pole, and another function of each direction: linear
/// interpolation returns it exactly, and a file with rows and columns exchanged would not.
Rgb multilinear(const Direction& wi, const Direction& wo) {
  const double i = polarAngle(wi), o = polarAngle(wo);
  return {1 + i * tent(wi) + 3 * o * turnedTent(wo), 2 + i * o * tent(wi) * tent(wo), 0.5 + i};
}

std::shared_ptr<const UtiaBrdf> readAsViewer(const Bytes& bytes) {
  materials::Material material;
  formats::utiaFormat.read(io::MemorySource(bytes), {}, material);
  return formOf<UtiaBrdf>(material.brdf);
}
/// With the light as incident direction, as the file names it.
std::shared_ptr<const UtiaBrdf> read(const Bytes& bytes) {
  return readAsViewer(bytes)->withIncident(IncidentDirection::light);
}
std::string readError(const Bytes& bytes) {
  return errorOf([&] { read(bytes); });
}
std::string sniffError(const Bytes& bytes) {
  return errorOf([&] { formats::utiaFormat.sniff(io::MemorySource(bytes)); });
}

Direction randomMeasured(std::mt19937_64& random) {
  Direction w;
  do w = randomUpper(random);
  while (polarAngle(w) > UtiaBrdf::maxPolarAngle);
  return w;
}

class UtiaFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void multilinearFunctionsAreExactBetweenNodes() {
    const Bytes bytes = utiaFile(utiaValues(multilinear));
    QCOMPARE(bytes.size(), std::size_t(1990656));
    formats::utiaFormat.sniff(io::MemorySource(bytes));
    const auto brdf = read(bytes);
    QVERIFY(!brdf->isIsotropic() && !brdf->isReciprocal());
    QCOMPARE(brdf->clampedCount(), std::size_t(0));
    std::mt19937_64 random(1);
    for (int i = 0; i < 2000; ++i) {
      const Direction wi = randomMeasured(random), wo = randomMeasured(random);
      QVERIFY(glm::length(brdf->evaluate(wi, wo) - multilinear(wi, wo)) < 2e-6);
      QVERIFY(brdf->hasData({wi, wo}));
    }
  }

  /// As of RGL files; without a choice the viewer is the incident direction.
  void incidentDirectionIsTheViewerTheLightOrBoth() {
    const auto viewer = readAsViewer(utiaFile(utiaValues(multilinear)));
    QVERIFY(viewer->incidentDirection() == IncidentDirection::viewer);
    QCOMPARE(withIncident(viewer, IncidentDirection::viewer), std::shared_ptr<const Brdf>(viewer));
    const auto light = withIncident(viewer, IncidentDirection::light),
               mean = withIncident(viewer, IncidentDirection::mean);
    QVERIFY(!viewer->isReciprocal() && !light->isReciprocal() && mean->isReciprocal());
    std::mt19937_64 random(3);
    for (int i = 0; i < 100; ++i) {
      const Direction wi = randomMeasured(random), wo = randomMeasured(random);
      QVERIFY(viewer->evaluate(wi, wo) == light->evaluate(wo, wi));
      QVERIFY(glm::length(light->evaluate(wi, wo) - multilinear(wi, wo)) < 2e-6);
      QVERIFY(mean->evaluate(wi, wo) == mean->evaluate(wo, wi));
      QVERIFY(glm::length(mean->evaluate(wi, wo) - (multilinear(wi, wo) + multilinear(wo, wi)) / 2.0) < 2e-6);
    }
  }

  /// Every stored node but those of the pole, whose azimuths are one direction.
  void nodesAreTheStoredValues() {
    const auto random = [](const Direction& wi, const Direction& wo) {
      return Rgb(2 + std::sin(90 * wi.x + 17 * wo.y), 2 + std::cos(50 * wi.y - 31 * wo.x), 1 + wi.x * wi.x);
    };
    const auto brdf = read(utiaFile(utiaValues(random)));
    for (std::size_t i = UtiaBrdf::azimuthCount; i < UtiaBrdf::directionCount; i += 7)
      for (std::size_t v = UtiaBrdf::azimuthCount; v < UtiaBrdf::directionCount; v += 5) {
        const Direction wi = utiaDirection(i), wo = utiaDirection(v);
        QVERIFY(glm::length(brdf->evaluate(wi, wo) - random(wi, wo)) < 1e-5);
      }
  }

  /// At the pole a file may hold another value for each azimuth: what is read there is their mean, from every side.
  void continuousAtThePoleAndAcrossTheSeam() {
    std::vector<Rgb> values = utiaValues(multilinear);
    for (std::size_t azimuth = 0; azimuth < UtiaBrdf::azimuthCount; ++azimuth)
      for (std::size_t v = 0; v < UtiaBrdf::directionCount; ++v)
        values[azimuth * UtiaBrdf::directionCount + v] = Rgb(double(azimuth));
    const auto brdf = read(utiaFile(values));
    const Direction wo = fromSpherical(0.7, 1), pole(0, 0, 1);
    QVERIFY(glm::length(brdf->evaluate(pole, wo) - Rgb(23.5)) < 1e-4);
    for (const double phi : {0.0, 1.0, 3.1, -2.0})
      QVERIFY(glm::length(brdf->evaluate(fromSpherical(1e-7, phi), wo) - Rgb(23.5)) < 1e-4);
    for (const double seam : {0.0, pi})
      for (const double theta : {0.4, 1.2}) {
        const Rgb left = brdf->evaluate(fromSpherical(theta, seam - 1e-9), wo),
                  right = brdf->evaluate(fromSpherical(theta, seam + 1e-9), wo);
        QVERIFY(glm::length(left - right) < 1e-6);
        QVERIFY(glm::length(brdf->evaluate(wo, fromSpherical(theta, seam - 1e-9)) -
                            brdf->evaluate(wo, fromSpherical(theta, seam + 1e-9))) < 1e-6);
      }
  }

  void lastNodeStaysToTheHorizon() {
    const auto brdf = read(utiaFile(utiaValues(multilinear)));
    const Direction wo = fromSpherical(0.5, -1);
    for (const double phi : {0.0, 2.0, -3.0}) {
      const Rgb atLast = brdf->evaluate(fromSpherical(UtiaBrdf::maxPolarAngle, phi), wo);
      for (const double theta : {1.32, 1.5, halfPi}) {
        QVERIFY(glm::length(brdf->evaluate(fromSpherical(theta, phi), wo) - atLast) < 1e-9);
        QVERIFY(!brdf->hasData({fromSpherical(theta, phi), wo}) && !brdf->hasData({wo, fromSpherical(theta, phi)}));
      }
      QVERIFY(brdf->hasData({fromSpherical(UtiaBrdf::maxPolarAngle, phi), wo}));
    }
    QVERIFY(brdf->evaluate({0, 0.6, -0.8}, wo) == Rgb(0) && !brdf->hasData({wo, {0, 0.6, -0.8}}));
  }

  void negativeValuesAreCutAndCounted() {
    std::vector<Rgb> values = utiaValues([](const Direction&, const Direction&) { return Rgb(1); });
    const std::size_t row = 100, column = 77;
    values[row * UtiaBrdf::directionCount + column] = {-0.5, 1, -1e-30};
    const auto brdf = read(utiaFile(values));
    QCOMPARE(brdf->clampedCount(), std::size_t(2));
    const Rgb value = brdf->evaluate(utiaDirection(row), utiaDirection(column));
    QVERIFY(glm::length(value - Rgb(0, 1, 0)) < 1e-6);
    for (int channel = 0; channel < 3; ++channel) QVERIFY(value[channel] >= 0);
  }

  void pictureHoldsTheSameBrdf() {
    const std::vector<Rgb> values = utiaValues(multilinear);
    const Bytes picture = utiaPicture(values);
    formats::utiaFormat.sniff(io::MemorySource(picture));
    const auto fromPicture = read(picture), fromPlanes = read(utiaFile(values));
    std::mt19937_64 random(2);
    for (int i = 0; i < 200; ++i) {
      const Direction wi = randomUpper(random), wo = randomUpper(random);
      QVERIFY(fromPicture->evaluate(wi, wo) == fromPlanes->evaluate(wi, wo));
    }
    const auto path = outputPath("io/small.exr");
    io::writeExr(Image(288, 287), path);
    QVERIFY(contains(sniffError(readFile(path)), "found an EXR image of 288 x 287 pixels"));
    Bytes half(picture.begin(), picture.begin() + std::ptrdiff_t(picture.size() / 2));
    QVERIFY(contains(sniffError(half), "cannot be read"));
  }

  void otherBytesAreRefused() {
    Bytes bytes = utiaFile(utiaValues(multilinear));
    QVERIFY(contains(readError(Bytes(bytes.begin(), bytes.end() - 1)), "found 1990655 bytes; expected 1990656"));
    QVERIFY(contains(sniffError({}), "found 0 bytes"));
    std::fill(bytes.begin(), bytes.begin() + 16, std::byte('t'));
    QVERIFY(contains(sniffError(bytes), "not BRDF values"));
    std::vector<Rgb> values = utiaValues(multilinear);
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e300}) {
      values[3 * 288 + 5].y = bad;
      QVERIFY(contains(readError(utiaFile(values)), "incident direction 3 and viewing direction 5"));
    }
  }
};

GONIO_TEST(UtiaFileTest)
}  // namespace utia_file_test

#include "utia_file_test.moc"
