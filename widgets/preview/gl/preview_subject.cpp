// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/preview_subject.h"

namespace gonio::widgets {

bool sameSubject(const PreviewSubject& a, const PreviewSubject& b) {
  if (a.blend || b.blend)
    return a.blend && b.blend && a.blend->interpolation == b.blend->interpolation &&
           a.blend->weights == b.blend->weights;
  if (a.model || b.model) return a.model == b.model && a.parameters == b.parameters;
  if (a.table != b.table || a.hasActiveEdit() != b.hasActiveEdit()) return false;
  if (a.hasActiveFactors() != b.hasActiveFactors() || (a.hasActiveFactors() && a.factors != b.factors)) return false;
  if (a.lobe.roughness != b.lobe.roughness || a.lobe.specularShare != b.lobe.specularShare) return false;
  return !a.hasActiveEdit() || (a.edit->model == b.edit->model && a.edit->fitted == b.edit->fitted &&
                                a.edit->edited == b.edit->edited && a.edit->strength == b.edit->strength);
}

std::shared_ptr<const Brdf> subjectBrdf(const PreviewSubject& subject) {
  if (subject.blend) return subject.blend->interpolation->brdf(subject.blend->weights);
  if (subject.model) return subject.model->instantiate(subject.parameters);
  if (!subject.table) return nullptr;
  return editing::applyEdits(subject.table, subject.edits());
}

}  // namespace gonio::widgets
