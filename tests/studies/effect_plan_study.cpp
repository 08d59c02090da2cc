// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// gonio_studies effect_plan [SCENES [FIRST]]: random scenes of hard materials (tests/support/random_plans.h) by their
// plans against all effects, with the same random numbers, in blocks of 8 x 8 pixels. A block that differs by more than
// the plan states and 4 standard errors is rendered again with another seed and 16 times as many samples. Prints the
// scenes that still differ, and the bounce rays of both.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/studies/study_program.h"
#include "tests/support/random_plans.h"

namespace gonio::study::effect_plan_study {
namespace {

int run(const std::vector<std::string>& arguments) {
  const int scenes = arguments.empty() ? 2000 : std::stoi(arguments[0]);
  const int first = arguments.size() < 2 ? 1 : std::stoi(arguments[1]);
  constexpr int side = 16, samples = 64, again = 16;
  int repeated = 0, differing = 0, precise = 0, black = 0;
  std::uint64_t rays = 0, raysOfAll = 0;
  for (int seed = first; seed < first + scenes; ++seed) {
    const test::RandomPlan random = test::randomPlan(std::uint64_t(seed));
    const rendering::EffectPlan plan = rendering::checkedPlan(random.scene, random.materials);
    test::PlanComparison result = test::comparePlan(random, side, samples, 1, plan);
    rays += result.rays;
    raysOfAll += result.raysOfAll;
    if (!result.agrees()) {
      ++repeated;
      result = test::comparePlan(random, side, again * samples, 2, plan);
    }
    black += result.mean == 0;
    precise += result.meanError <= 0.01 * result.mean;
    if (result.agrees()) continue;
    ++differing;
    std::printf("scene %d: mean %.4g, a block differs by %.3g, stated %.3g, standard error %.3g\n", seed, result.mean,
                result.difference, result.stated, result.standardError);
  }
  std::printf(
      "%d scenes: %d differ (%d were rendered again), %d black, %d with a standard error of the mean of at most 1 %%; "
      "bounce rays %.4g by the plan, %.4g with all effects\n",
      scenes, differing, repeated, black, precise, double(rays), double(raysOfAll));
  return differing == 0 ? 0 : 1;
}

int study(int count, char** values) { return run({values + 1, values + count}); }

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::effect_plan_study
