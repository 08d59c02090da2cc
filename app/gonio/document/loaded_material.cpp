// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/loaded_material.h"

#include <QCoreApplication>

#include "core/materials/sgd_library.h"

namespace gonio::app {

LoadedMaterialPtr measuredMaterial(materials::Material material, std::shared_ptr<const editing::BlendSource> blend,
                                   const TaskControl& control) {
  auto loaded = std::make_shared<LoadedMaterial>();
  loaded->material = std::move(material);
  loaded->blend = std::move(blend);
  control.throwIfStopped();
  constexpr double tabulatedShare = 0.7;
  loaded->table = loaded->material.tabulated(control.between(0, tabulatedShare));
  loaded->lobe = estimateSamplingLobe(*loaded->table);
  loaded->statistics = tableStatistics(*loaded->table);
  const double each = (1 - tabulatedShare) / double(loaded->albedo.size());
  for (std::size_t i = 0; i < loaded->albedo.size(); ++i) {
    control.throwIfStopped();
    loaded->albedo[i] = directionalAlbedo(*loaded->table, radians(LoadedMaterial::albedoDegrees[i]));
    control.report(tabulatedShare + each * double(i + 1));
  }
  return loaded;
}

LoadedMaterialPtr loadMaterial(const std::filesystem::path& path, const TaskControl& control) {
  constexpr double readShare = 0.3;
  return measuredMaterial(materials::readMaterial(path, control.between(0, readShare)), nullptr,
                          control.between(readShare, 1));
}

LoadedMaterialPtr loadSource(const editing::EditDocument& document, const TaskControl& control) {
  const double readShare = document.blend ? 0.8 : 0.3;
  return measuredMaterial(editing::readSource(document, {}, control.between(0, readShare)), document.blend,
                          control.between(readShare, 1));
}

QString sourceKind(const LoadedMaterial& loaded) {
  const auto text = [](const char* kind) { return QCoreApplication::translate("LoadedMaterial", kind); };
  if (loaded.blend) return text("Kept blend");
  return loaded.material.source.format == materials::sgdFormat ? text("Published fit") : text("Measured");
}

}  // namespace gonio::app
