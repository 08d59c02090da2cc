// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QColor>

#include "core/rendering/tone_map.h"
#include "widgets/preview/gl/preview_comparison.h"
#include "widgets/preview/gl/preview_resources.h"
#include "widgets/preview/gl/shown_picture.h"

namespace gonio::widgets {

/// How a picture of radiance becomes one of the screen.
struct DisplaySettings {
  double exposure = 0;  ///< stops
  ToneMap toneMap = ToneMap::filmic;
  QColor backgroundCentre{58, 58, 60}, backgroundEdge{34, 34, 36};
  bool checker = false;  ///< grey squares instead, which show where the picture lets light through
};

/// Puts accumulated pictures on the screen, alone or against each other. The shader holds what the mode calls for.
class PreviewDisplay : protected QOpenGLFunctions_4_1_Core {
 public:
  explicit PreviewDisplay(std::shared_ptr<PreviewResources> resources) : resources_(std::move(resources)) {}
  void initialize() { initializeOpenGLFunctions(); }

  /// Draws into the framebuffer that is bound. A picture without a sample so far is left as background.
  void present(const QSize& viewport, const DisplaySettings& settings, const ShownPicture& picture);
  /// Two pictures by comparison.mode (split, difference, twoUp; the others show `first` alone).
  /// @param range the difference of the last colour, > 0.
  void present(const QSize& viewport, const DisplaySettings& settings, const PreviewComparison& comparison,
               double range, const ShownPicture& first, const ShownPicture& second);

 private:
  void clear(const DisplaySettings& settings);
  void bindPicture(QOpenGLShaderProgram& program, int unit, const char* name, const char* samples,
                   const ShownPicture& picture);
  void setSettings(QOpenGLShaderProgram& program, const QSize& viewport, const DisplaySettings& settings);

  std::shared_ptr<PreviewResources> resources_;
};

}  // namespace gonio::widgets
