// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <string>

/// Candidates for the next image, as text of a description (docs/photographs.md).
namespace gonio::photograph {

/// How many variants of the first image of a description are candidates.
struct CandidateCounts {
  int rotations = 0;  ///< rotations of the environment, in equal steps of the whole circle
  /// Directions from which the first distant or small light comes (without one, an additional distant light of
  /// irradiance pi), evenly spread up to 120 degrees from the direction to the camera.
  int lights = 0;
  /// Positions of the camera, in equal steps about the vertical axis. Those from which the surface is not seen (behind
  /// a flat sample, or in a cylinder without ends) are left out.
  int cameras = 0;

  bool operator==(const CandidateCounts&) const = default;
};

/// The description with candidates added to its member "candidates". Their files are "rotation-090.exr",
/// "light-1.exr", "camera-090.exr". @throws Error if the text is no description with images, or rotations are requested
/// and the first image has no environment.
std::string withCandidates(const std::string& description, const CandidateCounts& counts);

/// The description with chosen candidates as further images, and without candidates. @param chosen below the number of
/// its candidates.
std::string withChosenCandidates(const std::string& description, std::span<const std::size_t> chosen);

}  // namespace gonio::photograph
