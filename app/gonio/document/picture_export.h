// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QColor>
#include <QString>

#include "core/rendering/picture_refinement.h"
#include "core/rendering/tone_map.h"

namespace gonio::app {

/// The background of a written picture.
enum class PictureBackground { environment, transparent, colour };

/// A picture to be rendered and written: content, size, quality and format.
struct PictureExport {
  QString path;  ///< its suffix decides: `.exr` 32-bit linear radiance, else 8-bit sRGB PNG
  Scene scene;
  EffectOverrides overrides;
  RenderMaterials otherSlotMaterials;  ///< from slot 1 on, see materialsInSlots()
  int width = 1024, height = 1024;
  RefinementLimits limits;
  PictureBackground background = PictureBackground::transparent;
  QColor colour = Qt::black;  ///< of the background; its linear value in an EXR
  double exposure = 0;        ///< stops; PNG only
  ToneMap toneMap = ToneMap::filmic;

  bool isExr() const { return path.endsWith(QStringLiteral(".exr"), Qt::CaseInsensitive); }
  /// The scene with the picture's background.
  Scene shownScene() const;
};

/// Input of the path tracer.
struct PicturePlan {
  Scene scene;
  RenderMaterials materials;
  EffectPlan plan;
};
PicturePlan planPicture(const PictureExport& request, const std::shared_ptr<const Brdf>& edited);

/// Renders a picture and writes it atomically. Not for the GUI thread.
/// @param edited the document's material with its edits, named `name`. @throws Error that names the file; Cancelled.
void writeRenderedPicture(const PictureExport& request, const std::shared_ptr<const Brdf>& edited,
                          const std::string& name, const TaskControl& control, const Pause& pause);

/// Composes an image over a colour. The bytes are sRGB with straight alpha, mixed in linear light; the resulting alpha
/// is 255.
void composeOver(const QColor& colour, std::span<std::uint8_t> rgba);
/// The same for linear radiance; the image then has no alpha.
void composeOver(const QColor& colour, Image& image);

}  // namespace gonio::app
