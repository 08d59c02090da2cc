// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/mesh_file.h"

#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cstring>
#include <fstream>
#include <sstream>

#include "tests/core/io/test_files.h"
#include "tests/fuzz/reader_seeds.h"
#include "tests/support/test_program.h"

namespace mesh_file_test {
using namespace gonio;
using namespace gonio::geometry;
using namespace gonio::io;

std::string textOf(const fuzz::Bytes& bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  const std::size_t at = text.find(what);
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

TriangleMesh read(const std::string& content, const std::string& suffix) {
  const MemorySource source(std::as_bytes(std::span(content)));
  return (suffix == ".ply" ? readPly(source) : readGltf(source)).mesh;
}

/// The text of the cube as binary in a byte order.
std::string binaryCube(bool bigEndian) {
  const std::string text = textOf(fuzz::plySeed());
  const std::size_t end = text.find("end_header\n") + 11;
  std::string result = replaced(text.substr(0, end), "ascii", bigEndian ? "binary_big_endian" : "binary_little_endian");
  std::istringstream numbers(text.substr(end));
  const auto put = [&](auto value) {
    char bytes[sizeof(value)];
    std::memcpy(bytes, &value, sizeof(value));
    if (bigEndian) std::ranges::reverse(bytes);
    result.append(bytes, sizeof(value));
  };
  for (int i = 0; i < 24; ++i) {
    float x;
    numbers >> x;
    put(x);
  }
  for (int i = 0; i < 30; ++i) {
    std::int32_t x;
    numbers >> x;
    i % 5 == 0 ? put(std::uint8_t(x)) : put(x);
  }
  return result;
}

class MeshFileTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theCubeOfPlyFiles() {
    for (const std::string& content : {textOf(fuzz::plySeed()), binaryCube(false), binaryCube(true)}) {
      const TriangleMesh mesh = read(content, ".ply");
      QCOMPARE(mesh.triangles().size(), std::size_t(12));
      QVERIFY(mesh.isClosed() && mesh.isConvex());
      QVERIFY(std::abs(mesh.volume() - 8) < 1e-12);
    }
  }

  /// Properties and elements that are not known are passed over, wherever they stand.
  void aPlyFileWithNormalsAndMore() {
    const TriangleMesh mesh = read(
        "ply\r\nformat ascii 1.0\r\nelement camera 1\r\nproperty list uchar float f\r\nelement vertex 3\r\nproperty "
        "uchar red\r\n"
        "property double x\r\nproperty double y\r\nproperty double z\r\nproperty float nx\r\nproperty float ny\r\n"
        "property float nz\r\nelement face 1\r\nproperty float q\r\nproperty list uchar uint "
        "vertex_index\r\nend_header\r\n"
        "2 5 6\n9 0 0 0 0 .6 .8\n9 1 0 0 0 .6 .8\n9 0 1 0 0 .6 .8\n.5 3 0 1 2\n",
        ".ply");
    QCOMPARE(mesh.bounds().max, glm::dvec3(1, 1, 0));
    for (const glm::vec3& normal : mesh.cornerNormals()) QVERIFY(glm::distance(normal, glm::vec3(0, 0.6, 0.8)) < 1e-6f);
  }

  /// Rows without properties take no bytes, so their count is not limited by the file.
  void plyElementsWithoutPropertiesAreSkipped() {
    const TriangleMesh mesh = read(
        "ply\nformat ascii 1.0\nelement nothing 18446744073709551615\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\nelement face 1\nproperty list uchar uint vertex_index\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
        ".ply");
    QCOMPARE(mesh.triangles().size(), std::size_t(1));
  }

  /// The nodes of a glTF file place its meshes.
  void nodesPlaceTheMeshes() {
    const TriangleMesh mesh = read(textOf(fuzz::glbSeed()), ".glb");
    QCOMPARE(mesh.triangles().size(), std::size_t(2));
    QCOMPARE(mesh.bounds().min, glm::dvec3(0, 0, 0));
    QCOMPARE(mesh.bounds().max, glm::dvec3(2, 4, 0));
    for (const glm::vec3& normal : mesh.cornerNormals()) QCOMPARE(normal, glm::vec3(0, 0, 1));
  }

  /// A text glTF file with its buffer in a file of its own, next to it.
  void filesOfAllSuffixes() {
    const QTemporaryDir folder;
    const std::filesystem::path place = folder.path().toStdString();
    const std::string glb = textOf(fuzz::glbSeed());
    const std::size_t end = glb.rfind("}]}") + 3;
    const std::string json =
        replaced(glb.substr(20, end - 20), R"("byteLength":78)", R"("byteLength":78,"uri":"m.bin")");
    std::ofstream(place / "mesh.gltf") << json;
    std::ofstream(place / "m.bin", std::ios::binary) << glb.substr(glb.size() - 80);
    std::ofstream(place / "MESH.GLB", std::ios::binary) << glb;
    std::ofstream(place / "mesh.ply") << textOf(fuzz::plySeed());
    std::ofstream(place / "mesh.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    QCOMPARE(readMesh(place / "mesh.gltf").mesh.triangles().size(), std::size_t(2));
    QCOMPARE(readMesh(place / "MESH.GLB").mesh.triangles().size(), std::size_t(2));
    QCOMPARE(readMesh(place / "mesh.ply").mesh.triangles().size(), std::size_t(12));
    QCOMPARE(readMesh(place / "mesh.obj").mesh.triangles().size(), std::size_t(1));
  }

  void plyElementsInAnyOrderAndStrips() {
    const TriangleMesh mesh = read("\xEF\xBB\xBF" + textOf(fuzz::stripsSeed()), ".ply");
    // Two triangles of the first strip, one of the second, one face.
    QCOMPARE(mesh.triangles().size(), std::size_t(4));
    QCOMPARE(mesh.triangles()[0], TriangleIndices(0, 1, 2));
    QCOMPARE(mesh.triangles()[1], TriangleIndices(2, 1, 3));
    QCOMPARE(mesh.triangles()[2], TriangleIndices(4, 1, 0));
    QCOMPARE(mesh.triangles()[3], TriangleIndices(0, 2, 4));
    const std::string text = replaced(textOf(fuzz::stripsSeed()), "3 0 2 4", "3 0 2 5");
    QVERIFY(test::contains(test::errorOf([&] { read(text, ".ply"); }), "found vertex 5, but there are only 5"));
  }

  /// Double precision counts until the mesh is centred.
  void plyOfLargeCoordinates() {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "4123456.75 0 5000000.001\n4123456.76 0 5000000.001\n4123456.75 0.01 5000000.002\n3 0 1 2\n";
    const MeshFile file = readPly(MemorySource(std::as_bytes(std::span(text))));
    QVERIFY(glm::length(glm::dvec3(file.mesh.positions()[1] - file.mesh.positions()[0]) - glm::dvec3(0.01, 0, 0)) <
            1e-8);
    QVERIFY(std::abs(file.origin.x + file.mesh.positions()[0].x - 4123456.75) < 1e-8);
  }

  /// The same tetrahedron as text and binary, whose header looks like text.
  void stlFiles() {
    const glm::vec3 corners[] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 1},
                                 {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    std::string text = "solid one\r\n";
    for (int i = 0; i < 12; ++i) {
      if (i % 3 == 0) text += "facet normal 0 0 0\nouter loop\n";
      text += "vertex " + std::to_string(corners[i].x) + " " + std::to_string(corners[i].y) + "\t" +
              std::to_string(corners[i].z) + "\n";
      if (i % 3 == 2) text += "endloop\nendfacet\n";
    }
    for (const std::string& content : {text + "endsolid one\n", textOf(fuzz::stlSeed())}) {
      const TriangleMesh mesh = readStl(MemorySource(std::as_bytes(std::span(content)))).mesh;
      QCOMPARE(mesh.triangles().size(), std::size_t(4));
      QVERIFY(mesh.isClosed() && mesh.isConvex() && std::abs(mesh.volume() - 1.0 / 6) < 1e-9);
    }
    const auto refusal = [](const std::string& content) {
      return test::errorOf([&] { readStl(MemorySource(std::as_bytes(std::span(content)))); });
    };
    QVERIFY(test::contains(refusal("ply\n"), "expected one of them"));
    QVERIFY(test::contains(refusal("solid\nvertex 0 0\n"), "line 2: found 'vertex 0 0'"));
    QVERIFY(test::contains(refusal("solid\nvertex 0 0 0\n"), "found 1 vertices"));
    QVERIFY(test::contains(refusal("solid\nendsolid\n"), "found no triangles"));
    QVERIFY(!refusal(textOf(fuzz::stlSeed()).substr(0, 200)).empty());
  }

  /// glTF 2.0, 3.7.3: the joints place a skinned mesh, its node does not; morph targets count by their default weights.
  void skinsAndMorphTargets() {
    const std::string text = textOf(fuzz::skinSeed());
    const TriangleMesh mesh = read(text, ".gltf");
    // 0.2 of the first joint (0, 10, 0) and 0.8 of the second (10, 10, 0); half of 4 along z for the third vertex.
    const glm::vec3 expected[] = {{8, 10, 0}, {9, 10, 0}, {8, 11, 2}};
    for (int i = 0; i < 3; ++i) QVERIFY(glm::distance(mesh.positions()[mesh.triangles()[0][i]], expected[i]) < 1e-5f);
    const TriangleMesh plain = read(replaced(text, R"("skin":0,)", ""), ".gltf");
    QVERIFY(glm::distance(plain.positions()[plain.triangles()[0][0]], glm::vec3(50, 60, 70)) < 1e-5f);
    const auto refused = [&](std::string_view what, std::string_view by) {
      return test::errorOf([&] { read(replaced(text, what, by), ".gltf"); });
    };
    QVERIFY(
        test::contains(refused("KHR_mesh_quantization", "KHR_node_visibility"), "required extension 'KHR_node_vis"));
    QVERIFY(
        test::contains(refused("KHR_mesh_quantization", "KHR_draco_mesh_compression"), "compressed with KHR_draco"));
    QVERIFY(refused("KHR_mesh_quantization", "KHR_materials_ior").empty());
    QVERIFY(test::contains(refused(R"("joints":[1,2])", R"("joints":[1])"), "JOINTS_0"));
    QVERIFY(test::contains(refused(R"("joints":[1,2])", R"("joints":[1,7])"), "there is no element 7"));
    QVERIFY(test::contains(refused(R"("count":3,"type":"VEC3","sparse")", R"("count":2,"type":"VEC3","sparse")"),
                           "indices below the count"));
  }

  void suffixes() {
    for (const char* name : {"a.obj", "b/A.PLY", "c.gltf", "d.glb"}) QVERIFY(isMeshFile(name));
    for (const char* name : {"a.json", "obj", "", "a.binary"}) QVERIFY(!isMeshFile(name));
    QCOMPARE(meshSuffixList("*"), std::string("*.obj *.ply *.stl *.gltf *.glb"));
  }

  void whatIsRefused() {
    const auto refusal = [](const std::string& content, const std::string& suffix) {
      return test::errorOf([&] { read(content, suffix); });
    };
    const std::string ply = textOf(fuzz::plySeed()), glb = textOf(fuzz::glbSeed());
    for (const std::string& content : {std::string(), glb})
      QVERIFY(test::contains(refusal(content, ".ply"), "does not begin with 'ply'"));
    QVERIFY(test::contains(refusal("ply", ".ply"), "expected 'end_header'"));
    QVERIFY(test::contains(refusal(replaced(ply, "float x", "float3 x"), ".ply"), "expected a type"));
    QVERIFY(test::contains(refusal(ply.substr(0, ply.size() - 8), ".ply"), "face 5: found the end of the file"));
    QVERIFY(test::contains(refusal(replaced(ply, "4 0 1 3 2", "4 0 1 3 9"), ".ply"), "face 0: found vertex 9"));
    QVERIFY(test::contains(refusal(replaced(ply, "4 0 1 3 2", "2 0 1 3 9"), ".ply"), "found 2 corners"));
    QVERIFY(test::contains(refusal(replaced(ply, "-1 -1 -1", "-1 nan -1"), ".ply"), "vertex 0: found 'nan'"));
    QVERIFY(test::contains(refusal("ply\n", ".glb"), "not JSON"));
    QVERIFY(test::contains(refusal(glb.substr(0, glb.size() / 2), ".glb"), "bytes of a chunk, expected"));
    const auto refused = [&](std::string_view what, std::string_view by) {
      return refusal(replaced(glb, what, by), ".glb");
    };
    QVERIFY(test::contains(refused(R"("indices":2)", R"("indices":7)"), "accessors: there is no element 7"));
    QVERIFY(
        test::contains(refused(R"("count":3,"type":"SCALAR")", R"("count":9,"type":"SCALAR")"), "accessors[2].count"));
    QVERIFY(test::contains(refused(R"("componentType":5126)", R"("componentType":8458)"), "5126 (float)"));
    QVERIFY(test::contains(refused(R"("nodes":[0,1]}])", R"("nodes":[0,9]}])"), "nodes: there is no element 9"));
    QVERIFY(test::contains(refused(R"("mesh":0,"scale":[2,2,2])", R"("children":[0,0,0      ])"), "in a cycle"));
    QVERIFY(test::contains(refused(R"("scene":0,)", R"("scene":6,)"), "scenes: there is no element 6"));
    QVERIFY(test::contains(test::errorOf([] { readMesh("vase.3mf"); }), "vase.3mf: found the suffix '.3mf'"));
    QVERIFY(test::contains(test::errorOf([] { readMesh("/nowhere/vase.ply"); }), "/nowhere/vase.ply"));
  }
};

GONIO_TEST(MeshFileTest)
}  // namespace mesh_file_test

#include "mesh_file_test.moc"
