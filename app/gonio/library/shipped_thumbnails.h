// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <optional>

#include "core/support/task_control.h"
#include "widgets/library/library_model.h"

namespace gonio::app {

/// Size of the pictures of the bundled materials, pixels, and their samples per pixel.
inline constexpr int shippedSide = 128, shippedSamples = 64;

/// The picture of a bundled material that is built into the program, by the SHA-256 of its content; nothing for other
/// materials. All pictures are tiles of one JPEG file, resources/thumbnails/bundled.jpg; coverage.png is the coverage
/// of the sphere, the same in all of them. The first call decodes them (20 ms). From any thread.
std::optional<widgets::LibraryLook> shippedLook(const std::string& sha256);

/// Renders the pictures of all bundled materials and writes bundled.jpg, bundled.csv and coverage.png into a
/// folder: what scripts/thumbnails.sh calls. About half a second each. @throws Error naming the file; Cancelled.
void writeShippedThumbnails(const QString& folder, const TaskControl& control = {});

}  // namespace gonio::app
