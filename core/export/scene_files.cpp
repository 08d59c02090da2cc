// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/scene_files.h"

#include <cmath>

#include "core/export/export_report.h"
#include "core/export/surface_target.h"
#include "core/io/exr_codec.h"
#include "core/support/error.h"

namespace gonio::exports {

namespace {

constexpr int scenePixels = 512, sceneSamples = 256;

/// An attribute of XML or a string of pbrt: what would end it is not in names of files that renderers open.
std::string quotable(std::string name) {
  for (char& c : name)
    if (c == '"' || c == '<' || c == '>' || c == '&' || c == '\\' || static_cast<unsigned char>(c) < 0x20) c = '_';
  return name;
}

std::string spaced(const Direction& v) { return colourText(v, " "); }

void expectShowable(const Scene& scene) {
  if (!scene.environment) throw Error("export: found a scene without an environment, expected one for --scene");
  if (scene.camera.fieldOfView <= 0)
    throw Error("export: found an orthographic camera, expected a perspective one for --scene");
}

/// "rotate" about +y by this many degrees takes a direction of the environment's picture to the world.
double environmentDegrees(const Scene& scene) { return -degrees(scene.environmentRotation); }

MadeExport::Part exrPart(std::string_view suffix, const Image& image) {
  return {std::string(suffix), io::encodeExr(image, {})};
}

/// Clarberg 2008: a position in [0, 1]^2 to the sphere; areas are proportional.
Direction octahedralDirection(double x, double y) {
  const double u = 2 * x - 1, v = 2 * y - 1, along = std::abs(u), across = std::abs(v);
  const double distance = 1 - (along + across), r = 1 - std::abs(distance);
  const double phi = (r > 0 ? (across - along) / r + 1 : 1) * pi / 4;
  const double sine = r * std::sqrt(2 - r * r);
  return {std::copysign(std::cos(phi), u) * sine, std::copysign(std::sin(phi), v) * sine,
          std::copysign(1 - r * r, distance)};
}

std::string mitsubaText(const Scene& scene, const std::string& file) {
  const CameraFrame camera = cameraFrame(scene.camera);
  // Mitsuba's picture has +z where Gonio's has -z; its sphere has its poles at z, Gonio's at y.
  return R"(<scene version="3.0.0">
  <integrator type="path"><boolean name="hide_emitters" value="true"/></integrator>
  <sensor type="perspective">
    <string name="fov_axis" value="smaller"/>
    <float name="fov" value=")" +
         decimalText(degrees(scene.camera.fieldOfView)) + R"("/>
    <transform name="to_world">
      <lookat origin=")" +
         colourText(camera.eye) + "\" target=\"" + colourText(camera.eye + camera.forward) + "\" up=\"" +
         colourText(camera.up) + R"("/>
    </transform>
    <sampler type="independent"><integer name="sample_count" value=")" +
         std::to_string(sceneSamples) + R"("/></sampler>
    <film type="hdrfilm">
      <integer name="width" value=")" +
         std::to_string(scenePixels) + R"("/>
      <integer name="height" value=")" +
         std::to_string(scenePixels) + R"("/>
      <rfilter type="box"/>
    </film>
  </sensor>
  <emitter type="envmap">
    <string name="filename" value=")" +
         file + R"(_environment.exr"/>
    <transform name="to_world"><rotate y="1" angle=")" +
         decimalText(180 + environmentDegrees(scene)) + R"("/></transform>
  </emitter>
  <shape type="sphere">
    <transform name="to_world"><rotate x="1" angle="-90"/></transform>
    <bsdf type="measured"><string name="filename" value=")" +
         file + R"(_rgb.bsdf"/></bsdf>
  </shape>
</scene>
)";
}

}  // namespace

Image octahedralEnvironment(const EnvironmentMap& environment, double rotation, int side) {
  const EnvironmentRotation turn(rotation);
  Image image(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Direction world = octahedralDirection((x + 0.5) / side, (y + 0.5) / side);
      image.at(x, y) = glm::vec3(environment.radiance(turn.toEnvironment(world)));
    }
  return image;
}

std::vector<MadeExport::Part> mitsubaScene(const Scene& scene, const std::string& name) {
  expectShowable(scene);
  std::vector<MadeExport::Part> parts;
  parts.push_back(textPart("_scene.xml", mitsubaText(scene, quotable(name))));
  parts.push_back(exrPart("_environment.exr", scene.environment->image()));
  return parts;
}

std::vector<MadeExport::Part> pbrtScene(const Scene& scene, const std::string& name) {
  expectShowable(scene);
  const CameraFrame camera = cameraFrame(scene.camera);
  const std::string file = quotable(name);
  const std::string pixels = std::to_string(scenePixels);
  // Three pixels for one of the latitude-longitude picture at its equator.
  const int side = 2 * scene.environment->image().height;
  // pbrt's cameras are left-handed; the light's frame is the world's before the camera's mirror.
  const std::string text = "Scale -1 1 1\nLookAt " + spaced(camera.eye) + "  " + spaced(camera.eye + camera.forward) +
                           "  " + spaced(camera.up) + "\nCamera \"perspective\" \"float fov\" [ " +
                           decimalText(degrees(scene.camera.fieldOfView)) +
                           " ]\nFilm \"rgb\" \"integer xresolution\" [ " + pixels + " ] \"integer yresolution\" [ " +
                           pixels + " ] \"string filename\" \"" + file +
                           "_pbrt.exr\"\nPixelFilter \"box\"\nSampler \"independent\" \"integer pixelsamples\" [ " +
                           std::to_string(sceneSamples) +
                           " ]\nIntegrator \"path\"\n\nWorldBegin\nLightSource \"infinite\" \"string filename\" \"" +
                           file + "_environment_octahedral.exr\"\nMaterial \"measured\" \"string filename\" \"" + file +
                           "_spec.bsdf\"\nRotate -90 1 0 0\nShape \"sphere\" \"float radius\" [ 1 ]\n";
  std::vector<MadeExport::Part> parts;
  parts.push_back(textPart("_scene.pbrt", text));
  parts.push_back(exrPart("_environment_octahedral.exr",
                          octahedralEnvironment(*scene.environment, scene.environmentRotation, side)));
  return parts;
}

}  // namespace gonio::exports
