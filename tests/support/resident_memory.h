// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <dlfcn.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <fstream>

namespace gonio::test {

/// jemalloc's mallctl(), null in programs that do not link it.
inline auto jemallocControl() {
  using Control = int (*)(const char*, void*, std::size_t*, void*, std::size_t);
  return reinterpret_cast<Control>(dlsym(RTLD_DEFAULT, "mallctl"));
}

/// The memory of this process in RAM, after unused memory has been returned to the system.
inline std::size_t residentMegabytes() {
  if (const auto control = jemallocControl()) control("arena.4096.purge", nullptr, nullptr, nullptr, 0);  // all arenas
  std::size_t all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * std::size_t(sysconf(_SC_PAGESIZE)) / 1'000'000;
}

/// The memory in use according to the allocator; zero if that is not jemalloc.
inline std::size_t allocatedMegabytes() {
  const auto control = jemallocControl();
  if (!control) return 0;
  std::uint64_t epoch = 1;
  control("epoch", nullptr, nullptr, &epoch, sizeof epoch);
  std::size_t bytes = 0, size = sizeof bytes;
  control("stats.allocated", &bytes, &size, nullptr, 0);
  return bytes / 1'000'000;
}

}  // namespace gonio::test
