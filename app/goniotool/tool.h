// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "core/support/task_control.h"

namespace gonio::tool {

/// Reported with exit code 2: the arguments contradict each other. Everything else that is thrown is reported with 1.
class UsageError : public Error {
 public:
  using Error::Error;
};

/// What all subcommands share: the global options, and the work that the chosen one has set.
struct Tool {
  bool json = false;
  bool showProgress = false;
  bool force = false;        ///< outputs may replace what checkOutputs() refuses, and exports files that exist
  int threads = 0;           ///< 0: all cores
  std::function<int()> run;  ///< returns the exit code

  /// Shows progress on standard error, on a terminal or when asked for, labelled by `what`. Lives as long as the work.
  TaskControl control(const std::string& what) const;
};

// One a subcommand; each lies in the file of its name.
void addInfo(CLI::App& app, Tool& tool);
void addEvaluate(CLI::App& app, Tool& tool);
void addCheck(CLI::App& app, Tool& tool);
void addConvert(CLI::App& app, Tool& tool);
void addFit(CLI::App& app, Tool& tool);
void addEdit(CLI::App& app, Tool& tool);
void addExport(CLI::App& app, Tool& tool);
void addRender(CLI::App& app, Tool& tool);
void addScenes(CLI::App& app, Tool& tool);
void addCompare(CLI::App& app, Tool& tool);
void addFactor(CLI::App& app, Tool& tool);
void addDictionary(CLI::App& app, Tool& tool);
void addEncode(CLI::App& app, Tool& tool);
void addDecode(CLI::App& app, Tool& tool);
void addInterpolate(CLI::App& app, Tool& tool);
void addPlan(CLI::App& app, Tool& tool);
void addMeasure(CLI::App& app, Tool& tool);
void addReconstruct(CLI::App& app, Tool& tool);
void addStudy(CLI::App& app, Tool& tool);
void addFigure(CLI::App& app, Tool& tool);
void addMerge(CLI::App& app, Tool& tool);

}  // namespace gonio::tool
