// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QString>
#include <optional>

#include "core/matching/reference_cells.h"
#include "core/rendering/tone_map.h"

namespace gonio::app {

/// Whether a file is an image that can only be a reference, by its suffix: all formats that Qt reads, but not HDR and
/// EXR, which are environments too.
bool isReferenceImageFile(const QString& path);
/// The patterns of all files that can be opened as reference images: "*.png *.jpg ...".
QString referenceImagePatterns();

/// How the values of an image are converted to radiance.
enum class ImageTones {
  clamp,      ///< rendered with the tone map Clamp and the exposure of the view
  filmic,     ///< the same with the tone map Filmic
  photograph  ///< unknown exposure
};

/// An image of a sphere, as read from a file.
struct ReferenceImage {
  QString path;
  QImage shown;                         ///< for display; of HDR and EXR files with exposure 0
  Image values;                         ///< linear display values, or radiance if isRadiance
  bool isRadiance = false;              ///< from an HDR or EXR file
  std::optional<matching::Disc> found;  ///< of the sphere; empty if none was found
  matching::Disc disc;                  ///< the found one, or a circle in the middle; changed by the user

  QString name() const { return path.section('/', -1); }
  /// The radiance for matching. @param exposure of the view, stops.
  matching::ReferencePicture picture(ImageTones tones, double exposure) const;
};

/// Reads an image and finds its sphere. @throws Error that names the file.
ReferenceImage readReferenceImage(const QString& path);

}  // namespace gonio::app
