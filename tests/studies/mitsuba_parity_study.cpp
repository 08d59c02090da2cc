// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// gonio_studies mitsuba_parity SHARED [SAMPLES [MATERIAL ...]]: our pictures of eight RGL materials against those of
// Mitsuba 3, in each order of the directions. SHARED is the folder of the development data.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "tests/studies/study_program.h"
#include "tests/support/mitsuba_pictures.h"

namespace gonio::study::mitsuba_parity_study {
namespace {

int study(int argumentCount, char** arguments) {
  if (argumentCount < 2) {
    std::fprintf(stderr, "usage: gonio_studies mitsuba_parity SHARED [SAMPLES [MATERIAL ...]]\n");
    return 2;
  }
  const int samples = argumentCount > 2 ? std::atoi(arguments[2]) : 256;
  std::printf("%-22s %16s %16s %16s\n", "dB (at least)", "viewer", "light", "mean");
  std::vector<std::string> materials(arguments + std::min(argumentCount, 3), arguments + argumentCount);
  if (materials.empty()) materials = test::mitsubaMaterials();
  for (const std::string& material : materials) {
    std::printf("%-22s", material.c_str());
    for (const IncidentDirection slot :
         {IncidentDirection::viewer, IncidentDirection::light, IncidentDirection::mean}) {
      const auto found = test::parityWithMitsuba(arguments[1], material, samples, slot);
      std::printf(" %8.1f (%5.1f)", test::Parity::decibels(found.error),
                  test::Parity::decibels(found.error + 2 * found.standardError));
      std::fflush(stdout);
    }
    std::printf("\n");
  }
  return 0;
}

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::mitsuba_parity_study
