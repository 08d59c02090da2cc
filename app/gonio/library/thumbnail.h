// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <chrono>

#include "core/materials/material.h"
#include "widgets/library/library_model.h"

namespace gonio::app {

/// A thumbnail that would take longer than it may.
class TooSlow : public Error {
 public:
  using Error::Error;
};

/// The thumbnail of a material: a sphere in the studio environment on a transparent background. A bundled material has
/// a built-in one (bundledThumbnail()). Others are rendered from the native form and cached in `cacheFolder`, by the
/// hash of the material's content and the version of the renderer. @param limit on the time, so that one material does
/// not hold up a whole library. @throws Error; TooSlow; Cancelled.
widgets::LibraryThumbnail materialThumbnail(const QString& id, const QString& cacheFolder, const TaskControl& control,
                                            std::chrono::milliseconds limit = std::chrono::seconds(30));

/// Reads the material of a library id: a bundled material, a file, or a document with its edits applied.
/// @throws Error, Cancelled.
materials::Material libraryMaterial(const QString& id, const TaskControl& control);

/// In the user's cache folder.
QString thumbnailCacheFolder();
/// The folder of documents that the user saved in the library, in the user's data folder.
QString ownMaterialsFolder();

}  // namespace gonio::app
