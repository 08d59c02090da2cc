// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/preview_subject.h"

namespace gonio::widgets {

namespace {

/// Those that change something, without what is for people alone.
editing::EditList activeEdits(const editing::EditList& edits) {
  editing::EditList active;
  for (const editing::Edit& edit : edits)
    if (!edit.isIdentity()) active.push_back({edit.content, {}, edit.strength});
  return active;
}

bool same(std::monostate, std::monostate) { return true; }
bool same(const EditedMaterial& a, const EditedMaterial& b) {
  return a.base == b.base && activeEdits(a.edits) == activeEdits(b.edits);
}
bool same(const StandaloneModel& a, const StandaloneModel& b) {
  return a.model == b.model && a.parameters == b.parameters && a.grid == b.grid;
}
bool same(const PreviewBlend& a, const PreviewBlend& b) {
  return a.interpolation == b.interpolation && a.weights == b.weights;
}

using BrdfPointer = std::shared_ptr<const Brdf>;
BrdfPointer brdfOf(std::monostate) { return nullptr; }
BrdfPointer brdfOf(const EditedMaterial& shown) { return editing::applyEdits(shown.base, shown.edits); }
BrdfPointer brdfOf(const StandaloneModel& shown) { return shown.model->instantiate(shown.parameters); }
BrdfPointer brdfOf(const PreviewBlend& shown) { return shown.interpolation->brdf(shown.weights); }

}  // namespace

BrdfPointer PreviewSubject::base() const {
  const auto* edited = std::get_if<EditedMaterial>(&shown);
  return edited ? edited->base : nullptr;
}

bool PreviewSubject::isMeasured() const {
  const auto* edited = std::get_if<EditedMaterial>(&shown);
  return edited ? editing::isIdentity(edited->edits) : isEmpty();
}

PreviewSubject measuredSubject(BrdfPointer base, std::shared_ptr<const TabulatedDensity> density) {
  if (!base) return {};
  return {EditedMaterial{std::move(base)}, std::move(density)};
}

bool sameSubject(const PreviewSubject& a, const PreviewSubject& b) {
  if (a.shown.index() != b.shown.index()) return false;
  if (std::holds_alternative<EditedMaterial>(a.shown) && a.density != b.density) return false;
  return std::visit([&](const auto& shown) { return same(shown, std::get<std::decay_t<decltype(shown)>>(b.shown)); },
                    a.shown);
}

std::shared_ptr<const Brdf> subjectBrdf(const PreviewSubject& subject) {
  return std::visit([](const auto& shown) { return brdfOf(shown); }, subject.shown);
}

}  // namespace gonio::widgets
