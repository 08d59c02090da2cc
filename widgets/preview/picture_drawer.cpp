// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/picture_drawer.h"

#include <algorithm>

#include "core/support/error.h"
#include "widgets/preview/gl/textures.h"

namespace gonio::widgets {

FrameBudget::Frame FrameBudget::next(double pixels, int accumulated, int wanted, bool resting, bool addsChange) const {
  const double budget = (resting && accumulated > 0 ? restingMs : interactiveMs) * 1e6;
  const auto affordable = [&](double atPixels) {
    return std::clamp(static_cast<int>(budget / std::max(1.0, nsPerSample_ * atPixels)), 1, maxSamplesPerFrame);
  };
  const int full = affordable(pixels);
  if (accumulated == 0 && full < minFirstSamples) {
    const double mostMs = addsChange ? interactiveMs : maxFirstFrameMs;
    const double scale = nsPerSample_ * pixels / 4 > mostMs * 1e6 ? 0.25 : 0.5;
    return {affordable(pixels * scale * scale), scale};
  }
  return {std::min(full, std::max(1, wanted - accumulated)), 1.0};
}

void FrameBudget::record(double pixels, int samples, double milliseconds) {
  const double measured = milliseconds * 1e6 / std::max(1.0, pixels * samples);
  // One slow frame (a page fault, another program) must not starve the next ones: move half way.
  nsPerSample_ = 0.5 * (nsPerSample_ + measured);
}

namespace {
/// With fewer, a picture is not worth being kept.
constexpr int fewestKnownSamples = 8;

bool isAtRest(const PictureRequest& request) {
  return std::chrono::steady_clock::now() - request.changed >= timeToRest;
}
}  // namespace

bool PictureRequest::replaces(const PictureRequest& other) const {
  return sides[0].subjectNumber != other.sides[0].subjectNumber ||
         sides[1].subjectNumber != other.sides[1].subjectNumber || scene.camera != other.scene.camera ||
         scene.environmentRotation != other.scene.environmentRotation || picture != other.picture;
}

PictureDrawer::PictureDrawer()
    : resources_(std::make_shared<PreviewResources>()),
      sides_{Side(resources_), Side(resources_)},
      display_(resources_) {}

void PictureDrawer::initialize() {
  if (!initializeOpenGLFunctions()) throw Error(openGlTooOld);
  for (Side& side : sides_) side.picture.initialize();
  display_.initialize();
}

void PictureDrawer::release() {
  for (Side& side : sides_) {
    side.picture.release();
    side.filter.release();
    forget(side);
    side.filteredSamples = 0;
  }
  resources_->release();
}

void PictureDrawer::setCompileListener(std::function<void()> listener) {
  resources_->setCompileListener(std::move(listener));
}

void PictureDrawer::take(const PictureRequest& request) {
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    Side& side = sides_[i];
    const PictureRequest::Side& wanted = request.sides[i];
    // If a scene is not drawn, the previous film stays until the next one is ready.
    if (!request.isDrawn && !wanted.subject.isEmpty()) continue;
    if (wanted.film) continue;
    const bool changes = wanted.subjectNumber != side.subjectNumber;
    if (changes) keepKnown(side, request);
    if (side.film) {
      side.picture.restart();
      side.film.reset();
    }
    if (changes) {
      side.picture.setSubject(wanted.subject);
      side.subjectNumber = wanted.subjectNumber;
    }
    const bool sameScene =
        !request.isDrawn || !side.picture.setScene(request.scene, wanted.plan, request.otherSlotSubjects);
    if (!sameScene || !request.filtersNoise || !side.known.serves(wanted.subject, request.picture)) forget(side);
  }
  if (request.comparison.difference != comparison_.difference || request.comparison.range != comparison_.range)
    range_ = 0;
  comparison_ = request.comparison;
}

bool PictureDrawer::startsCoarse(const PictureRequest& request) const {
  const double pixels = double(request.picture.width()) * request.picture.height() * (request.comparing ? 2 : 1);
  return budget_.next(pixels, 0, request.wantedSamples, true).scale < 1;
}

void PictureDrawer::forget(Side& side) {
  side.known.release();
  side.showsChange = false;
}

/// Comes before the subject changes.
void PictureDrawer::keepKnown(Side& side, const PictureRequest& request) {
  const bool isOfSubject = !side.film || side.filmNumber == side.subjectNumber;
  if (!isOfSubject || side.picture.size() != request.picture || side.picture.samples() < fewestKnownSamples) return;
  if (!request.filtersNoise || !startsCoarse(request)) return forget(side);
  side.known.keep(side.picture, side.filteredSamples > 0 ? &side.filter : nullptr);
  side.filteredSamples = 0;
}

PictureState PictureDrawer::addFrame(const PictureRequest& request, const std::function<bool()>& isObsolete) {
  take(request);
  PictureState state{.number = request.number};
  for (std::size_t i = 0; i < sides_.size(); ++i)
    if (takeFilm(sides_[i], request.sides[i]) && i == 0) state.isNew = true;
  addSamples(request, state, isObsolete);
  if (state.isObsolete) return state;
  for (Side& side : sides_) filterNoise(side, request);
  updateRange(request);
  state.range = range_;
  for (std::size_t i = 0; i < sides_.size(); ++i)
    state.sides[i] = {sides_[i].picture.size(), sides_[i].picture.samples(), sides_[i].film != nullptr,
                      sides_[i].isFiltered()};
  return state;
}

/// @returns whether it is a new one.
bool PictureDrawer::takeFilm(Side& side, const PictureRequest::Side& wanted) {
  if (!wanted.film || wanted.film == side.film) return false;
  if (side.showsChange && wanted.film->samples < fewestKnownSamples) return false;
  forget(side);
  side.film = wanted.film;
  side.filmNumber = wanted.subjectNumber;
  side.filteredSamples = 0;
  side.picture.showTraced(*wanted.film);
  return true;
}

/// Again whenever the samples have doubled: filtering takes as long as some of them.
void PictureDrawer::filterNoise(Side& side, const PictureRequest& request) {
  const int samples = side.picture.samples();
  if (side.known.isKept() && samples > 0) {
    if (side.picture.size() != request.picture) {
      if (side.filteredSamples == 0) side.filter.apply(*this, *resources_, side.picture, &side.known);
      side.filteredSamples = samples;
      side.showsChange = true;
      return;
    }
    // The change shows less noise than the first samples at the full resolution.
    if (side.showsChange && samples < std::min(fewestKnownSamples, request.wantedSamples)) return;
    forget(side);
  }
  if (!request.filtersNoise || samples == 0 || samples >= request.wantedSamples) {
    side.filteredSamples = 0;
  } else if (side.filteredSamples == 0 || samples >= 2 * side.filteredSamples) {
    side.filter.apply(*this, *resources_, side.picture);
    side.filteredSamples = samples;
  }
}

bool PictureDrawer::needsSamples(const PictureRequest& request, std::size_t side) const {
  if (!request.isDrawn || request.sides[side].film) return false;
  if (request.sides[0].subject.isEmpty() || (side == 1 && !request.comparing)) return false;
  const PreviewRenderer& picture = sides_[side].picture;
  if (!request.drawsAtRest && picture.samples() > 0 && isAtRest(request)) return false;
  return picture.size() != request.picture || picture.samples() < request.wantedSamples;
}

void PictureDrawer::addSamples(const PictureRequest& request, PictureState& state,
                               const std::function<bool()>& isObsolete) {
  const std::array needs{needsSamples(request, 0), needsSamples(request, 1)};
  if (!needs[0] && !needs[1]) return;
  const bool resting = request.drawsAtRest && isAtRest(request);
  const double pixels = double(request.picture.width()) * request.picture.height() * (needs[0] + needs[1]);
  const int wanted = request.wantedSamples;
  const int accumulated =
      std::min(needs[0] ? sides_[0].picture.samples() : wanted, needs[1] ? sides_[1].picture.samples() : wanted);
  const auto hasKnown = [&](std::size_t i) { return !needs[i] || sides_[i].known.isKept(); };
  const bool addsChange = hasKnown(0) && hasKnown(1);
  const FrameBudget::Frame frame = budget_.next(pixels, accumulated, wanted, resting, addsChange);
  coarse_ = frame.scale < 1;
  for (std::size_t i = 0; i < sides_.size(); ++i)
    if (needs[i] && coarse_ && sides_[i].known.isKept())
      sides_[i].known.drawBefore(sides_[i].picture, request.picture * frame.scale, frame.samples);
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    if (!needs[i]) continue;
    if (sides_[i].picture.samples() == 0 || sides_[i].picture.size() != request.picture * frame.scale)
      sides_[i].filteredSamples = 0;
    sides_[i].picture.setSize(request.picture * frame.scale);
    // The first frame of each step is shown: else slow ones would never be.
    if (!sides_[i].picture.accumulate(frame.samples, accumulated > 0 ? isObsolete : nullptr)) {
      state.isObsolete = true;
      return;
    }
  }
  state.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  state.isNew = needs[0];
  budget_.record(pixels * frame.scale * frame.scale, frame.samples, state.milliseconds);
}

std::optional<int> PictureDrawer::nextFrame(const PictureRequest& request) const {
  if (!needsSamples(request, 0) && !needsSamples(request, 1)) return std::nullopt;
  // A frame at half the resolution stands until the hand rests; others are refined at once.
  return coarse_ ? int(timeToRest.count()) : 0;
}

void PictureDrawer::updateRange(const PictureRequest& request) {
  if (!request.comparing || request.comparison.mode != CompareMode::difference) return;
  if (request.comparison.range > 0) {
    range_ = request.comparison.range;
    return;
  }
  PreviewRenderer &first = sides_[0].picture, &second = sides_[1].picture;
  const int samples = std::min(first.samples(), second.samples());
  // Noise makes a range too wide: it is found again at 4 times as many samples, and at last.
  const bool due =
      range_ == 0 || samples >= 4 * rangeSamples_ || (samples >= request.wantedSamples && rangeSamples_ < samples);
  if (samples < rangeSamples_) rangeSamples_ = samples;
  if (!due || first.size() != second.size() || samples == 0) return;
  range_ = automaticRange(pictureDifferences(first.readPicture(), second.readPicture(), request.comparison.difference));
  rangeSamples_ = samples;
}

void PictureDrawer::present(const PictureRequest& request) {
  if (request.comparing && !request.flickering)
    display_.present(request.viewport, request.display, request.comparison, std::max(range_, 1e-9), sides_[0].shown(),
                     sides_[1].shown());
  else
    display_.present(request.viewport, request.display, sides_[request.flickering ? 1 : 0].shown());
}

}  // namespace gonio::widgets
