// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// mitsuba_parity_study SHARED [SAMPLES [MATERIAL ...]]: our pictures of eight RGL materials against those of Mitsuba 3,
// in each order of the directions. SHARED is the folder of the development data.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "tests/support/mitsuba_pictures.h"

int main(int argumentCount, char** arguments) try {
  using namespace gonio;
  if (argumentCount < 2) {
    std::fprintf(stderr, "usage: mitsuba_parity_study SHARED [SAMPLES [MATERIAL ...]]\n");
    return 2;
  }
  const int samples = argumentCount > 2 ? std::atoi(arguments[2]) : 256;
  std::printf("%-22s %16s %16s %16s\n", "dB (at least)", "viewer", "light", "mean");
  std::vector<std::string> materials(arguments + std::min(argumentCount, 3), arguments + argumentCount);
  if (materials.empty()) materials = test::mitsubaMaterials();
  for (const std::string& material : materials) {
    std::printf("%-22s", material.c_str());
    for (const IncidentSlot slot : {IncidentSlot::viewer, IncidentSlot::light, IncidentSlot::mean}) {
      const auto found = test::parityWithMitsuba(arguments[1], material, samples, slot);
      std::printf(" %8.1f (%5.1f)", test::Parity::decibels(found.error),
                  test::Parity::decibels(found.error + 2 * found.standardError));
      std::fflush(stdout);
    }
    std::printf("\n");
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "mitsuba_parity_study: %s\n", error.what());
  return 1;
}
