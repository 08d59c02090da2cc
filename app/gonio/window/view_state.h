// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <nlohmann/json.hpp>

#include "core/rendering/scene.h"
#include "core/rendering/tone_map.h"

namespace gonio::widgets {
class PreviewWidget;
}

namespace gonio::app {

/// Scene, camera, light, exposure and tone map of a preview, in the format of .gonio files. Scene and environment are
/// stored by bundled name or file path.
nlohmann::json viewToJson(const widgets::PreviewWidget& preview);

/// Restores everything except the scene and the environment, which must be read first. Missing keys and keys of the
/// wrong type are ignored.
void restoreView(widgets::PreviewWidget& preview, const nlohmann::json& view);
/// The scene of a view; the single sphere if it does not name one.
QString sceneNameOf(const nlohmann::json& view);
/// The environment of a view: a bundled name, a path, or empty for the distant light; nullopt if the view does not
/// contain it.
std::optional<QString> environmentOf(const nlohmann::json& view);

}  // namespace gonio::app
