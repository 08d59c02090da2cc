// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QSize>
#include <array>
#include <chrono>
#include <memory>

#include "core/rendering/effect_plan.h"
#include "core/rendering/film.h"
#include "widgets/preview/gl/preview_display.h"
#include "widgets/preview/gl/preview_subject.h"

namespace gonio::widgets {

/// Time without a change after which a picture is at rest.
inline constexpr std::chrono::milliseconds timeToRest{120};

/// Description of a picture, passed by value from the GUI thread to the rendering thread.
struct PictureRequest {
  struct Side {
    PreviewSubject subject;
    int subjectNumber = 0;  ///< changes with the subject or its lobe
    EffectPlan plan;
    std::shared_ptr<const Film> film;  ///< path-traced picture that replaces the shader's, or null
  };

  int number = 0;  ///< number of the request, increasing
  std::array<Side, 2> sides;
  Scene scene;
  std::vector<PreviewSubject> otherSlotSubjects = {};  ///< see PreviewRenderer::setScene()
  bool isDrawn = true;                                 ///< whether the shader renders; else only films are shown
  bool filtersNoise = false;                           ///< for display, as long as there are fewer samples than wanted
  bool drawsAtRest = true;  ///< whether the shader also renders at rest; if not, a film replaces its picture
  bool comparing = false;   ///< whether the second side is shown
  bool flickering = false;
  PreviewComparison comparison;
  DisplaySettings display;
  QSize viewport{1, 1}, picture{1, 1};            ///< pixels; the whole viewport and one side
  int wantedSamples = 64;                         ///< per pixel
  std::chrono::steady_clock::time_point changed;  ///< time of the user's last change
};

/// The result of rendering.
struct PictureState {
  struct Side {
    QSize size;
    int samples = 0;
    bool isTraced = false;    ///< whether a film is shown
    bool isFiltered = false;  ///< whether noise was filtered
  };

  int number = 0;  ///< of the request
  std::array<Side, 2> sides;
  double range = 0;         ///< the difference shown in the last colour; 0: not determined yet
  double milliseconds = 0;  ///< time for the new samples
  bool isNew = false;       ///< whether the first side has new samples
  QImage picture;           ///< the final picture, with the viewport's size
};

}  // namespace gonio::widgets
