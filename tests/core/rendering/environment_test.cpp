// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/environment.h"

#include <QTest>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "core/io/image_io.h"
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

  /// Midpoint rule with a whole number of points per pixel: exact for a density that is constant over pixels, but for
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
    for (std::size_t y = 0; y < 8; ++y)
      for (std::size_t x = 0; x < 16; ++x) {
        const double solidAngle = 2 * pi / 16 * (std::cos(pi * double(y) / 8) - std::cos(pi * double(y + 1) / 8));
        const Direction centre = EnvironmentMap::directionAt((double(x) + 0.5) / 16, (double(y) + 0.5) / 8);
        QVERIFY(std::abs(counts[y * 16 + x] - map.pdf(centre) * solidAngle) < 2e-3);
      }
  }

  void endsOfTheUnitIntervalAreSafe() {
    const EnvironmentMap map = spottedMap();
    for (const double u : {0.0, 0x1p-53, 0.5, 1 - 0x1p-32, 1 - 0x1p-53})
      for (const double v : {0.0, 0x1p-53, 0.5, 1 - 0x1p-32, 1 - 0x1p-53}) {
        const auto s = map.sample(u, v);
        QVERIFY(s.pdf > 0 && std::isfinite(s.pdf) && std::abs(glm::length(s.direction) - 1) < 1e-12);
      }
  }

  /// The cumulative tables are float: the smallest rows, at the poles, hold 2e-5 of the whole and 6e-8 of rounding.
  void furnaceIsUniform() {
    std::mt19937_64 random(2);
    for (int n = 0; n < 1000; ++n) {
      const auto at = furnaceEnvironment()->at(randomDirection(random));
      QCOMPARE(at.radiance, Rgb(1));
      QVERIFY(std::abs(at.pdf * 4 * pi - 1) < 5e-3);
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
      double sum = 0;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          sum += map.pdf(EnvironmentMap::directionAt((x + 0.5) / width, (y + 0.5) / height)) * 2 * pi / width *
                 (std::cos(pi * y / height) - std::cos(pi * (y + 1) / height));
      QVERIFY(std::abs(sum - 1) < 1e-6);
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

  /// Maps above 8192 pixels wide are sampled by blocks of 2 x 2 pixels, the last ones cut off by the edges: the means
  /// of the density that each pixel would have alone.
  void wideMapsAreSampledByBlocks() {
    constexpr int width = 8195, height = 5, side = 2;
    Image image(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) image.at(x, y) = glm::vec3(float(1 + x % 3 + 5 * (x / 1000) + 3 * y));
    const EnvironmentMap map(image, "wide");
    const auto angle = [](int y) {
      return 2 * pi / width * (std::cos(pi * y / height) - std::cos(pi * (y + 1) / height));
    };
    // Mean of the bilinear radiance: neighbours reach an eighth into a pixel.
    const auto row = [&](int x, int y) {
      const auto at = [&](int column) {
        return double(image.at((column + width) % width, std::clamp(y, 0, height - 1)).x);
      };
      return 0.125 * at(x - 1) + 0.75 * at(x) + 0.125 * at(x + 1);
    };
    const auto light = [&](int x, int y) {
      return (0.125 * row(x, y - 1) + 0.75 * row(x, y) + 0.125 * row(x, y + 1)) * angle(y);
    };
    double total = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) total += light(x, y);
    for (int top = 0; top < height; top += side)
      for (const int left : {0, 2, 998, 4096, 8192, 8194}) {
        const int right = std::min(left + side, width), bottom = std::min(top + side, height);
        double power = 0, solidAngle = 0;
        for (int y = top; y < bottom; ++y)
          for (int x = left; x < right; ++x) {
            power += light(x, y);
            solidAngle += angle(y);
          }
        for (int y = top; y < bottom; ++y)
          for (int x = left; x < right; ++x) {
            const double pdf = map.pdf(EnvironmentMap::directionAt((x + 0.5) / width, (y + 0.5) / height));
            // The cumulative tables are float, and a block holds 1e-4 of a row.
            QVERIFY(std::abs(pdf / (power / total / solidAngle) - 1) < 2e-3);
          }
      }
    std::array<int, 3> rows{};
    double radiance = 0;
    constexpr int samples = 40000;
    for (int i = 0; i < samples; ++i) {
      const auto s = map.sample((i + 0.5) / samples, std::fmod(i * 0.6180339887498949, 1.0));
      QVERIFY(std::abs(map.pdf(s.direction) / s.pdf - 1) < 1e-6);
      radiance += s.radiance.x / s.pdf / samples;
      ++rows[std::size_t(EnvironmentMap::positionOf(s.direction).y * height) / side];
    }
    QVERIFY(std::ranges::all_of(rows, [](int count) { return count > 0; }));
    QVERIFY(std::abs(radiance / total - 1) < 2e-3);
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
