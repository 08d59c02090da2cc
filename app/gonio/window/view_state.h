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

/// Scene, camera, light, exposure and tone map of a preview, as a .gonio file keeps them. Scene and environment are
/// kept by their names: a bundled one's, or the path of a file.
nlohmann::json viewToJson(const widgets::PreviewWidget& preview);

/// What can be set at once. Keys that are missing or of the wrong type leave the view as it is.
void restoreView(widgets::PreviewWidget& preview, const nlohmann::json& view);
/// The scene that a view asks for: the lone sphere where it does not name one.
QString sceneNameOf(const nlohmann::json& view);
/// The environment that a view asks for: a bundled name, a path, or empty for the directional light; nothing when the
/// view does not state it.
std::optional<QString> environmentOf(const nlohmann::json& view);

}  // namespace gonio::app
