// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// gonio_studies albedo [MODEL]: the directional albedo of bundled materials whose roughness is changed, relative to
// that of the measurement (luminance), at 0, 10, .. 60, 65, .. 80 degrees: edits by lobes of a model (ggx) that keep
// the albedo, and the same that do not. Then how many are within 2 %.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/editing/edit.h"
#include "core/fitting/fit.h"
#include "core/materials/bundled_library.h"
#include "core/math/parallel.h"
#include "core/models/registry.h"
#include "tests/studies/study_program.h"
#include "tests/support/ring_albedo.h"

namespace gonio::study::albedo_study {
namespace {

constexpr const char* materialNames[] = {"merl-copy/two-layer-silver",
                                         "merl-copy/gold-metallic-paint",
                                         "merl-copy/gold-metallic-paint3",
                                         "merl-copy/green-metallic-paint2",
                                         "merl-copy/brass",
                                         "merl-copy/black-obsidian",
                                         "merl-copy/chrome",
                                         "merl-copy/alum-bronze",
                                         "merl-copy/steel",
                                         "merl-copy/tungsten-carbide",
                                         "merl-copy/blue-metallic-paint",
                                         "merl-copy/silver-metallic-paint2",
                                         "merl-copy/color-changing-paint3",
                                         "merl-copy/red-specular-plastic",
                                         "merl-copy/specular-black-phenolic",
                                         "merl-copy/special-walnut-224",
                                         "merl-copy/red-fabric",
                                         "merl-copy/grease-covered-steel",
                                         "rgl/ilm_solo_m_68",
                                         "rgl/ilm_l3_37_matte",
                                         "rgl/satin_purple",
                                         "rgl/chm_light_blue",
                                         "rgl/cc_iris_purple_gem",
                                         "rgl/vch_golden_yellow",
                                         "rgl/colodur_azure_4e",
                                         "rgl/aurora_white",
                                         "rgl/cc_ibiza_sunset",
                                         "rgl/cg_sunflower",
                                         "rgl/leaf_maple",
                                         "rgl/acrylic_felt_green",
                                         "rgl/paper_blue",
                                         "rgl/cm_toxic_green"};
constexpr double angles[] = {0, 10, 20, 30, 40, 50, 60, 65, 70, 75, 80};
constexpr double factors[] = {0.25, 0.5, 2, 4};

/// At each of the angles.
std::vector<double> albedos(const Brdf& brdf) {
  std::vector<double> result(std::size(angles));
  parallelForBlocks(result.size(), 1, [&](std::size_t i, std::size_t) {
    result[i] = luminance(test::ringAlbedo(brdf, angles[i], 600, 128));
  });
  return result;
}

/// Prints a row; returns the largest deviation from 1.
double printRow(const std::string& name, const Brdf& edited, const std::vector<double>& before, const char* what) {
  double worst = 0;
  std::printf("| %s | %s |", name.c_str(), what);
  const std::vector<double> after = albedos(edited);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double ratio = after[i] / before[i];
    worst = std::max(worst, std::abs(ratio - 1));
    std::printf(" %.2f", ratio);
  }
  std::printf(" |\n");
  std::fflush(stdout);
  return worst;
}

int study(int argumentCount, char** arguments) {
  const models::Model& model = models::findModel(argumentCount > 1 ? arguments[1] : "ggx");
  std::vector<double> kept;
  for (const std::string name : materialNames) {
    const auto base = materials::readLibraryMaterial("library:" + name).brdf;
    const auto table = formOf<TabulatedBrdf>(*base) ? base : std::shared_ptr<const Brdf>(bakeTable(*base));
    editing::DifferentialEdit change = editing::unchangedEdit(model, fitting::fit(*table, model).parameters);
    const std::vector<double> before = albedos(*base);
    for (const double factor : factors)
      for (const bool keepsAlbedo : {true, false}) {
        change.controls.values[std::size_t(editing::ArtistControl::roughness)] = Rgb(factor);
        change.keepsAlbedo = keepsAlbedo;
        const editing::Edit edit{change};
        char what[32];
        std::snprintf(what, sizeof what, "x %g%s", factor, keepsAlbedo ? "" : ", changes");
        const double worst = printRow(name, *editing::applyEdits(base, std::span(&edit, 1)), before, what);
        if (keepsAlbedo) kept.push_back(worst);
      }
  }
  std::ranges::sort(kept);
  std::printf("%td of %zu within 2 %%, median of the largest deviations %.3f, maximum %.3f\n",
              std::ranges::upper_bound(kept, 0.02) - kept.begin(), kept.size(), kept[kept.size() / 2], kept.back());
  return 0;
}

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::albedo_study
