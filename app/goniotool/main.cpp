// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <semaphore.h>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <memory>
#include <optional>
#include <stop_token>
#include <thread>

#include "app/goniotool/outputs.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "app/goniotool/usage.h"
#include "core/math/parallel.h"

namespace gonio::tool {

namespace {

/// While it exists, the first SIGINT, SIGTERM or SIGHUP asks the work to stop, so that no temporary file remains.
/// Another one ends the program at once; within half a second it counts as the same request. Signals that the parent
/// process ignores (`nohup`) stay ignored. Only one instance may exist in a process.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;

  std::stop_token token() const { return stop_.get_token(); }

 private:
  void watch(const std::stop_token& end);

  std::stop_source stop_;
  std::jthread watcher_;
};

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};

// timeout(1) and some shells send a signal to the process and then to its group.
constexpr std::int64_t sameRequestMs = 500;

std::atomic<int> received = 0;
std::atomic<std::int64_t> receivedAt = 0;  // 0: no signal yet
sem_t wakeUp;

/// On a clock that is never 0.
std::int64_t milliseconds() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t(now.tv_sec) * 1000 + now.tv_nsec / 1'000'000 + 1;
}

void endBy(int signal) {
  std::signal(signal, SIG_DFL);
  ::raise(signal);
}

extern "C" void receive(int signal) {
  const int errorBefore = errno;
  const std::int64_t now = milliseconds();
  std::int64_t first = 0;
  if (receivedAt.compare_exchange_strong(first, now)) {
    received = signal;
    ::sem_post(&wakeUp);
  } else if (now - first > sameRequestMs) {
    endBy(signal);
  }
  errno = errorBefore;
}

void setHandlers() {
  for (const int signal : signals) {
    struct sigaction current {};
    if (::sigaction(signal, nullptr, &current) != 0 || current.sa_handler == SIG_IGN) continue;
    struct sigaction next {};
    next.sa_handler = receive;
    next.sa_flags = SA_RESTART;
    ::sigaction(signal, &next, nullptr);
  }
}

StopOnSignal::StopOnSignal() {
  ::sem_init(&wakeUp, 0, 0);
  watcher_ = std::jthread([this](const std::stop_token& end) { watch(end); });
  setHandlers();
}

// The handlers stay installed: a first signal that arrives while the program exits only decides how it ends.
StopOnSignal::~StopOnSignal() {
  watcher_.request_stop();
  ::sem_post(&wakeUp);
}

void StopOnSignal::watch(const std::stop_token& end) {
  while (!end.stop_requested()) {
    if (::sem_wait(&wakeUp) == 0 && received != 0) stop_.request_stop();
  }
}

/// Ends the process by the signal that requested the stop, as its parent expects of an interrupted program (a shell
/// then ends its loop, too). Without a signal it returns. No StopOnSignal may exist.
void endByReceivedSignal() {
  if (received != 0) endBy(received);
}

}  // namespace

}  // namespace gonio::tool

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
  const tool::StopOnSignal stopOnSignal;
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
       {tool::addInfo,        tool::addEvaluate, tool::addCheck,      tool::addConvert,     tool::addFit,
        tool::addEdit,        tool::addFactor,   tool::addDictionary, tool::addEncode,      tool::addDecode,
        tool::addInterpolate, tool::addPlan,     tool::addMeasure,    tool::addReconstruct, tool::addExport,
        tool::addRender,      tool::addScenes,   tool::addCompare,    tool::addStudy,       tool::addFigure,
        tool::addTrainNeural, tool::addReproduce, tool::addPhotograph})
    add(app, tool);
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
  // Beyond the limit of the size of files (ulimit -f), writing fails with an error, which names the file.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    tool::Tool tool;
    const int code = parseAndWork(tool, argc, argv);
    // Also where the signal came too late to stop anything.
    if (code != 0 || !tool.keepsPartialResults) tool::endByReceivedSignal();
    return code;
  } catch (const std::exception& error) {
    return printError(error.what(), failed);
  }
}
