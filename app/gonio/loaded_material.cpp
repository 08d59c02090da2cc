// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/loaded_material.h"

namespace gonio::app {

namespace {

/// The control of one part of a longer task.
TaskControl part(const TaskControl& control, double from, double to) {
  return {control.stop, [&control, from, to](double share) { control.report(from + share * (to - from)); }};
}

}  // namespace

LoadedMaterialPtr loadMaterial(const std::filesystem::path& path, const TaskControl& control) {
  auto loaded = std::make_shared<LoadedMaterial>();
  loaded->material = io::readMaterial(path, part(control, 0, 0.3));
  control.throwIfStopped();
  loaded->table = loaded->material.tabulated(part(control, 0.3, 0.8));
  loaded->lobe = estimateSamplingLobe(*loaded->table);
  loaded->statistics = tableStatistics(*loaded->table);
  for (std::size_t i = 0; i < loaded->albedo.size(); ++i) {
    control.throwIfStopped();
    loaded->albedo[i] = directionalAlbedo(*loaded->table, radians(LoadedMaterial::albedoDegrees[i]));
    control.report(0.8 + 0.05 * double(i + 1));
  }
  return loaded;
}

}  // namespace gonio::app
