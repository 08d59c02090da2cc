// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/material_export.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "core/export/export_origin.h"
#include "core/io/atomic_file.h"
#include "core/support/file_in_errors.h"

namespace gonio::app {

using exports::MaterialForm;

namespace {

struct MaterialExportText {
  Q_DECLARE_TR_FUNCTIONS(MaterialExport)
};

bool isAnisotropic(const editing::EditList& edits) {
  return std::ranges::any_of(edits, [](const auto& edit) { return editing::isAnisotropic(edit); });
}

bool isTable(MaterialForm form) { return exports::formatOf(form) == materials::FormatId::merl; }

}  // namespace

QString formFilter(MaterialForm form) {
  switch (form) {
    case MaterialForm::rgl:
      return MaterialExportText::tr("RGL file (*.bsdf)");
    case MaterialForm::utia:
      return MaterialExportText::tr("UTIA file (*.bin)");
    case MaterialForm::foldedTable:
      return MaterialExportText::tr("MERL file, 90 × 90 × 180 (*.binary)");
    default:
      return MaterialExportText::tr("360-degree MERL file, 90 × 90 × 360 (*.binary)");
  }
}

QString ExportLosses::text() const {
  const QString all = sentences.join(QStringLiteral("; "));
  return std::isfinite(snr)
             ? MaterialExportText::tr("%1. Rendered SNR of the file: %2 dB.").arg(all).arg(snr, 0, 'f', 1)
             : MaterialExportText::tr("%1. Images of the file and of the material are identical.").arg(all);
}

ExportLosses writeMaterial(const LoadedMaterial& material, const std::shared_ptr<const Brdf>& base,
                           const editing::EditList& edits, MaterialForm form, const std::filesystem::path& path,
                           const TaskControl& control) {
  materials::Material own = material.material;
  if (!own.brdf) own.brdf = material.base;
  const std::shared_ptr<const Brdf> shown = editing::isIdentity(edits) ? base : editing::applyEdits(base, edits);
  exports::ExportSource source = exports::exportSource(own.name, own, shown, edits);
  // Cell by cell: cells without data keep none.
  const bool baked = base->asTable() && shown != base && isTable(form);
  if (baked) source.brdf = editing::bakeEdits(base, edits, control.between(0, 0.2));
  ExportLosses losses;
  exports::FormFile file = exports::encodeMaterial(source, own, form, control.between(0.2, 0.6));
  if (baked && isAnisotropic(edits)) file.losses.push_back(exports::azimuthLoss());
  for (const std::string& loss : file.losses) losses.sentences << QString::fromStdString(loss);
  if (!file.losses.empty()) losses.snr = exports::formSnr(file, *shown, control.between(0.6, 1));
  control.throwIfStopped();
  withFileInErrors(path, [&] { io::writeFileAtomically(path, file.bytes); });
  return losses;
}

}  // namespace gonio::app
