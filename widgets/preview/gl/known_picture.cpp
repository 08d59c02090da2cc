// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/known_picture.h"

namespace gonio::widgets {

void KnownPicture::keep(PreviewRenderer& renderer, NoiseFilter* filter) {
  release();
  subject_ = renderer.subject();
  samples_ = renderer.samples();
  picture_ = renderer.takeBuffer();
  if (filter) filtered_ = filter->takeBuffer();
}

void KnownPicture::release() {
  picture_.reset();
  filtered_.reset();
  before_.reset();
  subject_ = {};
}

bool KnownPicture::serves(const PreviewSubject& changed, const QSize& size) const {
  if (!picture_ || picture_->size() != size || subject_.shown.index() != changed.shown.index()) return false;
  if (const auto* edited = std::get_if<EditedMaterial>(&subject_.shown))
    return edited->base == std::get<EditedMaterial>(changed.shown).base;
  if (const auto* alone = std::get_if<StandaloneModel>(&subject_.shown))
    return alone->model == std::get<StandaloneModel>(changed.shown).model;
  if (const auto* blend = std::get_if<PreviewBlend>(&subject_.shown))
    return blend->mixture == std::get<PreviewBlend>(changed.shown).mixture;
  return false;
}

void KnownPicture::drawBefore(PreviewRenderer& renderer, const QSize& size, int samples) {
  const PreviewSubject changed = renderer.subject();
  if (before_ && before_->size() == size && samplesBefore_ == samples && subject_.density == changed.density) return;
  subject_.density = changed.density;
  renderer.setSubject(subject_);
  renderer.setSize(size);
  renderer.accumulate(samples);
  before_ = renderer.takeBuffer();
  samplesBefore_ = samples;
  renderer.setSubject(changed);
}

ShownPicture KnownPicture::shown() const {
  if (filtered_) return {filtered_->texture(), 1};
  return {picture_ ? picture_->texture() : 0, float(samples_)};
}

}  // namespace gonio::widgets
