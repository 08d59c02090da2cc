// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

#include "core/materials/material.h"
#include "widgets/library/library_model.h"

namespace gonio::app {

/// The thumbnail of a material: a sphere in the studio environment on a transparent background, 192 x 192, or for a
/// bundled material the built-in one, 128 x 128. Read from the disk cache in `cacheFolder`, with the material's content
/// hash and the version of the renderer as key, else rendered from the native form (without a table) in about 100 ms
/// and cached.
/// @throws Error, Cancelled.
widgets::LibraryThumbnail materialThumbnail(const QString& id, const QString& cacheFolder, const TaskControl& control);

/// Reads the material of a library id: a bundled material, a file, or a document with its edits applied.
/// @throws Error, Cancelled.
materials::Material libraryMaterial(const QString& id, const TaskControl& control);

/// In the user's cache folder.
QString thumbnailCacheFolder();
/// The folder of documents that the user saved in the library, in the user's data folder.
QString ownMaterialsFolder();

}  // namespace gonio::app
