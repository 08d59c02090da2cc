// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QString>
#include <chrono>
#include <optional>

#include "core/brdf/brdf.h"
#include "core/materials/material.h"
#include "core/math/image.h"
#include "core/support/task_control.h"
#include "widgets/library/library_model.h"

namespace gonio::app {

/// A picture of a sphere with any BRDF in the environment "rim-lights", on a transparent background, with hue and
/// roughness as text entries of the image.
/// @throws Cancelled.
QImage spherePicture(const Brdf& brdf, int pixels, int samples, const TaskControl& control = {});

/// Converts a rendered picture to display colours with exposure 0 and the filmic tone map.
QImage displayedImage(const Image& picture);

/// Size of the pictures of the bundled materials, pixels, and their samples per pixel.
inline constexpr int bundledSide = 128, bundledSamples = 64;

/// The rendered thumbnail of a bundled material, by the SHA-256 of its content; nullopt for other materials. All
/// thumbnails are tiles of one JPEG file, resources/thumbnails/bundled.jpg; coverage.png is the coverage of the sphere,
/// which is the same in all of them. The first call decodes them (20 ms). Thread-safe.
std::optional<widgets::LibraryThumbnail> bundledThumbnail(const std::string& sha256);

/// Renders the thumbnails of all bundled materials, in about half a second each, and writes bundled.jpg, bundled.csv
/// and coverage.png to a folder. Called by scripts/thumbnails.sh. @throws Error that names the file; Cancelled.
void writeBundledThumbnails(const QString& folder, const TaskControl& control = {});

/// A thumbnail that would take longer than it may.
class TooSlow : public Error {
 public:
  using Error::Error;
};

/// The thumbnail of a material: spherePicture(). A bundled material has
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
