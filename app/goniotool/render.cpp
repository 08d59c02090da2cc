// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <chrono>

#include "app/goniotool/materials.h"
#include "app/goniotool/picture_options.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"

namespace gonio::tool {

namespace {

struct Options {
  std::string material, out;
  std::shared_ptr<PictureOptions> picture = std::make_shared<PictureOptions>();
  bool effects = false;
};

/// What one convex sphere under distant light calls for.
Json effectsOf(const SphereScene& scene) {
  const bool hasEnvironment = scene.environment != nullptr;
  const auto effect = [](const char* name, bool simulated, const char* reason) {
    return Json{{"effect", name}, {"simulated", simulated}, {"reason", reason}};
  };
  return {
      effect("direct light", !hasEnvironment, hasEnvironment ? "the scene has none" : "one distant light"),
      effect("environment light", hasEnvironment, hasEnvironment ? "lights all of the sphere" : "the scene has none"),
      effect("shadows", false, "one convex object casts none"),
      effect("interreflection", false, "one convex object does not see itself")};
}

int render(const Options& options, const Tool& tool) {
  checkPicture(options.out);
  const SphereRenderOptions renderOptions = options.picture->renderOptions();
  const SphereScene scene = options.picture->sphereScene();
  const io::Material material = openMaterial(options.material, tool.control("reading"));
  const auto start = std::chrono::steady_clock::now();
  const Image image = renderSphere(*material.brdf, scene, renderOptions, tool.control("rendering"));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  writePicture(image, *options.picture, options.out);
  const Json effects = effectsOf(scene);
  std::string text = options.out + ": " + std::to_string(image.width) + " x " + std::to_string(image.height) + ", " +
                     number(seconds) + " s\n";
  if (options.effects)
    for (const Json& one : effects)
      text += "  " + one["effect"].get<std::string>() + ": " + (one["simulated"].get<bool>() ? "yes" : "no") + " (" +
              one["reason"].get<std::string>() + ")\n";
  print(tool,
        {{"seconds", seconds},
         {"samples", renderOptions.samples},
         {"width", image.width},
         {"height", image.height},
         {"scene", options.picture->scene},
         {"environment", scene.environment ? Json(scene.environment->name()) : Json(nullptr)},
         {"plan", effects},
         {"counters", {{"shadowRays", 0}, {"bounceRays", 0}}},
         {"out", options.out}},
        text);
  return 0;
}

}  // namespace

void addRender(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("render", "A picture of the material on a sphere");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  addPictureOptions(*command, options->picture);
  command->add_flag("--effects", options->effects, "Tell which effects are simulated, and why");
  command->add_option("--out", options->out, "Picture to write: .exr (linear) or .png")->required();
  command->callback([options, &tool] { tool.run = [options, &tool] { return render(*options, tool); }; });
}

}  // namespace gonio::tool
