// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <array>
#include <memory>

#include "core/brdf/sampling_lobe.h"
#include "core/brdf/statistics.h"
#include "core/editing/blend_source.h"
#include "core/materials/material.h"

namespace gonio::app {

/// A material with all that the editor shows of it, computed once while it loads. Immutable and shared between the
/// document, its undo steps and background work.
struct LoadedMaterial {
  static constexpr std::array<int, 4> albedoDegrees{0, 30, 60, 80};

  materials::Material material;
  std::shared_ptr<const editing::BlendSource> blend = nullptr;  ///< of a material without a file of its own
  std::shared_ptr<const TabulatedBrdf> table;
  SamplingLobe lobe;
  TableStatistics statistics;
  std::array<Rgb, 4> albedo;

  /// Whether the table was sampled from another form: it has an error of its own.
  bool isSampled() const { return material.brdf && material.brdf != table; }
};
using LoadedMaterialPtr = std::shared_ptr<const LoadedMaterial>;

/// Reads and tabulates a material and measures what the source panel shows. Up to some seconds (RGL files).
/// @throws Error, Cancelled.
LoadedMaterialPtr loadMaterial(const std::filesystem::path& path, const TaskControl& control = {});
/// What a document of resolved paths is about, without its edits. @throws Error, Cancelled.
LoadedMaterialPtr loadSource(const editing::EditDocument& document, const TaskControl& control = {});
/// The same of a material that is there already.
LoadedMaterialPtr measuredMaterial(materials::Material material, std::shared_ptr<const editing::BlendSource> blend,
                                   const TaskControl& control = {});

/// What a material is before its edits: "Measured" (also where a file holds its code or its factors), "Published fit"
/// or "Kept blend".
QString sourceKind(const LoadedMaterial& material);

}  // namespace gonio::app
