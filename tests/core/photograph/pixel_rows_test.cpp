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
Photograph view(const Light& light, int side = 32, const Surface& surface = {}) {
  Photograph photograph{.name = "test", .image = {}, .disc = {}, .camera = {.yaw = 0.3, .pitch = 0.2}, .light = light};
  photograph.surface = surface;
  photograph.size = {side, side};
  photograph.disc = discOf(photograph.camera, side, side);
  return photograph;
}

/// The regions of a photograph of which all pixels are 1.
std::vector<Region> greyRegions(Photograph photograph, std::size_t most, int side = 32) {
  photograph.image = Image(side, side);
  for (glm::vec3& pixel : photograph.image.pixels) pixel = glm::vec3(1);
  return regionsOf({.photographs = {photograph}, .warnings = {}}, most);
}

/// The point of a surface that a scene's camera sees at a place of a square image.
struct Seen {
  Direction position, normal, toViewer;
};
Seen seen(const Photograph& photograph, const glm::dvec2& pixel, int side) {
  const rendering::Scene scene = sceneOf(photograph, side, side);
  const Ray ray =
      rendering::cameraRay(rendering::cameraFrame(scene.camera), 2 * pixel.x / side - 1, 1 - 2 * pixel.y / side, 1);
  if (const auto* flat = std::get_if<FlatSample>(&photograph.surface)) {
    const double depth = glm::dot(ray.origin, flat->normal) / -glm::dot(ray.direction, flat->normal);
    return {ray.origin + depth * ray.direction, flat->normal, -ray.direction};
  }
  // The cylinder is the sphere of a plane across its axis.
  const auto* cylinder = std::get_if<Cylinder>(&photograph.surface);
  const auto across = [&](const Direction& of) {
    return cylinder ? of - glm::dot(of, cylinder->axis) * cylinder->axis : of;
  };
  const Direction origin = across(ray.origin), direction = across(ray.direction);
  const double a = glm::dot(direction, direction), b = glm::dot(origin, direction), c = glm::dot(origin, origin) - 1;
  const double depth = (-b - std::sqrt(b * b - a * c)) / a;
  return {ray.origin + depth * ray.direction, origin + depth * direction, -ray.direction};
}

const Surface slantedCylinder = Cylinder{glm::normalize(Direction(0.5, 1, 0.2)), 1.6};
const Surface turnedSample = FlatSample{glm::normalize(Direction(-0.6, 0.4, 1)), 1.6, 1.2};

void addSurfaces() {
  QTest::addColumn<int>("surface");
  QTest::newRow("sphere") << 0;
  QTest::newRow("cylinder") << 1;
  QTest::newRow("flat sample") << 2;
}
Surface surfaceAt(int row) { return row == 0 ? Surface(UnitSphere{}) : row == 1 ? slantedCylinder : turnedSample; }

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
  void lambertianUnderConstantLight_data() { addSurfaces(); }
  void lambertianUnderConstantLight() {
    QFETCH(int, surface);
    const dictionary::MappedCells mapping = allCells({30, 15, 18, true});
    const Photograph photograph = view({.environment = rendering::furnaceEnvironment()}, 32, surfaceAt(surface));
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

  /// The value of the table, interpolated by TabulatedBrdf, times irradiance and cosine: of a distant and a small
  /// light.
  void tableUnderDistantLight_data() { addSurfaces(); }
  void tableUnderDistantLight() {
    QFETCH(int, surface);
    const HalfDifferenceGrid grid{45, 30, 36, true};
    const auto table = bakeTable(*test::ggx(Rgb(0.1, 0.2, 0.3), Rgb(0.8), 0.3, 0.1), grid);
    const dictionary::MappedCells mapping = allCells(grid);
    const rendering::DirectionalLight light{glm::normalize(Direction(0.5, 0.4, 0.6)), Rgb(1, 2, 3)};
    const rendering::PointLight small{{-1, 0.5, 2.5}, Rgb(20, 10, 5)};
    const Photograph photograph =
        view({.environment = nullptr, .directional = {light}, .points = {small}}, 32, surfaceAt(surface));
    const auto regions = greyRegions(photograph, 1000);
    for (const Region& region : regions) QCOMPARE(region.points.size(), std::size_t(1));
    const auto values =
        assembleRows(mapping, {.photographs = {photograph}, .warnings = {}}, regions).values(valuesOf(mapping, *table));
    int lit = 0;
    for (std::size_t row = 0; row < values.size(); ++row) {
      const Seen point = seen(photograph, regions[row].points[0].pixel, 32);
      const Direction toSmall = small.position - point.position;
      const std::pair<Direction, Rgb> lights[] = {
          {light.toLight, light.irradiance}, {glm::normalize(toSmall), small.intensity / glm::dot(toSmall, toSmall)}};
      Rgb expected(0);
      for (const auto& [toLight, irradiance] : lights) {
        const DirectionPair pair = localPair(point, toLight);
        if (!(pair.wi.z > 0)) continue;
        expected += table->evaluate(pair.wi, pair.wo) * irradiance * pair.wi.z;
        ++lit;
      }
      for (int channel = 0; channel < 3; ++channel)
        QVERIFY2(std::abs(values[row][channel] - expected[channel]) < 1e-5 * (1 + expected[channel]),
                 QByteArray::number(values[row][channel]) + " not " + QByteArray::number(expected[channel]));
    }
    QVERIFY2(lit > 100, QByteArray::number(lit));
  }

  /// Every texel of the environment by itself.
  void tableUnderEnvironment_data() { addSurfaces(); }
  void tableUnderEnvironment() {
    QFETCH(int, surface);
    const HalfDifferenceGrid grid{90, 30, 36, true};
    const auto table = bakeTable(*test::ggx(Rgb(0.1), Rgb(1), 0.15, 0.1), grid);
    const dictionary::MappedCells mapping = allCells(grid);
    const auto environment = rendering::studioEnvironment();
    const double rotation = 0.7;
    const Photograph photograph = view({.environment = environment, .rotation = rotation}, 32, surfaceAt(surface));
    auto regions = greyRegions(photograph, surface == 0 ? 12 : 6);
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
