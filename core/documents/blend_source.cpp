// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/documents/blend_source.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "core/brdf/weighted_sum.h"
#include "core/documents/edit_document.h"
#include "core/interpolation/native_form_blend.h"
#include "core/io/json_text.h"
#include "core/io/sha256.h"
#include "core/materials/bundled_library.h"

namespace gonio::documents {

namespace {

constexpr double readFraction = 0.5;

bool hasModel(interpolation::InterpolationSpace space) {
  return space == interpolation::InterpolationSpace::parameters ||
         space == interpolation::InterpolationSpace::differential;
}

std::string_view nameOf(interpolation::InterpolationSpace space) {
  return interpolation::interpolationSpaceNames[std::size_t(space)];
}

interpolation::InterpolationSpace spaceFromJson(const JsonObject& object) {
  const auto found = std::find(interpolation::interpolationSpaceNames.begin(),
                               interpolation::interpolationSpaceNames.end(), object.text("space"));
  if (found == interpolation::interpolationSpaceNames.end()) object.fail("space", "the name of an interpolation space");
  return interpolation::InterpolationSpace(found - interpolation::interpolationSpaceNames.begin());
}

/// That of version 0.2.0, which documents do not name.
std::uint64_t firstDictionary() { return materials::bundledIds().back(); }

std::string hexOf(std::uint64_t id) {
  char text[17];
  std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(id));
  return text;
}

std::uint64_t dictionaryFromJson(const JsonObject& object) {
  if (!object.contains("dictionary")) return firstDictionary();
  const auto ids = materials::bundledIds();
  const auto found = std::ranges::find(ids, object.text("dictionary"), hexOf);
  if (found == ids.end()) object.fail("dictionary", "the id of a dictionary of this version of Gonio");
  return *found;
}

/// The JSON that identifies one material: the hash of its file and its edits.
nlohmann::json identityOf(const EditDocument& material) {
  nlohmann::json json = contentToJson(material);
  json["source"] = material.sourceSha256;
  return json;
}

std::string percent(double weight) { return std::to_string(std::lround(100 * weight)) + " %"; }

/// The last part of a path, without its suffix.
std::string nameOf(const EditDocument& material) {
  if (material.blend) return "blend";
  return std::filesystem::path(material.sourcePath.substr(material.sourcePath.rfind(':') + 1)).stem().string();
}

/// @param depth number of blends that contain the materials.
std::size_t samplingsOf(const BlendSource& blend, std::size_t depth = 1) {
  std::size_t count = 0;
  for (const EditDocument& material : blend.materials)
    count += material.blend ? samplingsOf(*material.blend, depth + 1) : depth;
  return count;
}

std::string nodesNote(const std::string& name, double accuracy) {
  return "The RGL files were resampled to the angles of " + name +
         " for the blend. Reflected light over its error: " + std::to_string(std::lround(accuracy)) +
         " dB under uniform illumination";
}

materials::Material readBlend(const BlendSource& blend, const std::filesystem::path& path, const TaskControl& control) {
  BlendSource found = blend;
  std::vector<interpolation::InterpolationMaterial> ends;
  for (std::size_t i = 0; i < blend.materials.size(); ++i) {
    const double each = readFraction / double(blend.materials.size());
    const TaskControl part = control.between(double(i) * each, double(i + 1) * each);
    const materials::Material source = readSource(blend.materials[i], path, part);
    found.materials[i].sourceSha256 = source.source.sha256;
    const auto table = source.tabulated({control.stop, {}});
    const editing::EditList& edits = blend.materials[i].edits;
    ends.push_back(interpolationMaterial(source, source.brdf ? source.brdf : table, table,
                                         editing::bakeEdits(table, edits, {control.stop, {}}), edits));
  }
  const auto interpolation = interpolation::prepareInterpolation(
      blend.space, ends, blendOptions(blend.model, blend.preserveDetail, blend.dictionary),
      control.between(readFraction, 0.9));
  return blendedMaterial(found, *interpolation, control.between(0.9, 1));
}

}  // namespace

interpolation::InterpolationMaterial interpolationMaterial(const materials::Material& material,
                                                           const std::shared_ptr<const Brdf>& base,
                                                           const std::shared_ptr<const TabulatedBrdf>& unedited,
                                                           const std::shared_ptr<const TabulatedBrdf>& edited,
                                                           const editing::EditList& edits) {
  interpolation::InterpolationMaterial end{
      .table = edited, .factors = nullptr, .code = edited == unedited ? material.code : nullptr};
  if (end.code) end.ensemble = {material.dictionary, &material.dictionary->ensemble};
  if (!formOf<TabulatedBrdf>(*base)) {
    end.base = base;
    end.edits = edits;
  }
  return end;
}

interpolation::InterpolationOptions blendOptions(const models::Model* model, bool preserveDetail,
                                                 std::uint64_t dictionary) {
  interpolation::InterpolationOptions options;
  options.preserveDetail = preserveDetail;
  options.model = model;
  const auto named = materials::bundledEnsemble(dictionary);
  options.ensemble = {named, &named->ensemble};
  options.pdv.terms = 3;  // what a frame costs grows with them, twice as fast as with the terms of one material
  return options;
}

void checkLimits(const BlendSource& blend) {
  if (const std::size_t count = samplingsOf(blend); count > maxBlendSamplings)
    throw Error("found a blend whose materials are sampled " + std::to_string(count) + " times, expected at most " +
                std::to_string(maxBlendSamplings) + "; each counts once for every blend that contains it");
}

nlohmann::json toJson(const BlendSource& blend) {
  nlohmann::json materials = nlohmann::json::array();
  for (std::size_t i = 0; i < blend.materials.size(); ++i) {
    nlohmann::json material = contentToJson(blend.materials[i]);
    material["weight"] = blend.weights[i];
    materials.push_back(std::move(material));
  }
  nlohmann::json json = {{"space", nameOf(blend.space)}, {"materials", std::move(materials)}};
  if (hasModel(blend.space) && blend.model) json["model"] = blend.model->spec().id;
  // Left out where it has no effect: the hashes of blends in older documents stay the same.
  if (interpolation::losesDetail(blend.space) && blend.preserveDetail) json["keepDetail"] = true;
  if (blend.space == interpolation::InterpolationSpace::dictionary && blend.dictionary != firstDictionary())
    json["dictionary"] = hexOf(blend.dictionary);
  return json;
}

std::shared_ptr<const BlendSource> blendSourceFromJson(const nlohmann::json& json, const std::string& where,
                                                       int version, int depth) {
  const JsonObject object(json, where);
  if (depth > maxBlendsInBlends)
    throw Error(where + ": found more than " + std::to_string(maxBlendsInBlends) + " nested blends");
  auto blend = std::make_shared<BlendSource>();
  blend->space = spaceFromJson(object);
  if (hasModel(blend->space)) blend->model = &modelFromJson(object);
  blend->preserveDetail = object.contains("keepDetail") && object.flag("keepDetail");
  blend->dictionary = dictionaryFromJson(object);
  const nlohmann::json& materials = object.array("materials");
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const JsonObject material(materials[i], object.place("materials") + "[" + std::to_string(i) + "]");
    blend->weights.push_back(material.number("weight", 0, 1));
    blend->materials.push_back(contentFromJson(material, version, depth));
  }
  if (materials.empty()) object.fail("materials", "at least one material");
  try {
    checkWeights(blend->weights, blend->materials.size());
  } catch (const Error& error) {
    throw Error(object.place("materials") + ": " + error.what());
  }
  return blend;
}

std::string blendSha256(const BlendSource& blend) {
  nlohmann::json identity = toJson(blend);
  for (std::size_t i = 0; i < blend.materials.size(); ++i)
    identity["materials"][i] = {blend.weights[i], identityOf(blend.materials[i])};
  return io::sha256Hex(std::string_view(io::jsonText(identity)));
}

materials::Material blendedMaterial(const BlendSource& blend, const interpolation::Interpolation& interpolation,
                                    const TaskControl& control) {
  checkLimits(blend);
  materials::Material material;
  std::string names, fractions;
  for (std::size_t i = 0; i < blend.materials.size(); ++i) {
    if (!(blend.weights[i] > 0)) continue;
    const std::string name = nameOf(blend.materials[i]);
    names += (names.empty() ? "" : " + ") + name;
    fractions += (fractions.empty() ? "" : ", ") + percent(blend.weights[i]) + " " + name;
  }
  material.name = names;
  material.source.format = "blend";
  material.source.description = fractions + "; space " + std::string(nameOf(blend.space));
  material.source.sha256 = blendSha256(blend);
  if (const auto own = interpolation::nativeFormBlend(interpolation, blend.weights, control)) {
    material.brdf = own->brdf;
    if (std::isfinite(own->accuracy))
      material.source.notes.push_back(nodesNote(nameOf(blend.materials[own->nodesOf]), own->accuracy));
    return material;
  }
  if (interpolation.mixesNativeForms() &&
      std::ranges::any_of(interpolation.ends(), [](const auto& end) { return end.base != nullptr; })) {
    material.brdf = interpolation.brdf(blend.weights);
    return material;
  }
  material.table = interpolation.table(blend.weights, control);
  const HalfDifferenceGrid& grid = material.table->grid();
  material.source.grid = {grid.thetaHCount, grid.thetaDCount, grid.phiDCount};
  material.brdf = material.table;
  return material;
}

std::vector<std::filesystem::path> sourceFiles(const EditDocument& document) {
  if (!document.blend) {
    if (document.sourcePath.empty() || document.sourcePath.starts_with(materials::libraryScheme)) return {};
    return {document.sourcePath};
  }
  std::vector<std::filesystem::path> files;
  for (const EditDocument& material : document.blend->materials)
    std::ranges::copy(sourceFiles(material), std::back_inserter(files));
  return files;
}

materials::Material readSource(const EditDocument& document, const std::filesystem::path& documentPath,
                               const TaskControl& control) {
  if (document.blend) return readBlend(*document.blend, documentPath, control);
  materials::Material material = materials::readMaterial(resolveSource(document, documentPath), control);
  material.brdf = withIncident(material.brdf, document.incident);
  return material;
}

}  // namespace gonio::documents
