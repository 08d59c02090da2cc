// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/models/model.h"
#include "tests/widgets/offscreen_spheres.h"

namespace gonio::test {

/// The table of a model, coarser than MERL's as no picture here needs more; of its parameters those of `set` have other
/// values than the default ones.
inline std::shared_ptr<const TabulatedBrdf> bakedModel(const char* id,
                                                       const std::vector<std::pair<const char*, double>>& set) {
  const models::Model& model = models::findModel(id);
  models::ParameterValues values = models::defaultParameters(model.spec());
  for (const auto& [name, value] : set) values.values[*model.spec().find(name)] = Rgb(value);
  return bakeTable(*model.instantiate(values), {60, 60, 60});
}

/// A model's edit of its roughness.
inline editing::Edit rougherEdit(const char* id, const char* parameter, double roughness) {
  const models::Model& model = models::findModel(id);
  editing::DifferentialEdit edit{.model = &model, .fitted = models::defaultParameters(model.spec())};
  edit.edited = edit.fitted;
  edit.edited.values[*model.spec().find(parameter)] = Rgb(roughness);
  return {edit};
}

/// The density of a material; that of the last one is kept, since many edits of one base are drawn in turn.
inline std::shared_ptr<const TabulatedDensity> lobeOf(const std::shared_ptr<const Brdf>& brdf) {
  static std::shared_ptr<const Brdf> last;
  static std::shared_ptr<const TabulatedDensity> lobe;
  if (brdf != last) lobe = std::make_shared<const TabulatedDensity>(*brdf);
  last = brdf;
  return lobe;
}

/// SNR of the shader's picture of a subject against the CPU's, dB, as OffscreenSpheres::agreement().
inline double agreement(OffscreenSpheres& spheres, widgets::PreviewSubject subject, const Scene& scene, double enough) {
  const std::shared_ptr<const Brdf> brdf = widgets::subjectBrdf(subject);
  const auto base = subject.base();
  subject.lobe = lobeOf(base ? base : brdf);
  return spheres.agreement(subject, *brdf, scene, enough);
}

inline double agreement(OffscreenSpheres& spheres, const std::shared_ptr<const TabulatedBrdf>& table,
                        const editing::EditList& edits, const Scene& scene, double enough) {
  return agreement(spheres, {widgets::EditedMaterial{table, edits}}, scene, enough);
}

}  // namespace gonio::test
