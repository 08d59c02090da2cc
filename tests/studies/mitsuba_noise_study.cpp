// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// gonio_studies mitsuba_noise SHARED [MATERIAL ...]: the noise of the pictures of eight RGL materials by Mitsuba 3 (256
// samples per pixel), and the number of samples with which ours have the same noise, with the processor time of each.
// SHARED is the folder of the development data.
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "tests/studies/study_program.h"
#include "tests/support/mitsuba_pictures.h"

namespace gonio::study::mitsuba_noise_study {
namespace {

using Pictures = std::array<Image, 2>;

/// The root mean square noise of one picture relative to the root mean square of the picture, from two seeds.
double noiseOf(const Pictures& pictures) {
  double signal = 0, noise = 0;
  for (std::size_t i = 0; i < pictures[0].pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double a = pictures[0].pixels[i][c], b = pictures[1].pixels[i][c];
      if (!std::isfinite(a * b)) continue;
      signal += a * b;
      noise += (a - b) * (a - b) / 2;
    }
  return std::sqrt(noise / signal);
}

void compare(const std::filesystem::path& shared, const std::string& material) {
  const double theirs = noiseOf({test::mitsubaPicture(shared, material, 1), test::mitsubaPicture(shared, material, 2)});
  std::printf("%-22s %8.3f %%", material.c_str(), 100 * theirs);
  const rendering::Scene scene = test::mitsubaScene(shared);
  const auto brdf = test::mitsubaMaterial(shared, material);
  const auto rendered = rendering::pictureMaterial(*brdf, {});
  double previous = 0, equal = 0;
  for (int samples = 8; samples <= 256; samples *= 2) {
    Pictures ours;
    const std::clock_t start = std::clock();
    for (const int seed : {1, 2})
      ours[std::size_t(seed - 1)] = rendering::renderPicture(
          rendered, scene, {.width = 256, .height = 256, .samples = samples, .seed = std::uint64_t(seed)});
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC / 2;
    const double noise = noiseOf(ours);
    std::printf("  %3d: %6.3f %% %6.2f s", samples, 100 * noise, seconds);
    std::fflush(stdout);
    // Between two numbers of samples, the logarithm of the noise is linear in that of the samples.
    if (equal == 0 && noise <= theirs && previous > theirs)
      equal = samples * std::exp2(-std::log(theirs / noise) / std::log(previous / noise));
    previous = noise;
  }
  std::printf("  equal at %.0f\n", equal);
}

int study(int argumentCount, char** arguments) {
  if (argumentCount < 2) {
    std::fprintf(stderr, "usage: gonio_studies mitsuba_noise SHARED [MATERIAL ...]\n");
    return 2;
  }
  std::vector<std::string> materials(arguments + std::min(argumentCount, 2), arguments + argumentCount);
  if (materials.empty()) materials = test::mitsubaMaterials();
  for (const std::string& material : materials) compare(arguments[1], material);
  return 0;
}

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::mitsuba_noise_study
