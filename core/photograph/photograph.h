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

#include "core/photograph/surface.h"

/// Materials from photographs of a sphere, a cylinder or a flat sample under known light: docs/photographs.md.
namespace gonio::photograph {

/// The light of a photograph, in the world axes of rendering::Scene. Lengths are in radii of the sphere or cylinder, or
/// in the unit of the flat sample, positions relative to the middle of the surface.
struct Light {
  std::shared_ptr<const rendering::EnvironmentMap> environment;  ///< may be null
  double rotation = 0;                                           ///< rad, rendering::EnvironmentRotation
  std::vector<rendering::DirectionalLight> directional;
  std::vector<rendering::PointLight> points;
};

/// A linear image of a surface.
struct Photograph {
  std::string name;     ///< for messages
  Image image;          ///< linear RGB, proportional to radiance; may be missing
  matching::Disc disc;  ///< the outline of a sphere; not used of other surfaces
  /// Camera outside of the surface (isOutside()). If it is a sphere, the camera's axis passes through the centre, and
  /// `disc` stands for the field of view.
  rendering::OrbitCamera camera;
  Surface surface;
  /// Of the image, also of one that is still to be rendered or taken, in pixels. Not used of a sphere.
  glm::ivec2 size{0};
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

/// The value from which pixels count as clipped: the largest value of the pixels that show the surface, if at least
/// 0.1 % of them (and 4) have a channel of exactly this value. Infinite otherwise.
double clippedFrom(const Photograph& photograph);

/// A description of photographs that may be rendered: as PhotographSet, but the images may be missing.
struct PhotographDescription {
  PhotographSet set;
  std::vector<std::filesystem::path> files;  ///< of the images
  std::vector<Photograph> candidates;        ///< for the next image (photograph_plan.h), without images
};

using GivenImages = std::map<std::string, Image>;

/// Larger files are no descriptions.
inline constexpr std::uint64_t maxDescriptionBytes = std::uint64_t(1) << 24;

/// Reads a JSON description (docs/photographs.md has the format). @param images whether to read the images.
/// @param folder base of relative paths.
/// @throws Error that names the member or the image file, what was found and what was expected: PNG and JPEG files
/// without a stated gamma, an outline outside of the image, no light, a camera that does not see the surface.
/// @param given linear images that stand for files, by the text of the member "file".
PhotographDescription parseDescription(const std::string& text, const std::filesystem::path& folder, bool images,
                                       const GivenImages& given = {});
/// The same from a file, which errors name.
PhotographDescription readDescription(const std::filesystem::path& path, bool images = true);

/// The scene that a photograph shows. The field of view of its camera shows a sphere as large as the disc is in an
/// image of this size.
rendering::Scene sceneOf(const Photograph& photograph, int width, int height);

}  // namespace gonio::photograph
