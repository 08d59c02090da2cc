// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/documents/edit_document.h"
#include "core/interpolation/interpolation.h"
#include "core/materials/dictionary_file.h"
#include "core/materials/material.h"

namespace gonio::documents {

/// The source of a document without a material file of its own: a blend of materials. In a document's "source":
///   {"blend": {"space": "parameters", "model": "ggx", "keepDetail": true, "materials": [
///      {"weight": 0.4, "source": {..}, "edits": [..]}, ..]}, "sha256": ..}
/// "model" is present in spaces that use one, "keepDetail" in blends that preserve measured detail, "dictionary" (the
/// id in hexadecimal) in blends of codes over another ensemble than that of version 0.2.0; documents of that version
/// have none of the last two. The materials are documents themselves and may be blends.
struct BlendSource {
  interpolation::InterpolationSpace space = interpolation::InterpolationSpace::linear;
  const models::Model* model = nullptr;  ///< for the spaces `parameters` and `differential`; ignored in others
  bool preserveDetail = true;            ///< InterpolationOptions::preserveDetail
  std::uint64_t dictionary = materials::bundledIds().front();  ///< id of the ensemble for the space `dictionary`
  std::vector<EditDocument> materials;                         ///< their views are ignored
  std::vector<double> weights;
};

/// The options of blends in the editor: a bundled ensemble (read at the first call, 0.1 s) and three PDV terms.
/// @param dictionary one of materials::bundledIds().
interpolation::InterpolationOptions blendOptions(const models::Model* model = nullptr, bool preserveDetail = true,
                                                 std::uint64_t dictionary = materials::bundledIds().front());

/// A material to blend, with its sparse code if no edit changes it. @param base the material in its native form, read
/// with the displayed incident direction. @param unedited its table. @param edited the table with `edits`; the same
/// object as `unedited` if no edit changes it.
interpolation::InterpolationMaterial interpolationMaterial(const materials::Material& material,
                                                           const std::shared_ptr<const Brdf>& base,
                                                           const std::shared_ptr<const TabulatedBrdf>& unedited,
                                                           const std::shared_ptr<const TabulatedBrdf>& edited,
                                                           const editing::EditList& edits);

/// @throws Error if an edit's values do not match its model.
nlohmann::json toJson(const BlendSource& blend);
/// Maximum depth of blends inside blends in text that is parsed; a blend that can be read is far less deep.
inline constexpr int maxBlendsInBlends = 16;
/// Maximum number of times that the materials of a blend are sampled to read it, 0.2 to 0.4 s each: a material is
/// sampled once for each blend that contains it, directly or in another blend.
inline constexpr std::size_t maxBlendSamplings = 32;
/// @throws Error that states the limit.
void checkLimits(const BlendSource& blend);

/// @param where the object's path in its document, for errors, e.g. "source.blend". @param version of the document.
/// @param depth 1 for a document's own blend.
/// @throws Error as documentFromJson(), and for invalid weights or more than maxBlendsInBlends nested blends.
std::shared_ptr<const BlendSource> blendSourceFromJson(const nlohmann::json& json, const std::string& where,
                                                       int version, int depth);

/// SHA-256 of a blend's content: the hashes of its sources (not their paths), edits, weights, space and model.
/// Lower-case hex.
std::string blendSha256(const BlendSource& blend);

/// A blend as a material, named after its materials, without a path. A blend of UTIA files, or of RGL files, has their
/// form where nativeFormBlend() finds one; for RGL files a note states the accuracy. Otherwise it is a weighted sum if
/// some material is not a table and `interpolation` allows it (mixesNativeForms()), else a table. @param interpolation
/// the prepared interpolation of `blend`. @throws Error as checkLimits(), Cancelled.
materials::Material blendedMaterial(const BlendSource& blend, const interpolation::Interpolation& interpolation,
                                    const TaskControl& control = {});

/// The source files of a document, including those of its blends, without bundled materials. Paths are as in the
/// document: see resolved().
std::vector<std::filesystem::path> sourceFiles(const EditDocument& document);

/// Reads the source of a document, without the document's own edits: the file, or the blend of all its files (up to
/// a few seconds, in addition to reading and editing each material). @param documentPath relative paths are resolved
/// against its folder. @throws Error that names the file; Cancelled.
materials::Material readSource(const EditDocument& document, const std::filesystem::path& documentPath,
                               const TaskControl& control = {});

}  // namespace gonio::documents
