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

/// A picture is at rest after so long without a change.
inline constexpr std::chrono::milliseconds timeToRest{120};

/// What is to be seen: a value that the GUI thread hands to the thread that draws.
struct PictureRequest {
  struct Side {
    PreviewSubject subject;
    int subjectNumber = 0;  ///< another number: another subject, or another lobe of it
    EffectPlan plan;
    std::shared_ptr<const Film> film;  ///< traced on the CPU, to be shown in place of what is drawn; or null
  };

  int number = 0;  ///< of the request, rising
  std::array<Side, 2> sides;
  Scene scene;
  std::vector<PreviewSubject> others = {};  ///< in the scene's slots, see PreviewRenderer::setScene()
  bool isDrawn = true;                      ///< by the shader; else films alone are shown
  bool filtersNoise = false;                ///< for the eye, while there are fewer samples than wanted
  bool drawsAtRest = true;                  ///< else a film comes then
  bool comparing = false;                   ///< the second side is wanted
  bool flickering = false;
  PreviewComparison comparison;
  DisplaySettings display;
  QSize viewport{1, 1}, picture{1, 1};            ///< pixels; of all and of one side
  int wantedSamples = 64;                         ///< of every pixel
  std::chrono::steady_clock::time_point changed;  ///< by the user, at last
};

/// What has been drawn.
struct PictureState {
  struct Side {
    QSize size;
    int samples = 0;
    bool isTraced = false;    ///< a film is shown
    bool isFiltered = false;  ///< without its noise
  };

  int number = 0;  ///< of the request
  std::array<Side, 2> sides;
  double range = 0;         ///< the difference that has the last colour; 0: not found yet
  double milliseconds = 0;  ///< of the new samples
  bool isNew = false;       ///< the first side has got samples
  QImage picture;           ///< as it is to be shown, of the viewport's size
};

}  // namespace gonio::widgets
