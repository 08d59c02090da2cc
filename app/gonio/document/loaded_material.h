// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <array>
#include <memory>
#include <mutex>

#include "core/brdf/tabulated_brdf.h"
#include "core/documents/blend_source.h"
#include "core/fitting/fit.h"
#include "core/materials/material.h"
#include "core/sampling/tabulated_density.h"

namespace gonio::app {

/// A material with all facts that the editor shows, computed once while it loads. Immutable, shared by the document,
/// its undo steps and background tasks.
struct LoadedMaterial {
  static constexpr std::array<int, 4> albedoDegrees{0, 30, 60, 80};

  materials::Material material;
  std::shared_ptr<const documents::BlendSource> blend = nullptr;  ///< of a material without a file
  /// The BRDF that is shown, edited and exported: the material in its native form, or a table if the preview cannot
  /// evaluate that form (widgets::isShownNatively()).
  std::shared_ptr<const Brdf> base;
  std::shared_ptr<const TabulatedDensity> density = nullptr;  ///< sampling density of the base
  TableStatistics statistics;                                 ///< on a coarse grid if the base is not a table
  std::array<Rgb, 4> albedo;

  /// Whether the base was sampled from another form, with a sampling error.
  bool isSampled() const { return material.brdf && material.brdf != base; }
  /// Whether table() is the base itself.
  bool isTable() const { return formOf<TabulatedBrdf>(*base) != nullptr; }
  /// The table for factors, codes and the fits of isotropic materials: the base, or sampled from it at the first call
  /// (up to a second, for an anisotropic measurement a few seconds; concurrent calls wait). Not for the GUI thread.
  /// @throws Cancelled.
  std::shared_ptr<const TabulatedBrdf> table(const TaskControl& control = {}) const;
  /// What models are fitted to: the base if it is anisotropic, else table(); errors refer to the base. Not for the GUI
  /// thread.
  /// @throws Cancelled.
  fitting::FitBase fitBase(const TaskControl& control = {}) const;
  /// Memory of the existing tables.
  std::size_t bytes() const;

 private:
  struct Sampled {
    std::mutex mutex;
    std::shared_ptr<const TabulatedBrdf> table;
  };
  std::shared_ptr<Sampled> m_sampled = std::make_shared<Sampled>();
};
using LoadedMaterialPtr = std::shared_ptr<const LoadedMaterial>;

/// Reads a material and computes the facts of the source panel, in a few tenths of a second, or up to a few seconds for
/// forms that are sampled as a table.
/// @throws Error, Cancelled.
LoadedMaterialPtr loadMaterial(const std::filesystem::path& path, const TaskControl& control = {});
/// As loadMaterial(), but also loads .gonio documents, with their edits applied.
LoadedMaterialPtr loadEdited(const std::filesystem::path& path, const TaskControl& control = {});
/// Loads the material of a document without its edits. The paths must be resolved. @throws Error, Cancelled.
LoadedMaterialPtr loadSource(const documents::EditDocument& document, const TaskControl& control = {});
/// As loadMaterial(), for a material in memory. @param blend its source if it is a blend, else null.
LoadedMaterialPtr loadInMemory(materials::Material material, std::shared_ptr<const documents::BlendSource> blend,
                               const TaskControl& control = {});

/// Kind of a material without its edits: "Measured" (also for files with codes or factors), "Close copy"
/// (near-measured), "Model fit" (published), "Reconstruction" or "Blend".
QString sourceKind(const LoadedMaterial& material);
/// Where the acquisition workspace stores the materials that it opens.
QString reconstructionFolder();

}  // namespace gonio::app
