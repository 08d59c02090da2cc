// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/geometry/triangle_mesh.h"

#include <QTest>
#include <limits>

#include "core/support/error.h"
#include "tests/support/simple_meshes.h"
#include "tests/support/test_program.h"

namespace triangle_mesh_test {
using namespace gonio;
using namespace gonio::geometry;
using namespace gonio::test;

std::string refusal(const MeshArrays& arrays) {
  try {
    TriangleMesh{arrays};
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// Every triangle with vertices of its own.
MeshArrays split(const MeshArrays& arrays) {
  MeshArrays result;
  for (const TriangleIndices& t : arrays.triangles) {
    const auto first = std::uint32_t(result.positions.size());
    for (int i = 0; i < 3; ++i) result.positions.push_back(arrays.positions[t[i]]);
    result.triangles.emplace_back(first, first + 1, first + 2);
  }
  return result;
}

MeshArrays turned(MeshArrays arrays) {
  for (TriangleIndices& t : arrays.triangles) std::swap(t[1], t[2]);
  return arrays;
}

MeshArrays joined(MeshArrays a, const TriangleMesh& b) {
  const auto first = std::uint32_t(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions().begin(), b.positions().end());
  for (const TriangleIndices& t : b.triangles()) a.triangles.push_back(t + first);
  return a;
}

/// `count` x `count` quadrangles in the plane y = 0, facing +y.
MeshArrays grid(int count) {
  MeshArrays arrays;
  for (int z = 0; z <= count; ++z)
    for (int x = 0; x <= count; ++x) arrays.positions.emplace_back(float(x) / float(count), 0, float(z) / float(count));
  for (int z = 0; z < count; ++z)
    for (int x = 0; x < count; ++x) {
      const auto a = std::uint32_t(z * (count + 1) + x), below = a + std::uint32_t(count) + 1;
      arrays.triangles.emplace_back(a, below, below + 1);
      arrays.triangles.emplace_back(a, below + 1, a + 1);
    }
  return arrays;
}

double maxNormalError(const TriangleMesh& mesh, const std::function<Direction(const Direction&)>& expected) {
  double worst = 0;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i)
    for (int corner = 0; corner < 3; ++corner) {
      const Direction normal(mesh.cornerNormals()[3 * i + std::size_t(corner)]);
      worst = std::max(worst, glm::length(normal - expected(Direction(mesh.positions()[mesh.triangles()[i][corner]]))));
    }
  return worst;
}

class TriangleMeshTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aCubeIsSharp() {
    const TriangleMesh mesh(cubeArrays());
    for (std::size_t i = 0; i < 12; ++i)
      for (std::size_t corner = 0; corner < 3; ++corner)
        QVERIFY(glm::length(Direction(mesh.cornerNormals()[3 * i + corner]) - mesh.geometricNormal(i)) < 1e-7);
    QVERIFY(mesh.isClosed() && mesh.isConvex() && !mesh.isPlanar());
    QCOMPARE(mesh.volume(), 8.0);
    QCOMPARE(mesh.bounds().min, glm::dvec3(-1));
    QCOMPARE(mesh.bounds().max, glm::dvec3(1));
    QCOMPARE(mesh.boundingSphere().radius, std::sqrt(3.0));
  }

  /// Weighted by angle, a mean over a place does not see how its faces are cut into triangles: on a sphere of
  /// quadrangles it is radial but for what one quadrangle's asymmetry leaves.
  void aSphereIsSmooth() {
    const TriangleMesh mesh = sphereMesh(2, 40, 80);
    QVERIFY(maxNormalError(mesh, [](const Direction& p) { return glm::normalize(p); }) < 5e-3);
  }

  void splitVerticesAreWelded() {
    MeshArrays arrays;
    const TriangleMesh sphere = sphereMesh(1, 20, 40);
    arrays.positions.assign(sphere.positions().begin(), sphere.positions().end());
    arrays.triangles.assign(sphere.triangles().begin(), sphere.triangles().end());
    const TriangleMesh mesh(split(arrays));
    QCOMPARE(mesh.positions().size(), 3 * mesh.triangles().size());
    QVERIFY(mesh.isClosed() && mesh.isConvex());
    QVERIFY(std::equal(mesh.cornerNormals().begin(), mesh.cornerNormals().end(), sphere.cornerNormals().begin()));
    // 0 and -0 are one place.
    MeshArrays cube = split(cubeArrays());
    for (glm::vec3& p : cube.positions) p += glm::vec3(1);
    for (std::size_t i = 0; i < 12; ++i)
      for (int axis = 0; axis < 3; ++axis)
        if (cube.positions[i][axis] == 0) cube.positions[i][axis] = -0.0f;
    QVERIFY(TriangleMesh(cube).isClosed());
  }

  /// Two faces in a fold: below the crease angle their edge is smooth, beyond it is sharp.
  void foldsAreCreasedBeyondTheCreaseAngle() {
    for (const double fold : {0.0, 10.0, 39.0, 41.0, 120.0}) {
      const double a = radians(fold);
      const MeshArrays arrays{.positions = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {std::cos(a), 0, -std::sin(a)}},
                              .triangles = {{0, 1, 2}, {0, 3, 1}}};
      const TriangleMesh mesh(arrays);
      const double between = std::acos(std::min(1.0, glm::dot(mesh.geometricNormal(0), mesh.geometricNormal(1))));
      QVERIFY(std::abs(between - a) < 1e-6);
      const double turn = glm::length(Direction(mesh.cornerNormals()[0]) - mesh.geometricNormal(0));
      QVERIFY(std::abs(turn - (fold < 40 ? 2 * std::sin(a / 4) : 0)) < 1e-6);
      QVERIFY(glm::length(Direction(mesh.cornerNormals()[2]) - mesh.geometricNormal(0)) < 1e-7);
    }
  }

  void givenNormalsAreKeptAndMissingOnesMade() {
    MeshArrays arrays = grid(1);
    arrays.normals.assign(6, glm::vec3(0, 3, 4));
    arrays.normals[1] = glm::vec3(0);
    arrays.normals[4] = glm::vec3(std::numeric_limits<float>::quiet_NaN(), 0, 1);
    arrays.normals[5] = glm::vec3(0, 3e30f, 4e30f);
    const TriangleMesh mesh(arrays);
    for (const std::size_t given : {0, 2, 3, 5})
      QVERIFY(glm::length(mesh.cornerNormals()[given] - glm::vec3(0, 0.6f, 0.8f)) < 1e-6f);
    for (const std::size_t made : {1, 4}) QCOMPARE(mesh.cornerNormals()[made], glm::vec3(0, 1, 0));
  }

  void theOutsideIsWhereNormalsPoint() {
    MeshArrays arrays = turned(grid(2));
    QCOMPARE(TriangleMesh(arrays).geometricNormal(0), Direction(0, -1, 0));
    arrays.normals.assign(3 * arrays.triangles.size(), glm::vec3(0, 1, 0));
    QCOMPARE(TriangleMesh(arrays).geometricNormal(0), Direction(0, 1, 0));
    QVERIFY(TriangleMesh(turned(cubeArrays())).isConvex());  // a closed mesh without normals is turned outward
    MeshArrays room = turned(cubeArrays());
    for (const TriangleIndices& t : room.triangles)
      for (int i = 0; i < 3; ++i) room.normals.push_back(-room.positions[t[i]]);
    const TriangleMesh inward(room);
    QVERIFY(inward.isClosed() && !inward.isConvex() && inward.volume() < 0);
  }

  void degenerateTrianglesAreDropped() {
    MeshArrays arrays = cubeArrays();
    arrays.positions.emplace_back(0, -1, -1);         // on an edge of the cube
    arrays.positions.push_back(arrays.positions[5]);  // a second vertex at one place
    arrays.positions.emplace_back(100, 100, 100);     // used by nothing
    arrays.triangles.emplace_back(0, 1, 8);
    arrays.triangles.emplace_back(3, 3, 7);
    arrays.triangles.emplace_back(5, 9, 2);
    arrays.triangles.emplace_back(10, 10, 10);
    const TriangleMesh mesh(arrays);
    QCOMPARE(mesh.droppedTriangles(), std::size_t(4));
    QCOMPARE(mesh.triangles().size(), std::size_t(12));
    QCOMPARE(mesh.positions().size(), std::size_t(8));
    QVERIFY(mesh.isClosed() && mesh.isConvex());
    QCOMPARE(mesh.bounds().max, glm::dvec3(1));
  }

  /// Scale has no part in what counts as degenerate.
  void tinyAndHugeMeshesAreWhole() {
    for (const float scale : {1e-35f, 1e-15f, 1e15f, 1e35f}) {
      MeshArrays arrays = cubeArrays();
      for (glm::vec3& p : arrays.positions) p *= scale;
      const TriangleMesh mesh(arrays);
      QCOMPARE(mesh.droppedTriangles(), std::size_t(0));
      QVERIFY(mesh.isConvex());
    }
  }

  void badArraysAreRefused() {
    MeshArrays arrays = cubeArrays();
    arrays.positions[5].y = std::numeric_limits<float>::quiet_NaN();
    QCOMPARE(refusal(arrays), "mesh: vertex 5 is at (1, nan, 1), expected finite numbers");
    arrays = cubeArrays();
    arrays.triangles[7][2] = 8;
    QCOMPARE(refusal(arrays), "mesh: triangle 7 refers to vertex 8, but there are only 8, counted from 0");
    arrays = cubeArrays();
    arrays.normals.resize(12);
    QCOMPARE(refusal(arrays), "mesh: found 12 normals, expected three for each of 12 triangles");
    QCOMPARE(refusal({}), "mesh: found no triangles, expected at least one");
    arrays = cubeArrays();
    for (glm::vec3& p : arrays.positions) p.x = p.y;
    for (glm::vec3& p : arrays.positions) p.z = 0;
    QCOMPARE(refusal(arrays),
             "mesh: found only triangles with zero area (12), expected at least one with a positive area");
  }

  void gapsAreNotClosed() {
    MeshArrays arrays = cubeArrays();
    arrays.triangles.pop_back();
    QVERIFY(!TriangleMesh(arrays).isClosed() && !TriangleMesh(arrays).isConvex());
    arrays = cubeArrays();
    std::swap(arrays.triangles[4][0], arrays.triangles[4][1]);  // one triangle is wound the other way
    QVERIFY(!TriangleMesh(arrays).isClosed());
    arrays = cubeArrays();
    arrays.triangles.push_back(arrays.triangles[0]);  // three triangles at an edge
    arrays.triangles.emplace_back(arrays.triangles[0][0], arrays.triangles[0][2], arrays.triangles[0][1]);
    QVERIFY(!TriangleMesh(arrays).isClosed());
  }

  void convexOrNot() {
    QVERIFY(sphereMesh(3, 30, 60).isConvex());
    QVERIFY(!torusMesh().isConvex());
    QVERIFY(!shaderBallMesh().isConvex());
    // Two convex parts: all edges are convex, the whole is not.
    const TriangleMesh apart = transformed(TriangleMesh(cubeArrays()), placement(1, 0, {4, 0, 0}));
    const TriangleMesh two(joined(cubeArrays(), apart));
    QVERIFY(two.isClosed() && !two.isConvex());
    // One dent: a vertex of the sphere is pushed in.
    const TriangleMesh sphere = sphereMesh(1, 20, 40);
    MeshArrays dented{.positions = {sphere.positions().begin(), sphere.positions().end()},
                      .triangles = {sphere.triangles().begin(), sphere.triangles().end()}};
    dented.positions[200] *= 0.97f;
    QVERIFY(TriangleMesh(dented).isClosed() && !TriangleMesh(dented).isConvex());
    QVERIFY(!sphereMesh(1, 200, 400).isConvex());  // too large to be proven: 79602 vertices x 159200 triangles
  }

  void planarOrNot() {
    const TriangleMesh flat(grid(5));
    QVERIFY(flat.isPlanar() && !flat.isClosed() && !flat.isConvex());
    QVERIFY(transformed(flat, placement(7, 0.3, {1, 2, 3}) * glm::dmat4(glm::dmat3(0.6, 0.8, 0, -0.8, 0.6, 0, 0, 0, 1)))
                .isPlanar());
    MeshArrays folded = grid(5);
    folded.positions[14].y = 1e-3f;
    QVERIFY(!TriangleMesh(folded).isPlanar());
    MeshArrays oneBack = grid(5);
    std::swap(oneBack.triangles[7][0], oneBack.triangles[7][1]);
    QVERIFY(!TriangleMesh(oneBack).isPlanar());
    MeshArrays twoSided = grid(5);
    for (const TriangleIndices& t : grid(5).triangles) twoSided.triangles.emplace_back(t[0], t[2], t[1]);
    QVERIFY(!TriangleMesh(twoSided).isPlanar());
  }

  void supportIsTheFarthestVertex() {
    const TriangleMesh cube(cubeArrays());
    std::mt19937_64 random(1);
    for (int n = 0; n < 100; ++n) {
      const Direction d = randomDirection(random);
      QCOMPARE(cube.support(d), std::abs(d.x) + std::abs(d.y) + std::abs(d.z));
    }
  }

  /// An ellipsoid's normals are the gradients of its equation.
  void placesKeepShapeAndNormals() {
    const glm::dvec3 axes(1, 2, 0.5), centre(3, -1, 2);
    glm::dmat4 matrix = glm::dmat4(glm::dmat3(axes.x, 0, 0, 0, axes.y, 0, 0, 0, axes.z));
    matrix[3] = glm::dvec4(centre, 1);
    const TriangleMesh sphere = sphereMesh(1, 60, 120);
    const auto gradient = [&](const Direction& p) { return glm::normalize((p - centre) / (axes * axes)); };
    const TriangleMesh ellipsoid = transformed(sphere, matrix);
    QVERIFY(maxNormalError(ellipsoid, gradient) < 5e-3);
    QVERIFY(ellipsoid.isConvex() && std::abs(ellipsoid.volume() / sphere.volume() - 1) < 1e-6);
    QVERIFY(glm::length(ellipsoid.boundingSphere().centre - centre) < 1e-5);
    matrix[0] *= -1.0;
    const TriangleMesh mirrored = transformed(sphere, matrix);
    QVERIFY(maxNormalError(mirrored, gradient) < 5e-3);
    QVERIFY(mirrored.volume() > 0);
    QVERIFY(glm::length(glm::dvec3(placement(2, halfPi, {5, 6, 7}) * glm::dvec4(0, 0, 1, 1)) - glm::dvec3(7, 6, 7)) <
            1e-12);
  }

  void badPlacesAreRefused() {
    const TriangleMesh cube(cubeArrays());
    QVERIFY_THROWS_EXCEPTION(Error, transformed(cube, placement(0, 0, {0, 0, 0})));
    QVERIFY_THROWS_EXCEPTION(Error, transformed(cube, placement(1e39, 0, {0, 0, 0})));
    QVERIFY_THROWS_EXCEPTION(Error, transformed(cube, placement(1, 0, {std::nan(""), 0, 0})));
    QVERIFY_THROWS_EXCEPTION(Error, transformed(cube, placement(1e-60, 0, {0, 0, 0})));
    // Far from the origin single precision makes one plane of two.
    QVERIFY_THROWS_EXCEPTION(Error, transformed(cube, placement(1e-3, 0, {1e6, 1e6, 1e6})));
  }
};

GONIO_TEST(TriangleMeshTest)
}  // namespace triangle_mesh_test

#include "triangle_mesh_test.moc"
