// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/matching/sphere_finder.h"
#include "core/rendering/scene.h"

/// Materials from photographs of a sphere under known light: docs/photographs.md.
namespace gonio::photograph {

/// The light of a photograph, in the world axes of rendering::Scene. Lengths are in radii of the sphere, positions
/// relative to its centre.
struct Light {
  std::shared_ptr<const rendering::EnvironmentMap> environment;  ///< may be null
  double rotation = 0;                                           ///< rad, rendering::EnvironmentRotation
  std::vector<rendering::DirectionalLight> directional;
  std::vector<rendering::PointLight> points;
};

/// A linear image of a sphere.
struct Photograph {
  std::string name;  ///< for messages
  Image image;       ///< linear RGB, proportional to radiance
  matching::Disc disc;
  /// Camera about the centre of the sphere; distances in radii, more than 1. Its axis passes through the centre, and
  /// `disc` is the sphere's outline, so the field of view is not used.
  rendering::OrbitCamera camera;
  Light light;
  double clip = std::numeric_limits<double>::infinity();  ///< pixels with a channel of at least this value are not used
};

/// Photographs of one material with the same exposure.
struct PhotographSet {
  std::vector<Photograph> photographs;
  /// Whether a pixel's value is a radiance in the unit of the light; otherwise, all have a common unknown factor.
  bool exposureKnown = true;
  /// The factors by which grey patches show that the pixel values of the files differ from radiances; the images have
  /// been divided by it. 1 without grey patches.
  Rgb exposure{1};
  std::vector<std::string> warnings;  ///< what was found, for people: clipped pixels, notes of the image readers
};

/// The outline of a sphere whose centre is on the axis of a perspective camera, in the middle of an image.
/// @param camera distance in radii.
matching::Disc discOf(const rendering::OrbitCamera& camera, int width, int height);

/// The value from which pixels count as clipped: the largest value of the image inside the disc, if at least 0.1 % of
/// the pixels there (and 4) have a channel of exactly this value. Infinite otherwise.
double clippedFrom(const Image& image, const matching::Disc& disc);

/// A description of photographs that may be rendered: as PhotographSet, but the images may be missing.
struct PhotographDescription {
  PhotographSet set;
  std::vector<std::filesystem::path> files;  ///< of the images
  std::vector<glm::ivec2> sizes;             ///< of the images to render, pixels; 256 x 256 if not stated
  std::vector<Photograph> candidates;        ///< for the next image (photograph_plan.h), without images
};

using GivenImages = std::map<std::string, Image>;

/// Larger files are no descriptions.
inline constexpr std::uint64_t maxDescriptionBytes = std::uint64_t(1) << 24;

/// Reads a JSON description (docs/photographs.md has the format). @param images whether to read the images.
/// @param folder base of relative paths.
/// @throws Error that names the member or the image file, what was found and what was expected: PNG and JPEG files
/// without a stated gamma, an outline outside of the image, no light, a camera inside the sphere.
/// @param given linear images that stand for files, by the text of the member "file".
PhotographDescription parseDescription(const std::string& text, const std::filesystem::path& folder, bool images,
                                       const GivenImages& given = {});
/// The same from a file, which errors name.
PhotographDescription readDescription(const std::filesystem::path& path, bool images = true);

/// The scene that a photograph shows: the unit sphere at the origin. Its camera's field of view shows the sphere
/// as large as the disc is in an image of this size.
rendering::Scene sceneOf(const Photograph& photograph, int width, int height);

}  // namespace gonio::photograph
