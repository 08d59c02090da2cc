// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/environment.h"

#include <QTest>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "core/io/image_io.h"
#include "core/math/sampling.h"
#include "core/rendering/scene.h"
#include "core/support/error.h"
#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace environment_test {
using namespace gonio;
using namespace gonio::rendering;

Direction randomDirection(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  return fromSpherical(std::acos(1 - 2 * uniform(random)), 2 * pi * uniform(random));
}

/// A few bright pixels, black ones and one in a corner: the hard shapes of a density.
EnvironmentMap spottedMap() {
  Image image(16, 8);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = glm::vec3(0.02f * float(i % 5));
  for (int x = 0; x < 16; ++x) image.at(x, 5) = glm::vec3(0);
  image.at(0, 0) = glm::vec3(3, 1, 0);
  image.at(9, 3) = glm::vec3(40);
  return EnvironmentMap(image, "spots");
}

/// Integral over the sphere by the midpoint rule.
template <typename Function>
double integral(const Function& function, int width) {
  const int height = width / 2;
  double sum = 0;
  for (int y = 0; y < height; ++y) {
    double row = 0;
    for (int x = 0; x < width; ++x) row += function(EnvironmentMap::directionAt((x + 0.5) / width, (y + 0.5) / height));
    sum += row * std::sin(pi * (y + 0.5) / height);
  }
  return sum * 2 * pi / width * pi / height;
}

class EnvironmentTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void mappingMeetsTheAxes() {
    const auto isNear = [](const Direction& a, const Direction& b) { return glm::length(a - b) < 1e-15; };
    QVERIFY(isNear(EnvironmentMap::directionAt(0.5, 0.5), {0, 0, -1}));
    QVERIFY(isNear(EnvironmentMap::directionAt(0.75, 0.5), {1, 0, 0}));
    QVERIFY(isNear(EnvironmentMap::directionAt(0.25, 0.5), {-1, 0, 0}));
    QVERIFY(isNear(EnvironmentMap::directionAt(0.0, 0.5), {0, 0, 1}));
    QVERIFY(isNear(EnvironmentMap::directionAt(0.3, 0.0), {0, 1, 0}));
    QVERIFY(isNear(EnvironmentMap::directionAt(0.3, 1.0), {0, -1, 0}));
  }

  void mappingAndItsInverse() {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int n = 0; n < 100000; ++n) {
      const Direction w = randomDirection(random);
      const glm::dvec2 p = EnvironmentMap::positionOf(w);
      QVERIFY(p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1);
      QVERIFY(glm::length(EnvironmentMap::directionAt(p.x, p.y) - w) < 1e-14);
      const double u = uniform(random), v = uniform(random);
      const glm::dvec2 back = EnvironmentMap::positionOf(EnvironmentMap::directionAt(u, v));
      QVERIFY(std::abs(back.y - v) < 1e-14);
      QVERIFY(std::abs(back.x - u) * std::sin(pi * v) < 1e-14);
    }
  }

  void pixelCentresReadTheirPixel() {
    const EnvironmentMap map = spottedMap();
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 16; ++x) {
        const Rgb value = map.radiance(EnvironmentMap::directionAt((x + 0.5) / 16, (y + 0.5) / 8));
        QVERIFY(glm::length(value - Rgb(map.image().at(x, y))) < 1e-12);
      }
  }

  void bilinearWrapsInAzimuth() {
    Image image(4, 2);
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 4; ++x) image.at(x, y) = glm::vec3(float(x));
    const EnvironmentMap map(image, "ramp");
    QVERIFY(std::abs(map.radiance(EnvironmentMap::directionAt(0.0, 0.5)).x - 1.5) < 1e-12);
    QVERIFY(std::abs(map.radiance(EnvironmentMap::directionAt(1.0, 0.5)).x - 1.5) < 1e-12);
    QVERIFY(std::abs(map.radiance(EnvironmentMap::directionAt(0.5, 0.5)).x - 1.5) < 1e-12);
    QVERIFY(std::abs(map.radiance(EnvironmentMap::directionAt(0.03125, 0.3)).x - (0.375 * 3)) < 1e-12);
  }

  /// Midpoint rule with a whole number of points per pixel: exact for a density that is linear across pixels, but for
  /// the change of the sine inside a row.
  void densityIntegratesToOne() {
    for (const EnvironmentMap& map : {spottedMap(), EnvironmentMap(Image(6, 4), "black"), *studioEnvironment()}) {
      const int width = 2 * map.image().width, height = (map.image().height > 64 ? 4 : 64) * map.image().height;
      double sum = 0;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          sum += map.pdf(EnvironmentMap::directionAt((x + 0.5) / width, (y + 0.5) / height)) *
                 std::sin(pi * (y + 0.5) / height);
      QVERIFY(std::abs(sum * 2 * pi / width * pi / height - 1) < 1e-4);
    }
  }

  void samplesFollowTheDensity() {
    const EnvironmentMap map = spottedMap();
    constexpr int perAxis = 500;
    std::vector<double> counts(16 * 8, 0.0);
    for (int i = 0; i < perAxis * perAxis; ++i) {
      const auto s = map.sample((i % perAxis + 0.5) / perAxis, (i / perAxis + 0.5) / perAxis);
      QVERIFY(std::abs(glm::length(s.direction) - 1) < 1e-12);
      QVERIFY(s.pdf > 0 && std::abs(map.pdf(s.direction) / s.pdf - 1) < 1e-6);
      QVERIFY(glm::length(map.radiance(s.direction) - s.radiance) < 1e-9);
      const glm::dvec2 p = EnvironmentMap::positionOf(s.direction);
      counts[std::size_t(p.y * 8) * 16 + std::size_t(p.x * 16)] += 1.0 / (perAxis * perAxis);
    }
    constexpr int parts = 32;
    for (std::size_t y = 0; y < 8; ++y)
      for (std::size_t x = 0; x < 16; ++x) {
        double probability = 0;
        for (int i = 0; i < parts * parts; ++i) {
          const double v = (double(y) + (i / parts + 0.5) / parts) / 8;
          const double solidAngle = 2 * pi / (16 * parts) * pi / (8 * parts) * std::sin(pi * v);
          probability +=
              map.pdf(EnvironmentMap::directionAt((double(x) + (i % parts + 0.5) / parts) / 16, v)) * solidAngle;
        }
        QVERIFY(std::abs(counts[y * 16 + x] - probability) < 1e-3);
      }
  }

  void endsOfTheUnitIntervalAreSafe() {
    const EnvironmentMap map = spottedMap();
    for (const double u : {0.0, 0x1p-53, 0.5, 1 - 0x1p-32, 1 - 0x1p-53})
      for (const double v : {0.0, 0x1p-53, 0.5, 1 - 0x1p-32, 1 - 0x1p-53}) {
        const auto s = map.sample(u, v);
        // At the ends of the interval the density may be that of a black pixel.
        QVERIFY(s.pdf > 0 || s.radiance == Rgb(0));
        QVERIFY(s.pdf >= 0 && std::isfinite(s.pdf) && std::abs(glm::length(s.direction) - 1) < 1e-12);
      }
  }

  void furnaceIsUniform() {
    std::mt19937_64 random(2);
    for (int n = 0; n < 1000; ++n) {
      const auto at = furnaceEnvironment()->at(randomDirection(random));
      QCOMPARE(at.radiance, Rgb(1));
      QVERIFY(std::abs(at.pdf * 4 * pi - 1) < 1e-9);
    }
  }

  void rotationTurnsFromAheadToTheRight() {
    QVERIFY(glm::length(EnvironmentRotation(radians(90)).fromEnvironment({0, 0, -1}) - Direction(1, 0, 0)) < 1e-15);
    const EnvironmentRotation rotation(0.7);
    std::mt19937_64 random(3);
    for (int n = 0; n < 1000; ++n) {
      const Direction w = randomDirection(random);
      QVERIFY(glm::length(rotation.fromEnvironment(rotation.toEnvironment(w)) - w) < 1e-14);
      const double turn = EnvironmentMap::positionOf(rotation.fromEnvironment(w)).x - EnvironmentMap::positionOf(w).x;
      QVERIFY(std::abs(std::remainder(turn - 0.7 / (2 * pi), 1.0)) < 1e-9);
    }
  }

  /// Nothing is brighter than the rest: every direction is as likely, and finite.
  void aBlackMapIsSampledEvenly() {
    const EnvironmentMap map(Image(32, 16), "black");
    constexpr int perAxis = 200;
    std::array<int, 8> octants{};
    for (int i = 0; i < perAxis * perAxis; ++i) {
      const auto s = map.sample((i % perAxis + 0.5) / perAxis, (i / perAxis + 0.5) / perAxis);
      QVERIFY(std::abs(s.pdf * 4 * pi - 1) < 1e-4);
      QVERIFY(std::abs(glm::length(s.direction) - 1) < 1e-12);
      QCOMPARE(s.radiance, Rgb(0));
      ++octants[std::size_t((s.direction.x > 0) + 2 * (s.direction.y > 0) + 4 * (s.direction.z > 0))];
    }
    for (const int count : octants) QVERIFY(std::abs(count * 8.0 / (perAxis * perAxis) - 1) < 0.03);
  }

  /// The radiance between pixel centres is bilinear, so that a pixel shines half way into its neighbours; also over the
  /// edge behind the camera and at a pole.
  void aHotPixelTakesAllSamples() {
    constexpr int width = 32, height = 16;
    for (const auto& [hotX, hotY] : {std::pair(13, 6), std::pair(0, 9), std::pair(31, 0)}) {
      Image image(width, height);
      image.at(hotX, hotY) = glm::vec3(1e6f, 1e5f, 0);
      const EnvironmentMap map(image, "hot");
      QVERIFY(std::abs(integral([&](const Direction& w) { return map.pdf(w); }, width * 16) - 1) < 1e-3);
      constexpr int perAxis = 100;
      int onIt = 0;
      for (int i = 0; i < perAxis * perAxis; ++i) {
        const auto s = map.sample((i % perAxis + 0.5) / perAxis, (i / perAxis + 0.5) / perAxis);
        const glm::dvec2 p = EnvironmentMap::positionOf(s.direction);
        const int dx = std::abs(int(p.x * width) - hotX), dy = std::abs(int(p.y * height) - hotY);
        QVERIFY(std::min(dx, width - dx) <= 1 && dy <= 1);
        QVERIFY(s.pdf > 0 && std::isfinite(s.pdf));
        onIt += dx == 0 && dy == 0;
      }
      // Of its light (3/4)^2 falls into the pixel itself, by solid angle somewhat less at the pole.
      const double fraction = double(onIt) / (perAxis * perAxis);
      QVERIFY(fraction > 0.5 && fraction < 0.65);
    }
  }

  /// Maps above 8192 pixels wide are reduced for sampling: the density is positive wherever the map is, also about a
  /// single bright pixel and over the edge behind the camera, and samples have the right mean.
  void wideMapsAreReducedForSampling() {
    constexpr int width = 8195, height = 5;
    Image image(width, height);
    image.at(8194, 2) = glm::vec3(100);
    image.at(4001, 0) = glm::vec3(50);
    for (int x = 2000; x < 3000; ++x) image.at(x, 3) = glm::vec3(float(1 + x % 3));
    const EnvironmentMap map(image, "wide");
    double total = 0, density = 0;
    constexpr int across = 4, down = 50;  // per pixel
    for (int y = 0; y < height * down; ++y)
      for (int x = 0; x < width * across; ++x) {
        const double v = (y + 0.5) / (height * down);
        const auto at = map.at(EnvironmentMap::directionAt((x + 0.5) / (width * across), v));
        QVERIFY(at.pdf > 0 || at.radiance == Rgb(0));
        const double solidAngle = std::sin(pi * v) * pi / (height * down) * 2 * pi / (width * across);
        total += at.radiance.x * solidAngle;
        density += at.pdf * solidAngle;
      }
    QVERIFY(std::abs(density - 1) < 2e-3);
    double sum = 0, squares = 0;
    constexpr int samples = 100000;
    for (int i = 0; i < samples; ++i) {
      const glm::dvec2 u = scrambledSobol(std::uint32_t(i), 3);
      const auto s = map.sample(u.x, u.y);
      QVERIFY(std::abs(map.pdf(s.direction) / s.pdf - 1) < 1e-6);
      const double one = s.radiance.x / s.pdf;
      sum += one / samples;
      squares += one * one / samples;
    }
    QVERIFY(std::abs(sum / total - 1) < 6 * std::sqrt((squares / (sum * sum) - 1) / samples) + 2e-3);
  }

  /// The density for a surface integrates to 1, and misses no light above the horizon, whatever the normal; samples
  /// have it, and their mean is the irradiance.
  void surfacesAreSampledByTheirIrradiance() {
    std::mt19937_64 random(7);
    for (const EnvironmentMap& map : {spottedMap(), *studioEnvironment(), EnvironmentMap(Image(3, 2), "black")})
      for (int n = 0; n < 12; ++n) {
        const Direction normal = n < 3 ? Direction(n == 0, n == 1 ? -1 : 0, n == 2) : randomDirection(random);
        const int width = std::max(768, 2 * map.image().width);
        QVERIFY(std::abs(integral([&](const Direction& w) { return map.atAbove(normal, w).pdf; }, width) - 1) < 2e-3);
        const double irradiance =
            integral([&](const Direction& w) { return map.radiance(w).y * std::max(0.0, glm::dot(normal, w)); }, width);
        double sum = 0, squares = 0, squaresOfSphere = 0;
        constexpr int samples = 4096;
        for (int i = 0; i < samples; ++i) {
          const glm::dvec2 u = scrambledSobol(std::uint32_t(i), std::uint32_t(n));
          const auto even = map.sample(u.x, u.y);
          if (even.pdf > 0)
            squaresOfSphere +=
                std::pow(even.radiance.y * std::max(0.0, glm::dot(normal, even.direction)) / even.pdf, 2) / samples;
          const auto s = map.sampleAbove(normal, u.x, u.y);
          if (!(s.pdf > 0)) continue;
          QVERIFY(glm::dot(normal, s.direction) > 0);
          QVERIFY(std::abs(map.atAbove(normal, s.direction).pdf / s.pdf - 1) < 1e-6);
          const double one = s.radiance.y * glm::dot(normal, s.direction) / s.pdf;
          sum += one / samples;
          squares += one * one / samples;
        }
        const double error = std::sqrt(std::max(0.0, squares - sum * sum) / samples);
        QVERIFY2(std::abs(sum - irradiance) <= 4 * error + 2e-3 * irradiance,
                 qPrintable(QString("%1 and %2").arg(sum).arg(irradiance)));
        QVERIFY(squares <= 1.02 * squaresOfSphere);
      }
  }

  void noLightAboveTheHorizonMissesTheDensity() {
    std::mt19937_64 random(8);
    for (const EnvironmentMap& map : {spottedMap(), EnvironmentMap(Image(3, 2), "black"), *skyEnvironment()})
      for (int n = 0; n < 200000; ++n) {
        const Direction normal = randomDirection(random);
        Direction w = randomDirection(random);
        if (n % 2) w = glm::normalize(w - (glm::dot(w, normal) - 0.01) * normal);  // near the horizon
        if (!(glm::dot(normal, w) > 0)) continue;
        const auto at = map.atAbove(normal, w);
        QCOMPARE(at.radiance, map.radiance(w));
        QVERIFY(std::isfinite(at.pdf) && (at.pdf > 0 || at.radiance == Rgb(0)));
      }
  }

  /// A lamp below the horizon takes no samples.
  void lightBelowTheHorizonIsNotSampled() {
    Image image(64, 32);
    image.at(20, 25) = glm::vec3(100);
    const EnvironmentMap lamp(image, "lamp");
    QCOMPARE(lamp.sampleAbove({0, 1, 0}, 0.3, 0.6).pdf, 0.0);
    image.at(5, 3) = glm::vec3(1e-3f);
    const EnvironmentMap both(image, "both");
    for (std::uint32_t i = 0; i < 1000; ++i) {
      const glm::dvec2 u = scrambledSobol(i, 2);
      QVERIFY(both.sampleAbove({0, 1, 0}, u.x, u.y).direction.y > 0);
    }
  }

  void badPicturesAreRefused() {
    QVERIFY_THROWS_EXCEPTION(Error, EnvironmentMap(Image(), "none"));
    const auto refusal = [](float value) {
      Image image(4, 3);
      image.at(3, 1).y = value;
      image.at(0, 2).x = value;  // the first one is named
      try {
        EnvironmentMap(image, "attic");
      } catch (const Error& error) {
        return std::string(error.what());
      }
      return std::string("no error");
    };
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (const auto& [value, text] : {std::pair(std::numeric_limits<float>::quiet_NaN(), "nan"),
                                      std::pair(infinity, "inf"), std::pair(-infinity, "-inf")})
      QCOMPARE(refusal(value), std::string("environment 'attic': pixel (3, 1), counted from the upper left, has ") +
                                   text + " in channel G; expected a finite radiance");
    QVERIFY_THROWS_EXCEPTION(Error, bundledEnvironment("moon"));
  }

  /// Filters and gamuts leave tiny negative values.
  void negativeRadianceIsZeroAndCounted() {
    Image image(4, 2);
    for (glm::vec3& pixel : image.pixels) pixel = glm::vec3(1);
    image.at(1, 0) = {-1e-7f, 0.5f, -0.25f};
    image.at(3, 1).y = -1e-9f;
    const EnvironmentMap map(image, "filtered", {"converted"});
    QVERIFY(map.image().at(1, 0) == glm::vec3(0, 0.5f, 0) && map.image().at(3, 1) == glm::vec3(1, 0, 1));
    QCOMPARE(map.notes(), (std::vector<std::string>{
                              "converted", "2 pixels with negative values, down to -0.25, were limited to 0"}));
  }

  void filesOfOtherShapesAndLayouts() {
    const auto path = test::outputPath("rendering/layout.exr");
    io::writeExr(Image(8, 8), path);
    const auto square = openEnvironment(path.string());
    QVERIFY(square->notes().size() == 1 && test::contains(square->notes()[0], "8 x 8 pixels is read as a latitude"));
    io::writeExr(Image(8, 4), path);
    QVERIFY(openEnvironment(path.string())->notes().empty());
    io::writeExr(Image(8, 8), path, {{io::layoutAttribute, "equal-area octahedral"}});
    const std::string error = test::errorOf([&] { openEnvironment(path.string()); });
    QVERIFY2(test::contains(error, path.string() + ": found an environment with the layout 'equal-area octahedral'"),
             error.c_str());
  }
};

GONIO_TEST(EnvironmentTest)
}  // namespace environment_test

#include "environment_test.moc"
