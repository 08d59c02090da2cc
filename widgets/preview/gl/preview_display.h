// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <qopengl.h>
#include <QColor>

#include "core/rendering/tone_map.h"
#include "widgets/preview/gl/preview_comparison.h"
#include "widgets/preview/gl/preview_resources.h"

namespace gonio::widgets {

/// A picture that can be displayed.
struct ShownPicture {
  GLuint texture = 0;  ///< premultiplied linear radiance and coverage, times `samples`; 0: no picture yet
  float samples = 1;
};

/// Conversion of radiance to display colours.
struct DisplaySettings {
  double exposure = 0;  ///< stops
  rendering::ToneMap toneMap = rendering::ToneMap::filmic;
  QColor backgroundCentre{58, 58, 60}, backgroundEdge{34, 34, 36};
  bool checker = false;  ///< draws grey squares instead, which show transparency
};

/// Displays one accumulated picture, or two in comparison. The shader contains only what the mode needs.
class PreviewDisplay : protected QOpenGLFunctions_4_1_Core {
 public:
  explicit PreviewDisplay(std::shared_ptr<PreviewResources> resources) : resources_(std::move(resources)) {}
  void initialize() { initializeOpenGLFunctions(); }

  /// Draws to the bound framebuffer. For a picture without samples the background is shown.
  void present(const QSize& viewport, const DisplaySettings& settings, const ShownPicture& picture);
  /// Draws two pictures according to comparison.mode (split, difference, twoUp; other modes show `first` alone).
  /// @param range the difference shown in the last colour of the map, > 0.
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
