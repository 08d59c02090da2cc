// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/photograph/photograph.h"

#include <algorithm>
#include <cmath>

#include "core/io/byte_source.h"
#include "core/io/image_io.h"
#include "core/io/json_text.h"
#include "core/math/colour.h"
#include "core/photograph/grey_patch.h"
#include "core/photograph/pixel_rows.h"
#include "core/support/error.h"
#include "core/support/json_object.h"
#include "core/support/text.h"

namespace gonio::photograph {

namespace {

constexpr std::size_t maxPhotographs = 64;
constexpr int defaultSide = 256, mostSide = 16384;

Direction numbersOf(const JsonObject& object, std::string_view key, bool mayBeNegative = true) {
  const auto [x, y, z] = object.triple(key, mayBeNegative);
  return {x, y, z};
}

double optionalNumber(const JsonObject& object, std::string_view key, double min, double max, double otherwise) {
  return object.contains(key) ? object.number(key, min, max) : otherwise;
}

/// Where a camera must be to see a surface.
const char* expectedPosition(const Surface& surface) {
  if (std::holds_alternative<Cylinder>(surface))
    return "a point outside of the cylinder: its distance from the axis, in radii, must be above 1";
  if (std::holds_alternative<FlatSample>(surface))
    return "a point in front of the flat sample, where its normal points";
  return "a point outside of the sphere: its distance from the centre, in radii, must be above 1";
}

rendering::OrbitCamera cameraOf(const JsonObject& json, const Surface& surface) {
  json.expectOnly({"position", "lookAt", "fieldOfView"});
  rendering::OrbitCamera camera;
  camera.fieldOfView = radians(optionalNumber(json, "fieldOfView", 1, 120, degrees(camera.fieldOfView)));
  const Direction position = numbersOf(json, "position");
  if (!isOutside(surface, position)) json.fail("position", expectedPosition(surface));
  if (json.contains("lookAt")) {
    if (isSphere(surface)) json.fail("lookAt", "no point: the camera looks at the centre of a sphere");
    camera.target = numbersOf(json, "lookAt");
  }
  const Direction fromTarget = position - camera.target;
  camera.distance = glm::length(fromTarget);
  if (!(camera.distance > 0)) json.fail("lookAt", "another point than the position of the camera");
  camera.yaw = std::atan2(fromTarget.x, fromTarget.z);
  camera.pitch = std::atan2(fromTarget.y, std::hypot(fromTarget.x, fromTarget.z));
  if (std::abs(camera.pitch) > radians(89))
    json.fail("position", "a camera at most 89 degrees above or below the point that it looks at");
  return camera;
}

void readLight(const JsonObject& json, const std::filesystem::path& folder, const Surface& surface, Light& light) {
  json.expectOnly({"environment", "rotation", "toLight", "irradiance", "position", "intensity"});
  if (json.contains("environment")) {
    if (light.environment) json.fail("environment", "one environment per photograph");
    light.environment = rendering::openEnvironment(json.text("environment"), folder);
    light.rotation = radians(optionalNumber(json, "rotation", -360, 360, 0));
  } else if (json.contains("toLight")) {
    light.directional.push_back({readDirection(json, "toLight"), numbersOf(json, "irradiance", false)});
  } else if (json.contains("position")) {
    const Direction position = numbersOf(json, "position");
    if (occupies(surface, position))
      json.fail("position", "a light outside of the " + std::string(surfaceName(surface)) +
                                (std::holds_alternative<FlatSample>(surface) ? "" : ", in radii from its centre"));
    light.points.push_back({position, numbersOf(json, "intensity", false)});
  } else {
    json.fail("environment", "\"environment\", \"toLight\" (a distant light) or \"position\" (a small light)");
  }
}

/// The exponent of a member "gamma"; 0: the sRGB curve.
double gammaOf(const JsonObject& json) {
  const char* expected = "a number from 1 to 4, or \"sRGB\"";
  const nlohmann::json& gamma = json.member("gamma", expected);
  if (gamma == "sRGB") return 0;
  if (!gamma.is_number() || !(gamma.get<double>() >= 1 && gamma.get<double>() <= 4)) json.fail("gamma", expected);
  return gamma.get<double>();
}

/// A PNG or JPEG image, linear by the stated gamma.
Image decodedImage(const std::filesystem::path& path, double gamma) {
  Image image = io::readEncodedImage(path);
  for (glm::vec3& pixel : image.pixels)
    for (int channel = 0; channel < 3; ++channel)
      pixel[channel] = float(gamma == 0 ? fromSrgb(pixel[channel]) : std::pow(double(pixel[channel]), gamma));
  return image;
}

Image linearImage(const JsonObject& json, const std::filesystem::path& path, const GivenImages& given,
                  std::vector<std::string>& warnings) {
  if (const auto found = given.find(json.text("file")); found != given.end()) return found->second;
  const std::string suffix = lowerCase(path.extension().string()), name = path.filename().string();
  if (suffix == ".png" || suffix == ".jpg" || suffix == ".jpeg") {
    if (!json.contains("gamma"))
      throw Error(path.string() +
                  ": found a PNG or JPEG image, which is not linear, expected a linear image (.exr or .hdr), or the "
                  "member \"gamma\"; better develop the camera's raw file without a tone curve");
    const double gamma = gammaOf(json);
    warnings.push_back(name + ": converted to linear values by " +
                       (gamma == 0 ? std::string("the sRGB curve") : "a gamma of " + shortText(gamma)) +
                       "; the tone curve of a camera is another one, so that colours and highlights may be wrong");
    return decodedImage(path, gamma);
  }
  if (json.contains("gamma")) json.fail("gamma", "no gamma: EXR and Radiance HDR images are linear");
  io::ImageFile file = io::readImageFile(path);
  for (const std::string& note : file.notes) warnings.push_back(name + ": " + note);
  return std::move(file.image);
}

GreyPatch greyPatchOf(const JsonObject& json) {
  GreyPatch patch;
  patch.reflectance = json.number("reflectance", 0.01, 1);
  if (json.contains("position")) patch.position = numbersOf(json, "position");
  if (json.contains("sphere")) {
    json.expectOnly({"sphere", "reflectance", "position"});
    const JsonObject disc = json.object("sphere");
    disc.expectOnly({"x", "y", "radius"});
    patch.sphere = {disc.number("x", 0, mostSide), disc.number("y", 0, mostSide),
                    disc.number("radius", matching::minDiscRadius, mostSide)};
    return patch;
  }
  json.expectOnly({"x", "y", "width", "height", "normal", "reflectance", "position"});
  patch.x = json.number("x", 0, mostSide);
  patch.y = json.number("y", 0, mostSide);
  patch.width = json.number("width", 1, mostSide);
  patch.height = json.number("height", 1, mostSide);
  patch.normal = readDirection(json, "normal");
  return patch;
}

matching::Disc discIn(const JsonObject& json, const Photograph& photograph) {
  const glm::ivec2& size = photograph.size;
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

/// The outline of a sphere; of other surfaces, checks that the image shows them. @param camera of the entry.
void placeSurface(const JsonObject& json, const JsonObject& camera, Photograph& photograph) {
  const glm::ivec2& size = photograph.size;
  if (isSphere(photograph.surface)) {
    photograph.disc = discIn(json, photograph);
    const matching::Disc& disc = photograph.disc;
    if (disc.x < 0 || disc.y < 0 || disc.x > size.x || disc.y > size.y || disc.radius < matching::minDiscRadius)
      json.fail("sphere", "an outline with its centre in the image and a radius of at least 8 pixels");
    return;
  }
  if (json.contains("sphere"))
    json.fail("sphere", "no outline beside \"shape\": camera and field of view show where the " +
                            std::string(surfaceName(photograph.surface)) + " is");
  if (!hasUsedPixels(photograph))
    camera.fail("position", "a camera that has the " + std::string(surfaceName(photograph.surface)) + " in its image");
}

/// An entry of "images" or "candidates".
struct Entry {
  std::filesystem::path file;
  Photograph photograph;
};

/// @param reads whether to read the image.
Entry readPhotograph(const JsonObject& json, const std::filesystem::path& folder, bool reads, const GivenImages& given,
                     std::vector<std::string>& warnings) {
  json.expectOnly({"file", "shape", "camera", "sphere", "lights", "clip", "width", "height", "gamma", "greyPatch"});
  Entry entry{.file = folder / json.text("file"), .photograph = {}};
  Photograph& photograph = entry.photograph;
  photograph.name = entry.file.filename().string();
  photograph.surface = readSurface(json);
  const JsonObject camera = json.object("camera");
  photograph.camera = cameraOf(camera, photograph.surface);
  const nlohmann::json& lights = json.array("lights");
  for (std::size_t i = 0; i < lights.size(); ++i)
    readLight(JsonObject(lights[i], json.place("lights[" + std::to_string(i) + "]")), folder, photograph.surface,
              photograph.light);
  if (lights.empty()) json.fail("lights", "at least one light");
  photograph.size = {int(optionalNumber(json, "width", 16, mostSide, defaultSide)),
                     int(optionalNumber(json, "height", 16, mostSide, defaultSide))};
  if (reads) {
    photograph.image = linearImage(json, entry.file, given, warnings);
    photograph.size = {photograph.image.width, photograph.image.height};
  }
  placeSurface(json, camera, photograph);
  if (reads) photograph.clip = clippedFrom(photograph);
  if (reads && json.contains("gamma")) photograph.clip = std::min(photograph.clip, 1.0);  // the largest stored value
  if (json.contains("clip")) photograph.clip = json.number("clip", 0, JsonObject::maxOfTriple);
  if (reads && !json.contains("clip") && !json.contains("gamma") && std::isfinite(photograph.clip))
    warnings.push_back(photograph.name + ": many pixels have the largest value, " + numberText(photograph.clip) +
                       "; they count as clipped and are not used");
  return entry;
}

/// Divides all images by the exposure that grey patches show. @param exposures of each.
void applyExposure(const std::vector<Rgb>& exposures, PhotographSet& set) {
  Rgb sum(0), least = exposures[0], most = exposures[0];
  for (const Rgb& exposure : exposures) {
    sum += glm::log(exposure) / double(exposures.size());
    least = glm::min(least, exposure);
    most = glm::max(most, exposure);
  }
  constexpr double like = 1.05;
  if (maxChannel(most / least) > like)
    set.warnings.push_back("the grey patches of the images show exposures that differ by up to " +
                           shortText(100 * (maxChannel(most / least) - 1), 2) + " %; their mean is used");
  set.exposure = glm::exp(sum);
  for (Photograph& photograph : set.photographs) {
    for (glm::vec3& pixel : photograph.image.pixels) pixel /= glm::vec3(set.exposure);
    photograph.clip /= maxChannel(set.exposure);
  }
}

}  // namespace

matching::Disc discOf(const rendering::OrbitCamera& camera, int width, int height) {
  const double tangent = 1 / std::sqrt(camera.distance * camera.distance - 1);
  return {0.5 * width, 0.5 * height, 0.5 * std::min(width, height) * tangent / std::tan(camera.fieldOfView / 2)};
}

double clippedFrom(const Photograph& photograph) {
  const SurfaceView view(photograph);
  const Image& image = photograph.image;
  float largest = 0;
  std::size_t inside = 0, equal = 0;
  for (const bool counts : {false, true})
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        if (!view.shows({x + 0.5, y + 0.5})) continue;
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

PhotographDescription parseDescription(const std::string& text, const std::filesystem::path& folder, bool images,
                                       const GivenImages& given) {
  const nlohmann::json json = io::parseJson(text);
  const JsonObject root(json, "");
  if (root.text("format") != "gonio photographs") root.fail("format", "\"gonio photographs\"");
  if (root.number("version", 1, 1e6) != 1) root.fail("version", "1, the only version that this program reads");
  root.expectOnly({"format", "version", "exposure", "images", "candidates"});
  PhotographDescription result;
  if (root.contains("exposure")) {
    const std::string exposure = root.text("exposure");
    if (exposure != "known" && exposure != "unknown") root.fail("exposure", "\"known\" or \"unknown\"");
    result.set.exposureKnown = exposure == "known";
  }
  const nlohmann::json& list = root.array("images");
  if (list.empty() || list.size() > maxPhotographs) root.fail("images", "1 to 64 images");
  std::vector<Rgb> exposures;
  const bool isStatedKnown = root.contains("exposure") && result.set.exposureKnown;
  bool hasPatch = false;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const JsonObject image(list[i], "images[" + std::to_string(i) + "]");
    Entry entry = readPhotograph(image, folder, images, given, result.set.warnings);
    if (image.contains("greyPatch")) {
      const GreyPatch patch = greyPatchOf(image.object("greyPatch"));
      if (isStatedKnown) root.fail("exposure", "\"unknown\", or no exposure, beside a grey patch, which shows it");
      hasPatch = true;
      if (images) exposures.push_back(exposureOf(entry.photograph, patch, result.set.warnings));
    }
    result.files.push_back(std::move(entry.file));
    result.set.photographs.push_back(std::move(entry.photograph));
  }
  if (hasPatch) result.set.exposureKnown = true;
  if (!exposures.empty()) applyExposure(exposures, result.set);
  if (!root.contains("candidates")) return result;
  const nlohmann::json& candidates = root.array("candidates");
  if (candidates.size() > maxPhotographs) root.fail("candidates", "at most 64 images");
  for (std::size_t i = 0; i < candidates.size(); ++i)
    result.candidates.push_back(readPhotograph(JsonObject(candidates[i], "candidates[" + std::to_string(i) + "]"),
                                               folder, false, given, result.set.warnings)
                                    .photograph);
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
  if (!isSphere(photograph.surface)) {
    scene.objects[0] = {.name = std::string(surfaceName(photograph.surface)),
                        .shape = renderedShape(photograph.surface)};
    return scene;
  }
  const double tangent = 1 / std::sqrt(photograph.camera.distance * photograph.camera.distance - 1);
  scene.camera.fieldOfView = 2 * std::atan(0.5 * std::min(width, height) * tangent / photograph.disc.radius);
  return scene;
}

}  // namespace gonio::photograph
