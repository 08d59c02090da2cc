// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/rendering/render_picture.h"
#include "core/rgl/rgl_sampler.h"

namespace gonio::rgl {

/// Number of polar angles of the incident direction, and of nodes along each side of a slice.
struct RglSize {
  std::size_t thetaCount = 16, size = 32;
};

struct RglOptions {
  double snr = 40;                     ///< rendered SNR in comparisonScene() to reach, dB
  std::optional<RglSize> size;         ///< a new parameterisation of this size
  std::uint64_t maxBytes = 5'000'000;  ///< of the RGB file
  std::size_t azimuths = 12;           ///< for anisotropic materials: intervals of the circle
};

/// The RGL file that a material was read from.
struct RglFileSource {
  std::shared_ptr<const RglBrdf> brdf;
  std::vector<std::byte> bytes;
  bool onlyColoursChanged = false;  ///< whether edits left the shape of the highlights, so that these nodes suit them
};

/// A material as an RGL file with RGB colours and one with spectra: Mitsuba's RGB variants read only the first, its
/// spectral variants and pbrt only the second.
struct EncodedRgl {
  std::vector<std::byte> rgb, spectral;
  /// The files as they evaluate, with IncidentDirection::viewer; the spectral one in colours under D65.
  std::shared_ptr<const RglBrdf> rgbBrdf, spectralBrdf;
  double rgbSnr = std::numeric_limits<double>::infinity(), spectralSnr = rgbSnr;  ///< their rendered SNR, dB
  RglSize size;
  bool ownParameterisation = false;  ///< whether the source's nodes were kept
  bool unchanged = false;            ///< whether also its values were
  bool keepsSpectra = true;          ///< false if the source is spectral and `spectral` was made of RGB colours
  /// Number of negative values: in the RGB file, of colours outside sRGB, which Mitsuba evaluates; in the spectral file
  /// only as the source has them, since pbrt sets them to 0.
  std::size_t negativeValues = 0;
};

/// Renders the material of an encodeRgl(), for RenderedComparison::signalToNoiseRatio(). @throws Cancelled.
using ReferencePictures = std::function<rendering::RenderedComparison(const TaskControl&)>;

/// Encodes a material, with the viewer as incident direction (IncidentDirection::viewer), in the parameterisation that
/// its error calls for. A material that an RGL file was edited to keeps the file's nodes if its values there reproduce
/// it without visible error, as after changes of colour; all fields that do not change are copied. Other materials get
/// a new parameterisation, placed by the material itself: of a series of sizes, the smallest that reaches the SNR, or
/// the best within `maxBytes`. The source's nodes are one of the sizes. Takes 1 to 5 s.
/// @param source null if the material was not read from an RGL file. @param origin for the field `description`.
/// @param pictures renders the material for the comparisons that decide; not called for a file that is copied.
/// @throws Error if the source's bytes are not an RGL file; Cancelled.
EncodedRgl encodeRgl(const Brdf& material, const RglFileSource* source, const std::string& origin,
                     const RglOptions& options, const ReferencePictures& pictures, const TaskControl& control = {});

}  // namespace gonio::rgl
