// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/goniotool/tool.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/scene.h"
#include "core/rendering/tone_map.h"

namespace gonio::tool {

/// The options of all subcommands that make pictures.
struct PictureOptions {
  std::string environment, size = "256", toneMap = "clamp";
  std::vector<double> light;  ///< direction to the light, world; empty: an environment
  double rotation = 0;        ///< of the environment, degrees
  double exposure = 0;        ///< stops, of PNG pictures
  int samples = 64;
  std::uint64_t seed = 1;
  bool showEnvironment = false, blurBackground = false;

  /// With `light`, replaces all lights of the scene by this distant light. Otherwise replaces its environment by
  /// `environment` if that is not empty, and applies rotation and background.
  /// @throws Error if the environment is neither bundled nor a readable picture; UsageError for other invalid options.
  void apply(rendering::Scene& scene) const;
  rendering::RenderOptions renderOptions() const;
  rendering::ToneMap tone() const {
    return toneMap == rendering::toneMapName(rendering::ToneMap::filmic) ? rendering::ToneMap::filmic
                                                                         : rendering::ToneMap::clamp;
  }
};

/// Size and samples of rendering::smallComparisonPicture(), so that commands that compare report the same SNR.
PictureOptions comparisonPictures();

/// Width and height of "256" or "640x480". @throws UsageError.
std::pair<int, int> pictureSize(const std::string& text);

/// Adds the options for light, size, samples and display.
void addPictureOptions(CLI::App& command, const std::shared_ptr<PictureOptions>& options);

/// Adds --up, the axis of a mesh as the scene that points up: "y" or "z" (rendering::upAxisOf()).
void addUpOption(CLI::App& command, std::string& up);

/// Writes a picture by the suffix of `out`: .exr (linear, with the attributes) or .png (displayed).
/// @throws Error that names the file; UsageError for another suffix (checkPicture() reports it before the work).
void writePicture(const Image& image, const PictureOptions& options, const std::string& out,
                  std::map<std::string, std::string> attributes = {});
void checkPicture(const std::string& out, bool mayBeExr = true);

}  // namespace gonio::tool
