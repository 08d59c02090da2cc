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

/// Camera, light, exposure and tone map of a preview, as a .gonio file keeps them. The environment is kept by its name:
/// a bundled one's, or the path of its file.
nlohmann::json viewToJson(const widgets::PreviewWidget& preview);

/// What can be set at once. Keys that are missing or of the wrong type leave the view as it is.
void restoreView(widgets::PreviewWidget& preview, const nlohmann::json& view);
/// The environment that a view asks for: a bundled name, a path, or empty for the directional light; nothing when the
/// view does not tell.
std::optional<QString> environmentOf(const nlohmann::json& view);

}  // namespace gonio::app
