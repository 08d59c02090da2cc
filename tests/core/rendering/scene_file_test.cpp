// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/scene_file.h"

#include <QTest>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/geometry/bundled_meshes.h"
#include "core/io/image_io.h"
#include "core/rendering/environment.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/scene_light.h"
#include "core/support/error.h"
#include "tests/core/io/test_files.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace scene_file_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::geometry;

/// A scene of one of everything that a scene file may say.
const char* const everything = R"({
  "format": "gonio scene",
  "version": 1,
  "description": "one of everything",
  "camera": {"yaw": 30, "pitch": -20, "distance": 7, "fieldOfView": 40, "target": [0, 1, 2]},
  "objects": [
    {"name": "ball", "shape": "sphere", "centre": [1, 2, 3], "radius": 0.5, "material": 1},
    {"name": "floor", "shape": "rectangle", "centre": [0, -1, 0], "halfU": [0, 0, 3], "halfV": [4, 0, 0],
     "material": {"diffuse": [0.1, 0.2, 0.3]}},
    {"name": "lamp", "shape": "rectangle", "halfU": [1, 0, 0], "halfV": [0, 0, 1], "radiance": [7, 8, 9]},
    {"name": "ring", "shape": "mesh", "mesh": "torus", "scale": 2, "turn": 90, "centre": [0, 5, 0]}
  ],
  "lights": [
    {"kind": "directional", "toLight": [0, 3, 4], "irradiance": [1, 2, 3]},
    {"kind": "point", "position": [1, 1, 1], "intensity": [4, 5, 6]}
  ],
  "environment": {"picture": "sky", "rotation": 45, "shown": true}
})";

Direction place(double x, double y, double z) { return {x, y, z}; }
bool near(const Direction& a, const Direction& b, double tolerance = 1e-12) { return glm::length(a - b) < tolerance; }

/// The text of the error that a scene gives; empty where it gives none.
std::string errorOf(const nlohmann::json& json, const std::optional<std::filesystem::path>& folder = {}) {
  try {
    parseScene(json.dump(), 1, folder);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

nlohmann::json scene() { return nlohmann::json::parse(everything); }
using Pointer = nlohmann::json::json_pointer;

/// One wrong member: its place in `everything`, what stands there, and what the error says.
struct Wrong {
  const char* pointer;
  nlohmann::json value;
  const char* text;
};

std::vector<Wrong> wrongMembers() {
  const double tooFar = 1e7;
  return {
      {"/format", "gonio document", "format: found the string \"gonio document\", expected \"gonio scene\""},
      {"/version", 2, "version: found the number 2, expected 1, the only version"},
      {"/description", 3, "description: found the number 3, expected a string"},
      {"/objects", 3, "objects: found the number 3, expected a list"},
      {"/objects/0", 3, "objects[0]: found the number 3, expected an object"},
      {"/objects/0/name", nullptr, "objects[0].name: found null, expected a string"},
      {"/objects/0/shape", "cone", "objects[0].shape: found the string \"cone\", expected \"sphere\", \"rectangle\""},
      {"/objects/0/raduis", 1, "objects[0].raduis: unknown member, expected one of name, shape"},
      {"/objects/0/radius", 0, "objects[0].radius: found the number 0, expected a number from"},
      {"/objects/0/centre", {1, 2}, "objects[0].centre: found a list of 2, expected three numbers from -1e6"},
      {"/objects/0/centre", {1, 2, tooFar}, "objects[0].centre: found a list of 3, expected three numbers"},
      {"/objects/0/centre", {1, "x", 2}, "objects[0].centre: found a list of 3, expected three numbers"},
      {"/objects/0/material", -1, "objects[0].material: found the number -1, expected a material number"},
      {"/objects/0/material", "all", "objects[0].material: found the string \"all\", expected a material number"},
      {"/objects/0/radiance", {1, 1, 1}, "objects[0].radiance: found a list of 3, expected no radiance (only"},
      {"/objects/1/material", "each",
       "objects[1].material: found the string \"each\", expected a material other than \"each\""},
      {"/objects/1/material/diffuse", {1, 2, 0}, "objects[1].material.diffuse: found a list of 3, expected a refl"},
      {"/objects/1/material/diffuse", {1, -1, 0}, "objects[1].material.diffuse: found a list of 3, expected three"},
      {"/objects/1/material/gloss", 1, "objects[1].material.gloss: unknown member, expected one of"},
      {"/objects/1/halfV", {4, 0, 1}, "objects[1].halfV: found a list of 3, expected a side that is perpendicular"},
      {"/objects/1/halfV", {0, 0, 0}, "objects[1].halfV: found a list of 3, expected a side that is perpendicular"},
      {"/objects/1/halfU", {1e-200, 0, 0}, "objects[1].halfV: found a list of 3, expected a side that is perp"},
      {"/objects/2/radiance", {-1, 0, 0}, "objects[2].radiance: found a list of 3, expected three numbers from 0"},
      {"/objects/3/mesh", "teapot", "teapot"},
      {"/objects/3/mesh", "teapot.obj", "objects[3].mesh: found the string \"teapot.obj\", expected the name of a"},
      {"/objects/3/scale", -1, "objects[3].scale: found the number -1, expected a number from"},
      {"/objects/3/turn", "left", "objects[3].turn: found the string \"left\", expected a number from -360"},
      {"/objects/3/fit", 1, "objects[3].fit: found the number 1, expected true or false"},
      {"/lights/0/kind", "sun", "lights[0].kind: found the string \"sun\", expected \"directional\" or \"point\""},
      {"/lights/0/toLight", {0, 0, 0}, "lights[0].toLight: found a list of 3, expected a direction"},
      {"/lights/0/irradiance", {1, -2, 3}, "lights[0].irradiance: found a list of 3, expected three numbers from 0"},
      {"/lights/1/intensity", 5, "lights[1].intensity: found the number 5, expected three numbers from 0"},
      {"/lights/1/colour", "red", "lights[1].colour: unknown member, expected one of kind, position"},
      {"/environment/picture", "attic", "environment.picture: found the string \"attic\", expected the name of a"},
      {"/environment/rotation", 400, "environment.rotation: found the number 400, expected a number from -360"},
      {"/camera/pitch", 90, "camera.pitch: found the number 90, expected a number from -89"},
      {"/camera/distance", "far", "camera.distance: found the string \"far\", expected a number from"},
      {"/camera/fieldOfView", 0, "camera.fieldOfView: found the number 0, expected a number from 1"},
      {"/lamps", 1, "lamps: unknown member, expected one of format, version"}};
}

class SceneFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void everyMember() {
    const Scene scene = parseScene(everything, 3);
    QCOMPARE(scene.description, std::string("one of everything"));
    QVERIFY(std::abs(scene.camera.yaw - radians(30)) < 1e-15 && std::abs(scene.camera.pitch + radians(20)) < 1e-15);
    QVERIFY(scene.camera.distance == 7 && std::abs(scene.camera.fieldOfView - radians(40)) < 1e-15);
    QVERIFY(near(scene.camera.target, place(0, 1, 2)));
    QCOMPARE(scene.objects.size(), std::size_t(4));
    const auto& ball = std::get<Sphere>(scene.objects[0].shape);
    QVERIFY(near(ball.centre, place(1, 2, 3)) && ball.radius == 0.5);
    QCOMPARE(std::get<MaterialSlot>(scene.objects[0].material).number, 1);
    QCOMPARE(materialSlotCount(scene), 2);
    const auto& floor = std::get<Rectangle>(scene.objects[1].shape);
    QVERIFY(near(floor.normal(), place(0, 1, 0)) && floor.area() == 48);
    QVERIFY(near(std::get<Diffuse>(scene.objects[1].material).reflectance, place(0.1, 0.2, 0.3)));
    QVERIFY(scene.objects[2].emits() && near(scene.objects[2].radiance, place(7, 8, 9)));
    const TriangleMesh& ring = std::get<MeshShape>(scene.objects[3].shape)->mesh();
    QVERIFY(near(ring.boundingSphere().centre, place(0, 5 + 2 * torusMesh().boundingSphere().centre.y, 0), 1e-5));
    QVERIFY(near(scene.directionalLights[0].toLight, place(0, 0.6, 0.8)));
    QVERIFY(near(scene.directionalLights[0].irradiance, place(1, 2, 3)));
    QVERIFY(near(scene.pointLights[0].position, place(1, 1, 1)) &&
            near(scene.pointLights[0].intensity, place(4, 5, 6)));
    QVERIFY(scene.environment == bundledEnvironment("sky") && scene.showEnvironment);
    QVERIFY(std::abs(scene.environmentRotation - radians(45)) < 1e-15);
  }

  void whatIsNotSaid() {
    const Scene empty = parseScene(R"({"format": "gonio scene", "version": 1})", 1);
    QVERIFY(empty.objects.empty() && !empty.environment && empty.pointLights.empty());
    QCOMPARE(empty.camera.distance, OrbitCamera{}.distance);
    const Scene sphere = parseScene(
        R"({"format": "gonio scene", "version": 1, "objects": [{"name": "a", "shape": "sphere"}], "camera": {}})", 1);
    QVERIFY(std::get<Sphere>(sphere.objects[0].shape).radius == 1 && materialSlotCount(sphere) == 1);
    // The whole sphere stands in a square picture, and fills most of it.
    const double half = std::asin(1 / sphere.camera.distance);
    QVERIFY(half < sphere.camera.fieldOfView / 2 && half > 0.8 * sphere.camera.fieldOfView / 2);
  }

  void theComparisonSceneHasTwoNames() {
    const test::FunctionBrdf grey([](const Direction&, const Direction&) { return Rgb(0.2); });
    RenderOptions options;
    options.width = options.height = 24;
    options.samples = 4;
    const Image expected = renderPicture(grey, comparisonScene(), options);
    for (const char* name : {comparisonSceneName, "sphere"})
      QCOMPARE(renderPicture(grey, openScene(name), options).pixels, expected.pixels);
  }

  void bundledScenesParse() {
    QCOMPARE(bundledSceneNames().size(), bundledScenes().size());
    QCOMPARE(bundledSceneNames().front(), std::string("sphere"));
    for (const std::string& name : bundledSceneNames())
      for (const int materials : {1, 3}) {
        const Scene scene = openScene(name, materials);
        QCOMPARE(scene.name, name);
        QVERIFY(!scene.description.empty() && !scene.objects.empty());
        QVERIFY(materialSlotCount(scene) >= 1 && materialSlotCount(scene) <= materials);
        QVERIFY(!lightsOf(scene).empty());
      }
  }

  /// "sphere" is what previews and rendered SNRs show.
  void theSphereIsTheComparisonScene() {
    const Scene file = openScene("sphere"), made = comparisonScene();
    QVERIFY(file.environment == made.environment && file.environmentRotation == made.environmentRotation);
    QCOMPARE(file.camera.distance, made.camera.distance);
    QCOMPARE(file.camera.fieldOfView, made.camera.fieldOfView);
    QVERIFY(file.camera.yaw == made.camera.yaw && file.camera.pitch == made.camera.pitch);
    QCOMPARE(std::get<Sphere>(file.objects[0].shape).radius, 1.0);
  }

  void eachStandsSideBySide() {
    const Scene row = openScene("row", 4);
    QCOMPARE(row.objects.size(), std::size_t(5));
    for (int i = 0; i < 4; ++i) {
      QCOMPARE(std::get<MaterialSlot>(row.objects[std::size_t(i)].material).number, i);
      QCOMPARE(row.objects[std::size_t(i)].name, "the sphere " + std::to_string(i + 1));
      QVERIFY(near(std::get<Sphere>(row.objects[std::size_t(i)].shape).centre, place(2.3 * (i - 1.5), 0, 0)));
    }
    QCOMPARE(openScene("row", 1).objects[0].name, std::string("the sphere"));
    // With one material both places show it.
    QCOMPARE(materialSlotCount(openScene("two-spheres", 1)), 1);
    QCOMPARE(materialSlotCount(openScene("two-spheres", 5)), 2);
  }

  void badMembersAreNamed() {
    QVERIFY(errorOf(scene()).empty());
    for (const Wrong& wrong : wrongMembers()) {
      nlohmann::json changed = scene();
      changed[Pointer(wrong.pointer)] = wrong.value;
      const std::string error = errorOf(changed);
      QVERIFY2(error.find(wrong.text) != std::string::npos,
               (std::string(wrong.pointer) + ": " + (error.empty() ? "no error" : error)).c_str());
    }
    for (const char* required : {"/format", "/version", "/objects/0/name", "/objects/0/shape", "/objects/1/halfU",
                                 "/objects/3/mesh", "/lights/0/kind", "/lights/0/toLight", "/lights/1/position",
                                 "/environment/picture", "/objects/1/material/diffuse"}) {
      nlohmann::json changed = scene();
      const Pointer pointer(required);
      changed[pointer.parent_pointer()].erase(pointer.back());
      const std::string error = errorOf(changed);
      QVERIFY2(error.find(pointer.back()) != std::string::npos && error.find("found nothing") != std::string::npos,
               required);
    }
  }

  void textsThatAreNoScene() {
    for (const char* text : {"", "{", "[]", "3", "{\"format\": \"gonio scene\", \"version\": 1e999}", "\xff\xfe"})
      QVERIFY_THROWS_EXCEPTION(Error, parseScene(text, 1));
    nlohmann::json many = scene();
    for (int i = 0; i < 300; ++i) many["objects"].push_back(many["objects"][0]);
    QVERIFY(errorOf(many).find("objects: found a list of 304, expected at most 256 entries") != std::string::npos);
    nlohmann::json huge = scene();
    huge["objects"][0]["material"] = 18446744073709551615u;
    QVERIFY(errorOf(huge).empty());
  }

  /// A scene with a mesh and a picture beside it, both by relative paths; where no folder is given, none is opened.
  void filesBesideTheScene() {
    const std::filesystem::path folder = test::outputPath("scenes/lamp").parent_path();
    std::ofstream(folder / "block.obj") << "v 10 5 10\nv 12 5 10\nv 10 8 10\nv 10 5 14\n"
                                           "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    Image picture(8, 4);
    for (glm::vec3& pixel : picture.pixels) pixel = {1, 2, 3};
    io::writeExr(picture, folder / "dawn.exr", {});
    nlohmann::json json = scene();
    json["objects"][3] = {{"name", "block"}, {"shape", "mesh"}, {"mesh", "block.obj"}, {"fit", true}};
    json["environment"] = {{"picture", "dawn.exr"}};
    QVERIFY(errorOf(json, folder).empty());
    QVERIFY(errorOf(json).find("cannot refer to files") != std::string::npos);
    std::ofstream(folder / "morning.json") << json.dump();
    const Scene read = openScene((folder / "morning.json").string());
    QCOMPARE(read.name, std::string("morning"));
    QCOMPARE(read.environment->name(), (folder / "dawn.exr").string());
    QVERIFY(near(read.environment->radiance({0, 1, 0}), place(1, 2, 3), 1e-6));
    checkFits(std::get<MeshShape>(read.objects[3].shape)->mesh(), place(0, 0, 0));
    for (const double turn : {30.0, -140.0}) {
      json["objects"][3]["turn"] = turn;
      json["objects"][3]["centre"] = {3, 4, 5};
      const Scene turned = parseScene(json.dump(), 1, folder);
      checkFits(std::get<MeshShape>(turned.objects[3].shape)->mesh(), place(3, 4, 5));
    }
    json["environment"]["picture"] = "dusk.exr";
    std::ofstream(folder / "evening.json") << json.dump();
    try {
      openScene((folder / "evening.json").string());
      QFAIL("a picture that is not there");
    } catch (const Error& error) {
      const std::string text = error.what();
      QVERIFY2(text.find("evening.json: ") != std::string::npos && text.find("dusk.exr") != std::string::npos,
               text.c_str());
    }
  }

  /// A flat mesh would share the plane of the ground; a closed one shows it no upper side.
  void aFlatMeshLiesAboveTheGround() {
    const auto lowest = [](const std::string& text) {
      const auto path = test::writeFile("scenes/flat.obj", std::as_bytes(std::span(text)));
      return std::get<MeshShape>(openScene(path.string()).objects[0].shape)->mesh().bounds().min.y;
    };
    const std::string square = "v -1 0 -1\nv -1 0 1\nv 1 0 1\nv 1 0 -1\n";
    const double flat = lowest(square + "f 1 2 3 4\n");
    QVERIFY2(flat > -1 + 5e-4 && flat < -1 + 2e-3, std::to_string(flat).c_str());
    // With a bump.
    QVERIFY(lowest(square + "v 3 0 0\nv 4 1 0\nv 3 0 -1\nf 1 2 3 4\nf 5 6 7\n") > -1 + 5e-4);
    const double pyramid = lowest(square + "v 0 1 0\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
    QVERIFY2(std::abs(pyramid + 1) < 1e-6, std::to_string(pyramid).c_str());
  }

  /// A mesh far from the origin is the same scene, and stands where a scene file says.
  void coordinatesOfMaps() {
    const auto corners = [](const char* x, const char* y, const char* z) {
      return std::string("v ") + x + ".00 " + y + " " + z + "\nv " + x + ".01 " + y + " " + z + "\nv " + x + ".00 " +
             y + ".02 " + z + "\nf 1 2 3\n";
    };
    std::vector<TriangleMesh> meshes;
    for (const std::string& text : {corners("0", "0", "0"), corners("512345", "100", "4123456")}) {
      const auto path = test::writeFile("scenes/far.obj", std::as_bytes(std::span(text)));
      meshes.push_back(std::get<MeshShape>(openScene(path.string()).objects[0].shape)->mesh());
      const Scene placed =
          parseScene(R"({"format": "gonio scene", "version": 1, "objects": [{"name": "a", "shape": "mesh",
        "mesh": "far.obj", "scale": 0.001, "centre": [1, 2, 3]}]})",
                     1, path.parent_path());
      const TriangleMesh& mesh = std::get<MeshShape>(placed.objects[0].shape)->mesh();
      const double x = text.starts_with("v 0") ? 1 : 1 + 512.345;
      QVERIFY(std::abs(mesh.bounds().min.x - x) < 1e-4);
    }
    for (std::size_t i = 0; i < 3; ++i)
      QVERIFY(glm::length(meshes[0].positions()[i] - meshes[1].positions()[i]) < 1e-5f);
  }

  /// A box of 1 x 2 x 4 along x, y, z with a tip at +z: with z up the tip is on top, and +y of the file away from the
  /// viewer (-z), also for coordinates of maps and in scene files.
  void meshesStandUpright() {
    const auto box = [](const std::string& x) {
      return "v " + x + "0 0 0\nv " + x + "1 0 0\nv " + x + "0 2 0\nv " + x +
             "0 0 4\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    };
    const auto extentOf = [](const Scene& scene) {
      const TriangleMesh& mesh = std::get<MeshShape>(scene.objects[0].shape)->mesh();
      return mesh.bounds().max - mesh.bounds().min;
    };
    const auto isShape = [](const glm::dvec3& extent, const glm::dvec3& shape) {
      return glm::length(extent / glm::length(extent) - shape / glm::length(shape)) < 1e-6;
    };
    for (const char* x : {"", "51234"}) {
      const std::string text = box(x);
      const auto path = test::writeFile("scenes/upright.obj", std::as_bytes(std::span(text)));
      const Scene lying = openScene(path.string()), standing = openScene(path.string(), 1, UpAxis::z);
      QVERIFY(lying.pose.up == UpAxis::y && standing.pose.up == UpAxis::z);
      QVERIFY(isShape(extentOf(lying), {1, 2, 4}) && isShape(extentOf(standing), {1, 4, 2}));
      // Only one vertex is at the top: it is the tip of the file, above the corner at the origin (front, left).
      const TriangleMesh& mesh = std::get<MeshShape>(standing.objects[0].shape)->mesh();
      for (const glm::vec3& vertex : mesh.positions())
        if (vertex.y > mesh.bounds().max.y - 1e-3)
          QVERIFY(vertex.x < mesh.bounds().min.x + 1e-3 && vertex.z > mesh.bounds().max.z - 1e-3);
      QVERIFY(mesh.volume() > 0);
      const auto placed = [&](const char* up) {
        return parseScene(
            std::string(R"({"format": "gonio scene", "version": 1, "objects": [{"name": "a", "shape": "mesh",
          "mesh": "upright.obj", "up": ")") +
                up + "\"}]}",
            1, path.parent_path());
      };
      const Scene inFile = placed("z");
      const TriangleMesh::Bounds bounds = std::get<MeshShape>(inFile.objects[0].shape)->mesh().bounds();
      QVERIFY(isShape(extentOf(placed("y")), {1, 2, 4}) && isShape(extentOf(placed("z")), {1, 4, 2}));
      // Not fitted: where its coordinates say, turned about the origin of the file.
      QVERIFY(std::abs(bounds.min.x - std::stod(x + std::string("0"))) < 0.1);
      QVERIFY(std::abs(bounds.max.y - 4) < 1e-6 && std::abs(bounds.min.z + 2) < 1e-6);
    }
    QVERIFY(upAxisOf(upAxisName(UpAxis::z)) == UpAxis::z);
    const auto refusal = [](auto open) {
      try {
        open();
        return std::string();
      } catch (const Error& error) {
        return std::string(error.what());
      }
    };
    QCOMPARE(refusal([] { upAxisOf("x"); }), std::string("up axis: found 'x', expected y or z"));
    QVERIFY(
        refusal([] { openScene("sphere", 1, UpAxis::z); }).starts_with("sphere: found the up axis z, expected a mesh"));
    nlohmann::json bundled = scene();
    bundled["objects"][0] = {{"name", "a"}, {"shape", "mesh"}, {"mesh", "torus"}, {"up", "z"}};
    QVERIFY(errorOf(bundled).find("bundled meshes are y up") != std::string::npos);
  }

  /// A tooth whose tip is at the +z end of the file: quarter turns bring the tip to the right, the back and the left,
  /// and move nothing else.
  void meshesAreTurnedAboutTheUpAxis() {
    const std::string text = "v -1 0 -1\nv 1 0 -1\nv 0 1 -1\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    const auto path = test::writeFile("scenes/turned.obj", std::as_bytes(std::span(text)));
    const glm::dvec3 tips[] = {{0, 0, 1}, {1, 0, 0}, {0, 0, -1}, {-1, 0, 0}};
    for (int turns = 0; turns < 4; ++turns) {
      const Scene scene = openScene(path.string(), 1, {UpAxis::y, turns});
      QCOMPARE(scene.pose.quarterTurns, turns);
      const TriangleMesh& mesh = std::get<MeshShape>(scene.objects[0].shape)->mesh();
      const glm::dvec3 towardsTip = glm::dvec3(mesh.positions()[3]) -
                                    glm::dvec3(mesh.positions()[0] + mesh.positions()[1] + mesh.positions()[2]) / 3.0;
      const glm::dvec3 along(towardsTip.x, 0, towardsTip.z);
      QVERIFY(glm::length(glm::normalize(along) - tips[turns]) < 1e-6);
      QVERIFY(mesh.volume() > 0);
    }
  }

  void aMeshIsAScene() {
    const std::filesystem::path folder = test::outputPath("scenes/lamp").parent_path();
    std::ofstream(folder / "Tooth.obj") << "v 10 5 10\nv 12 5 10\nv 10 8 10\nv 10 5 14\n"
                                           "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    const Scene scene = openScene((folder / "Tooth.obj").string(), 2);
    QCOMPARE(scene.name, std::string("Tooth"));
    QCOMPARE(scene.objects.size(), std::size_t(2));
    QCOMPARE(scene.objects[0].name, std::string("Tooth"));
    const TriangleMesh& mesh = std::get<MeshShape>(scene.objects[0].shape)->mesh();
    checkFits(mesh, place(0, 0, 0));
    // It fills the view.
    const CameraFrame frame = cameraFrame(scene.camera);
    double farthest = 0;
    for (const glm::vec3& vertex : mesh.positions()) {
      const Direction ray = (Direction(vertex) - frame.eye) / glm::dot(Direction(vertex) - frame.eye, frame.forward);
      farthest = std::max({farthest, std::abs(glm::dot(ray, frame.right)), std::abs(glm::dot(ray, frame.up))});
    }
    QVERIFY(farthest / frame.halfExtent > 0.9 && farthest / frame.halfExtent < 0.95);
  }

  void whatIsNeitherANameNorAFile() {
    for (const std::string& name : {std::string("spheer"), std::string(5000, 'x'), std::string()}) try {
        openScene(name);
        QFAIL("no such scene");
      } catch (const Error& error) {
        const std::string text = error.what();
        QVERIFY(text.find("neither a bundled scene (sphere, sphere-distant-light, ") != std::string::npos);
        QVERIFY(text.find("torus) nor a file") != std::string::npos);
      }
    // Named once.
    const std::string folder = test::outputPath("scenes/lamp").parent_path().string();
    try {
      openScene(folder);
      QFAIL("a folder");
    } catch (const Error& error) {
      const std::string text = error.what();
      QVERIFY2(text.starts_with(folder + ": found") && text.rfind(folder) == 0, text.c_str());
    }
  }

 private:
  /// In a sphere of radius 1 about the vertical through `centre`, standing on the plane one below it.
  static void checkFits(const TriangleMesh& mesh, const Direction& centre) {
    QVERIFY(std::abs(mesh.boundingSphere().radius - 1) < 0.2);
    QVERIFY(std::abs(mesh.bounds().min.y - (centre.y - 1)) < 1e-5);
    double farthest = 0;
    for (const glm::vec3& p : mesh.positions())
      farthest = std::max(farthest, std::hypot(double(p.x) - centre.x, double(p.z) - centre.z));
    QVERIFY2(farthest < 1 + 1e-5, qPrintable(QString::number(farthest)));
  }
};

GONIO_TEST(SceneFileTest)
}  // namespace scene_file_test

#include "scene_file_test.moc"
