// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "core/io/image_io.h"
#include "core/rendering/environment.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/scene_file.h"
#include "core/rgl/rgl_file.h"

/// Pictures of RGL materials by Mitsuba 3 (data/renderings of the development data, where the README has the scene).
namespace gonio::test {

inline std::vector<std::string> mitsubaMaterials() {
  return {"acrylic_felt_green", "aurora_white", "cc_iris_purple_gem", "chm_mint",
          "leaf_maple",         "paper_blue",   "satin_purple",       "vch_golden_yellow"};
}

/// Energy of the difference over that of the picture, free of the noise of both by two seeds of each; a chance result
/// may be negative.
struct Parity {
  double error = 0, standardError = 0;
  static double decibels(double fraction) {
    return fraction > 0 ? -10 * std::log10(fraction) : std::numeric_limits<double>::infinity();
  }
};

/// An environment as Mitsuba reads it: the centres of its first and its last row lie on the poles, in Gonio half a
/// pixel away from them. Drawn out by rows, which keeps it linear between those of Mitsuba but for an eighth of a row.
inline std::shared_ptr<const rendering::EnvironmentMap> asMitsubaReads(const rendering::EnvironmentMap& environment) {
  constexpr int factor = 4;
  const Image& own = environment.image();
  Image rows(own.width, own.height * factor);
  for (int y = 0; y < rows.height; ++y) {
    const double place = (y + 0.5) / rows.height * (own.height - 1);
    const int top = std::min(int(place), own.height - 2);
    for (int x = 0; x < rows.width; ++x)
      rows.at(x, y) = glm::mix(own.at(x, top), own.at(x, top + 1), float(place - top));
  }
  return std::make_shared<const rendering::EnvironmentMap>(std::move(rows), environment.name());
}

/// The scene of Mitsuba's pictures. @param shared folder of the development data.
inline rendering::Scene mitsubaScene(const std::filesystem::path& shared) {
  static const auto environment =
      asMitsubaReads(*rendering::openEnvironment((shared / "data/environments/studio.hdr").string()));
  rendering::Scene scene = rendering::openScene("sphere", 1);
  scene.environment = environment;
  return scene;
}

/// @param seed 1 or 2.
inline Image mitsubaPicture(const std::filesystem::path& shared, const std::string& material, int seed) {
  return io::readImage(shared / "data/renderings" / (material + "." + std::to_string(seed) + ".exr"));
}

inline std::shared_ptr<const Brdf> mitsubaMaterial(const std::filesystem::path& shared, const std::string& material,
                                                   IncidentDirection incident = IncidentDirection::viewer) {
  return rgl::readRgl(io::FileSource(shared / "data/rgl" / (material + "_rgb.bsdf"))).brdf->withIncident(incident);
}

/// Our pictures against Mitsuba's. A pixel of theirs that is no number (chm_mint has one) is left out.
/// @param samples a pixel of ours, 256 x 256.
inline Parity parityWithMitsuba(const std::filesystem::path& shared, const std::string& material, int samples,
                                IncidentDirection incident = IncidentDirection::viewer) {
  const rendering::Scene scene = mitsubaScene(shared);
  Image theirs[2], ours[2];
  const auto brdf = mitsubaMaterial(shared, material, incident);
  const auto rendered = rendering::pictureMaterial(*brdf, {});
  for (const int seed : {1, 2}) {
    theirs[seed - 1] = mitsubaPicture(shared, material, seed);
    const Image& size = theirs[seed - 1];
    ours[seed - 1] = rendering::renderPicture(
        rendered, scene, {.width = size.width, .height = size.height, .samples = samples, .seed = std::uint64_t(seed)});
  }
  double signal = 0, error = 0, squares = 0;
  for (std::size_t i = 0; i < theirs[0].pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double m1 = theirs[0].pixels[i][c], m2 = theirs[1].pixels[i][c];
      if (!std::isfinite(m1 * m2)) continue;
      signal += m1 * m2;
      const double product = (m1 - ours[0].pixels[i][c]) * (m2 - ours[1].pixels[i][c]);
      error += product;
      squares += product * product;
    }
  return {error / signal, std::sqrt(squares) / signal};
}

}  // namespace gonio::test
