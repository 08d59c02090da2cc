// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/export/export_target.h"
#include "core/export/shaders/reciprocal_lobes.h"
#include "core/export/shaders/surface_values.h"
#include "core/rendering/render_picture.h"

/// The rows of exportTargets(), and functions that the targets share.
namespace gonio::exports {

// The material as values: files in the formats of materials::encode(), and tables.

/// NAME_rgb.bsdf and NAME_spec.bsdf by formats::encodeRgl(). The spectra, which pbrt reads, are nowhere negative.
ExportTarget mitsubaTarget();
ExportTarget pbrtTarget();
/// NAME.binary: MERL, 90 x 90 x 180, reciprocal and isotropic.
ExportTarget merlTarget();
/// NAME_360.binary: MERL, 90 x 90 x 360, isotropic.
ExportTarget merlCircleTarget();
/// NAME.bin: UTIA, 288 x 288 pairs of directions.
ExportTarget utiaTarget();
/// NAME.csv: BRDF values on a grid of directions.
ExportTarget csvTarget();
/// NAME_slices.exr: images of slices of half-difference space, as in BRDF viewers and papers.
ExportTarget slicesTarget();

// Fits of other programs' shading models (shaders/shading_models.h).

/// NAME_blender.py: a Python script that creates the material of fitViewLobes() in Blender.
ExportTarget blenderTarget();
/// NAME_principled.py: a Python script that creates a Principled BSDF in Blender with the values fitted to
/// principledShader().
ExportTarget principledTarget();
/// NAME.gltf: a sphere with the material of gltfShader() and an embedded buffer.
ExportTarget gltfTarget();
/// NAME.mtlx: a sum of generalized_schlick_bsdf lobes.
ExportTarget materialXTarget();
/// NAME_openpbr.mtlx: open_pbr_surface.
ExportTarget openPbrTarget();
/// NAME_standard_surface.mtlx: standard_surface.
ExportTarget standardSurfaceTarget();
/// NAME_values.csv: the parameters of the materials of Unreal Engine, Unity (HDRP) and Arnold.
ExportTarget valuesTarget();
/// NAME.glsl: a GLSL function of reciprocal lobes.
ExportTarget glslTarget();

/// Renders `brdf` and sets the members `brdf` and `snr` of the export. @throws Cancelled.
void measureExport(ExportResult& made, std::shared_ptr<const Brdf> brdf,
                   const rendering::RenderedComparison& comparison, const TaskControl& control);

/// The origin with the accuracy: "chrome, exported by Gonio 1.0. ... Rendered SNR 31.2 dB (comparison scene)."
std::string originText(const materials::EditedMaterial& source, double snr);

/// The warning for an anisotropic material in a target of isotropic materials.
std::string meanAzimuthWarning();

/// Writes the text of a file. @param name of the material. @param origin the text from originText().
using SurfaceText = std::string (*)(const SurfaceValues& values, const std::string& name, const std::string& origin);

/// The values as written to a file: layers without effect are set to 0, and the rotation is reduced to [0, pi), the
/// period of a grain.
SurfaceValues writtenValues(SurfaceValues values);

/// An export with one file, fitted by fitSurface(). @throws Cancelled.
ExportResult makeSurfaceExport(const SurfaceShader& shader, std::string_view suffix, SurfaceText text,
                               const materials::EditedMaterial& source, const ExportOptions& options,
                               const TaskControl& control);

/// Fits lobes for a target's own formula and measures the result, without writing files. @param counts numbers of GGX
/// lobes to try, ascending; the first that reaches options.snr is used, or the one with the highest SNR.
/// @throws Cancelled.
std::pair<ExportResult, ReciprocalLobes> makeLobesExport(std::span<const std::size_t> counts, LobesFormula formula,
                                                         const materials::EditedMaterial& source,
                                                         const ExportOptions& options, const TaskControl& control);

}  // namespace gonio::exports
