// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>

#include "widgets/preview/frame_budget.h"
#include "widgets/preview/gl/noise_filter.h"
#include "widgets/preview/picture_request.h"

namespace gonio::widgets {

/// Draws the requested picture frame by frame: chooses the number of samples per frame, determines the range of a
/// difference and composes the result. Independent of threads and widgets; all calls need the context of initialize().
class PictureDrawer : protected QOpenGLFunctions_4_1_Core {
 public:
  PictureDrawer();

  /// @throws Error if the context has no OpenGL 4.1 core functions.
  void initialize();
  /// Frees the OpenGL objects.
  void release();
  /// The listener is called before a shader is compiled, which can take a second.
  void setCompileListener(std::function<void()> listener);

  /// Adds the samples of one frame, unless the picture is complete.
  /// @throws Error with the compiler's log if a shader does not compile.
  PictureState addFrame(const PictureRequest& request);
  /// Draws the request's viewport to the bound framebuffer.
  void present(const PictureRequest& request);
  /// Time until the next frame of the request, in ms; nullopt if it has all samples.
  std::optional<int> nextFrame(const PictureRequest& request) const;
  /// The linear radiance of the first side, at the quality reached so far.
  Image readFirst() { return sides_[0].picture.readPicture(); }

 private:
  struct Side {
    explicit Side(const std::shared_ptr<PreviewResources>& resources) : picture(resources) {}
    ShownPicture shown() const { return filteredSamples > 0 ? filter.shown() : picture.shown(); }

    PreviewRenderer picture;
    NoiseFilter filter;
    int filteredSamples = 0;  ///< samples at the time of noise filtering; 0: not filtered
    int subjectNumber = -1;
    std::shared_ptr<const Film> film;  ///< the film that the picture shows; null: it is rendered by the shader
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
  bool coarse_ = false;   ///< the last frame has half or a quarter of the resolution
  double range_ = 0;      ///< 0: not determined yet
  int rangeSamples_ = 0;  ///< number of samples when the range was determined
};

}  // namespace gonio::widgets
