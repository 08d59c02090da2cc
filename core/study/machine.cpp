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
  MachineFacts facts = buildFacts();
  facts.processor = processorName();
  facts.cores = int(std::thread::hardware_concurrency());
  facts.threads = threadCount();
  facts.date = dateNow();
  return facts;
}

MachineFacts buildFacts() {
  return {.processor = {}, .version = buildVersion, .compiler = buildCompiler, .flags = buildFlags, .date = {}};
}

std::vector<std::string> machineLines(const MachineFacts& facts) {
  const auto counted = [](int count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
  };
  std::vector<std::string> lines;
  if (!facts.processor.empty())
    lines.push_back(facts.processor + ", " + counted(facts.cores, "core") + ", " + counted(facts.threads, "thread"));
  lines.push_back("Gonio " + facts.version + ", " + facts.compiler + ", " + facts.flags);
  if (!facts.date.empty()) lines.push_back(facts.date);
  return lines;
}

}  // namespace gonio::study
