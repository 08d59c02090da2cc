// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

namespace gonio::study {

/// Machine, program and date of measured times.
struct MachineFacts {
  std::string processor;  ///< name, or "unknown processor" if the system does not report it
  int cores = 0;          ///< of the machine, as reported by the system
  int threads = 0;        ///< of parallel loops
  std::string version;    ///< of Gonio
  std::string compiler;   ///< e.g. "GNU 12.2.0"
  std::string flags;      ///< build type and flags of the compiler
  std::string date;       ///< ISO 8601, UTC, e.g. "2026-11-21T22:15:00Z"
};

/// The facts of this process now; `threads` is threadCount() of the calling thread.
MachineFacts machineFacts();

/// Only the facts of the program, for results without times: no processor and no date.
MachineFacts buildFacts();

/// Lines for display: processor with its cores and threads; program and build; date. Empty facts are omitted.
std::vector<std::string> machineLines(const MachineFacts& facts);

}  // namespace gonio::study
