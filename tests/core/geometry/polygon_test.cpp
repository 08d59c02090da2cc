// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/geometry/polygon.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/geometry/triangle_mesh.h"
#include "tests/support/test_program.h"

namespace polygon_test {
using namespace gonio;
using namespace gonio::geometry;

using Points = std::vector<glm::vec3>;

double signedArea(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const Direction& normal) {
  return glm::dot(glm::cross(Direction(b) - Direction(a), Direction(c) - Direction(a)), normal) / 2;
}

double signedArea(const Points& polygon, const Direction& normal) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += signedArea(polygon[0], polygon[i], polygon[i + 1], normal);
  return sum;
}

/// n - 2 triangles, each with a positive area, that together have the polygon's: then none overlaps another.
bool isCutCleanly(const Points& polygon, const Direction& normal) {
  const std::vector<TriangleIndices> triangles = triangulatePolygon(polygon);
  double sum = 0;
  for (const TriangleIndices& t : triangles) {
    const double area = signedArea(polygon[t[0]], polygon[t[1]], polygon[t[2]], normal);
    if (!(area > 0)) return false;
    sum += area;
  }
  return triangles.size() == polygon.size() - 2 && std::abs(sum / signedArea(polygon, normal) - 1) < 1e-6;
}

/// A star-shaped polygon about (0, 0): simple, far from convex.
Points star(int corners, std::mt19937_64& random) {
  std::uniform_real_distribution<float> uniform(0.1f, 1);
  Points result;
  for (int i = 0; i < corners; ++i) {
    const float angle = float(2 * pi * i / corners), radius = uniform(random);
    result.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  return result;
}

class PolygonTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void simplePolygonsAreCutCleanly() {
    const Direction up(0, 0, 1);
    QVERIFY(isCutCleanly({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, up));
    QVERIFY(
        isCutCleanly({{0, 0, 0}, {2, 0, 0}, {0.5f, 0.5f, 0}, {0, 2, 0}}, up));  // a dart: only one diagonal is inside
    QVERIFY(isCutCleanly({{2, 0, 0}, {0.5f, 0.5f, 0}, {0, 2, 0}, {0, 0, 0}}, up));
    // Two combs, whose teeth hide most diagonals.
    Points comb{{10, -1, 0}};
    for (int i = 10; i >= 0; --i) comb.emplace_back(i, i % 2 ? 5.0f : 0.2f, 0);
    comb.emplace_back(0, -1, 0);
    QVERIFY(isCutCleanly(comb, up));
    std::mt19937_64 random(1);
    for (int n = 5; n < 200; n += 3) QVERIFY(isCutCleanly(star(n, random), up));
  }

  /// Whatever plane the polygon lies in, however large it is and however far away.
  void placeAndSizeDoNotMatter() {
    std::mt19937_64 random(2);
    const glm::dmat3 turns[] = {glm::dmat3(1), glm::dmat3(0, 1, 0, 0, 0, 1, 1, 0, 0),
                                glm::dmat3(0, 0, 1, 1, 0, 0, 0, 1, 0), glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, -1),
                                glm::dmat3(0.6, 0, 0.8, 0, 1, 0, -0.8, 0, 0.6)};
    for (const double size : {1e-6, 1.0, 1e6})
      for (const glm::dmat3& turn : turns) {
        Points polygon = star(40, random);
        for (glm::vec3& p : polygon) p = glm::vec3(turn * (Direction(p) + Direction(50, -30, 20)) * size);
        QVERIFY(isCutCleanly(polygon, turn[2]));
      }
  }

  void cornersInLineGetTrianglesWithAnArea() {
    // A square with points on all its edges, from every start.
    Points square;
    for (int i = 0; i < 4; ++i) square.emplace_back(i, 0, 0);
    for (int i = 0; i < 4; ++i) square.emplace_back(4, i, 0);
    for (int i = 0; i < 4; ++i) square.emplace_back(4 - i, 4, 0);
    for (int i = 0; i < 4; ++i) square.emplace_back(0, 4 - i, 0);
    for (std::size_t start = 0; start < square.size(); ++start) {
      std::rotate(square.begin(), square.begin() + 1, square.end());
      QVERIFY(isCutCleanly(square, {0, 0, 1}));
    }
  }

  void aConvexQuadrangleIsCutAlongItsShorterDiagonal() {
    QCOMPARE(triangulatePolygon(Points{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {-2, 1, 0}})[0], TriangleIndices(0, 1, 2));
    QCOMPARE(triangulatePolygon(Points{{2, 1, 0}, {0, 2, 0}, {-2, 1, 0}, {0, 0, 0}})[0], TriangleIndices(0, 1, 3));
  }

  /// Crossing, folded and pointlike ones: n - 2 triangles all the same.
  void badPolygonsAreCutSomehow() {
    for (const Points& polygon : {Points(7, glm::vec3(1)), Points{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
                                  Points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5f, 0, 0}}}) {
      const std::vector<TriangleIndices> triangles = triangulatePolygon(polygon);
      QCOMPARE(triangles.size(), polygon.size() - 2);
      for (const TriangleIndices& t : triangles)
        for (int i = 0; i < 3; ++i) QVERIFY(t[i] < polygon.size() && t[i] != t[(i + 1) % 3]);
    }
  }
};

GONIO_TEST(PolygonTest)
}  // namespace polygon_test

#include "polygon_test.moc"
