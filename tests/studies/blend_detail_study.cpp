// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// gonio_studies blend_detail: the tables of docs/results/interpolation.md, section "Measured detail" (5 minutes). In
// the spaces that lose detail, without and with it:
//   - between two materials with a known middle: GGX, and near-measured paints whose highlight an edit by lobes makes
//     narrower for one end and wider for the other, so that the paint itself is in the middle;
//   - near the ends of pairs of measured files and near-measured copies, at a weight of 0.995;
//   - the time of an evaluation.
//
// gonio_studies blend_detail FOLDER: writes contact sheets of twelve pairs, a file per pair: rows linear, then
// parameters, factors and dictionary, each without and with detail; columns weights 1, 0.995, 0.5, 0.005 and 0 of the
// first.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "core/editing/edit.h"
#include "core/fitting/fit.h"
#include "core/interpolation/interpolation.h"
#include "core/io/image_io.h"
#include "core/materials/dictionary_file.h"
#include "core/materials/material.h"
#include "core/models/registry.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/tone_map.h"
#include "tests/studies/study_program.h"

namespace gonio::study::blend_detail_study {
namespace {

using interpolation::InterpolationMaterial;
using interpolation::InterpolationSpace;
using BrdfPointer = std::shared_ptr<const Brdf>;

struct SpaceRow {
  const char* name;
  InterpolationSpace space;
  const char* model;
  int terms;
};
constexpr SpaceRow linearRow{"linear", InterpolationSpace::linear, "ggx", 3};
constexpr SpaceRow spaceRows[] = {{"parameters, GGX", InterpolationSpace::parameters, "ggx", 3},
                                  {"parameters, Ward", InterpolationSpace::parameters, "ward", 3},
                                  {"factors, 3 terms", InterpolationSpace::factors, "ggx", 3},
                                  {"factors, 10 terms", InterpolationSpace::factors, "ggx", 10},
                                  {"dictionary", InterpolationSpace::dictionary, "ggx", 3}};

std::shared_ptr<const interpolation::Interpolation> prepared(const SpaceRow& row,
                                                             const std::vector<InterpolationMaterial>& ends,
                                                             bool preserveDetail) {
  interpolation::InterpolationOptions options{.preserveDetail = preserveDetail, .model = &models::findModel(row.model)};
  options.pdv.terms = row.terms;
  const auto dictionary = materials::bundledEnsemble();
  options.ensemble = {dictionary, &dictionary->ensemble};
  return interpolation::prepareInterpolation(row.space, ends, options);
}

InterpolationMaterial bundled(const std::string& id) {
  const materials::Material material = materials::readMaterial("library:" + id);
  InterpolationMaterial end{.table = material.tabulated()};
  if (!material.table) end.base = material.brdf;
  return end;
}

/// A blend with a known middle.
struct KnownBlend {
  std::string name;
  std::vector<InterpolationMaterial> ends;
  BrdfPointer middle;
};

BrdfPointer ggxTable(double roughness) {
  const models::ModelSpec& spec = models::ggx().spec();
  models::ParameterValues parameters = models::defaultParameters(spec);
  parameters.values[*spec.find("diffuse")] = Rgb(0.1);
  parameters.values[*spec.find("specular")] = Rgb(0.6);
  parameters.values[*spec.find("roughness")] = Rgb(roughness);
  parameters.values[*spec.find("f0")] = Rgb(0.1);
  return bakeTable(*models::ggx().instantiate(parameters));
}

KnownBlend ggxBlend(double first, double second) {
  char name[64];
  std::snprintf(name, sizeof name, "GGX, roughness %g and %g", first, second);
  const auto end = [](double roughness) {
    return InterpolationMaterial{.table = std::static_pointer_cast<const TabulatedBrdf>(ggxTable(roughness))};
  };
  return {name, {end(first), end(second)}, ggxTable(std::sqrt(first * second))};
}

KnownBlend paintBlend(const std::string& paint, double factor) {
  const auto table = bundled("merl-copy/" + paint).table;
  editing::DifferentialEdit edit =
      editing::unchangedEdit(models::ggx(), fitting::fit(*table, models::ggx()).parameters);
  KnownBlend blend{paint + ", highlights 1/1.5 and 1.5 times as wide", {}, table};
  for (const double roughness : {1 / factor, factor}) {
    edit.controls.values[std::size_t(editing::ArtistControl::roughness)] = Rgb(roughness);
    blend.ends.push_back({.table = editing::bakeEdits(table, editing::EditList{{edit}})});
  }
  return blend;
}

double snrOf(const rendering::RenderedComparison& truth, const Brdf& brdf) {
  return truth.signalToNoiseRatio(truth.render(brdf));
}

void printMiddle(const KnownBlend& blend) {
  const rendering::RenderedComparison truth(*blend.middle, rendering::smallComparisonPicture());
  const std::vector<double> half{0.5, 0.5};
  std::printf("\n| %s | without, dB | with, dB |\n|---|---|---|\n| linear | %.1f | |\n", blend.name.c_str(),
              snrOf(truth, *prepared(linearRow, blend.ends, false)->brdf(half)));
  for (const SpaceRow& row : spaceRows) {
    std::printf("| %s | %.1f | %.1f |\n", row.name, snrOf(truth, *prepared(row, blend.ends, false)->brdf(half)),
                snrOf(truth, *prepared(row, blend.ends, true)->brdf(half)));
    std::fflush(stdout);
  }
}

struct Pair {
  const char *first, *second;
};
constexpr Pair pairs[] = {{"rgl/satin_purple", "rgl/acrylic_felt_green"},
                          {"rgl/satin_purple", "rgl-copy/satin_gold"},
                          {"rgl/aurora_white", "rgl/cc_ibiza_sunset"},
                          {"rgl/chm_mint", "rgl/vch_golden_yellow"},
                          {"rgl/paper_blue", "rgl/leaf_maple"},
                          {"dtu-copy/cardboard", "rgl/paper_white"},
                          {"merl-copy/chrome", "merl-copy/blue-rubber"},
                          {"merl-copy/blue-rubber", "merl-copy/chrome"},
                          {"merl-copy/blue-metallic-paint", "merl-copy/gold-paint"},
                          {"rgl/cg_sunflower", "rgl/vch_ultra_pink"},
                          {"rgl/colodur_napoli_4f", "rgl/ilm_l3_37_matte"},
                          {"rgl/cm_toxic_green", "merl-copy/dark-red-paint"}};

void printEnd(const Pair& pair) {
  const std::vector<InterpolationMaterial> ends{bundled(pair.first), bundled(pair.second)};
  const rendering::RenderedComparison truth(*ends[0].material(), rendering::smallComparisonPicture());
  const std::vector<double> begun{0.995, 0.005};
  std::printf("| %s, %s | %.1f |", pair.first, pair.second,
              snrOf(truth, *prepared(linearRow, ends, false)->brdf(begun)));
  for (const std::size_t row : {0, 2, 4})
    for (const bool preserves : {false, true}) {
      std::printf(" %.1f |", snrOf(truth, *prepared(spaceRows[row], ends, preserves)->brdf(begun)));
      std::fflush(stdout);
    }
  std::printf("\n");
}

double nanosecondsOf(const Brdf& brdf) {
  std::vector<DirectionPair> directions;
  for (int i = 0; i < 20000; ++i)
    directions.push_back({fromSpherical(std::fmod(0.7548776662 * i, 1.0) * 1.4, i),
                          fromSpherical(std::fmod(0.5698402910 * i, 1.0) * 1.4, 2.0 * i)});
  std::vector<Rgb> values(directions.size());
  double shortest = 1e300;
  for (int run = 0; run < 5; ++run) {
    const auto start = std::chrono::steady_clock::now();
    brdf.evaluate(directions, values);
    shortest = std::min(shortest, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return 1e9 * shortest / double(directions.size());
}

void printTimes(const Pair& pair) {
  const std::vector<InterpolationMaterial> ends{bundled(pair.first), bundled(pair.second)};
  const std::vector<double> half{0.5, 0.5};
  std::printf("\n| %s, %s | without, ns | with, ns |\n|---|---|---|\n| linear | %.0f | |\n", pair.first, pair.second,
              nanosecondsOf(*prepared(linearRow, ends, false)->brdf(half)));
  for (const SpaceRow& row : spaceRows)
    std::printf("| %s | %.0f | %.0f |\n", row.name, nanosecondsOf(*prepared(row, ends, false)->brdf(half)),
                nanosecondsOf(*prepared(row, ends, true)->brdf(half)));
}

void writeSheet(const Pair& pair, const std::filesystem::path& file) {
  constexpr int side = 140, samples = 32;
  const std::vector<InterpolationMaterial> ends{bundled(pair.first), bundled(pair.second)};
  std::vector<std::shared_ptr<const interpolation::Interpolation>> rows{prepared(linearRow, ends, false)};
  for (const std::size_t row : {0, 2, 4})
    for (const bool preserves : {false, true}) rows.push_back(prepared(spaceRows[row], ends, preserves));
  const std::vector<double> weights{1, 0.995, 0.5, 0.005, 0};
  const int width = side * int(weights.size()), height = side * int(rows.size());
  std::vector<unsigned char> sheet(4 * std::size_t(width) * std::size_t(height));
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t column = 0; column < weights.size(); ++column) {
      const BrdfPointer blend = rows[row]->brdf(std::vector{weights[column], 1 - weights[column]});
      const Image picture = rendering::renderPicture(*blend, rendering::comparisonScene(),
                                                     {.width = side, .height = side, .samples = samples});
      const auto bytes = rendering::toDisplayBytes(picture, 0, rendering::ToneMap::filmic);
      for (std::size_t y = 0; y < side; ++y)
        std::copy_n(bytes.begin() + std::ptrdiff_t(4 * y * side), 4 * side,
                    sheet.begin() + std::ptrdiff_t(4 * ((row * side + y) * std::size_t(width) + column * side)));
    }
  io::writePng(sheet, width, height, file);
}

int study(int count, char** arguments) {
  if (count > 1) {
    int number = 0;
    for (const Pair& pair : pairs)
      writeSheet(pair, std::filesystem::path(arguments[1]) / ("pair-" + std::to_string(++number) + ".png"));
    return 0;
  }
  printMiddle(ggxBlend(0.1, 0.2));
  printMiddle(ggxBlend(0.1, 0.4));
  for (const char* paint : {"blue-metallic-paint", "gold-paint", "dark-red-paint"}) printMiddle(paintBlend(paint, 1.5));
  std::printf(
      "\n| first, second | linear | parameters: without | with | factors: without | with | dictionary: without | with "
      "|\n|---|---|---|---|---|---|---|---|\n");
  for (const Pair& pair : pairs) printEnd(pair);
  printTimes(pairs[0]);
  printTimes(pairs[6]);
  return 0;
}

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::blend_detail_study
