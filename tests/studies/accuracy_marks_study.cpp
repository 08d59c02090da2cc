// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// gonio_studies accuracy_marks FOLDER: the benchmark of accuracy. Rendered SNR and size of fits, factors and codes of
// two measured materials, FOLDER/satin_purple_rgb.bsdf and FOLDER/ilm_solo_m_68_rgb.bsdf (RGL), in the sphere in the
// studio (64 x 64 pixels, 32 samples), against the folded table, beside the marks of 26 November 2026. Exits with 1 if
// a representation loses a decibel, or a tenth of its size changes; what gains a decibel needs a new mark. Half a
// minute.
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>

#include "core/formats/pdv.h"
#include "core/materials/material.h"
#include "core/study/accuracy_study.h"
#include "core/support/error.h"
#include "tests/studies/study_program.h"

namespace gonio::study::accuracy_marks_study {
namespace {

struct Mark {
  double decibels;
  double bytes = 0;  ///< 0: not checked, since it does not change
};
/// By the id of a representation, of codes by id and number of coefficients.
using Marks = std::map<std::string, Mark>;

const std::map<std::string, Marks> marksOfMaterials{{"satin_purple",
                                                     {{"ggx", {20.0}},
                                                      {"layered", {22.9}},
                                                      {"factors-2d", {28.3}},
                                                      {"factors-3d", {37.5}},
                                                      {"code-256", {40.9, 661}},
                                                      {"code-1024", {49.1, 2135}}}},
                                                    {"ilm_solo_m_68",
                                                     {{"ggx", {11.4}},
                                                      {"layered", {12.1}},
                                                      {"factors-2d", {37.6}},
                                                      {"factors-3d", {33.5}},
                                                      {"code-256", {35.8, 668}},
                                                      {"code-1024", {41.4, 2312}}}}};

/// Of compact PDV factors with joint terms in the bytes of as many terms over all nodes, for satin_purple.
constexpr std::pair<int, double> compactMarks[] = {{1, 29.7}, {2, 38.7}, {5, 49.0}, {10, 55.4}};

std::string keyOf(const Representation& representation) {
  const std::string budget = representation.kind->id == "code" ? "-" + std::to_string(int(representation.budget)) : "";
  return representation.id() + budget;
}

using Folder = std::filesystem::path;

std::shared_ptr<const TabulatedBrdf> measuredTable(const Folder& folder, const std::string& name) {
  return meanOfOrders(materials::readMaterial(folder / (name + "_rgb.bsdf")).tabulated());
}

std::vector<StudyRecord> recordsOf(const std::shared_ptr<const TabulatedBrdf>& table,
                                   std::span<const Representation> representations) {
  StudyOptions options;
  options.timed = false;
  options.picture = {.width = 64, .height = 64, .samples = 32};
  return runStudy({table, table}, representations, options);
}

/// Prints a line of the table. Returns whether the mark is met.
bool report(const std::string& material, const std::string& name, const StudyRecord& record, const Mark& mark) {
  const bool met = std::abs(record.renderedSnr - mark.decibels) < 1 &&
                   (mark.bytes == 0 || std::abs(double(record.bytes) / mark.bytes - 1) < 0.1);
  std::printf("%s, %s, %.1f, %.1f, %zu, %.0f%s\n", material.c_str(), name.c_str(), record.renderedSnr, mark.decibels,
              record.bytes, mark.bytes, met ? "" : ", differs");
  std::fflush(stdout);
  return met;
}

/// Compact factors are at least 5 dB ahead of Kautz and McCool 1999 in the same bytes.
bool reportCompact(const Folder& folder) {
  const auto table = measuredTable(folder, "satin_purple");
  bool met = true;
  for (const auto& [terms, mark] : compactMarks) {
    const std::size_t bytes = formats::pdvFileBytes(factorization::PdvForm::threeFactors, terms);
    const std::array models{representationById("factors-3d-compact", 2 * terms),
                            representationById("kautz-mccool", double(bytes))};
    const std::vector<StudyRecord> records = recordsOf(table, models);
    const std::string budget = " in " + std::to_string(bytes) + " bytes";
    met = report("satin_purple", "factors-3d-compact" + budget, records[0], {mark}) && met;
    const bool ahead =
        records[0].bytes <= bytes && records[1].bytes <= bytes && records[0].renderedSnr > records[1].renderedSnr + 5;
    std::printf("satin_purple, kautz-mccool%s, %.1f%s\n", budget.c_str(), records[1].renderedSnr,
                ahead ? "" : ", compact factors are not ahead");
    met = met && ahead;
  }
  return met;
}

int study(int count, char** values) {
  if (count != 2) throw Error("accuracy_marks: expected the folder of the measured files");
  const Folder folder = values[1];
  RepresentationChoice choice;
  choice.names = {"ggx", "layered", "factors", "codes"};
  choice.terms = {10};
  choice.coefficients = {256, 1024};
  const std::vector<Representation> representations = representationsOf(choice);
  std::printf("material, representation, rendered SNR [dB], mark [dB], bytes, mark\n");
  bool met = true;
  for (const auto& [material, marks] : marksOfMaterials)
    for (const StudyRecord& record : recordsOf(measuredTable(folder, material), representations)) {
      const std::string key = keyOf(record.representation);
      met = report(material, key, record, marks.at(key)) && met;
    }
  met = reportCompact(folder) && met;
  return met ? 0 : 1;
}

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::accuracy_marks_study
