// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QStringList>

#include "app/gonio/document/loaded_material.h"
#include "core/editing/edit.h"
#include "core/export/material_form.h"

namespace gonio::app {

/// A form for people, with the pattern of its files: "RGL material (*.bsdf)".
QString formFilter(exports::MaterialForm form);

/// What a written file cannot hold; empty: nothing.
struct ExportLosses {
  QStringList sentences;
  double snr = 0;  ///< of the file against the material, dB, where something was lost

  /// One text for people.
  QString text() const;
};

/// Writes a material with its edits, atomically; where something is lost its error is measured (some seconds). Not for
/// the GUI thread.
/// @param base of the material in the order of the directions that is shown
/// @throws Error naming the file; Cancelled.
ExportLosses writeMaterial(const LoadedMaterial& material, const std::shared_ptr<const Brdf>& base,
                           const editing::EditList& edits, exports::MaterialForm form,
                           const std::filesystem::path& path, const TaskControl& control);

}  // namespace gonio::app
