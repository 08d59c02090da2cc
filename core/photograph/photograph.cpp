// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/photograph/photograph.h"

#include <algorithm>
#include <cmath>

#include "core/io/byte_source.h"
#include "core/io/image_io.h"
#include "core/io/json_text.h"
#include "core/support/error.h"
#include "core/support/json_object.h"
#include "core/support/text.h"

namespace gonio::photograph {

namespace {

constexpr std::uint64_t maxDescriptionBytes = std::uint64_t(1) << 24;
constexpr std::size_t maxPhotographs = 64;
constexpr int defaultSide = 256, mostSide = 16384;

Direction numbersOf(const JsonObject& object, std::string_view key, bool mayBeNegative = true) {
  const auto [x, y, z] = object.triple(key, mayBeNegative);
  return {x, y, z};
}

double optionalNumber(const JsonObject& object, std::string_view key, double min, double max, double otherwise) {
  return object.contains(key) ? object.number(key, min, max) : otherwise;
}

rendering::OrbitCamera cameraOf(const JsonObject& json) {
  json.expectOnly({"position", "fieldOfView"});
  rendering::OrbitCamera camera;
  camera.fieldOfView = radians(optionalNumber(json, "fieldOfView", 1, 120, degrees(camera.fieldOfView)));
  const Direction position = numbersOf(json, "position");
  camera.distance = glm::length(position);
  if (!(camera.distance > 1))
    json.fail("position", "a point outside of the sphere: its distance from the centre, in radii, must be above 1");
  camera.yaw = std::atan2(position.x, position.z);
  camera.pitch = std::atan2(position.y, std::hypot(position.x, position.z));
  if (std::abs(camera.pitch) > radians(89))
    json.fail("position", "a camera at most 89 degrees above or below the sphere");
  return camera;
}

void readLight(const JsonObject& json, const std::filesystem::path& folder, Light& light) {
  json.expectOnly({"environment", "rotation", "toLight", "irradiance", "position", "intensity"});
  if (json.contains("environment")) {
    if (light.environment) json.fail("environment", "one environment per photograph");
    light.environment = rendering::openEnvironment(json.text("environment"), folder);
    light.rotation = radians(optionalNumber(json, "rotation", -360, 360, 0));
  } else if (json.contains("toLight")) {
    const Direction toLight = numbersOf(json, "toLight");
    if (!(glm::length(toLight) > 0)) json.fail("toLight", "a direction, not [0, 0, 0]");
    light.directional.push_back({glm::normalize(toLight), numbersOf(json, "irradiance", false)});
  } else if (json.contains("position")) {
    const Direction position = numbersOf(json, "position");
    if (!(glm::length(position) > 1)) json.fail("position", "a light outside of the sphere, in radii from its centre");
    light.points.push_back({position, numbersOf(json, "intensity", false)});
  } else {
    json.fail("environment", "\"environment\", \"toLight\" (a distant light) or \"position\" (a small light)");
  }
}

Image linearImage(const std::filesystem::path& path, std::vector<std::string>& warnings) {
  const std::string suffix = lowerCase(path.extension().string());
  if (suffix == ".png" || suffix == ".jpg" || suffix == ".jpeg")
    throw Error(path.string() +
                ": found a PNG or JPEG image, which is not linear, expected a linear image (.exr or .hdr); develop the "
                "camera's raw file without a tone curve");
  io::ImageFile file = io::readImageFile(path);
  for (const std::string& note : file.notes) warnings.push_back(path.filename().string() + ": " + note);
  return std::move(file.image);
}

matching::Disc discIn(const JsonObject& json, const Photograph& photograph, const glm::ivec2& size) {
  if (!json.contains("sphere")) return discOf(photograph.camera, size.x, size.y);
  const char* expected = "\"find\", or {\"x\": .., \"y\": .., \"radius\": ..} in pixels";
  const nlohmann::json& sphere = json.member("sphere", expected);
  if (sphere == "find") {
    if (photograph.image.pixels.empty()) return discOf(photograph.camera, size.x, size.y);
    return matching::findSphere(photograph.image);
  }
  if (!sphere.is_object()) json.fail("sphere", expected);
  const JsonObject disc = json.object("sphere");
  disc.expectOnly({"x", "y", "radius"});
  return {disc.number("x", 0, size.x), disc.number("y", 0, size.y),
          disc.number("radius", matching::minDiscRadius, std::max(size.x, size.y))};
}

/// Reads one entry of "images".
void readPhotograph(const JsonObject& json, const std::filesystem::path& folder, bool reads,
                    PhotographDescription& result) {
  json.expectOnly({"file", "camera", "sphere", "lights", "clip", "width", "height"});
  Photograph photograph;
  const std::filesystem::path file = folder / json.text("file");
  photograph.name = file.filename().string();
  photograph.camera = cameraOf(json.object("camera"));
  const nlohmann::json& lights = json.array("lights");
  for (std::size_t i = 0; i < lights.size(); ++i)
    readLight(JsonObject(lights[i], json.place("lights[" + std::to_string(i) + "]")), folder, photograph.light);
  if (lights.empty()) json.fail("lights", "at least one light");
  glm::ivec2 size(int(optionalNumber(json, "width", 16, mostSide, defaultSide)),
                  int(optionalNumber(json, "height", 16, mostSide, defaultSide)));
  if (reads) {
    photograph.image = linearImage(file, result.set.warnings);
    size = {photograph.image.width, photograph.image.height};
  }
  photograph.disc = discIn(json, photograph, size);
  const matching::Disc& disc = photograph.disc;
  if (disc.x < 0 || disc.y < 0 || disc.x > size.x || disc.y > size.y || disc.radius < matching::minDiscRadius)
    json.fail("sphere", "an outline with its centre in the image and a radius of at least 8 pixels");
  if (reads) photograph.clip = clippedFrom(photograph.image, photograph.disc);
  if (json.contains("clip")) photograph.clip = json.number("clip", 0, JsonObject::maxOfTriple);
  if (reads && !json.contains("clip") && std::isfinite(photograph.clip))
    result.set.warnings.push_back(photograph.name + ": many pixels have the largest value, " +
                                  numberText(photograph.clip) + "; they count as clipped and are not used");
  result.files.push_back(file);
  result.sizes.push_back(size);
  result.set.photographs.push_back(std::move(photograph));
}

}  // namespace

matching::Disc discOf(const rendering::OrbitCamera& camera, int width, int height) {
  const double tangent = 1 / std::sqrt(camera.distance * camera.distance - 1);
  return {0.5 * width, 0.5 * height, 0.5 * std::min(width, height) * tangent / std::tan(camera.fieldOfView / 2)};
}

double clippedFrom(const Image& image, const matching::Disc& disc) {
  float largest = 0;
  std::size_t inside = 0, equal = 0;
  for (const bool counts : {false, true})
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        if (std::hypot(x + 0.5 - disc.x, y + 0.5 - disc.y) > disc.radius) continue;
        const glm::vec3& pixel = image.at(x, y);
        const float value = std::max({pixel.x, pixel.y, pixel.z});
        if (!std::isfinite(value)) continue;
        if (counts) {
          ++inside;
          equal += value == largest;
        } else {
          largest = std::max(largest, value);
        }
      }
  return equal >= 4 && double(equal) >= 1e-3 * double(inside) ? double(largest)
                                                              : std::numeric_limits<double>::infinity();
}

PhotographDescription parseDescription(const std::string& text, const std::filesystem::path& folder, bool images) {
  const nlohmann::json json = io::parseJson(text);
  const JsonObject root(json, "");
  if (root.text("format") != "gonio photographs") root.fail("format", "\"gonio photographs\"");
  if (root.number("version", 1, 1e6) != 1) root.fail("version", "1, the only version that this program reads");
  root.expectOnly({"format", "version", "exposure", "images"});
  PhotographDescription result;
  if (root.contains("exposure")) {
    const std::string exposure = root.text("exposure");
    if (exposure != "known" && exposure != "unknown") root.fail("exposure", "\"known\" or \"unknown\"");
    result.set.exposureKnown = exposure == "known";
  }
  const nlohmann::json& list = root.array("images");
  if (list.empty() || list.size() > maxPhotographs) root.fail("images", "1 to 64 images");
  for (std::size_t i = 0; i < list.size(); ++i)
    readPhotograph(JsonObject(list[i], "images[" + std::to_string(i) + "]"), folder, images, result);
  return result;
}

PhotographDescription readDescription(const std::filesystem::path& path, bool images) {
  return withFileInErrors(path, [&] {
    const std::vector<std::byte> bytes = io::FileSource(path).readAll(maxDescriptionBytes);
    return parseDescription({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path.parent_path(), images);
  });
}

rendering::Scene sceneOf(const Photograph& photograph, int width, int height) {
  rendering::Scene scene = rendering::sphereScene(photograph.light.environment, photograph.camera);
  scene.environmentRotation = photograph.light.rotation;
  scene.directionalLights = photograph.light.directional;
  scene.pointLights = photograph.light.points;
  const double tangent = 1 / std::sqrt(photograph.camera.distance * photograph.camera.distance - 1);
  scene.camera.fieldOfView = 2 * std::atan(0.5 * std::min(width, height) * tangent / photograph.disc.radius);
  return scene;
}

}  // namespace gonio::photograph
