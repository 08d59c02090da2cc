// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/materials.h"
#include "app/goniotool/pages.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/io/mesh_file.h"
#include "core/rendering/scene_file.h"

namespace gonio::tool {

namespace {

struct ScenesArguments {
  std::vector<std::string> materials, scenes;
};

int scenes(const ScenesArguments& options, const Tool& tool) {
  std::vector<std::shared_ptr<const rendering::RenderMaterial>> slotMaterials;
  for (const std::string& material : options.materials)
    slotMaterials.push_back(std::make_shared<const rendering::RenderMaterial>(
        documents::openMaterial(material, tool.control("reading")).brdf));
  if (slotMaterials.empty()) slotMaterials.push_back(rendering::diffuseMaterial(Rgb(0.5)));
  Json list = Json::array();
  std::string text;
  for (const std::string& name : options.scenes.empty() ? rendering::bundledSceneNames() : options.scenes) {
    const rendering::Scene scene = rendering::openScene(name, int(slotMaterials.size()));
    const rendering::EffectPlan plan = rendering::planEffects(scene, rendering::bindMaterials(scene, slotMaterials));
    list.push_back({{"scene", scene.name},
                    {"description", scene.description},
                    {"objects", scene.objects.size()},
                    {"reflections", plan.reflections},
                    {"plan", planJson(plan)}});
    text += scene.name + ": " + scene.description + "\n" + planText(plan);
  }
  print(tool, {{"scenes", list}}, text);
  return 0;
}

}  // namespace

std::string sceneTable() {
  const std::vector<std::shared_ptr<const rendering::RenderMaterial>> grey{rendering::diffuseMaterial(Rgb(0.5))};
  std::string table = "| name | shows | effects of a grey material |\n|---|---|---|\n";
  for (const std::string& name : rendering::bundledSceneNames()) {
    const rendering::Scene scene = rendering::openScene(name, int(grey.size()));
    const rendering::EffectPlan plan = rendering::planEffects(scene, rendering::bindMaterials(scene, grey));
    std::string effects;
    for (std::size_t i = 0; i < rendering::effectCount; ++i)
      if (plan.simulates(rendering::Effect(i)))
        effects += (effects.empty() ? "`" : ", `") + std::string(rendering::effectId(rendering::Effect(i))) + "`";
    table += "| `" + name + "` | " + scene.description + " | " + effects + " |\n";
  }
  return table;
}

void addScenes(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<ScenesArguments>();
  CLI::App* command = app.add_subcommand("scenes", "Lists scenes with their effect plans");
  command->add_option("SCENE", options->scenes,
                      "Scenes, scene files (.json) or meshes (" + io::meshSuffixList() + ") (all bundled scenes)");
  command->add_option("--material", options->materials, "Material of the scenes (a grey Lambertian surface)")
      ->type_name("MATERIAL");
  command->callback([options, &tool] { tool.run = [options, &tool] { return scenes(*options, tool); }; });
}

}  // namespace gonio::tool
