// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/loaded_material.h"

#include <QCoreApplication>
#include <QStandardPaths>

#include "core/documents/edit_document.h"
#include "core/documents/open_material.h"
#include "core/materials/bundled_library.h"
#include "core/sampling/directional_albedo.h"
#include "widgets/preview/gl/shader_base.h"

namespace gonio::app {

namespace {

/// Of a measurement without nodes of its own on the half-difference grid.
constexpr HalfDifferenceGrid coarseGrid{.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 60, .reciprocal = false};

}  // namespace

std::shared_ptr<const TabulatedBrdf> LoadedMaterial::table(const TaskControl& control) const {
  if (auto own = formOf<TabulatedBrdf>(base)) return own;
  const std::scoped_lock lock(m_sampled->mutex);
  if (!m_sampled->table) m_sampled->table = material.tabulated(control);
  return m_sampled->table;
}

fitting::FitBase LoadedMaterial::fitBase(const TaskControl& control) const {
  if (base->isIsotropic()) return {table(control), base};
  return {base, base};
}

std::size_t LoadedMaterial::bytes() const {
  if (const TabulatedBrdf* own = formOf<TabulatedBrdf>(*base)) return own->bytes();
  const std::scoped_lock lock(m_sampled->mutex);
  return m_sampled->table ? m_sampled->table->bytes() : 0;
}

LoadedMaterialPtr loadInMemory(materials::Material material, std::shared_ptr<const documents::BlendSource> blend,
                               const TaskControl& control) {
  auto loaded = std::make_shared<LoadedMaterial>();
  loaded->material = std::move(material);
  loaded->blend = std::move(blend);
  control.throwIfStopped();
  constexpr double tabulatedFraction = 0.7;
  loaded->base = loaded->material.brdf;
  if (!loaded->base || !widgets::isShownNatively(*loaded->base))
    loaded->base = loaded->material.tabulated(control.between(0, tabulatedFraction));
  control.throwIfStopped();
  loaded->density = std::make_shared<const TabulatedDensity>(*loaded->base);
  loaded->statistics = tableStatistics(loaded->isTable() ? *formOf<TabulatedBrdf>(*loaded->base)
                                                         : *bakeTable(*loaded->base, coarseGrid));
  const double each = (1 - tabulatedFraction) / double(loaded->albedo.size());
  const DirectionalAlbedo albedo(*loaded->base);
  for (std::size_t i = 0; i < loaded->albedo.size(); ++i) {
    control.throwIfStopped();
    loaded->albedo[i] = albedo(radians(LoadedMaterial::albedoDegrees[i]));
    control.report(tabulatedFraction + each * double(i + 1));
  }
  return loaded;
}

LoadedMaterialPtr loadMaterial(const std::filesystem::path& path, const TaskControl& control) {
  constexpr double readFraction = 0.3;
  return loadInMemory(materials::readMaterial(path, control.between(0, readFraction)), nullptr,
                      control.between(readFraction, 1));
}

LoadedMaterialPtr loadEdited(const std::filesystem::path& path, const TaskControl& control) {
  if (!documents::isDocumentName(path)) return loadMaterial(path, control);
  constexpr double editedFraction = 0.6;
  return loadInMemory(documents::editedMaterial(path, control.between(0, editedFraction)).shown, nullptr,
                      control.between(editedFraction, 1));
}

LoadedMaterialPtr loadSource(const documents::EditDocument& document, const TaskControl& control) {
  const double readFraction = document.blend ? 0.8 : 0.3;
  return loadInMemory(documents::readSource(document, {}, control.between(0, readFraction)), document.blend,
                      control.between(readFraction, 1));
}

QString reconstructionFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/acquired");
}

QString sourceKind(const LoadedMaterial& loaded) {
  const auto text = [](const char* kind) { return QCoreApplication::translate("LoadedMaterial", kind); };
  if (loaded.blend) return text("Blend");
  if (loaded.material.source.path.parent_path() == reconstructionFolder().toStdString()) return text("Reconstruction");
  if (loaded.material.source.format == materials::nearMeasuredFormat) return text("Close copy");
  return loaded.material.source.format == materials::sgdFormat ? text("Model fit") : text("Measured");
}

}  // namespace gonio::app
