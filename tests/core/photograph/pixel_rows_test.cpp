// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/photograph/pixel_rows.h"

#include <QTest>

#include "core/brdf/data_transform.h"
#include "core/support/error.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace pixel_rows_test {
using namespace gonio;
using namespace gonio::photograph;

/// All cells of a grid with both directions above the horizon.
dictionary::MappedCells allCells(const HalfDifferenceGrid& grid) {
  dictionary::MappedCells mapping{.grid = grid, .cells = {}, .weights = {}, .reference = {}};
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (grid.nodeAboveHorizon(i)) mapping.cells.push_back(std::uint32_t(i));
  return mapping;
}

std::vector<glm::vec3> valuesOf(const dictionary::MappedCells& mapping, const TabulatedBrdf& table) {
  std::vector<glm::vec3> values;
  for (const std::uint32_t cell : mapping.cells) values.push_back(table.values()[cell]);
  return values;
}

/// A photograph without pixels.
Photograph view(const Light& light, int side = 32) {
  Photograph photograph{.name = "test", .image = {}, .disc = {}, .camera = {.yaw = 0.3, .pitch = 0.2}, .light = light};
  photograph.disc = discOf(photograph.camera, side, side);
  return photograph;
}

/// The regions of a photograph of which all pixels are 1.
std::vector<Region> greyRegions(Photograph photograph, std::size_t most, int side = 32) {
  photograph.image = Image(side, side);
  for (glm::vec3& pixel : photograph.image.pixels) pixel = glm::vec3(1);
  return regionsOf({.photographs = {photograph}, .warnings = {}}, most);
}

/// The point of the unit sphere that a scene's camera sees at a place of a square image, as the renderer finds it.
struct Seen {
  Direction normal, toViewer;
};
Seen seen(const Photograph& photograph, const glm::dvec2& pixel, int side) {
  const rendering::Scene scene = sceneOf(photograph, side, side);
  const Ray ray =
      rendering::cameraRay(rendering::cameraFrame(scene.camera), 2 * pixel.x / side - 1, 1 - 2 * pixel.y / side, 1);
  const double along = glm::dot(ray.origin, ray.direction);
  const double depth = -along - std::sqrt(along * along - glm::dot(ray.origin, ray.origin) + 1);
  return {ray.origin + depth * ray.direction, -ray.direction};
}

/// Directions in a frame of which z is the normal.
DirectionPair localPair(const Seen& seen, const Direction& toLight) {
  const Direction x = glm::normalize(glm::cross(seen.normal, Direction(0.3, 0.5, 0.7))), y = glm::cross(seen.normal, x);
  const auto local = [&](const Direction& w) {
    return Direction(glm::dot(w, x), glm::dot(w, y), glm::dot(w, seen.normal));
  };
  return {local(toLight), local(seen.toViewer)};
}

class PixelRowsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Closed form: the radiance is albedo times that of the light.
  void lambertianUnderConstantLight() {
    const dictionary::MappedCells mapping = allCells({30, 15, 18, true});
    const Photograph photograph = view({.environment = rendering::furnaceEnvironment()});
    const PhotographSet set{.photographs = {photograph}, .warnings = {}};
    const auto regions = greyRegions(photograph, 60);
    const PixelRows rows = assembleRows(mapping, set, regions);
    const auto values = rows.values(std::vector<glm::vec3>(mapping.cells.size(), glm::vec3(0.2, 0.5, 0.8) / float(pi)));
    QCOMPARE(values.size(), regions.size());
    for (std::size_t row = 0; row < values.size(); ++row) {
      const double lost = rows.lost[row];
      QVERIFY2(std::abs(values[row].y - 0.5 * (1 - lost)) < 0.005, QByteArray::number(values[row].y));
      QVERIFY2(std::abs(values[row].x / values[row].z - 0.25) < 1e-5, QByteArray::number(values[row].x));
    }
  }

  /// The value of the table, interpolated by TabulatedBrdf, times irradiance and cosine.
  void tableUnderDistantLight() {
    const HalfDifferenceGrid grid{45, 30, 36, true};
    const auto table = bakeTable(*test::ggx(Rgb(0.1, 0.2, 0.3), Rgb(0.8), 0.3, 0.1), grid);
    const dictionary::MappedCells mapping = allCells(grid);
    const rendering::DirectionalLight light{glm::normalize(Direction(0.5, 0.4, 0.6)), Rgb(1, 2, 3)};
    const Photograph photograph = view({.environment = nullptr, .directional = {light}, .points = {}});
    const auto regions = greyRegions(photograph, 1000);
    for (const Region& region : regions) QCOMPARE(region.points.size(), std::size_t(1));
    const auto values =
        assembleRows(mapping, {.photographs = {photograph}, .warnings = {}}, regions).values(valuesOf(mapping, *table));
    int lit = 0;
    for (std::size_t row = 0; row < values.size(); ++row) {
      const DirectionPair pair = localPair(seen(photograph, regions[row].points[0].pixel, 32), light.toLight);
      const Rgb expected = pair.wi.z > 0 ? table->evaluate(pair.wi, pair.wo) * light.irradiance * pair.wi.z : Rgb(0);
      lit += pair.wi.z > 0;
      for (int channel = 0; channel < 3; ++channel)
        QVERIFY2(std::abs(values[row][channel] - expected[channel]) < 1e-5 * (1 + expected[channel]),
                 QByteArray::number(values[row][channel]) + " not " + QByteArray::number(expected[channel]));
    }
    QVERIFY(lit > 100);
  }

  /// Every texel of the environment by itself.
  void tableUnderEnvironment() {
    const HalfDifferenceGrid grid{90, 30, 36, true};
    const auto table = bakeTable(*test::ggx(Rgb(0.1), Rgb(1), 0.15, 0.1), grid);
    const dictionary::MappedCells mapping = allCells(grid);
    const auto environment = rendering::studioEnvironment();
    const double rotation = 0.7;
    const Photograph photograph = view({.environment = environment, .rotation = rotation});
    auto regions = greyRegions(photograph, 12);
    for (Region& region : regions) region.points = {{region.centre, 1}};
    const auto values =
        assembleRows(mapping, {.photographs = {photograph}, .warnings = {}}, regions).values(valuesOf(mapping, *table));
    const Image& image = environment->image();
    const rendering::EnvironmentRotation turn(rotation);
    for (std::size_t row = 0; row < values.size(); ++row) {
      const Seen point = seen(photograph, regions[row].points[0].pixel, 32);
      std::vector<DirectionPair> pairs;
      std::vector<Rgb> light;
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
          const Direction direction = turn.fromEnvironment(
              rendering::EnvironmentMap::directionAt((x + 0.5) / image.width, (y + 0.5) / image.height));
          const double solidAngle =
              2 * pi / image.width * (std::cos(pi * y / image.height) - std::cos(pi * (y + 1) / image.height));
          pairs.push_back(localPair(point, direction));
          if (!(pairs.back().wi.z > 0)) {
            pairs.pop_back();
            continue;
          }
          light.push_back(Rgb(image.at(x, y)) * (solidAngle * pairs.back().wi.z));
        }
      std::vector<Rgb> brdf(pairs.size());
      table->evaluate(pairs, brdf);
      Rgb expected(0);
      for (std::size_t i = 0; i < pairs.size(); ++i) expected += brdf[i] * light[i];
      for (int channel = 0; channel < 3; ++channel)
        QVERIFY2(std::abs(values[row][channel] / expected[channel] - 1) < 0.02,
                 QByteArray::number(values[row][channel]) + " not " + QByteArray::number(expected[channel]));
    }
  }

  /// From far away a small light is a distant one.
  void smallLightFallsOff() {
    const dictionary::MappedCells mapping = allCells({30, 15, 18, true});
    const std::vector<glm::vec3> grey(mapping.cells.size(), glm::vec3(0.1f));
    const Direction toLight = glm::normalize(Direction(1, 1, 3));
    const auto valuesUnder = [&](const Light& light) {
      const Photograph photograph = view(light);
      const auto regions = greyRegions(photograph, 60);
      return assembleRows(mapping, {.photographs = {photograph}, .warnings = {}}, regions).values(grey);
    };
    const auto small = valuesUnder({.environment = nullptr, .directional = {}, .points = {{1e4 * toLight, Rgb(3e8)}}});
    const auto distant = valuesUnder({.environment = nullptr, .directional = {{toLight, Rgb(3)}}, .points = {}});
    for (std::size_t row = 0; row < small.size(); ++row)
      QVERIFY(std::abs(small[row].x - distant[row].x) < 1e-3 * (0.01 + distant[row].x));
  }

  void regionsLeaveOutWhatIsUnusable() {
    PhotographSet set{.photographs = {view({.environment = rendering::furnaceEnvironment()}, 64)}, .warnings = {}};
    Photograph& photograph = set.photographs[0];
    photograph.image = Image(64, 64);
    for (glm::vec3& pixel : photograph.image.pixels) pixel = glm::vec3(1, 2, 3);
    const std::size_t all = regionsOf(set, 4000).size();
    photograph.image.at(32, 32).y = std::numeric_limits<float>::quiet_NaN();
    photograph.image.at(20, 30).x = 9;
    photograph.clip = 8;
    const auto regions = regionsOf(set, 4000);
    QCOMPARE(regions.size(), all - 2);
    QCOMPARE(regions[0].value, Rgb(1, 2, 3));
    QCOMPARE(regions[0].variance, Rgb(0));
    QVERIFY(regionsOf(set, 100).size() <= 100);
    for (glm::vec3& pixel : photograph.image.pixels) pixel = glm::vec3(0);
    QVERIFY_THROWS_EXCEPTION(Error, regionsOf(set, 100));
  }
};

GONIO_TEST(PixelRowsTest)

}  // namespace pixel_rows_test

#include "pixel_rows_test.moc"
