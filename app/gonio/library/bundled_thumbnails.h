// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <optional>

#include "core/support/task_control.h"
#include "widgets/library/library_model.h"

namespace gonio::app {

/// Size of the pictures of the bundled materials, pixels, and their samples per pixel.
inline constexpr int bundledSide = 128, bundledSamples = 64;

/// The rendered thumbnail of a bundled material, by the SHA-256 of its content; nullopt for other materials. All
/// thumbnails are tiles of one JPEG file, resources/thumbnails/bundled.jpg; coverage.png is the coverage of the sphere,
/// which is the same in all of them. The first call decodes them (20 ms). Thread-safe.
std::optional<widgets::LibraryThumbnail> bundledThumbnail(const std::string& sha256);

/// Renders the thumbnails of all bundled materials, in about half a second each, and writes bundled.jpg, bundled.csv
/// and coverage.png to a folder. Called by scripts/thumbnails.sh. @throws Error that names the file; Cancelled.
void writeBundledThumbnails(const QString& folder, const TaskControl& control = {});

}  // namespace gonio::app
