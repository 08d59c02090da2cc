// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QSize>
#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "core/rendering/effect_plan.h"
#include "core/rendering/film.h"
#include "widgets/preview/gl/noise_filter.h"
#include "widgets/preview/gl/preview_display.h"
#include "widgets/preview/gl/preview_subject.h"

namespace gonio::widgets {

/// Chooses the number of samples and the scale of a frame from the measured cost of previous frames, so that
/// interaction stays fluid and a picture at rest converges quickly. Plain arithmetic, no OpenGL.
class FrameBudget {
 public:
  static constexpr double interactiveMs = 8;  ///< also of the first frame after a change: half a frame of a display
  static constexpr double restingMs = 80;
  static constexpr int maxSamplesPerFrame = 64;
  /// If the time allows fewer samples than this, the first frame has half the resolution; if one sample at half
  /// resolution takes longer than maxFirstFrameMs, a quarter.
  static constexpr int minFirstSamples = 6;
  static constexpr double maxFirstFrameMs = 30;

  struct Frame {
    int samples;
    double scale;  ///< of the resolution: 1, 0.5 or 0.25
  };
  /// @param pixels of the picture at full scale; @param accumulated samples so far (0: first frame after a change);
  /// @param wanted samples of the converged picture; @param resting nothing has changed for a while.
  /// @param addsChange the first frame shows the change of a known picture, for which a quarter is enough.
  Frame next(double pixels, int accumulated, int wanted, bool resting, bool addsChange = false) const;

  /// Records the cost of a frame.
  void record(double pixels, int samples, double milliseconds);

 private:
  double nsPerSample_ = 15;
};

/// Time without a change after which a picture is at rest.
inline constexpr std::chrono::milliseconds timeToRest{120};

/// Description of a picture, passed by value from the GUI thread to the rendering thread.
struct PictureRequest {
  struct Side {
    PreviewSubject subject;
    int subjectNumber = 0;  ///< changes with the subject or its density
    rendering::EffectPlan plan;
    std::shared_ptr<const rendering::Film> film;  ///< path-traced picture that replaces the shader's, or null
  };

  int number = 0;  ///< number of the request, increasing
  std::array<Side, 2> sides;
  rendering::Scene scene;
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

  /// Whether a step of the hand since the other request makes its frames useless: of the material, camera or light.
  bool replaces(const PictureRequest& other) const;
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
  bool isObsolete = false;  ///< drawing was ended by PictureDrawer::addFrame()'s isObsolete
  QImage picture;           ///< the final picture, with the viewport's size
};

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
  /// @param isObsolete asked every few ms while a frame after the first one of a material and scene is drawn: if true,
  /// it is ended.
  /// @throws Error with the compiler's log if a shader does not compile.
  PictureState addFrame(const PictureRequest& request, const std::function<bool()>& isObsolete = {});
  /// Draws the request's viewport to the bound framebuffer.
  void present(const PictureRequest& request);
  /// Time until the next frame of the request, in ms; nullopt if it has all samples.
  std::optional<int> nextFrame(const PictureRequest& request) const;
  /// The linear radiance of the first side, at the quality reached so far.
  Image readFirst() { return sides_[0].picture.readPicture(); }

 private:
  struct Side {
    explicit Side(const std::shared_ptr<PreviewResources>& resources) : picture(resources) {}
    ShownPicture shown() const { return isFiltered() ? filter.shown() : picture.shown(); }
    bool isFiltered() const { return filteredSamples > 0 || showsChange; }

    PreviewRenderer picture;
    NoiseFilter filter;
    KnownPicture known;
    int filteredSamples = 0;                  ///< samples at the time of noise filtering; 0: not filtered
    bool showsChange = false;                 ///< the filter shows the known picture with the change
    int subjectNumber = -1, filmNumber = -1;  ///< of the renderer's subject, and of the film's
    std::shared_ptr<const rendering::Film>
        film;  ///< the film that the picture shows; null: it is rendered by the shader
  };

  void take(const PictureRequest& request);
  static void forget(Side& side);
  void keepKnown(Side& side, const PictureRequest& request);
  bool startsCoarse(const PictureRequest& request) const;
  bool takeFilm(Side& side, const PictureRequest::Side& wanted);
  void filterNoise(Side& side, const PictureRequest& request);
  void addSamples(const PictureRequest& request, PictureState& state, const std::function<bool()>& isObsolete);
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
