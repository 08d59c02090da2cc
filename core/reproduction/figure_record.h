// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/figures/figure_layout.h"
#include "core/io/csv_text.h"
#include "core/reproduction/inputs.h"
#include "core/support/task_control.h"

/// The figures and tables of Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling and
/// Acquisition", made from a user's materials.
namespace gonio::reproduction {

/// Seed of all random numbers; figures that need independent ones count from it.
inline constexpr int runSeed = 1;

/// A number that the dissertation prints. `name` is that of the ReproducedValue that is compared with it.
struct PrintedValue {
  std::string_view name;
  double value = 0;
  bool lowerIsBetter = false;
};

struct ReproducedValue {
  std::string name, unit;
  double value = 0;
};

/// What the maker of a figure returns.
struct MadeFigure {
  figures::FigureDrawing drawing;
  io::CsvTable table;                   ///< the data of the drawing
  std::vector<ReproducedValue> values;  ///< in the order of display
  std::vector<std::string> remarks;     ///< what this run did differently, such as a sentence about fewer folds
};

/// One figure or table. Report, command line, workflow and documentation read these records.
struct FigureRecord {
  std::string_view id;  ///< as printed, e.g. "4.3"; with `isTable` that of a table
  bool isTable = false;
  std::string_view title, shows;
  std::string_view source;             ///< where the printed values are, or what the print shows where it has none
  std::vector<PrintedValue> printed;   ///< empty: no numbers are printed
  std::string_view differences;        ///< known reasons for differences
  std::vector<Subject> subjects;       ///< the materials of the figure, in the order in which the maker reads them
  std::vector<MaterialSet> wholeSets;  ///< sets of which it uses all materials, or the test materials of a quick run
  bool isLearned = false;              ///< whether it uses Inputs::trainingMaterials()
  double fullMinutes = 0, quickMinutes = 0;  ///< on two cores, with 100 MERL, 51 RGL and 6 DTU materials
  /// Deterministic except for times. @throws Error that states the cause; Cancelled.
  MadeFigure (*make)(const FigureRecord& record, Inputs& inputs, const TaskControl& control) = nullptr;

  /// "figure 4.3" or "table 5.1".
  std::string name() const { return (isTable ? "table " : "figure ") + std::string(id); }
  /// Name of its files without suffix: "figure-4.3" or "table-5.1".
  std::string stem() const { return (isTable ? "table-" : "figure-") + std::string(id); }
};

/// All records, in the order of the dissertation.
std::span<const FigureRecord> allFigures();
/// The records with these ids, in the order of allFigures(); all for no ids. @throws Error that lists the known ids.
std::vector<const FigureRecord*> selectedFigures(std::span<const std::string> ids);

// The records of each file of makers.
std::vector<FigureRecord> statisticsFigures();   ///< table 2.1, figures 2.7, 4.1, 4.2
std::vector<FigureRecord> factorFigures();       ///< 4.3, 4.4, 4.8
std::vector<FigureRecord> measurementFigures();  ///< 2.6, 5.3, 5.4
std::vector<FigureRecord> dictionaryFigures();   ///< 2.8, 4.5 to 4.7, 4.9
std::vector<FigureRecord> acquisitionFigures();  ///< 5.5 to 5.9, table 5.1

/// The materials that a figure uses: its subjects, then those of its whole sets (testMaterials() in a quick run), then
/// the training set.
std::vector<InputMaterial> materialsOf(const FigureRecord& record, const Inputs& inputs);

}  // namespace gonio::reproduction
