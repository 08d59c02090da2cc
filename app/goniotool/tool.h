// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <CLI/CLI.hpp>
#include <chrono>
#include <functional>
#include <stop_token>
#include <string>

#include "core/support/task_control.h"

namespace gonio::tool {

/// Invalid or contradictory arguments, reported with exit code 2. All other exceptions are reported with 1.
class UsageError : public Error {
 public:
  using Error::Error;
};

/// Data shared by all subcommands: the global options and the action of the selected subcommand.
struct Tool {
  bool json = false;
  bool showProgress = false;
  bool force = false;                ///< permits outputs that checkOutputs() refuses, and exports to existing files
  int threads = 0;                   ///< 0: all cores
  std::stop_token stop;              ///< of the whole program, see system::StopOnSignal
  std::function<int()> run;          ///< returns the exit code
  bool keepsPartialResults = false;  ///< whether exit code 0 after a stop means the results so far

  /// A control with `stop` that shows progress on standard error (on a terminal or if requested), labelled with `what`.
  TaskControl control(const std::string& what) const;

  /// For results that may be incomplete after a stop. @throws Cancelled if a stop was requested.
  void throwIfStopped() const { TaskControl{stop, {}}.throwIfStopped(); }
};

/// Group of the options and arguments that name files to write, as a heading of the help; all others are inputs.
inline constexpr const char* outputGroup = "Outputs";

/// Seconds since a time of the steady clock.
double secondsSince(std::chrono::steady_clock::time_point start);

/// Erases the line of progress on standard error if that is a terminal, so that a message can take its place.
void eraseProgress();

// One function per subcommand, each in the file of the same name.
void addInfo(CLI::App& app, Tool& tool);
void addEvaluate(CLI::App& app, Tool& tool);
void addCheck(CLI::App& app, Tool& tool);
void addConvert(CLI::App& app, Tool& tool);
void addFit(CLI::App& app, Tool& tool);
void addEdit(CLI::App& app, Tool& tool);
void addExport(CLI::App& app, Tool& tool);
void addRender(CLI::App& app, Tool& tool);
void addReproduce(CLI::App& app, Tool& tool);
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
void addPhotograph(CLI::App& app, Tool& tool);
void addStudy(CLI::App& app, Tool& tool);
void addFigure(CLI::App& app, Tool& tool);
void addTrainNeural(CLI::App& app, Tool& tool);

}  // namespace gonio::tool
