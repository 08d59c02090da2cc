// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/picture_drawer.h"

#include <algorithm>

#include "core/support/error.h"
#include "widgets/preview/gl/textures.h"

namespace gonio::widgets {

FrameBudget::Frame FrameBudget::next(double pixels, int accumulated, int wanted, bool resting) const {
  const double budget = (resting && accumulated > 0 ? restingMs : interactiveMs) * 1e6;
  const auto affordable = [&](double atPixels) {
    return std::clamp(static_cast<int>(budget / std::max(1.0, nsPerSample_ * atPixels)), 1, maxSamplesPerFrame);
  };
  const int full = affordable(pixels);
  if (accumulated == 0 && full < minFirstSamples) {
    const double scale = nsPerSample_ * pixels / 4 > maxFirstFrameMs * 1e6 ? 0.25 : 0.5;
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
bool isAtRest(const PictureRequest& request) {
  return std::chrono::steady_clock::now() - request.changed >= timeToRest;
}
}  // namespace

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
    if (side.film && !wanted.film) {
      side.picture.restart();
      side.film.reset();
    }
    if (wanted.film) continue;
    if (wanted.subjectNumber != side.subjectNumber) {
      side.picture.setSubject(wanted.subject);
      side.subjectNumber = wanted.subjectNumber;
    }
    if (request.isDrawn) side.picture.setScene(request.scene, wanted.plan, request.otherSlotSubjects);
  }
  if (request.comparison.difference != comparison_.difference || request.comparison.range != comparison_.range)
    range_ = 0;
  comparison_ = request.comparison;
}

PictureState PictureDrawer::addFrame(const PictureRequest& request) {
  take(request);
  PictureState state{.number = request.number};
  for (std::size_t i = 0; i < sides_.size(); ++i)
    if (takeFilm(sides_[i], request.sides[i]) && i == 0) state.isNew = true;
  addSamples(request, state);
  for (Side& side : sides_) filterNoise(side, request);
  updateRange(request);
  state.range = range_;
  for (std::size_t i = 0; i < sides_.size(); ++i)
    state.sides[i] = {sides_[i].picture.size(), sides_[i].picture.samples(), sides_[i].film != nullptr,
                      sides_[i].filteredSamples > 0};
  return state;
}

/// @returns whether it is a new one.
bool PictureDrawer::takeFilm(Side& side, const PictureRequest::Side& wanted) {
  if (!wanted.film || wanted.film == side.film) return false;
  side.film = wanted.film;
  side.filteredSamples = 0;
  side.picture.showTraced(*wanted.film);
  return true;
}

/// Again whenever the samples have doubled: filtering takes as long as some of them.
void PictureDrawer::filterNoise(Side& side, const PictureRequest& request) {
  const int samples = side.picture.samples();
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

void PictureDrawer::addSamples(const PictureRequest& request, PictureState& state) {
  const std::array needs{needsSamples(request, 0), needsSamples(request, 1)};
  if (!needs[0] && !needs[1]) return;
  const bool resting = request.drawsAtRest && isAtRest(request);
  const double pixels = double(request.picture.width()) * request.picture.height() * (needs[0] + needs[1]);
  const int wanted = request.wantedSamples;
  const int accumulated =
      std::min(needs[0] ? sides_[0].picture.samples() : wanted, needs[1] ? sides_[1].picture.samples() : wanted);
  const FrameBudget::Frame frame = budget_.next(pixels, accumulated, wanted, resting);
  coarse_ = frame.scale < 1;
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    if (!needs[i]) continue;
    if (sides_[i].picture.samples() == 0 || sides_[i].picture.size() != request.picture * frame.scale)
      sides_[i].filteredSamples = 0;
    sides_[i].picture.setSize(request.picture * frame.scale);
    sides_[i].picture.accumulate(frame.samples);
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
