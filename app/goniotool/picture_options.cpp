// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/picture_options.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <tuple>

#include "app/goniotool/report.h"
#include "app/goniotool/usage.h"
#include "core/io/image_io.h"
#include "core/rendering/environment.h"

namespace gonio::tool {

namespace {

constexpr int maxPictureSize = 8192;

std::string suffixOf(const std::string& path) { return std::filesystem::path(path).extension().string(); }

/// On standard error, a line each.
void printNotes(const std::vector<std::string>& notes, const std::string& start) {
  for (const std::string& note : notes) std::fprintf(stderr, "note: %s\n", oneLine(start + note).c_str());
}

}  // namespace

PictureOptions comparisonPictures() {
  const rendering::RenderOptions picture = rendering::smallComparisonPicture();
  PictureOptions options;
  options.size = std::to_string(picture.width);
  options.samples = picture.samples;
  return options;
}

std::pair<int, int> pictureSize(const std::string& text) {
  int width = 0, height = 0;
  const char* const end = text.data() + text.size();
  auto [at, error] = std::from_chars(text.data(), end, width);
  height = width;
  if (error == std::errc() && at != end && *at == 'x') {
    const auto second = std::from_chars(at + 1, end, height);
    at = second.ptr;
    error = second.ec;
  }
  const auto fits = [](int length) { return length >= 1 && length <= maxPictureSize; };
  if (error != std::errc() || at != end || !fits(width) || !fits(height))
    throw UsageError("found '" + text + "', expected a number or WIDTHxHEIGHT up to 8192");
  return {width, height};
}

void PictureOptions::apply(rendering::Scene& scene) const {
  printNotes(scene.notes, "");
  if (!light.empty()) {
    const Direction direction(light[0], light[1], light[2]);
    const double length = glm::length(direction);
    if (!(length > 0) || std::isinf(length))
      throw UsageError("--light: found a direction of length " + number(length) + ", expected a finite one above 0");
    scene.environment = nullptr;
    scene.pointLights.clear();
    std::erase_if(scene.objects, [](const rendering::SceneObject& object) { return object.emits(); });
    scene.directionalLights = {{.toLight = glm::normalize(direction)}};
    return;
  }
  if (!environment.empty()) scene.environment = rendering::openEnvironment(environment);
  if (scene.environment) printNotes(scene.environment->notes(), scene.environment->name() + ": ");
  scene.environmentRotation += radians(rotation);
  scene.showEnvironment = scene.showEnvironment || showEnvironment || blurBackground;
  scene.blurBackground = scene.blurBackground || blurBackground;
}

rendering::RenderOptions PictureOptions::renderOptions() const {
  rendering::RenderOptions result;
  std::tie(result.width, result.height) = pictureSize(size);
  result.samples = samples;
  result.seed = seed;
  return result;
}

void addPictureOptions(CLI::App& command, const std::shared_ptr<PictureOptions>& options) {
  auto* environment = command
                          .add_option("--environment", options->environment,
                                      "Environment: " + rendering::bundledEnvironmentList() +
                                          " or an image file (environment of the scene)")
                          ->type_name("NAME|FILE");
  command
      .add_option("--light", options->light,
                  "Replace all lights with a distant light; X Y Z points towards the light, y up, z towards the camera")
      ->expected(3)
      ->excludes(environment);
  command.add_option("--rotation", options->rotation,
                     "Rotation of the environment about the vertical axis, degrees (0)");
  command.add_flag("--show-environment", options->showEnvironment, "Show the environment behind the objects");
  command.add_flag("--blur-background", options->blurBackground, "Blur the environment behind the objects");
  command.add_option("--size", options->size, "Size of the image, pixels: a number or WIDTHxHEIGHT (256)")
      ->type_name("N|WIDTHxHEIGHT")
      ->check(parsedBy(pictureSize));
  command.add_option("--samples", options->samples, "Samples per pixel (64)")->check(CLI::Range(1, 1 << 20));
  command.add_option("--seed", options->seed, "Seed of the random numbers (1)");
  command.add_option("--exposure", options->exposure, "Exposure of PNG images, stops (0)")
      ->check(CLI::Range(-30.0, 30.0));
  command.add_option("--tone-map", options->toneMap, "Tone map of PNG images: clamp or filmic (clamp)")
      ->check(CLI::IsMember({std::string(rendering::toneMapName(rendering::ToneMap::clamp)),
                             std::string(rendering::toneMapName(rendering::ToneMap::filmic))}));
}

void addUpOption(CLI::App& command, std::string& up) {
  command.add_option("--up", up, "Axis that points up, if the scene is a mesh: y or z (y)")
      ->check(CLI::IsMember({"y", "z"}));
}

void checkPicture(const std::string& out, bool mayBeExr) {
  const std::string suffix = suffixOf(out);
  if (suffix == ".png" || (mayBeExr && suffix == ".exr")) return;
  throw UsageError(out + ": found the suffix '" + suffix + "', expected " + (mayBeExr ? ".exr or .png" : ".png"));
}

void writePicture(const Image& image, const PictureOptions& options, const std::string& out,
                  std::map<std::string, std::string> attributes) {
  checkPicture(out);
  attributes["software"] = "goniotool " GONIO_VERSION;
  if (suffixOf(out) == ".exr")
    io::writeExr(image, out, attributes);
  else
    io::writePng(rendering::toDisplayBytes(image, options.exposure, options.tone()), image.width, image.height, out);
}

}  // namespace gonio::tool
