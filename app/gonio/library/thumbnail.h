// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

#include "core/materials/material.h"
#include "widgets/library/library_model.h"

namespace gonio::app {

/// The picture of a material for the library: a sphere in the studio, on a transparent ground, 192 x 192; of a bundled
/// material the one that ships, 128 x 128. Read from the disk cache under `cacheFolder`, where it lies under the
/// material's content hash and the version of the renderer; else rendered from the material's own form (no table is
/// made) and put there. Some 100 ms when it is rendered.
/// @throws Error, Cancelled.
widgets::LibraryLook materialLook(const QString& id, const QString& cacheFolder, const TaskControl& control);

/// What an id of the library is: a bundled material, a file, or a document with its edits applied.
/// @throws Error, Cancelled.
materials::Material libraryMaterial(const QString& id, const TaskControl& control);

/// Under the user's cache folder.
QString thumbnailCacheFolder();
/// Where documents lie that the user keeps in the library: under the user's data folder.
QString ownMaterialsFolder();

}  // namespace gonio::app
