// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/goniotool/tool.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/scene.h"
#include "core/rendering/tone_map.h"

namespace gonio::tool {

/// The options of every picture that a subcommand makes.
struct PictureOptions {
  std::string environment, size = "256", toneMap = "clamp";
  std::vector<double> light;  ///< direction to the light, world; empty: an environment
  double rotation = 0;        ///< of the environment, degrees
  double exposure = 0;        ///< stops, of PNG pictures
  int samples = 64;
  std::uint64_t seed = 1;
  bool showEnvironment = false, blurBackground = false;

  /// Puts a distant light that was asked for in the place of all lights of the scene, an environment in the place of
  /// its environment.
  /// @throws Error when the environment is neither bundled nor a readable picture; UsageError for the rest.
  void apply(Scene& scene) const;
  /// @throws UsageError when the size is not understood.
  RenderOptions renderOptions() const;
  ToneMap tone() const { return toneMap == toneMapName(ToneMap::filmic) ? ToneMap::filmic : ToneMap::clamp; }
};

/// Options of the light, the size, the samples and the display.
void addPictureOptions(CLI::App& command, const std::shared_ptr<PictureOptions>& options);

/// Writes a picture by the suffix of `out`: .exr (linear, with the attributes) or .png (displayed).
/// @throws Error naming the file; UsageError for another suffix (checkPicture() reports it before the work).
void writePicture(const Image& image, const PictureOptions& options, const std::string& out,
                  std::map<std::string, std::string> attributes = {});
void checkPicture(const std::string& out, bool mayBeExr = true);

}  // namespace gonio::tool
