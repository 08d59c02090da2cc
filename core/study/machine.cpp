// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/machine.h"

#include <ctime>
#include <fstream>
#include <thread>

#include "core/math/parallel.h"
#include "core/study/build_facts.h"

namespace gonio::study {

namespace {

std::string processorName() {
  std::ifstream facts("/proc/cpuinfo");
  for (std::string line; std::getline(facts, line);)
    if (line.starts_with("model name"))
      if (const auto at = line.find(": "); at != std::string::npos) return line.substr(at + 2);
  return "unknown processor";
}

std::string dateNow() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc)};
}

}  // namespace

MachineFacts machineFacts() {
  return {.processor = processorName(),
          .cores = int(std::thread::hardware_concurrency()),
          .threads = threadCount(),
          .version = buildVersion,
          .compiler = buildCompiler,
          .flags = buildFlags,
          .date = dateNow()};
}

std::vector<std::string> machineLines(const MachineFacts& facts) {
  const auto counted = [](int count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
  };
  return {facts.processor + ", " + counted(facts.cores, "core") + ", " + counted(facts.threads, "thread"),
          "Gonio " + facts.version + ", " + facts.compiler + ", " + facts.flags, facts.date};
}

}  // namespace gonio::study
