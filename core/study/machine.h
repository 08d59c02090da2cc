// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

namespace gonio::study {

/// Where, with which program and when times were measured.
struct MachineFacts {
  std::string processor;  ///< its own name, or "unknown processor" where the system does not report it
  int cores = 0;          ///< of the machine, as the system counts them
  int threads = 0;        ///< that parallel work used
  std::string version;    ///< of Gonio
  std::string compiler;   ///< "GNU 12.2.0"
  std::string flags;      ///< build type and flags of the compiler
  std::string date;       ///< ISO 8601, UTC: "2026-11-21T22:15:00Z"
};

/// Of this process now; `threads` those of the calling thread.
MachineFacts machineFacts();

/// The same of the program alone, for results without times: neither processor nor date.
MachineFacts buildFacts();

/// For people: processor with its cores and threads; program and build; date. What is empty is left out.
std::vector<std::string> machineLines(const MachineFacts& facts);

}  // namespace gonio::study
