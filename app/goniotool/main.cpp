// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <cstdio>
#include <memory>
#include <optional>

#include "app/goniotool/outputs.h"
#include "app/goniotool/pages.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "app/goniotool/usage.h"
#include "core/io/csv_text.h"
#include "core/math/parallel.h"
#include "core/support/system.h"

namespace {

using namespace gonio;

constexpr int failed = 1, wrongUsage = 2;

int printError(const std::string& message, int code) {
  tool::eraseProgress();
  std::fprintf(stderr, "goniotool: %s\n", tool::oneLine(message).c_str());
  return code;
}

int work(const tool::Tool& tool, const CLI::App& command) {
  std::optional<ThreadLimit> limit;
  if (tool.threads > 0) limit.emplace(tool.threads);
  try {
    if (!tool.force) tool::checkOutputs(command);
    return tool.run();
  } catch (const tool::UsageError& error) {
    return printError(error.what(), wrongUsage);
  } catch (const Cancelled&) {
    return printError("interrupted", failed);
  } catch (const std::exception& error) {
    return printError(error.what(), failed);
  }
}

int parseAndWork(tool::Tool& tool, int argc, char** argv) {
  CLI::App app(
      "Command-line tool for measured materials (BRDFs): reads, checks, converts, fits, edits, factorises, encodes "
      "and\n"
      "blends them, plans measurements, exports, renders, compares, and makes studies and figures.",
      "goniotool");
  const system::StopOnSignal stopOnSignal;
  tool.stop = stopOnSignal.token();
  app.set_version_flag("--version", std::string("goniotool " GONIO_VERSION));
  app.require_subcommand(1);
  app.fallthrough();
  app.add_flag("--json", tool.json, "Print results as JSON");
  app.add_flag("--progress", tool.showProgress, "Show progress on standard error even if it is not a terminal");
  app.add_flag("--force", tool.force, "Allow outputs to replace input files, and exports to replace existing files");
  app.add_option("--threads", tool.threads, "Number of threads (all cores)")->check(CLI::Range(1, 4096));
  app.formatter(std::make_shared<tool::HelpFormatter>());
  app.footer("Exit code: 0 success, 1 failure or failed check, 2 wrong usage.");
  for (const auto add :
       {tool::addInfo,        tool::addEvaluate,  tool::addCheck,      tool::addConvert,     tool::addFit,
        tool::addEdit,        tool::addFactor,    tool::addDictionary, tool::addEncode,      tool::addDecode,
        tool::addInterpolate, tool::addPlan,      tool::addMeasure,    tool::addReconstruct, tool::addExport,
        tool::addRender,      tool::addScenes,    tool::addCompare,    tool::addStudy,       tool::addFigure,
        tool::addTrainNeural, tool::addReproduce, tool::addPhotograph})
    add(app, tool);
  // For the build: prints a page of docs with its tables.
  app.add_option_function<std::string>("--complete-page",
                                       [&app](const std::string& file) {
                                         std::fputs(tool::completePage(app, io::readText(file)).c_str(), stdout);
                                         throw CLI::Success();
                                       })
      ->group("");
  tool::checkValues(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // help, version
    return printError(tool::usageMessage(app, error), wrongUsage);
  }
  return work(tool, *app.get_subcommands().front());
}

}  // namespace

int main(int argc, char** argv) {
  system::reportTooLargeFiles();
  system::keepFreedMemory();
  try {
    tool::Tool tool;
    const int code = parseAndWork(tool, argc, argv);
    // Also where the signal came too late to stop anything.
    if (code != 0 || !tool.keepsPartialResults) system::endByReceivedSignal();
    return code;
  } catch (const std::exception& error) {
    return printError(error.what(), failed);
  }
}
