// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/scene_file.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/bundled_meshes.h"
#include "core/io/byte_source.h"
#include "core/io/json_text.h"
#include "core/io/mesh_file.h"
#include "core/rendering/environment.h"
#include "core/rendering/render_picture.h"
#include "core/support/error.h"
#include "core/support/json_object.h"

namespace gonio::rendering {

namespace {

constexpr double largest = 1e6;    ///< coordinate, radiance
constexpr double smallest = 1e-6;  ///< radius, half side, scale
constexpr std::uint64_t maxSceneBytes = std::uint64_t(1) << 24;
constexpr int maxObjects = 256;

Direction triple(const JsonObject& object, std::string_view key, bool mayBeNegative = true) {
  const auto [x, y, z] = object.triple(key, mayBeNegative);
  return {x, y, z};
}

Direction tripleOr(const JsonObject& object, std::string_view key, const Direction& otherwise) {
  return object.contains(key) ? triple(object, key) : otherwise;
}

double numberOr(const JsonObject& object, std::string_view key, double min, double max, double otherwise) {
  return object.contains(key) ? object.number(key, min, max) : otherwise;
}

/// The mesh of a file with the axis `up` of its coordinates upright.
io::MeshFile readUpright(const std::filesystem::path& path, UpAxis up) {
  io::MeshFile file = io::readMesh(path);
  if (up == UpAxis::y) return file;
  const glm::dmat4 turn({1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1});  // exact in single precision
  file.mesh = transformed(file.mesh, turn);
  file.origin = glm::dvec3(turn * glm::dvec4(file.origin, 1));
  return file;
}

/// Whether triangles that face up lie in the plane of the lowest vertices, where they would share it with the ground.
bool liesOnGround(const geometry::TriangleMesh& mesh) {
  const double limit = mesh.bounds().min.y + geometry::TriangleMesh::shapeTolerance * mesh.boundingSphere().radius;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    const geometry::TriangleIndices& triangle = mesh.triangles()[i];
    const auto isLow = [&](int corner) { return mesh.positions()[triangle[corner]].y <= limit; };
    if (isLow(0) && isLow(1) && isLow(2) && mesh.geometricNormal(i).y > 0) return true;
  }
  return false;
}

/// Scaled, turned about +y (rad) and moved; `fits`: first into a sphere of radius 1 that stands on the plane one below
/// the origin, or, for a flat mesh that would lie in this plane, slightly above it.
Shape placedMesh(std::shared_ptr<const geometry::TriangleMesh> mesh, const glm::dvec3& origin, double scale,
                 double turn, Direction centre, bool fits) {
  // Thousands of times the rounding of rays that leave the ground or the mesh.
  constexpr double lift = 1e-3;
  if (fits) {
    const double size = scale;
    scale /= mesh->boundingSphere().radius;
    const Direction middle = mesh->boundingSphere().centre, foot(middle.x, mesh->bounds().min.y, middle.z);
    centre -= Direction(geometry::placement(scale, turn, Direction(0)) * glm::dvec4(foot, 1)) + Direction(0, 1, 0);
    if (liesOnGround(*mesh)) centre.y += lift * size;
  } else {
    centre += Direction(geometry::placement(scale, turn, Direction(0)) * glm::dvec4(origin, 1));
  }
  const glm::dmat4 placed = geometry::placement(scale, turn, centre);
  if (placed != glm::dmat4(1)) mesh = std::make_shared<const geometry::TriangleMesh>(transformed(*mesh, placed));
  return std::make_shared<const geometry::MeshIntersector>(std::move(mesh));
}

void addNotes(const std::string& name, const io::MeshFile& file, Scene& scene) {
  for (const std::string& note : file.notes) scene.notes.push_back(name + ": " + note);
}

/// From where all that is looked at fits into a square picture, with a margin.
double fittingDistance(const Scene& scene, const OrbitCamera& camera) {
  constexpr double margin = 1.08;
  const CameraFrame frame = cameraFrame(camera);
  const double halfAngle = camera.fieldOfView / 2;
  double distance = 0;
  const auto include = [&](const Direction& centre, double radius) {
    const Direction offset = centre - camera.target;
    const double across = std::max(std::abs(glm::dot(offset, frame.right)), std::abs(glm::dot(offset, frame.up)));
    distance = std::max(distance, margin * (across / std::tan(halfAngle) + radius / std::sin(halfAngle)) -
                                      glm::dot(offset, frame.forward));
  };
  for (const SceneObject& object : scene.objects) {
    if (object.emits() || !std::holds_alternative<MaterialSlot>(object.material)) continue;
    if (const auto* mesh = std::get_if<MeshShape>(&object.shape)) {
      for (const glm::vec3& vertex : (*mesh)->mesh().positions()) include(Direction(vertex), 0);
    } else {
      const Sphere bound = boundingSphere(object.shape);
      include(bound.centre, bound.radius);
    }
  }
  return distance > 0 ? distance : camera.distance;
}

/// Reads one scene: a part of the file a function.
class SceneReader {
 public:
  SceneReader(const JsonObject& root, int materials, const std::optional<std::filesystem::path>& folder)
      : root_(root), materials_(materials), folder_(folder) {}

  Scene read();

 private:
  void readObject(const JsonObject& object);
  Shape shapeOf(const JsonObject& object);
  Shape meshOf(const JsonObject& object);
  void readLight(const JsonObject& light);
  void readEnvironment(const JsonObject& environment);
  void readCamera(const JsonObject& camera);

  const JsonObject& root_;
  int materials_;
  const std::optional<std::filesystem::path>& folder_;
  Scene scene_;
};

Scene SceneReader::read() {
  if (root_.text("format") != "gonio scene") root_.fail("format", "\"gonio scene\"");
  if (root_.number("version", 1, 1e6) != 1) root_.fail("version", "1, the only version that this program reads");
  root_.expectOnly({"format", "version", "description", "camera", "objects", "lights", "environment"});
  if (root_.contains("description")) scene_.description = root_.text("description");
  const nlohmann::json none = nlohmann::json::array();
  const auto each = [&](const char* key, auto read) {
    const nlohmann::json& list = root_.contains(key) ? root_.array(key) : none;
    if (list.size() > maxObjects) root_.fail(key, "at most " + std::to_string(maxObjects) + " entries");
    for (std::size_t i = 0; i < list.size(); ++i)
      read(JsonObject(list[i], std::string(key) + "[" + std::to_string(i) + "]"));
  };
  each("objects", [&](const JsonObject& object) { readObject(object); });
  each("lights", [&](const JsonObject& light) { readLight(light); });
  if (root_.contains("environment")) readEnvironment(root_.object("environment"));
  if (root_.contains("camera")) readCamera(root_.object("camera"));
  return std::move(scene_);
}

Shape SceneReader::meshOf(const JsonObject& object) {
  object.expectOnly({"name", "shape", "mesh", "centre", "scale", "turn", "fit", "up", "material", "radiance"});
  const std::string name = object.text("mesh"), up = object.contains("up") ? object.text("up") : "y";
  if (up != "y" && !(up == "z" && io::isMeshFile(name)))
    object.fail("up", io::isMeshFile(name) ? "\"y\" or \"z\"" : "\"y\" (bundled meshes are y up)");
  if (io::isMeshFile(name) && !folder_)
    object.fail("mesh", "the name of a bundled mesh (a scene read from text cannot refer to files)");
  std::shared_ptr<const geometry::TriangleMesh> mesh;
  glm::dvec3 origin(0);
  if (io::isMeshFile(name)) {
    io::MeshFile file = readUpright(*folder_ / name, upAxisOf(up));
    addNotes(name, file, scene_);
    origin = file.origin;
    mesh = std::make_shared<const geometry::TriangleMesh>(std::move(file.mesh));
  } else {
    mesh = geometry::bundledMesh(name);
  }
  return placedMesh(std::move(mesh), origin, numberOr(object, "scale", smallest, largest, 1),
                    radians(numberOr(object, "turn", -360, 360, 0)), tripleOr(object, "centre", {0, 0, 0}),
                    object.contains("fit") && object.flag("fit"));
}

Shape SceneReader::shapeOf(const JsonObject& object) {
  const std::string kind = object.text("shape");
  if (kind == "mesh") return meshOf(object);
  if (kind == "sphere") {
    object.expectOnly({"name", "shape", "centre", "radius", "material", "spacing", "radiance"});
    return Sphere{tripleOr(object, "centre", {0, 0, 0}), numberOr(object, "radius", smallest, largest, 1)};
  }
  if (kind != "rectangle") object.fail("shape", "\"sphere\", \"rectangle\" or \"mesh\"");
  object.expectOnly({"name", "shape", "centre", "halfU", "halfV", "material", "radiance"});
  const Rectangle rectangle{tripleOr(object, "centre", {0, 0, 0}), triple(object, "halfU"), triple(object, "halfV")};
  const double u = glm::length(rectangle.halfU), v = glm::length(rectangle.halfV);
  if (!(u >= smallest && v >= smallest) || std::abs(glm::dot(rectangle.halfU, rectangle.halfV)) > 1e-6 * u * v)
    object.fail("halfV", "a side that is perpendicular to halfU, both at least 1e-6 long");
  return rectangle;
}

void SceneReader::readObject(const JsonObject& object) {
  SceneObject result{.name = object.text("name"), .shape = shapeOf(object)};
  if (object.contains("radiance")) {
    if (!std::holds_alternative<Rectangle>(result.shape))
      object.fail("radiance", "no radiance (only rectangles emit light)");
    result.radiance = triple(object, "radiance", false);
  }
  const char* expected = "a material number from 0, \"each\", or {\"diffuse\": [r, g, b]}";
  const nlohmann::json material =
      object.contains("material") ? object.member("material", expected) : nlohmann::json(0u);
  if (material.is_object()) {
    const JsonObject diffuse(material, object.place("material"));
    diffuse.expectOnly({"diffuse"});
    result.material = Diffuse{triple(diffuse, "diffuse", false)};
    if (maxChannel(std::get<Diffuse>(result.material).reflectance) > 1)
      diffuse.fail("diffuse", "a reflectance of at most 1");
  } else if (material.is_number_unsigned()) {
    // With fewer materials than the scene has places for, the last one takes the others.
    result.material = MaterialSlot{int(std::min(material.get<std::uint64_t>(), std::uint64_t(materials_ - 1)))};
  } else if (material != "each") {
    object.fail("material", expected);
  }
  if (material != "each") return scene_.objects.push_back(std::move(result));
  auto* sphere = std::get_if<Sphere>(&result.shape);
  if (!sphere) object.fail("material", "a material other than \"each\" (only a sphere can use \"each\")");
  const double spacing = numberOr(object, "spacing", 0, largest, 2.3 * sphere->radius);
  const Direction middle = sphere->centre;
  for (int i = 0; i < materials_; ++i) {
    sphere->centre = middle + Direction((i - 0.5 * (materials_ - 1)) * spacing, 0, 0);
    result.material = MaterialSlot{i};
    scene_.objects.push_back(result);
    if (materials_ > 1) scene_.objects.back().name += ' ' + std::to_string(i + 1);
  }
}

void SceneReader::readLight(const JsonObject& light) {
  const std::string kind = light.text("kind");
  if (kind == "point") {
    light.expectOnly({"kind", "position", "intensity"});
    scene_.pointLights.push_back({triple(light, "position"), triple(light, "intensity", false)});
  } else if (kind == "directional") {
    light.expectOnly({"kind", "toLight", "irradiance"});
    const Direction way = triple(light, "toLight");
    if (!(glm::length(way) >= smallest)) light.fail("toLight", "a direction, at least 1e-6 long");
    scene_.directionalLights.push_back({glm::normalize(way), triple(light, "irradiance", false)});
  } else {
    light.fail("kind", "\"directional\" or \"point\"");
  }
}

void SceneReader::readEnvironment(const JsonObject& environment) {
  environment.expectOnly({"picture", "rotation", "shown", "blurred"});
  const std::string picture = environment.text("picture");
  if (!folder_ && std::ranges::find(bundledEnvironmentNames(), picture) == bundledEnvironmentNames().end())
    environment.fail("picture", "the name of a bundled environment (a scene read from text cannot refer to files)");
  scene_.environment = openEnvironment(picture, folder_.value_or(""));
  scene_.environmentRotation = radians(numberOr(environment, "rotation", -360, 360, 0));
  scene_.showEnvironment = environment.contains("shown") && environment.flag("shown");
  scene_.blurBackground = environment.contains("blurred") && environment.flag("blurred");
}

void SceneReader::readCamera(const JsonObject& camera) {
  camera.expectOnly({"yaw", "pitch", "distance", "fieldOfView", "target"});
  OrbitCamera& result = scene_.camera;
  result.yaw = radians(numberOr(camera, "yaw", -360, 360, 0));
  result.pitch = radians(numberOr(camera, "pitch", -89, 89, 0));
  result.fieldOfView = radians(numberOr(camera, "fieldOfView", 1, 120, degrees(result.fieldOfView)));
  result.target = tripleOr(camera, "target", {0, 0, 0});
  if (!camera.contains("distance") || camera.member("distance", "") == "fit")
    result.distance = fittingDistance(scene_, result);
  else
    result.distance = camera.number("distance", 1e-3, largest);
}

std::string namesText() {
  std::string text;
  for (const std::string& name : bundledSceneNames()) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// A mesh from disk as its own scene: the bundled one of the shader ball with that mesh in its place.
Scene meshScene(const std::filesystem::path& path, const MeshPose& pose) {
  Scene scene = openScene("shader-ball");
  scene.name = path.stem().string();
  scene.description = "A mesh on the ground";
  scene.objects[0].name = scene.name;
  io::MeshFile file = readUpright(path, pose.up);
  addNotes(path.filename().string(), file, scene);
  scene.objects[0].shape = placedMesh(std::make_shared<const geometry::TriangleMesh>(std::move(file.mesh)), file.origin,
                                      1, pose.quarterTurns * pi / 2, Direction(0), true);
  const geometry::TriangleMesh::Bounds& bounds = std::get<MeshShape>(scene.objects[0].shape)->mesh().bounds();
  scene.camera.target = (bounds.min + bounds.max) / 2.0;
  scene.camera.distance = fittingDistance(scene, scene.camera);
  return scene;
}

}  // namespace

const std::vector<std::string>& bundledSceneNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const BundledScene& scene : bundledScenes()) result.emplace_back(scene.name);
    return result;
  }();
  return names;
}

Scene parseScene(const std::string& text, int materials, const std::optional<std::filesystem::path>& folder) {
  const nlohmann::json json = io::parseJson(text);
  return SceneReader(JsonObject(json, ""), materials, folder).read();
}

namespace {

Scene sceneOfFile(const std::filesystem::path& path, int materials, const MeshPose& pose) {
  if (io::isMeshFile(path)) return meshScene(path, pose);
  Scene scene = withFileInErrors(path, [&] {
    const std::vector<std::byte> bytes = io::FileSource(path).readAll(maxSceneBytes);
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return parseScene(text, materials, path.parent_path());
  });
  scene.name = path.stem().string();
  return scene;
}

}  // namespace

std::string_view upAxisName(UpAxis up) { return up == UpAxis::y ? "y" : "z"; }

UpAxis upAxisOf(std::string_view name) {
  for (const UpAxis up : {UpAxis::y, UpAxis::z})
    if (name == upAxisName(up)) return up;
  throw Error("up axis: found '" + std::string(name) + "', expected y or z");
}

Scene openScene(const std::string& nameOrPath, int materials, const MeshPose& pose) {
  if (pose.up != UpAxis::y && !io::isMeshFile(nameOrPath))
    throw Error(nameOrPath + ": found the up axis " + std::string(upAxisName(pose.up)) + ", expected a mesh file (" +
                io::meshSuffixList() + "); bundled scenes are y up, and scene files state the axis of each mesh");
  Scene scene;
  const std::string_view name =
      nameOrPath == comparisonSceneName ? bundledComparisonScene : std::string_view(nameOrPath);
  const auto bundled = std::ranges::find(bundledScenes(), name, &BundledScene::name);
  if (bundled != bundledScenes().end()) {
    scene = parseScene(std::string(bundled->json), materials);
    scene.name = nameOrPath;
  } else if (std::error_code unreadable; std::filesystem::exists(nameOrPath, unreadable)) {
    scene = sceneOfFile(nameOrPath, materials, pose);
  } else {
    throw Error(nameOrPath + ": found neither a bundled scene (" + namesText() + ") nor a file with this name");
  }
  scene.source = nameOrPath;
  scene.pose = pose;
  return scene;
}

}  // namespace gonio::rendering
