// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QColor>
#include <QString>

#include "core/rendering/picture_refinement.h"
#include "core/rendering/tone_map.h"

namespace gonio::app {

/// What lies behind the objects of a written picture.
enum class PictureBackground { environment, transparent, colour };

/// A picture that is to be rendered and written: what, how large, how well, in which form.
struct PictureExport {
  QString path;  ///< its suffix decides: `.exr` 32-bit linear radiance, else 8-bit sRGB PNG
  Scene scene;
  EffectOverrides overrides;
  RenderMaterials others;  ///< beside the document's material, see materialsInSlots()
  int width = 1024, height = 1024;
  RefinementLimits limits;
  PictureBackground background = PictureBackground::transparent;
  QColor colour = Qt::black;  ///< of the background; in an EXR as its linear value
  double exposure = 0;        ///< stops; PNG only
  ToneMap toneMap = ToneMap::filmic;

  bool isExr() const { return path.endsWith(QStringLiteral(".exr"), Qt::CaseInsensitive); }
  /// The scene with the background that the picture asks for.
  Scene shownScene() const;
};

/// What the path tracer needs of a picture.
struct PicturePlan {
  Scene scene;
  RenderMaterials materials;
  EffectPlan plan;
};
PicturePlan planPicture(const PictureExport& request, const std::shared_ptr<const Brdf>& edited);

/// Renders and writes it, atomically. Not for the GUI thread.
/// @param edited the document's material with its edits, named `name`. @throws Error naming the file; Cancelled.
void writeRenderedPicture(const PictureExport& request, const std::shared_ptr<const Brdf>& edited,
                          const std::string& name, const TaskControl& control, const Pause& pause);

/// An image over a colour: straight sRGB bytes, mixed in linear light; alpha 255.
void composeOver(const QColor& colour, std::span<std::uint8_t> rgba);
/// The same of linear radiance; the image then has no alpha.
void composeOver(const QColor& colour, Image& image);

}  // namespace gonio::app
