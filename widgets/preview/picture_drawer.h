// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>

#include "widgets/preview/frame_budget.h"
#include "widgets/preview/gl/noise_filter.h"
#include "widgets/preview/picture_request.h"

namespace gonio::widgets {

/// Draws what is requested, a frame at a time: decides how many samples the frame gets, finds the range of a
/// difference, puts it all together. Knows neither threads nor widgets; every call needs the context of initialize().
class PictureDrawer : protected QOpenGLFunctions_4_1_Core {
 public:
  PictureDrawer();

  /// @throws Error when the context has no OpenGL 4.1 core functions.
  void initialize();
  /// Frees what belongs to the context.
  void release();
  /// Called before a shader is compiled, which can take a second.
  void setCompileListener(std::function<void()> listener);

  /// Adds a frame's samples where some are missing.
  /// @throws Error with the compiler's log when a shader does not compile.
  PictureState addFrame(const PictureRequest& request);
  /// Draws the request's viewport into the framebuffer that is bound.
  void present(const PictureRequest& request);
  /// When the next frame of the request is due, in ms; nothing once it has all its samples.
  std::optional<int> nextFrame(const PictureRequest& request) const;
  /// The linear radiance of the first side so far.
  Image readFirst() { return sides_[0].picture.readPicture(); }

 private:
  struct Side {
    explicit Side(const std::shared_ptr<PreviewResources>& resources) : picture(resources) {}
    ShownPicture shown() const { return filteredSamples > 0 ? filter.shown() : picture.shown(); }

    PreviewRenderer picture;
    NoiseFilter filter;
    int filteredSamples = 0;  ///< that were there when the noise was filtered; 0: it is not
    int subjectNumber = -1;
    std::shared_ptr<const Film> film;  ///< that the picture shows; null: what is drawn
  };

  void take(const PictureRequest& request);
  bool takeFilm(Side& side, const PictureRequest::Side& wanted);
  void filterNoise(Side& side, const PictureRequest& request);
  void addSamples(const PictureRequest& request, PictureState& state);
  void updateRange(const PictureRequest& request);
  bool needsSamples(const PictureRequest& request, std::size_t side) const;

  std::shared_ptr<PreviewResources> resources_;
  std::array<Side, 2> sides_;
  PreviewDisplay display_;
  FrameBudget budget_;
  PreviewComparison comparison_;
  bool coarse_ = false;   ///< the last frame has half the resolution
  double range_ = 0;      ///< 0: not found yet
  int rangeSamples_ = 0;  ///< at which the range was found
};

}  // namespace gonio::widgets
