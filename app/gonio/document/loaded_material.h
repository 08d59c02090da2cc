// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <array>
#include <memory>
#include <mutex>

#include "core/brdf/statistics.h"
#include "core/brdf/tabulated_lobe.h"
#include "core/documents/blend_source.h"
#include "core/materials/material.h"

namespace gonio::app {

/// A material with all that the editor shows of it, computed once while it loads. Immutable and shared between the
/// document, its undo steps and background work.
struct LoadedMaterial {
  static constexpr std::array<int, 4> albedoDegrees{0, 30, 60, 80};

  materials::Material material;
  std::shared_ptr<const editing::BlendSource> blend = nullptr;  ///< of a material without a file of its own
  /// What is shown, edited and exported: the measurement in its own form. Of the forms that the preview does not know
  /// (widgets::isShownNatively()) a table stands for it.
  std::shared_ptr<const Brdf> base;
  std::shared_ptr<const TabulatedLobe> lobe = nullptr;  ///< of the base
  TableStatistics statistics;                           ///< of what is no table on a coarse grid
  std::array<Rgb, 4> albedo;

  /// Whether the base was sampled from another form: it has an error of its own.
  bool isSampled() const { return material.brdf && material.brdf != base; }
  /// Whether table() is the base itself.
  bool isTable() const { return base->asTable() != nullptr; }
  /// The table that fits, factors and codes are made of: the base, or sampled from it at the first call (up to a
  /// second, of an anisotropic measurement some seconds, in which others wait). Not for the GUI thread. @throws
  /// Cancelled.
  std::shared_ptr<const TabulatedBrdf> table(const TaskControl& control = {}) const;
  /// What models are fitted to: the base where it is anisotropic, else table(). Not for the GUI thread. @throws
  /// Cancelled.
  std::shared_ptr<const Brdf> fitBase(const TaskControl& control = {}) const;
  /// In memory: of the tables that there are now.
  std::size_t bytes() const;

 private:
  struct Sampled {
    std::mutex mutex;
    std::shared_ptr<const TabulatedBrdf> table;
  };
  std::shared_ptr<Sampled> m_sampled = std::make_shared<Sampled>();
};
using LoadedMaterialPtr = std::shared_ptr<const LoadedMaterial>;

/// Reads a material and measures what the source panel shows: some tenths of a second; up to some seconds for forms
/// that are tabulated.
/// @throws Error, Cancelled.
LoadedMaterialPtr loadMaterial(const std::filesystem::path& path, const TaskControl& control = {});
/// The same, or a document with its edits applied as a material of its own.
LoadedMaterialPtr loadEdited(const std::filesystem::path& path, const TaskControl& control = {});
/// What a document of resolved paths is about, without its edits. @throws Error, Cancelled.
LoadedMaterialPtr loadSource(const editing::EditDocument& document, const TaskControl& control = {});
/// The same of a material that is there already.
LoadedMaterialPtr measuredMaterial(materials::Material material, std::shared_ptr<const editing::BlendSource> blend,
                                   const TaskControl& control = {});

/// What a material is before its edits: "Measured" (also where a file holds its code or its factors), "Published fit"
/// or "Kept blend".
QString sourceKind(const LoadedMaterial& material);

}  // namespace gonio::app
