// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/reproduction/figure_record.h"

/// The files of a run: STEM.pdf, STEM.csv, STEM.svg and STEM.json for each figure, and report.html.
namespace gonio::reproduction {

/// A material that a figure was made from; the folder of its file is not stored.
struct UsedMaterial {
  std::string name, file, sha256;
};

/// The state of a figure in a run.
struct FigureResult {
  const FigureRecord* record = nullptr;
  std::vector<ReproducedValue> values;
  std::vector<std::string> remarks;
  std::vector<UsedMaterial> materials;
  double seconds = 0;
  std::string error;    ///< why it could not be made; empty: it was
  bool isKept = false;  ///< whether its files are those of an earlier run
};

/// What a figure depends on, as a hash: version, whether the run is quick, and the hashes of its materials.
std::string figureKey(const FigureRecord& record, std::span<const UsedMaterial> materials, bool quick);
std::vector<UsedMaterial> usedMaterials(std::span<const InputMaterial> materials, Inputs& inputs);

/// Writes the four files of a figure; STEM.json last, so that the others exist where it does. @throws Error that names
/// the file.
void writeFigure(const std::filesystem::path& folder, const FigureResult& result, const MadeFigure& made,
                 const std::string& key);
/// The result of an earlier run if all files exist and were made with the same key; else nullopt.
std::optional<FigureResult> keptFigure(const std::filesystem::path& folder, const FigureRecord& record,
                                       const std::string& key);

/// The comparison of a value with the printed one: "better by 1.2 dB", "worse by 3.4 dB"; empty without a printed one.
std::string comparisonText(const PrintedValue& printed, const ReproducedValue& value);
/// The printed value of a name, if there is one.
const PrintedValue* printedValue(const FigureRecord& record, std::string_view name);

/// report.html: origins of the materials, machine and version, a table of all printed values beside the reproduced
/// ones, then each figure with its values, reasons for differences and hashes of its materials.
std::string reportHtml(const Inputs& inputs, std::span<const FigureResult> results);

}  // namespace gonio::reproduction
