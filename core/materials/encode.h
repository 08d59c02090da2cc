// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <limits>
#include <optional>

#include "core/materials/edited_material.h"
#include "core/materials/material_formats.h"
#include "core/rgl/rgl_encoder.h"

/// Writing materials: every file of a material, from any program, is made by encode().
namespace gonio::materials {

struct EncodeOptions {
  double snr = 40;                              ///< rendered SNR in comparisonScene() that the file should reach, dB
  std::optional<rgl::RglSize> size = {};        ///< of `.bsdf` files; empty: the smallest that reaches the SNR
  std::optional<HalfDifferenceGrid> grid = {};  ///< of MERL files of materials that are not such tables; empty: the
                                                ///< usual one
  int pictureSize = 128, samples = 32;          ///< of the pictures that measure the SNR
  int blender = 4;                              ///< exports for Blender: 3 or 4, the series whose shading is fitted
};

/// A file in memory, and what it lost.
struct Encoded {
  std::vector<std::byte> bytes;
  std::shared_ptr<const Brdf> readBack;  ///< the file as a reader evaluates it
  std::vector<std::string> losses = {};  ///< what the file does not hold, one sentence each, for the user
  double snr = std::numeric_limits<double>::infinity();      ///< rendered SNR against the material, dB; an encoder
                                                             ///< that has not measured it leaves it infinite
  double brdfSnr = std::numeric_limits<double>::infinity();  ///< BRDF SNR (metrics::brdfSignalToNoiseRatio()), dB
};

/// The file of a material with its edits. An unedited material in its own format gives its file, byte for byte, after
/// verifying its hash; RGL files that lack fields which other programs need, as bundled ones do, are completed. The
/// accuracy is measured against `material.shown` in its native form. Takes 1 to 5 s, less for files that are copied.
/// @throws Error if the format cannot be written or the file has changed; Cancelled.
Encoded encode(const EditedMaterial& material, const MaterialFormat& format, const EncodeOptions& options = {},
               const TaskControl& control = {});

/// The file that a material was read from, for encoders: empty if it is edited, displayed with another incident
/// direction than readers take, or was read in another format or from a file with another suffix than the one that is
/// written.
/// @throws Error if the file has changed.
std::optional<Encoded> copyOfFile(const EditedMaterial& material, const MaterialFormat& format);

/// encode() in the format of the suffix, written atomically. @throws Error that names the file.
Encoded writeMaterial(const EditedMaterial& material, const std::filesystem::path& path,
                      const EncodeOptions& options = {}, const TaskControl& control = {});

/// The formats that a material can be written in, the one that holds most of it first.
std::vector<const MaterialFormat*> writableFormats(const Brdf& material);
/// The format for writing a material to a file of this name; `.binary` is the 360-degree layout only for such tables
/// and for such an EncodeOptions::grid. @throws Error that names the file, if no written format has this suffix.
const MaterialFormat& writableFormat(const std::filesystem::path& path, const Brdf& material,
                                     const EncodeOptions& options = {});
/// The same without a material. @param other another suffix that the caller writes, for the message; empty if there is
/// none.
void checkWritableSuffix(const std::filesystem::path& path, std::string_view other = {});

/// Whether an SNR misses what was asked for, as a sentence that states what would help; empty if it does not.
std::string shortfall(const Encoded& made, const MaterialFormat& format, const EncodeOptions& options);

/// Renders a material with the picture size and samples of the options, for RenderedComparison::signalToNoiseRatio().
/// @throws Cancelled.
rendering::RenderedComparison comparisonOf(const EditedMaterial& material, const EncodeOptions& options,
                                           const TaskControl& control);

}  // namespace gonio::materials
