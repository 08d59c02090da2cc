// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <malloc.h>
#include <unistd.h>

#include <fstream>

namespace gonio::test {

/// The memory of this process in RAM, after unused memory has been returned to the system. Zero where it is not known.
inline std::size_t residentMegabytes() {
  malloc_trim(0);
  std::size_t all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * std::size_t(sysconf(_SC_PAGESIZE)) / 1'000'000;
}

/// The memory in use according to glibc's allocator.
inline std::size_t allocatedMegabytes() {
  const struct mallinfo2 info = mallinfo2();
  return (info.uordblks + info.hblkhd) / 1'000'000;
}

}  // namespace gonio::test
