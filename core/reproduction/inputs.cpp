// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/reproduction/inputs.h"

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "core/documents/open_material.h"
#include "core/io/byte_source.h"
#include "core/io/sha256.h"
#include "core/materials/bundled_library.h"
#include "core/study/training_files.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::reproduction {

namespace {

/// Tables of 19 MB that stay in memory.
constexpr std::size_t keptTables = 12;

std::vector<std::string> bundledPaths(MaterialSet set) {
  std::vector<std::string> paths;
  const std::string scheme(materials::libraryScheme);
  if (set == MaterialSet::rgl)
    for (const auto& measured : materials::measuredMaterials()) paths.push_back(scheme + "rgl/" + measured.name);
  const std::string_view source = set == MaterialSet::merl  ? materials::merlCopySource
                                  : set == MaterialSet::rgl ? materials::rglCopySource
                                                            : materials::dtuCopySource;
  for (const auto& copy : materials::nearMeasuredMaterials())
    if (copy.source == source && !materials::isOriginalBundled(copy))
      paths.push_back(scheme + copy.source + "/" + copy.name);
  return paths;
}

}  // namespace

std::string materialName(std::string_view stem) {
  std::string name = lowerCase(std::string(stem));
  std::ranges::replace(name, '_', '-');
  if (name.ends_with("-rgb")) name.resize(name.size() - 4);
  return name;
}

std::string shownName(const InputMaterial& material) {
  return material.replaced.empty() ? material.name : material.name + " (for " + std::string(material.replaced) + ")";
}

Inputs::Inputs(InputOptions options) : options_(std::move(options)) {
  for (const MaterialSet set : {MaterialSet::merl, MaterialSet::rgl, MaterialSet::dtu}) {
    const std::string& given = folder(set);
    if (!given.empty() && !std::filesystem::is_directory(given))
      throw Error(given + ": found no folder of this name, expected a folder of measured files");
    for (const std::string& path : given.empty() ? bundledPaths(set) : study::trainingFiles({given}))
      sets_[std::size_t(set)].push_back({path, materialName(std::filesystem::path(path).stem().string()), set});
  }
}

std::vector<InputMaterial> Inputs::testMaterials(std::span<const MaterialSet> sets) const {
  static const std::vector<Subject> wanted{{MaterialSet::merl, "gold-metallic-paint", {"gold-metallic-paint2"}},
                                           {MaterialSet::merl, "yellow-matte-plastic", {"yellow-plastic"}},
                                           {MaterialSet::rgl, "satin-purple", {"satin-blue"}},
                                           {MaterialSet::dtu, "cardboard", {"yellowpaper"}}};
  std::vector<InputMaterial> found;
  for (const Subject& subject : wanted)
    if (std::ranges::count(sets, subject.set)) {
      try {
        found.push_back(find(subject));
      } catch (const Error&) {
        found.push_back(materials(subject.set).front());
      }
    }
  return found;
}

std::vector<InputMaterial> Inputs::trainingMaterials() const {
  std::vector<InputMaterial> training;
  const std::size_t step = quick() ? 4 : 1;
  for (const MaterialSet set : {MaterialSet::merl, MaterialSet::rgl})
    for (std::size_t i = 0; i < materials(set).size(); i += step) training.push_back(materials(set)[i]);
  return training;
}

InputMaterial Inputs::find(const Subject& subject) const {
  const auto named = [&](std::string_view name) {
    return std::ranges::find(materials(subject.set), name, &InputMaterial::name);
  };
  const auto end = materials(subject.set).end();
  if (const auto own = named(subject.name); own != end) return *own;
  for (const std::string_view substitute : subject.substitutes)
    if (const auto other = named(substitute); other != end) {
      InputMaterial material = *other;
      material.replaced = subject.name;
      return material;
    }
  std::string expected(subject.name);
  for (const std::string_view substitute : subject.substitutes) expected += " or " + std::string(substitute);
  const std::string place = folder(subject.set).empty() ? "the bundled materials" : folder(subject.set);
  throw Error(place + ": found no material " + expected + " of the set " +
              std::string(materialSetNames[std::size_t(subject.set)]));
}

std::vector<std::string> Inputs::origins() const {
  std::vector<std::string> lines;
  for (const MaterialSet set : {MaterialSet::merl, MaterialSet::rgl, MaterialSet::dtu}) {
    const std::string count = std::to_string(materials(set).size()) + " materials, ";
    std::string line = set == MaterialSet::merl ? "MERL: " : set == MaterialSet::rgl ? "RGL: " : "DTU: ";
    if (!folder(set).empty())
      line += count + "files of the folder given with --" + std::string(materialSetNames[std::size_t(set)]);
    else if (set == MaterialSet::rgl)
      line += count + "bundled measured files, and near-measured copies of the others";
    else
      line += count + "bundled near-measured copies (neural fits), not the measured files";
    lines.push_back(line);
  }
  return lines;
}

const std::string& Inputs::hash(const InputMaterial& material) {
  std::string& hash = hashes_[material.path];
  if (hash.empty())
    hash = material.path.starts_with(materials::libraryScheme) ? materials::librarySha256(material.path)
                                                               : io::sha256Hex(io::FileSource(material.path));
  return hash;
}

std::shared_ptr<const TabulatedBrdf> Inputs::table(const InputMaterial& material, const TaskControl& control) {
  for (const auto& [path, table] : tables_)
    if (path == material.path) return table;
  auto table = meanOfOrders(documents::openMaterial(material.path, {control.stop, {}}).tabulated({control.stop, {}}));
  if (tables_.size() == keptTables) tables_.erase(tables_.begin());
  tables_.emplace_back(material.path, table);
  return table;
}

std::shared_ptr<const dictionary::PrincipalComponents> Inputs::basis(std::span<const InputMaterial> training,
                                                                     const TaskControl& control) {
  std::vector<std::string> paths;
  std::string key;
  for (const InputMaterial& material : training) {
    paths.push_back(material.path);
    key += material.path + "\n";
  }
  if (basis_ && key == basisKey_) return basis_;
  basis_.reset();
  const auto materials = study::trainingMaterials(paths);
  basis_ = std::make_shared<const dictionary::PrincipalComponents>(
      dictionary::learnPrincipalComponents(materials.names.size(), materials.load, {}, control));
  basisKey_ = key;
  return basis_;
}

rendering::RenderOptions Inputs::picture() const {
  rendering::RenderOptions options = rendering::smallComparisonPicture();
  if (!quick()) options.width = options.height = 256;
  return options;
}

}  // namespace gonio::reproduction
