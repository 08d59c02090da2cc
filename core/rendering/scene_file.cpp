// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/scene_file.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/bundled_meshes.h"
#include "core/io/byte_source.h"
#include "core/io/obj_file.h"
#include "core/rendering/bundled_scenes.h"
#include "core/rendering/environment_file.h"
#include "core/support/json_object.h"
#include "core/support/naming_file.h"

namespace gonio {

namespace {

constexpr double largest = 1e6;  ///< coordinate, radiance
constexpr std::uint64_t maxSceneBytes = std::uint64_t(1) << 24;
constexpr int maxObjects = 256;

Direction triple(const JsonObject& object, std::string_view key, double min = -largest) {
  const std::string expected = std::string("three numbers from ") + (min < 0 ? "-1e6" : "0") + " to 1e6, as [1, 2, 3]";
  const nlohmann::json& found = object.member(key, expected);
  if (!found.is_array() || found.size() != 3) object.fail(key, expected);
  Direction result;
  for (int i = 0; i < 3; ++i) {
    if (!found[std::size_t(i)].is_number()) object.fail(key, expected);
    result[i] = found[std::size_t(i)].get<double>();
    if (!(result[i] >= min && result[i] <= largest)) object.fail(key, expected);
  }
  return result;
}

Direction tripleOr(const JsonObject& object, std::string_view key, const Direction& otherwise) {
  return object.contains(key) ? triple(object, key) : otherwise;
}

double numberOr(const JsonObject& object, std::string_view key, double min, double max, double otherwise) {
  return object.contains(key) ? object.number(key, min, max) : otherwise;
}

/// Reads one scene: a part of the file a function.
class SceneReader {
 public:
  SceneReader(const JsonObject& root, int materials, std::filesystem::path folder)
      : root_(root), materials_(materials), folder_(std::move(folder)) {}

  Scene read();

 private:
  void readObject(const JsonObject& object);
  Shape shapeOf(const JsonObject& object) const;
  Shape meshOf(const JsonObject& object) const;
  void readLight(const JsonObject& light);
  void readEnvironment(const JsonObject& environment);
  void readCamera(const JsonObject& camera);
  double fittingDistance(const OrbitCamera& camera) const;

  const JsonObject& root_;
  int materials_;
  std::filesystem::path folder_;
  Scene scene_;
};

Scene SceneReader::read() {
  if (root_.text("format") != "gonio scene") root_.fail("format", "\"gonio scene\"");
  if (root_.number("version", 1, 1e6) != 1) root_.fail("version", "1, the only version that this program reads");
  if (root_.contains("description")) scene_.description = root_.text("description");
  const nlohmann::json none = nlohmann::json::array();
  const auto each = [&](const char* key, auto read) {
    const nlohmann::json& list = root_.contains(key) ? root_.array(key) : none;
    if (list.size() > maxObjects) root_.fail(key, "at most 256");
    for (std::size_t i = 0; i < list.size(); ++i)
      read(JsonObject(list[i], std::string(key) + "[" + std::to_string(i) + "]"));
  };
  each("objects", [&](const JsonObject& object) { readObject(object); });
  each("lights", [&](const JsonObject& light) { readLight(light); });
  if (root_.contains("environment")) readEnvironment(root_.object("environment"));
  if (root_.contains("camera")) readCamera(root_.object("camera"));
  return std::move(scene_);
}

Shape SceneReader::meshOf(const JsonObject& object) const {
  const std::string name = object.text("mesh");
  const bool isFile = std::filesystem::path(name).extension() == ".obj";
  std::shared_ptr<const TriangleMesh> mesh =
      isFile ? std::make_shared<const TriangleMesh>(io::readObj(folder_ / name)) : bundledMesh(name);
  double scale = numberOr(object, "scale", 1e-6, largest, 1);
  Direction translation = tripleOr(object, "centre", {0, 0, 0});
  if (object.contains("fit") && object.flag("fit")) {
    // Into the unit sphere about `centre`, on the plane one below it.
    scale /= mesh->boundingSphere().radius;
    const Direction middle = mesh->boundingSphere().centre;
    translation -= scale * Direction(middle.x, mesh->bounds().min.y, middle.z) + Direction(0, 1, 0);
  }
  const glm::dmat4 placed = placement(scale, radians(numberOr(object, "turn", -360, 360, 0)), translation);
  if (placed != glm::dmat4(1)) mesh = std::make_shared<const TriangleMesh>(transformed(*mesh, placed));
  return std::make_shared<const MeshIntersector>(std::move(mesh));
}

Shape SceneReader::shapeOf(const JsonObject& object) const {
  const std::string kind = object.text("shape");
  if (kind == "sphere")
    return Sphere{tripleOr(object, "centre", {0, 0, 0}), numberOr(object, "radius", 1e-6, largest, 1)};
  if (kind == "mesh") return meshOf(object);
  if (kind != "rectangle") object.fail("shape", "\"sphere\", \"rectangle\" or \"mesh\"");
  const Rectangle rectangle{tripleOr(object, "centre", {0, 0, 0}), triple(object, "halfU"), triple(object, "halfV")};
  const double u = glm::length(rectangle.halfU), v = glm::length(rectangle.halfV);
  if (!(u > 0 && v > 0) || std::abs(glm::dot(rectangle.halfU, rectangle.halfV)) > 1e-6 * u * v)
    object.fail("halfV", "a side that is perpendicular to halfU, neither of length 0");
  return rectangle;
}

void SceneReader::readObject(const JsonObject& object) {
  SceneObject result{.name = object.text("name"), .shape = shapeOf(object)};
  if (object.contains("radiance")) {
    if (!std::holds_alternative<Rectangle>(result.shape)) object.fail("radiance", "none: only a rectangle emits");
    result.radiance = triple(object, "radiance", 0);
  }
  const char* expected = "a number of a material from 0, \"each\", or {\"diffuse\": [r, g, b]}";
  const nlohmann::json material = object.contains("material") ? object.member("material", expected) : nlohmann::json(0);
  if (material.is_object()) {
    const JsonObject diffuse(material, object.place("material"));
    result.material = Diffuse{triple(diffuse, "diffuse", 0)};
    if (maxChannel(std::get<Diffuse>(result.material).reflectance) > 1)
      diffuse.fail("diffuse", "a reflectance of at most 1");
  } else if (material.is_number_integer() && material.get<int>() >= 0) {
    // With fewer materials than the scene has places for, the last one takes the others.
    result.material = LookedAt{std::min(material.get<int>(), materials_ - 1)};
  } else if (material != "each") {
    object.fail("material", expected);
  }
  if (material != "each") return scene_.objects.push_back(std::move(result));
  auto* sphere = std::get_if<Sphere>(&result.shape);
  if (!sphere) object.fail("material", "\"each\" for a sphere alone");
  const double spacing = numberOr(object, "spacing", 0, largest, 2.3 * sphere->radius);
  const Direction middle = sphere->centre;
  for (int i = 0; i < materials_; ++i) {
    sphere->centre = middle + Direction((i - 0.5 * (materials_ - 1)) * spacing, 0, 0);
    result.material = LookedAt{i};
    scene_.objects.push_back(result);
    if (materials_ > 1) scene_.objects.back().name += ' ' + std::to_string(i + 1);
  }
}

void SceneReader::readLight(const JsonObject& light) {
  const std::string kind = light.text("kind");
  if (kind == "point") {
    scene_.pointLights.push_back({triple(light, "position"), triple(light, "intensity", 0)});
  } else if (kind == "directional") {
    const Direction way = triple(light, "toLight");
    if (!(glm::length(way) > 0)) light.fail("toLight", "a direction, not of length 0");
    scene_.directionalLights.push_back({glm::normalize(way), triple(light, "irradiance", 0)});
  } else {
    light.fail("kind", "\"directional\" or \"point\"");
  }
}

void SceneReader::readEnvironment(const JsonObject& environment) {
  scene_.environment = openEnvironment(environment.text("picture"), folder_);
  scene_.environmentRotation = radians(numberOr(environment, "rotation", -360, 360, 0));
  scene_.showEnvironment = environment.contains("shown") && environment.flag("shown");
}

/// From where all that is looked at fits into a square picture.
double SceneReader::fittingDistance(const OrbitCamera& camera) const {
  const CameraFrame frame = cameraFrame(camera);
  double distance = 0;
  for (const SceneObject& object : scene_.objects) {
    if (object.emits() || !std::holds_alternative<LookedAt>(object.material)) continue;
    const Sphere bound = boundingSphere(object.shape);
    const Direction offset = bound.centre - camera.target;
    const double across = std::hypot(glm::dot(offset, frame.right), glm::dot(offset, frame.up));
    const double halfAngle = camera.fieldOfView / 2;
    distance = std::max(distance, across / std::tan(halfAngle) + 1.08 * bound.radius / std::sin(halfAngle) -
                                      glm::dot(offset, frame.forward));
  }
  return distance > 0 ? distance : camera.distance;
}

void SceneReader::readCamera(const JsonObject& camera) {
  OrbitCamera& result = scene_.camera;
  result.yaw = radians(numberOr(camera, "yaw", -360, 360, 0));
  result.pitch = radians(numberOr(camera, "pitch", -89, 89, 0));
  result.fieldOfView = radians(numberOr(camera, "fieldOfView", 1, 120, degrees(result.fieldOfView)));
  result.target = tripleOr(camera, "target", {0, 0, 0});
  if (!camera.contains("distance") || camera.member("distance", "") == "fit")
    result.distance = fittingDistance(result);
  else
    result.distance = camera.number("distance", 1e-3, largest);
}

std::string namesText() {
  std::string text;
  for (const std::string& name : bundledSceneNames()) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// A mesh from disk as its own scene: the bundled one of the shader ball with that mesh in its place.
Scene meshScene(const std::filesystem::path& path, int materials) {
  const auto found = std::ranges::find(bundledScenes(), std::string_view("shader-ball"), &BundledScene::name);
  nlohmann::json json = nlohmann::json::parse(found->json);
  nlohmann::json& object = json["objects"][0];
  object["name"] = path.stem().string();
  object["mesh"] = std::filesystem::absolute(path).string();
  object["fit"] = true;
  json["description"] = "A mesh on the ground in the studio";
  Scene scene = parseScene(json.dump(), materials);
  scene.name = path.stem().string();
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

Scene parseScene(const std::string& text, int materials, const std::filesystem::path& folder) {
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception& error) {
    throw Error(std::string("found no JSON (") + error.what() + "), expected a scene");
  }
  return SceneReader(JsonObject(json, ""), materials, folder).read();
}

Scene openScene(const std::string& nameOrPath, int materials) {
  for (const BundledScene& bundled : bundledScenes())
    if (nameOrPath == bundled.name) {
      Scene scene = parseScene(std::string(bundled.json), materials);
      scene.name = nameOrPath;
      return scene;
    }
  const std::filesystem::path path(nameOrPath);
  if (!std::filesystem::exists(path))
    throw Error(nameOrPath + ": found neither a scene of this name (" + namesText() + ") nor a file");
  if (path.extension() == ".obj") return meshScene(path, materials);
  Scene scene = namingFile(path, [&] {
    const std::vector<std::byte> bytes = io::FileSource(path).readAll(maxSceneBytes);
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return parseScene(text, materials, path.parent_path());
  });
  scene.name = path.stem().string();
  return scene;
}

}  // namespace gonio
