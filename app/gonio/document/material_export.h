// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QStringList>

#include "app/gonio/document/loaded_material.h"
#include "core/editing/edit.h"
#include "core/export/material_form.h"

namespace gonio::app {

/// File filter of a form for dialogs, e.g. "RGL file (*.bsdf)".
QString formFilter(exports::MaterialForm form);

/// Content that a written file cannot represent; empty: none.
struct ExportLosses {
  QStringList sentences;
  double snr = 0;  ///< rendered SNR of the file against the material, dB, if something was lost

  /// A message for the user.
  QString text() const;
};

/// Writes a material with its edits, atomically. If content is lost, measures the error (a few seconds). Not for the
/// GUI thread.
/// @param base base of the material, read with the displayed incident direction
/// @throws Error that names the file; Cancelled.
ExportLosses writeMaterial(const LoadedMaterial& material, const std::shared_ptr<const Brdf>& base,
                           const editing::EditList& edits, exports::MaterialForm form,
                           const std::filesystem::path& path, const TaskControl& control);

}  // namespace gonio::app
