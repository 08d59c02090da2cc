// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <cmath>

#include "core/export/export_files.h"
#include "core/export/scenes/scene_files.h"

namespace gonio::exports {

namespace {

/// The components separated by spaces, e.g. "1 2 3".
std::string spaced(const Direction& v) { return colourText(v, " "); }

/// Clarberg 2008: a position in [0, 1]^2 to the sphere; areas are proportional.
Direction octahedralDirection(double x, double y) {
  const double u = 2 * x - 1, v = 2 * y - 1, along = std::abs(u), across = std::abs(v);
  const double distance = 1 - (along + across), r = 1 - std::abs(distance);
  const double phi = (r > 0 ? (across - along) / r + 1 : 1) * pi / 4;
  const double sine = r * std::sqrt(2 - r * r);
  return {std::copysign(std::cos(phi), u) * sine, std::copysign(std::sin(phi), v) * sine,
          std::copysign(1 - r * r, distance)};
}

std::string bracketed(const std::string& values) { return " [ " + values + " ]"; }

/// A string, in which a backslash precedes quotes and backslashes.
std::string pbrtString(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

/// pbrt's cameras are left-handed: the first line mirrors the camera alone.
std::string pbrtCamera(const rendering::OrbitCamera& view) {
  const rendering::CameraFrame camera = rendering::cameraFrame(view);
  const std::string e = sixDigitText(camera.halfExtent);
  return "Scale -1 1 1\nLookAt " + spaced(camera.eye) + "  " + spaced(camera.eye + camera.forward) + "  " +
         spaced(camera.up) + "\nCamera " +
         (camera.orthographic
              ? "\"orthographic\" \"float screenwindow\"" + bracketed("-" + e + " " + e + " -" + e + " " + e)
              : "\"perspective\" \"float fov\"" + bracketed(sixDigitText(degrees(view.fieldOfView)))) +
         "\n";
}

/// @param hides whether the picture should not show the environment: pbrt always shows it and its films have no alpha,
/// so the picture gets the normals, by which a program can mask it.
std::string pbrtFilm(const std::string& name, bool hides) {
  const std::string pixels = bracketed(std::to_string(scenePixels));
  const std::string film = hides ? "# Pixels whose channels Ns.X, Ns.Y and Ns.Z are 0 show the environment behind the "
                                   "scene, which Gonio hides.\nFilm \"gbuffer\""
                                 : "Film \"rgb\"";
  return film + " \"integer xresolution\"" + pixels + " \"integer yresolution\"" + pixels + " \"string filename\" " +
         pbrtString(name + "_pbrt.exr") + "\nPixelFilter \"box\"\nSampler \"independent\" \"integer " +
         "pixelsamples\"" + bracketed(std::to_string(scenePictureSamples)) + "\nIntegrator \"path\"\n\nWorldBegin\n";
}

std::string pbrtLights(const rendering::Scene& scene) {
  std::string text;
  for (const rendering::DirectionalLight& light : scene.directionalLights)
    text += "LightSource \"distant\" \"point3 from\"" + bracketed(spaced(light.toLight)) +
            " \"point3 to\" [ 0 0 0 ] \"rgb L\"" + bracketed(spaced(light.irradiance)) + "\n";
  for (const rendering::PointLight& light : scene.pointLights)
    text += "LightSource \"point\" \"point3 from\"" + bracketed(spaced(light.position)) + " \"rgb I\"" +
            bracketed(spaced(light.intensity)) + "\n";
  return text;
}

/// The sphere has its poles at z in pbrt, at y in Gonio.
std::string pbrtShape(const rendering::SceneObject& object, const std::string& mesh) {
  if (const auto* sphere = std::get_if<rendering::Sphere>(&object.shape))
    return "  Translate " + spaced(sphere->centre) + "\n  Rotate -90 1 0 0\n  Shape \"sphere\" \"float radius\"" +
           bracketed(sixDigitText(sphere->radius)) + "\n";
  if (const auto* rectangle = std::get_if<rendering::Rectangle>(&object.shape)) {
    std::string corners;
    for (const double v : {-1.0, 1.0})
      for (const double u : {-1.0, 1.0}) corners += (corners.empty() ? "" : "  ") + spaced(rectangle->at(u, v));
    return "  Shape \"bilinearmesh\" \"point3 P\"" + bracketed(corners) + "\n";
  }
  return "  Shape \"plymesh\" \"string filename\" " + pbrtString(mesh) + "\n";
}

std::string pbrtSurface(const rendering::SceneObject& object) {
  if (object.emits())
    return "  Material \"diffuse\" \"rgb reflectance\" [ 0 0 0 ]\n  AreaLightSource \"diffuse\" \"rgb L\"" +
           bracketed(spaced(object.radiance)) + "\n";
  if (const auto* diffuse = std::get_if<rendering::Diffuse>(&object.material))
    return "  Material \"diffuse\" \"rgb reflectance\"" + bracketed(spaced(diffuse->reflectance)) + "\n";
  return "  NamedMaterial \"material\"\n";
}

std::string pbrtText(const rendering::Scene& scene, const SceneFileNames& files) {
  std::string text = pbrtCamera(scene.camera) + pbrtFilm(files.name, scene.environment && !scene.showEnvironment);
  if (scene.environment) text += "LightSource \"infinite\" \"string filename\" " + pbrtString(files.environment) + "\n";
  text += pbrtLights(scene);
  text += "MakeNamedMaterial \"material\" \"string type\" \"measured\" \"string filename\" " +
          pbrtString(files.material) + "\n";
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    text += "AttributeBegin\n" + pbrtSurface(scene.objects[i]) + pbrtShape(scene.objects[i], files.meshes[i]) +
            "AttributeEnd\n";
  return text;
}

Image pbrtEnvironment(const rendering::Scene& scene) {
  // Three pixels for one of the latitude-longitude picture at its equator.
  return octahedralEnvironment(*scene.environment, scene.environmentRotation, 2 * scene.environment->image().height);
}

}  // namespace

Image octahedralEnvironment(const rendering::EnvironmentMap& environment, double rotation, int side) {
  const rendering::EnvironmentRotation turn(rotation);
  Image image(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Direction world = octahedralDirection((x + 0.5) / side, (y + 0.5) / side);
      image.at(x, y) = glm::vec3(environment.radiance(turn.toEnvironment(world)));
    }
  return image;
}

const SceneFormat& pbrtSceneFormat() {
  static const SceneFormat format{.textSuffix = "_scene.pbrt",
                                  .environmentSuffix = "_environment_octahedral.exr",
                                  .environmentLayout = "equal-area octahedral",
                                  .materialSuffix = "_spec.bsdf",
                                  .text = pbrtText,
                                  .environment = pbrtEnvironment};
  return format;
}

}  // namespace gonio::exports
