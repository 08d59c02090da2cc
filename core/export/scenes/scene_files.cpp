// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/scenes/scene_files.h"

#include "core/io/exr_codec.h"
#include "core/io/mesh_file.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::exports {

namespace {

/// So that Gonio does not take the file for a latitude-longitude map.
std::map<std::string, std::string> layoutOf(const SceneFormat& format) {
  if (format.environmentLayout.empty()) return {};
  return {{io::layoutAttribute, std::string(format.environmentLayout)}};
}

const geometry::TriangleMesh* meshOf(const rendering::SceneObject& object) {
  const auto* shape = std::get_if<rendering::MeshShape>(&object.shape);
  return shape ? &(*shape)->mesh() : nullptr;
}

/// One suffix per object; empty if it is not a mesh.
std::vector<std::string> meshSuffixesOf(const rendering::Scene& scene) {
  std::vector<std::string> suffixes;
  int count = 0;
  for (const rendering::SceneObject& object : scene.objects)
    suffixes.push_back(meshOf(object) ? "_mesh" + std::to_string(++count) + ".ply" : std::string());
  return suffixes;
}

}  // namespace

std::vector<std::string> sceneSuffixes(const SceneFormat& format, const rendering::Scene& scene) {
  std::vector<std::string> suffixes{std::string(format.textSuffix)};
  if (scene.environment) suffixes.emplace_back(format.environmentSuffix);
  for (std::string& suffix : meshSuffixesOf(scene))
    if (!suffix.empty()) suffixes.push_back(std::move(suffix));
  return suffixes;
}

void checkSceneName(const SceneFormat& format, const std::string& name) {
  const std::string reason = ": the renderer would not find the files of the scene";
  if (plainText(name) != name)
    throw Error(plainText(name) + ": found control characters or invalid UTF-8, expected a name without them" + reason);
  if (const auto at = name.find_first_of(format.excludedCharacters); at != std::string::npos)
    throw Error(name + ": found " + name[at] + ", expected a name without it" + reason);
}

std::vector<ExportPart> sceneParts(const SceneFormat& format, const rendering::Scene& scene, const std::string& name) {
  checkSceneName(format, name);
  const std::vector<std::string> meshSuffixes = meshSuffixesOf(scene);
  SceneFileNames names{.name = name, .material = name + std::string(format.materialSuffix)};
  if (scene.environment) names.environment = name + std::string(format.environmentSuffix);
  for (const std::string& suffix : meshSuffixes) names.meshes.push_back(suffix.empty() ? suffix : name + suffix);
  std::vector<ExportPart> parts{textPart(format.textSuffix, format.text(scene, names))};
  if (scene.environment)
    parts.push_back(
        {std::string(format.environmentSuffix), io::encodeExr(format.environment(scene), layoutOf(format))});
  for (std::size_t i = 0; i < meshSuffixes.size(); ++i)
    if (const geometry::TriangleMesh* mesh = meshOf(scene.objects[i]))
      parts.push_back({meshSuffixes[i], io::encodePly(*mesh)});
  return parts;
}

}  // namespace gonio::exports
