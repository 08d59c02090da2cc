// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// gonio_studies composition [GRID [FOLDER [KIND ...]]]: edits whose truth is known (composition_truths.h), by each
// model that edits and each composition. The material is fitted; the controls that the truth names are set to the
// values that are best for the composition. Prints, for each, the rendered SNR of the edited material against the
// truth, dB, and the hue error of its highlight, CIELAB units; then medians, of each kind of edit and of all. GRID:
// MERL grids divided by this (2). FOLDER: pictures of the five worst of each method, the truth above the edited
// material; "" for none. KIND: of edits ("roughness", "body grey"), or one of them ("roughness Beckmann metal 4"); all
// without.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>

#include "core/editing/edit.h"
#include "core/fitting/fit.h"
#include "core/io/image_io.h"
#include "core/models/common_parameters.h"
#include "core/models/registry.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/tone_map.h"
#include "tests/studies/composition_truths.h"
#include "tests/studies/highlight_hue.h"
#include "tests/studies/study_program.h"

namespace gonio::study::composition_study {
namespace {

using editing::Composition;
using editing::DifferentialEdit;

struct Method {
  const models::Model* model;
  Composition composition;
  bool keepsAlbedo = false;

  std::string name() const {
    return std::string(model->spec().id) + " " + std::string(editing::compositionIds[std::size_t(composition)]) +
           (keepsAlbedo ? " albedo" : "");
  }
};

struct Outcome {
  double snr = -1e9, hue = 0;
  DifferentialEdit edit;
  std::size_t truth = 0;
};

std::shared_ptr<const Brdf> edited(const EditTruth& truth, const DifferentialEdit& change) {
  const editing::Edit edit{change};
  return editing::applyEdits(truth.before, std::span(&edit, 1));
}

/// Indices of the width parameters of the fitted lobes that are on.
std::vector<std::size_t> widthsOf(const DifferentialEdit& edit) {
  const models::ModelSpec& spec = edit.model->spec();
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    const models::ParameterSpec& parameter = spec.parameters[i];
    if (parameter.role != models::ParameterRole::width) continue;
    const std::string_view choice = parameter.activeWith;
    if (choice.empty() || models::chosen(edit.fitted.values[*spec.find(choice)].x) == parameter.activeChoice)
      widths.push_back(i);
  }
  return widths;
}

/// Sets a control. Of the upper highlight: the widths of the sharpest lobe and of all that are less than half as wide
/// as the widest.
void set(const ControlSearch& search, const Rgb& value, DifferentialEdit& change) {
  if (!search.upperOnly) {
    change.controls.values[std::size_t(search.control)] = value;
    return;
  }
  const std::vector<std::size_t> widths = widthsOf(change);
  const auto width = [&](std::size_t i) { return change.fitted.values[i].x; };
  const double widest = width(std::ranges::max(widths, {}, width)),
               sharpest = width(std::ranges::min(widths, {}, width));
  for (const std::size_t i : widths)
    if (width(i) < widest / 2 || width(i) == sharpest) change.edited.values[i] = change.fitted.values[i] * value;
}

/// The best values of the controls, one after the other.
Outcome bestOf(const EditTruth& truth, const rendering::RenderedComparison& comparison, DifferentialEdit change) {
  Outcome best;
  const auto consider = [&](const DifferentialEdit& candidate) {
    const rendering::ComparisonPicture picture = comparison.render(*edited(truth, candidate));
    const double snr = comparison.signalToNoiseRatio(picture);
    if (snr > best.snr) best = {snr, highlightHueError(comparison.reference(), picture.image), candidate};
  };
  if (truth.recolour) truth.recolour(change.model->spec(), change.edited);
  for (const ControlSearch& search : truth.search) set(search, search.start, change);
  consider(change);
  for (const ControlSearch& search : truth.search) {
    DifferentialEdit candidate = best.edit;
    for (int step = -search.reach; step <= search.reach; ++step) {
      if (step == 0) continue;
      set(search, search.start * std::pow(2, step / search.steps), candidate);
      consider(candidate);
    }
  }
  return best;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values.empty() ? 0 : (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

/// Medians over the truths of one kind (empty: of all) for each method.
void printMedians(const std::string& kind, const std::vector<EditTruth>& truths,
                  const std::vector<std::vector<Outcome>>& outcomes) {
  std::printf("| **median%s%s** |", kind.empty() ? "" : ", ", kind.c_str());
  for (const std::vector<Outcome>& column : outcomes) {
    std::vector<double> snr, hue;
    for (const Outcome& outcome : column)
      if (kind.empty() || truths[outcome.truth].kind == kind) snr.push_back(outcome.snr), hue.push_back(outcome.hue);
    std::printf(" %.1f / %.1f |", median(snr), median(hue));
  }
  std::printf("\n");
}

void printTable(const std::vector<EditTruth>& truths, const std::vector<std::vector<Outcome>>& outcomes) {
  std::vector<std::string> kinds;
  for (const EditTruth& truth : truths)
    if (std::ranges::find(kinds, truth.kind) == kinds.end()) kinds.push_back(truth.kind);
  for (const std::string& kind : kinds) printMedians(kind, truths, outcomes);
  printMedians("", truths, outcomes);
}

constexpr int pictureSide = 160, worstCount = 5;

void blit(const Image& from, Image& to, int x, int y) {
  for (int row = 0; row < from.height; ++row)
    std::copy_n(from.pixels.begin() + std::ptrdiff_t(row) * from.width, from.width,
                to.pixels.begin() + std::ptrdiff_t(y + row) * to.width + x);
}

void writeWorst(const Method& method, std::vector<Outcome> column, const std::vector<EditTruth>& truths,
                const std::filesystem::path& folder) {
  std::ranges::sort(column, {}, &Outcome::snr);
  Image sheet(pictureSide * worstCount, pictureSide * 2);
  std::printf("worst of %s:", method.name().c_str());
  for (int i = 0; i < worstCount; ++i) {
    const Outcome& outcome = column[std::size_t(i)];
    const EditTruth& truth = truths[outcome.truth];
    const rendering::RenderedComparison comparison(*truth.after,
                                                   {.width = pictureSide, .height = pictureSide, .samples = 64});
    blit(comparison.reference(), sheet, i * pictureSide, 0);
    blit(comparison.render(*edited(truth, outcome.edit)).image, sheet, i * pictureSide, pictureSide);
    std::printf(" %s %s (%.1f dB);", truth.kind.c_str(), truth.name.c_str(), outcome.snr);
  }
  std::printf("\n");
  std::string name = method.name();
  std::ranges::replace(name, ' ', '-');
  io::writePng(rendering::toDisplayBytes(sheet, 0, rendering::ToneMap::filmic), sheet.width, sheet.height,
               folder / (name + ".png"));
}

void run(int divisor, const std::filesystem::path& folder, const std::vector<std::string>& kinds) {
  std::vector<Method> methods;
  for (const models::Model* model : {&models::ggx(), &models::layered()})
    for (const Composition composition : {Composition::additive, Composition::logPlus, Composition::lobes})
      methods.push_back({model, composition});
  for (const models::Model* model : {&models::ggx(), &models::layered()})
    methods.push_back({model, Composition::lobes, true});
  std::vector<EditTruth> truths =
      editTruths({.thetaHCount = 90 / divisor, .thetaDCount = 90 / divisor, .phiDCount = 180 / divisor});
  if (!kinds.empty())
    std::erase_if(truths, [&](const EditTruth& truth) {
      return std::ranges::none_of(
          kinds, [&](const std::string& kind) { return kind == truth.kind || kind == truth.kind + ' ' + truth.name; });
    });
  std::printf("| kind | truth |");
  for (const Method& method : methods) std::printf(" %s |", method.name().c_str());
  std::printf("\n");
  std::vector<std::vector<Outcome>> outcomes(methods.size());
  std::map<std::pair<const TabulatedBrdf*, const models::Model*>, models::ParameterValues> fits;
  for (std::size_t t = 0; t < truths.size(); ++t) {
    const EditTruth& truth = truths[t];
    const rendering::RenderedComparison comparison(*truth.after, {.width = 64, .height = 64, .samples = 64});
    std::printf("| %s | %s |", truth.kind.c_str(), truth.name.c_str());
    for (std::size_t i = 0; i < methods.size(); ++i) {
      models::ParameterValues& fit = fits[{truth.before.get(), methods[i].model}];
      if (fit.values.empty()) fit = fitting::fit(*truth.before, *methods[i].model).parameters;
      DifferentialEdit change{methods[i].model, fit, fit, methods[i].composition};
      change.keepsAlbedo = methods[i].keepsAlbedo;
      outcomes[i].push_back(bestOf(truth, comparison, change));
      outcomes[i].back().truth = t;
      std::printf(" %.1f / %.1f |", outcomes[i].back().snr, outcomes[i].back().hue);
      std::fflush(stdout);
    }
    std::printf("\n");
  }
  printTable(truths, outcomes);
  if (folder.empty()) return;
  for (std::size_t i = 0; i < methods.size(); ++i) writeWorst(methods[i], outcomes[i], truths, folder);
}

int study(int argumentCount, char** arguments) {
  run(argumentCount > 1 ? std::max(1, std::atoi(arguments[1])) : 2, argumentCount > 2 ? arguments[2] : "",
      {arguments + std::min(argumentCount, 3), arguments + argumentCount});
  return 0;
}

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::composition_study
