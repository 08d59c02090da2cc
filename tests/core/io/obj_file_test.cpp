// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/mesh_file.h"

#include <QTest>
#include <cstdio>

#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace obj_file_test {
using namespace gonio;
using namespace gonio::geometry;
using namespace gonio::io;

TriangleMesh read(std::string_view text, const TaskControl& control = {}) {
  return readObj(MemorySource(std::as_bytes(std::span(text))), control).mesh;
}

std::string refusal(std::string_view text) {
  return test::errorOf([&] { read(text); });
}

/// [-1, 1]^3; vertex 1 + 4 x + 2 y + z with x, y, z 0 or 1.
const std::string cubeVertices = "v -1 -1 -1\nv -1 -1 1\nv -1 1 -1\nv -1 1 1\nv 1 -1 -1\nv 1 -1 1\nv 1 1 -1\nv 1 1 1\n";
const std::string cubeFaces = "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";

bool isCube(const TriangleMesh& mesh) {
  return mesh.triangles().size() == 12 && mesh.isClosed() && mesh.isConvex() && std::abs(mesh.volume() - 8) < 1e-12 &&
         mesh.droppedTriangles() == 0;
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

const std::filesystem::path spot = std::filesystem::path(GONIO_SHARED_DIR) / "data/meshes/spot.obj";

class ObjFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aCube() {
    QVERIFY(isCube(read(cubeVertices + cubeFaces)));
    QVERIFY(isCube(read(replaced(cubeVertices + cubeFaces, "\n", "\r\n"))));
    QVERIFY(isCube(read(replaced(cubeVertices + cubeFaces, "\n", "\r"))));
    QVERIFY(isCube(read(replaced(cubeVertices + cubeFaces, " ", " \t "))));
    QVERIFY(isCube(read(cubeFaces + cubeVertices)));  // faces first
    QVERIFY(isCube(read("\xef\xbb\xbf" + cubeVertices + cubeFaces)));
    QVERIFY(isCube(read(replaced(cubeVertices + cubeFaces, "\n", " # f 1 1 1\n# v x\n\n"))));
    QVERIFY(isCube(read(replaced(cubeVertices + cubeFaces, "f ", "f \\\n"))));
    QVERIFY(isCube(read("mtllib a b\no cube\n" + cubeVertices + "vt 0 x\ng a b\nusemtl m\ns 1\n" +
                        replaced(cubeFaces, "\nf 3", "\no two\ng\nl 1 2\np 1\nf 3") + "vp 1\ncurv 0 1")));
  }

  void facesInEveryForm() {
    std::string triangles;
    for (const char* face :
         {"1 2 4", "1 4 3", "5 7 8", "5 8 6", "1 5 6", "1 6 2", "3 4 8", "3 8 7", "1 3 7", "1 7 5", "2 6 8", "2 8 4"})
      triangles += std::string("f ") + face + "\n";
    QVERIFY(isCube(read(cubeVertices + triangles)));
    // Relative to the end: 1 is -8.
    std::string relative = cubeFaces;
    for (int i = 1; i <= 8; ++i)
      relative = replaced(relative, " " + std::to_string(i), " -" + std::to_string(9 - i) + " ");
    QVERIFY(isCube(read(cubeVertices + relative)));
    QVERIFY(isCube(read(cubeVertices + relative + "v 9 9 9\n")));  // only what stands before the face counts
    std::string withTexture = cubeFaces;
    for (int i = 1; i <= 8; ++i)
      withTexture = replaced(withTexture, " " + std::to_string(i), " " + std::to_string(i) + "/7");
    QVERIFY(isCube(read(cubeVertices + withTexture)));
  }

  void normalsAreTakenWhereGiven() {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\nvn 0 3 4\n";
    const TriangleMesh mesh = read(corners + "f 1//2 2/9/1 3//-1\n");
    QCOMPARE(mesh.cornerNormals()[0], glm::vec3(0, 0.6f, 0.8f));
    QCOMPARE(mesh.cornerNormals()[1], glm::vec3(0, 0, 1));
    QCOMPARE(mesh.cornerNormals()[2], glm::vec3(0, 0.6f, 0.8f));
    const TriangleMesh partly = read(corners + "f 1//2 2 3/1/\n");
    QCOMPARE(partly.cornerNormals()[0], glm::vec3(0, 0.6f, 0.8f));
    QCOMPARE(partly.cornerNormals()[1], glm::vec3(0, 0, 1));
    QCOMPARE(read(corners + "f 1 2 3\n").cornerNormals()[2], glm::vec3(0, 0, 1));
  }

  /// The shape does not need what is missing.
  void missingNormalsAndShortFaces() {
    for (const auto& [normals, corner] : {std::pair<std::string, std::string>{"", "//1"},
                                          {"vn 0 1 0\n", "//0"},
                                          {"vn nan nan nan\n", "//1"},
                                          {"vn 0 1 0\n", "//-2"},
                                          {"vn 0 inf 0\n", "//99999999999999999999"}}) {
      std::string faces = cubeFaces;
      for (int i = 1; i <= 8; ++i) faces = replaced(faces, " " + std::to_string(i), " " + std::to_string(i) + corner);
      const std::string text = cubeVertices + normals + faces + "f 1 2\n";
      const MeshFile file = readObj(MemorySource(std::as_bytes(std::span(text))));
      QVERIFY(isCube(file.mesh));
      QVERIFY(file.mesh.cornerNormals()[0] == read(cubeVertices + cubeFaces).cornerNormals()[0]);
      QCOMPARE(file.notes, (std::vector<std::string>{
                               "24 corners of faces have normals that are missing or not finite; they were computed",
                               "1 faces of fewer than 3 corners were left out"}));
    }
  }

  /// As in maps: single precision steps by half a metre there.
  void largeCoordinatesKeepTheShape() {
    const auto moved = [](const glm::dvec3& by) {
      std::string text;
      for (const int x : {-1, 1})
        for (const int y : {-1, 1})
          for (const int z : {-1, 1}) {
            char line[100];
            std::snprintf(line, sizeof line, "v %.3f %.3f %.3f\n", 0.01 * x + by.x, 0.01 * y + by.y, 0.01 * z + by.z);
            text += line;
          }
      text += cubeFaces;
      return readObj(MemorySource(std::as_bytes(std::span(text))));
    };
    const MeshFile near = moved({0, 0, 0}), far = moved({512345.5, 100.25, 4123456.75});
    QCOMPARE(near.origin, glm::dvec3(0));
    QVERIFY(glm::length(far.origin - glm::dvec3(512345.5, 100.25, 4123456.75)) < 1e-6);
    QVERIFY(far.mesh.isConvex() && std::abs(far.mesh.volume() - 8e-6) < 1e-11);
    for (std::size_t i = 0; i < 8; ++i)
      QVERIFY(glm::length(far.mesh.positions()[i] - near.mesh.positions()[i]) < 1e-7f);
    QVERIFY(
        test::contains(test::errorOf([&] { read("v 1e39 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"); }), "single precision"));
  }

  void polygonsAreCut() {
    // An L of six corners, and the box on it: nothing sticks out, nothing is missing.
    std::string text;
    for (const int z : {0, 1})
      for (const char* corner : {"0 0 ", "2 0 ", "2 1 ", "1 1 ", "1 2 ", "0 2 "})
        text += "v " + std::string(corner) + std::to_string(z) + "\n";
    text += "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\n";
    for (int i = 1; i <= 6; ++i) {
      const int next = i % 6 + 1;
      for (const int corner : {i, next, next + 6, i + 6}) text += (corner == i ? "f " : " ") + std::to_string(corner);
      text += "\n";
    }
    const TriangleMesh mesh = read(text);
    QVERIFY(mesh.isClosed() && !mesh.isConvex());
    QVERIFY(std::abs(mesh.volume() - 3) < 1e-12);
    QCOMPARE(mesh.triangles().size(), std::size_t(4 + 4 + 12));
  }

  void numbersInEveryForm() {
    const TriangleMesh mesh = read("v .5 -1.e1 +2\nv 1E+2 1e-60 -0 0.3\nv 3 4 5 0.1 0.2 0.3\nf 1 2 3");
    QCOMPARE(mesh.positions()[0], glm::vec3(0.5f, -10, 2));
    QCOMPARE(mesh.positions()[1], glm::vec3(100, 0, 0));
    QCOMPARE(mesh.positions()[2], glm::vec3(3, 4, 5));
  }

  void errorsTellTheLine() {
    const std::string good = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n";
    const std::pair<std::string, std::string> cases[] = {
        {good + "\nv 1 nan 0\n", "line 6: found 'nan', expected a finite number"},
        {good + "v 1 2 inf\n", "line 5: found 'inf', expected a finite"},
        {good + "v 1 2 1e39\n", "line 5: found '1e39', expected a finite number in the range"},
        {good + "v 1 2 1e999\n", "line 5: found '1e999', expected a finite number in the range"},
        {good + "v 1 2 3x\n", "line 5: found '3x', expected a number"},
        {good + "v 1 2\n", "line 5: found the end of the line, expected three numbers"},
        {good + "vn 0 zero 0\n", "line 5: found 'zero', expected a number"},
        {good + "f 1 2 4\n", "line 5: found vertex '4', but there are only 3, counted from 1"},
        {good + "f 0 1 2\n", "line 5: found vertex '0', but there are only 3"},
        {good + "f 1 2 -4\n", "line 5: found vertex '-4', but there are only 3, 3 before this line"},
        {good + "f 1 2 99999999999999999999\n", "line 5: found vertex '99999999999999999999', but there are only 3"},
        {good + "f 1 2 4294967297\n", "line 5: found vertex '4294967297', but there are only 3"},
        {good + "f 1//one 2//2 3//1\n", "line 5: found 'one', expected the index of a normal"},
        {good + "f 1 two 3\n", "line 5: found 'two', expected the index of a vertex"},
        {good + "f 1.5 2 3\n", "line 5: found '1.5', expected the index of a vertex"},
        {good + "f \\\n1 2\n", "found no faces (3 vertices)"},
        {good, "found no faces (3 vertices), expected lines such as 'f 1 2 3'"},
        {"", "found no faces (0 vertices)"},
        {"\x89PNG\r\n\x1a\n", "found no faces (0 vertices)"},
        {"Dear all,\n\nthe mesh follows.\n", "found no faces (0 vertices)"},
        {good + "f 1 1 2\n", "found only triangles with zero area (1)"}};
    for (const auto& [text, expected] : cases) {
      const std::string found = refusal(text);
      QVERIFY2(test::contains(found, expected), (found + "\n, expected " + expected).c_str());
    }
    const auto path = test::writeFile("bad.obj", std::as_bytes(std::span(std::string_view("v 1\n"))));
    QVERIFY(test::errorOf([&] { readObj(path); }).starts_with(path.string() + ": line 1: found the end"));
  }

  void tooLargeAFileIsRefusedUnread() {
    struct Huge : ByteSource {
      std::uint64_t size() const override { return (std::uint64_t(1) << 31) + 1; }
      void readAt(std::uint64_t, std::span<std::byte>) const override { throw std::logic_error("it was read"); }
    };
    QVERIFY(
        test::contains(test::errorOf([] { readObj(Huge()); }), "found 2147483649 bytes, expected at most 2147483648"));
  }

  void readingCanBeStopped() {
    std::string text = cubeVertices;
    for (int i = 0; i < 30000; ++i) text += "f 1 2 3\n";
    std::stop_source stop;
    double last = 0;
    bool rose = true;
    const TaskControl control{stop.get_token(), [&](double fraction) {
                                rose = rose && fraction >= last && fraction <= 1;
                                last = fraction;
                                if (fraction > 0.3) stop.request_stop();
                              }};
    QVERIFY_THROWS_EXCEPTION(Cancelled, read(text, control));
    QVERIFY(rose && last > 0.3);
  }

  void spotIsWhole() {
    if (!std::filesystem::exists(spot)) QSKIP("the shared data are not at hand");
    const TriangleMesh mesh = readObj(spot).mesh;
    QCOMPARE(mesh.triangles().size(), std::size_t(5856));
    QCOMPARE(mesh.positions().size(), std::size_t(2930));
    QCOMPARE(mesh.droppedTriangles(), std::size_t(0));
    QVERIFY(mesh.isClosed() && !mesh.isConvex() && mesh.volume() > 0);
  }
};

GONIO_TEST(ObjFileTest)
}  // namespace obj_file_test

#include "obj_file_test.moc"
