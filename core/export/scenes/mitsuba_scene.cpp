// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/export_files.h"
#include "core/export/scenes/scene_files.h"
#include "core/support/text.h"

namespace gonio::exports {

namespace {

std::string valueLine(const char* type, const char* name, const std::string& value) {
  return std::string("<") + type + " name=\"" + name + "\" value=\"" + value + "\"/>\n";
}

std::string xyz(const char* type, const char* name, const Direction& v) {
  return std::string("<") + type + " name=\"" + name + "\" x=\"" + sixDigitText(v.x) + "\" y=\"" + sixDigitText(v.y) +
         "\" z=\"" + sixDigitText(v.z) + "\"/>\n";
}

std::string fileLine(const std::string& file) { return valueLine("string", "filename", xmlText(file)); }

std::string mitsubaSensor(const rendering::OrbitCamera& view) {
  const rendering::CameraFrame camera = rendering::cameraFrame(view);
  std::string text = camera.orthographic ? "  <sensor type=\"orthographic\">\n"
                                         : "  <sensor type=\"perspective\">\n    <string name=\"fov_axis\" "
                                           "value=\"smaller\"/>\n    " +
                                               valueLine("float", "fov", sixDigitText(degrees(view.fieldOfView)));
  const std::string extent = sixDigitText(camera.halfExtent);
  text += "    <transform name=\"to_world\">\n";
  if (camera.orthographic) text += "      <scale x=\"" + extent + "\" y=\"" + extent + "\"/>\n";
  text += "      <lookat origin=\"" + colourText(camera.eye) + "\" target=\"" +
          colourText(camera.eye + camera.forward) + "\" up=\"" + colourText(camera.up) + "\"/>\n    </transform>\n";
  text += "    <sampler type=\"independent\">" +
          valueLine("integer", "sample_count", std::to_string(scenePictureSamples)) + "    </sampler>\n";
  text += "    <film type=\"hdrfilm\">\n      " + valueLine("integer", "width", std::to_string(scenePixels)) +
          "      " + valueLine("integer", "height", std::to_string(scenePixels)) +
          "      <rfilter type=\"box\"/>\n    </film>\n  </sensor>\n";
  return text;
}

/// Mitsuba's picture has +z where Gonio's has -z.
std::string mitsubaEnvironment(const rendering::Scene& scene, const std::string& file) {
  return "  <emitter type=\"envmap\">\n    " + fileLine(file) +
         "    <transform name=\"to_world\"><rotate y=\"1\" angle=\"" +
         sixDigitText(180 - degrees(scene.environmentRotation)) + "\"/></transform>\n  </emitter>\n";
}

std::string mitsubaLights(const rendering::Scene& scene) {
  std::string text;
  for (const rendering::DirectionalLight& light : scene.directionalLights)
    text += "  <emitter type=\"directional\">\n    " + xyz("vector", "direction", -light.toLight) + "    " +
            valueLine("rgb", "irradiance", colourText(light.irradiance)) + "  </emitter>\n";
  for (const rendering::PointLight& light : scene.pointLights)
    text += "  <emitter type=\"point\">\n    " + xyz("point", "position", light.position) + "    " +
            valueLine("rgb", "intensity", colourText(light.intensity)) + "  </emitter>\n";
  return text;
}

/// The sphere has its poles at z in Mitsuba, at y in Gonio.
std::string mitsubaSphere(const rendering::Sphere& sphere) {
  return "  <shape type=\"sphere\">\n    <transform name=\"to_world\"><rotate x=\"1\" angle=\"-90\"/><scale value=\"" +
         sixDigitText(sphere.radius) + "\"/><translate x=\"" + sixDigitText(sphere.centre.x) + "\" y=\"" +
         sixDigitText(sphere.centre.y) + "\" z=\"" + sixDigitText(sphere.centre.z) + "\"/></transform>\n";
}

/// [-1, 1]^2 with +z as its front goes to the rectangle.
std::string mitsubaRectangle(const rendering::Rectangle& rectangle) {
  const Direction n = rectangle.normal();
  std::string matrix;
  for (int row = 0; row < 3; ++row)
    for (const double value : {rectangle.halfU[row], rectangle.halfV[row], n[row], rectangle.centre[row]})
      matrix += sixDigitText(value) + " ";
  return "  <shape type=\"rectangle\">\n    <transform name=\"to_world\"><matrix value=\"" + matrix +
         "0 0 0 1\"/></transform>\n";
}

std::string mitsubaShape(const rendering::SceneObject& object, const std::string& mesh) {
  if (const auto* sphere = std::get_if<rendering::Sphere>(&object.shape)) return mitsubaSphere(*sphere);
  if (const auto* rectangle = std::get_if<rendering::Rectangle>(&object.shape)) return mitsubaRectangle(*rectangle);
  return "  <shape type=\"ply\">\n    " + fileLine(mesh);
}

std::string mitsubaSurface(const rendering::SceneObject& object) {
  if (object.emits())
    return "    <bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0\"/></bsdf>\n    <emitter type=\"area\">" +
           valueLine("rgb", "radiance", colourText(object.radiance)) + "    </emitter>\n";
  if (const auto* diffuse = std::get_if<rendering::Diffuse>(&object.material))
    return "    <bsdf type=\"diffuse\">" + valueLine("rgb", "reflectance", colourText(diffuse->reflectance)) +
           "    </bsdf>\n";
  return "    <ref id=\"material\"/>\n";
}

std::string mitsubaText(const rendering::Scene& scene, const SceneFileNames& files) {
  const bool hides = scene.environment && !scene.showEnvironment;
  std::string text = "<scene version=\"3.0.0\">\n  <integrator type=\"path\">" +
                     valueLine("boolean", "hide_emitters", hides ? "true" : "false") + "  </integrator>\n";
  text += mitsubaSensor(scene.camera);
  text += "  <bsdf type=\"measured\" id=\"material\">" + fileLine(files.material) + "  </bsdf>\n";
  if (scene.environment) text += mitsubaEnvironment(scene, files.environment);
  text += mitsubaLights(scene);
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    text += mitsubaShape(scene.objects[i], files.meshes[i]) + mitsubaSurface(scene.objects[i]) + "  </shape>\n";
  return text + "</scene>\n";
}

}  // namespace

const SceneFormat& mitsubaSceneFormat() {
  // A $ begins a parameter. Recent versions read \$ as $, others as both characters.
  static const SceneFormat format{
      .textSuffix = "_scene.xml",
      .environmentSuffix = "_environment.exr",
      .materialSuffix = "_rgb.bsdf",
      .excludedCharacters = "$",
      .text = mitsubaText,
      .environment = [](const rendering::Scene& scene) { return scene.environment->image(); }};
  return format;
}

}  // namespace gonio::exports
