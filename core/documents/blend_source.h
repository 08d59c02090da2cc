// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/documents/edit_document.h"
#include "core/interpolation/interpolation.h"
#include "core/materials/material.h"

namespace gonio::editing {

/// What a document is about that has no file of its own: materials blended in a space. In a document's "source":
///   {"blend": {"space": "linear", "model": "ggx", "materials": [
///      {"weight": 0.4, "source": {..}, "edits": [..]}, ..]}, "sha256": ..}
/// "model" in spaces that have one. The materials are documents of their own, and may be blends again.
struct BlendSource {
  InterpolationSpace space = InterpolationSpace::linear;
  const models::Model* model = nullptr;  ///< of `parameters` and `differential`; else not looked at
  std::vector<EditDocument> materials;   ///< their views do not count
  std::vector<double> weights;
};

/// What an editor's blends are prepared with: the bundled dictionary (read at the first call, 0.1 s), few terms of
/// factors.
InterpolationOptions blendOptions(const models::Model* model = nullptr);

/// A material as one that is blended: with its code while no edit has changed it.
/// @param base in its own form, in the order of directions that is shown. @param unedited its table. @param edited the
/// table with `edits`, the same object where there are none.
InterpolationEnd blendedEnd(const materials::Material& material, const std::shared_ptr<const Brdf>& base,
                            const std::shared_ptr<const TabulatedBrdf>& unedited,
                            const std::shared_ptr<const TabulatedBrdf>& edited, const EditList& edits);

/// @throws Error when an edit's values do not fit its model.
nlohmann::json toJson(const BlendSource& blend);
/// How deep blends of blends may be.
inline constexpr int maxBlendsInBlends = 16;
/// @param version of the document. @param depth 1 for a document's own blend.
/// @throws Error as documentFromJson(); weights that are none and blends in too many blends too.
std::shared_ptr<const BlendSource> blendSourceFromJson(const nlohmann::json& json, const std::string& where,
                                                       int version, int depth);

/// Distinguishes a blend from one of other materials, other edits or other weights; those of the sources count, not
/// their paths. Lower-case hex.
std::string blendSha256(const BlendSource& blend);

/// A blend as a material: named after its materials, without a path. In their own form where all have the same one
/// (ownFormBlend()), of RGL files with a note about it; where some have another form than a table, the sum of these;
/// else a table.
/// @param interpolation of `blend`, prepared. @throws Cancelled.
materials::Material blendedMaterial(const BlendSource& blend, const Interpolation& interpolation,
                                    const TaskControl& control = {});

/// The files that a document is about, in its blends too; none of them bundled. As their paths stand in the document:
/// see resolved().
std::vector<std::filesystem::path> sourceFiles(const EditDocument& document);

/// Reads what a document is about, without its own edits: the file, or the blend of all files. Each of a blend's
/// materials takes as long as its file and its edits, the blend up to some seconds.
/// @param documentPath against which relative paths are resolved. @throws Error naming the file; Cancelled.
materials::Material readSource(const EditDocument& document, const std::filesystem::path& documentPath,
                               const TaskControl& control = {});

}  // namespace gonio::editing
